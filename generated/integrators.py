# Generated from derive/ with SymPy 1.14.0 and CasADi 3.8.2: do not edit, run `make derive`.
"""Integrators over one interval of time, built on a right-hand side.

Time is scaled to the interval, so its length is an argument and not part of the code: one
compiled function serves every time grid.
"""

from __future__ import annotations

from typing import Any

import casadi as ca

#: Options of CasADi's `erk` for each method. The tape bounds the steps an adjoint can retrace.
METHODS: dict[str, dict[str, Any]] = {
    "rk4": {"method": "rk4", "step_size": 1.0},
    "rk45": {
        "method": "rk45",
        "reltol": 1e-11,
        "abstol": 1e-13,
        "max_num_steps": 1_000_000,
        "max_tape_steps": 2000,
    },
}


def interval(rhs: ca.Function, name: str, method: str) -> ca.Function:
    """Integrate x' = rhs(x, u, p) over an interval of length h under constant inputs.

    Parameters
    ----------
    rhs : casadi.Function
        (x, u, p) -> xdot.
    name : str
        Name of the result.
    method : str
        ``"rk4"``, one classical Runge-Kutta step of length h, or ``"rk45"``, adaptive steps.

    Returns
    -------
    casadi.Function
        (x0, u, p, h) -> xf, with h in seconds.
    """
    sizes = [*(rhs.size1_in(k) for k in range(3)), 1]
    x, u, p, h = (ca.SX.sym(s, n) for s, n in zip("xuph", sizes, strict=True))
    scaled = {"x": x, "u": u, "p": ca.vertcat(p, h), "ode": h * rhs(x, u, p)}
    step = ca.integrator(f"{name}_step", "erk", scaled, 0.0, 1.0, METHODS[method])
    start, inputs, parameters, length = (
        ca.MX.sym(s, n) for s, n in zip("xuph", sizes, strict=True)
    )
    end = step(x0=start, u=inputs, p=ca.vertcat(parameters, length))["xf"]
    arguments = [start, inputs, parameters, length]
    return ca.Function(name, arguments, [end], ["x0", "u", "p", "h"], ["xf"])


def derivatives(function: ca.Function) -> list[ca.Function]:
    """The function with the derivatives an optimiser asks for: fwd1, adj1 and fwd1_adj1."""
    return [function, function.forward(1), function.reverse(1), function.reverse(1).forward(1)]


def jacobians(rhs: ca.Function, outputs: ca.Function, name: str) -> ca.Function:
    """Jacobians of states and outputs by differentiation of the whole chain.

    Parameters
    ----------
    rhs, outputs : casadi.Function
        (x, u, p) -> xdot and (x, u, p) -> y.
    name : str
        Name of the result.

    Returns
    -------
    casadi.Function
        (x, u, p) -> fx, fu, fp, gx, gu, gp.
    """
    arguments = [ca.SX.sym(s, rhs.size1_in(k)) for k, s in enumerate("xup")]
    results = [
        ca.densify(ca.cse(ca.jacobian(function(*arguments), argument)))
        for function in (rhs, outputs)
        for argument in arguments
    ]
    names = [f"{of}{by}" for of in "fg" for by in "xup"]
    return ca.Function(name, arguments, results, [*"xup"], names)
