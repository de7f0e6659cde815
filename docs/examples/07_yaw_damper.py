"""A pilot who keeps an unstable taildragger on the runway: optimal control on compiled integrators.

The tail wheel is off the ground and a gust pushes the tail. Hands off, the aircraft ground-loops.
Which rudder force, within what a rudder can do and half a second late, brings it back with least
effort? Direct multiple shooting: states and forces at the nodes are unknowns, the compiled
integrator links them, IPOPT gets exact first and second derivatives. The same problem is then
solved with CasADi's own integrators, in turn, to compare the time.
"""

import os
import statistics
import time

import casadi as ca
import numpy as np
from matplotlib import pyplot

import groundroll as gr
from groundroll import generated
from groundroll.view.plots import COLOURS, style

plane = gr.Aircraft.load("brott-physical").replace(tail_wheel_stiffness=0.0)
p = plane.parameters("nonlinear")
LARGEST, DELAY = 350.0, 0.7  # N of rudder force at the tail; s until the pilot acts
END, N = 5.0, 50
REPEATS = int(os.environ.get("REPEATS", "3"))  # 0: no comparison
h = END / N
t = np.linspace(0.0, END, N + 1)
# Open-loop control of an unstable aircraft forgives nothing: optimise against the very gust that
# is flown, here one that holds over each interval.
smooth = gr.gusts.one_minus_cosine(peak="250 N", start="0.2 s", length="0.8 s")
gust = gr.gusts.sampled(t[:-1], smooth(t[:-1] + h / 2), hold=True)
STATES = generated.PACKS["nonlinear"].states
ALONG, ACROSS, HEADING = (STATES.index(s) for s in ("X", "Y", "psi"))


def problem(step: ca.Function) -> tuple[dict[str, ca.MX], dict[str, np.ndarray]]:
    """Unknowns, cost and constraints; `step` is (x0, u, p, h) -> xf."""
    x, u = ca.MX.sym("x", 7, N + 1), ca.MX.sym("u", 1, N)
    force = u + ca.DM(gust(t[:-1])).T
    ends = step.map(N)(x[:, :-1], force, ca.repmat(p, 1, N), ca.repmat(h, 1, N))
    cost = h * (ca.sumsqr(x[ACROSS, :]) + ca.sumsqr(10 * x[HEADING, :]) + ca.sumsqr(u / 100))
    nlp = {"x": ca.veccat(x, u), "f": cost, "g": ca.vec(x[:, 1:] - ends)}
    free = np.full((7, N + 1), np.inf)
    free[:, 0] = 0.0  # starts on the centre line, along it
    rudder = np.where(t[:-1] < DELAY, 0.0, LARGEST)
    most = np.concatenate([free.ravel("F"), rudder])
    guess = np.zeros((7, N + 1))
    guess[ALONG] = plane["u"] * t
    x0 = np.concatenate([guess.ravel("F"), np.zeros(N)])
    return nlp, {"x0": x0, "lbx": -most, "ubx": most, "lbg": 0, "ubg": 0}


def solver(step: ca.Function) -> ca.Function:
    quiet = {"print_time": False, "ipopt.print_level": 0, "ipopt.sb": "yes"}
    return ca.nlpsol("solver", "ipopt", problem(step)[0], quiet)


def casadi_integrator(plugin: str, options: dict[str, float]) -> ca.Function:
    """One of CasADi's own integrators on the same right-hand side, with the same face."""
    x, u, q, length = (ca.MX.sym(s, n) for s, n in (("x", 7), ("u", 1), ("p", p.size), ("h", 1)))
    rate = length * generated.build("nonlinear_rhs")(x, u, q)
    dae = {"x": x, "u": u, "p": ca.vertcat(q, length), "ode": rate}
    own = ca.integrator("own", plugin, dae, 0.0, 1.0, options)
    return ca.Function("own", [x, u, q, length], [own(x0=x, u=u, p=ca.vertcat(q, length))["xf"]])


def hessian_error(step: ca.Function) -> float:
    """Second derivative of the Lagrangian along a direction, against central differences."""
    nlp, arguments = problem(step)
    weights = ca.MX.sym("w", nlp["g"].numel())
    lagrangian = nlp["f"] + ca.dot(weights, nlp["g"])
    direction = np.random.default_rng(1).normal(size=nlp["x"].numel())
    gradient = ca.gradient(lagrangian, nlp["x"])
    slope = ca.Function("slope", [nlp["x"], weights], [gradient])
    exact = ca.Function("exact", [nlp["x"], weights], [ca.hessian(lagrangian, nlp["x"])[0]])
    at, w = (
        arguments["x0"] + 0.01 * direction,
        np.random.default_rng(2).normal(size=weights.numel()),
    )
    e = 1e-5
    differences = (slope(at + e * direction, w) - slope(at - e * direction, w)) / (2 * e)
    product = exact(at, w) @ direction
    return float(ca.norm_inf(product - differences) / ca.norm_inf(product))


steps = {
    "rk45 compiled": generated.load("nonlinear_rk45"),
    "rk4 compiled": generated.load("nonlinear_rk4"),
    "rk45 in CasADi's VM": generated.build("nonlinear_rk45"),
    "rk4 in CasADi's VM": generated.build("nonlinear_rk4"),
    "cvodes in CasADi's VM": casadi_integrator("cvodes", {"reltol": 1e-9, "abstol": 1e-11}),
}
print(f"Hessian against differences: {hessian_error(steps['rk45 compiled']):.0e} of it")

# Solve once, and fly the result: the gust as it is, the rudder held over each interval.
arguments = problem(steps["rk45 compiled"])[1]
found = solver(steps["rk45 compiled"])(**arguments)["x"].full().ravel()
rudder = gr.gusts.sampled(t[:-1], found[-N:], hold=True)
saved = gr.simulate(plane, disturbance=gust + rudder, t=END)
lost = gr.simulate(plane, disturbance=gust, t=3.0)
print(f"hands off: {abs(lost['Y']).max():.1f} m off the centre line after {lost.t[-1]:g} s")
print(f"pilot:     {abs(saved['Y']).max():.1f} m at most, {saved['Y'][-1]:+.2f} m at the end")

with style():
    figure, (above, below) = pyplot.subplots(2, 1, figsize=(9, 4.8), height_ratios=(2, 1))
    gr.runway_view([lost, saved], labels=["hands off", "with rudder"], width=18, ax=above)
    below.step(t[:-1], gust(t[:-1]), where="post", color="0.4", label="gust")
    below.step(t[:-1], found[-N:], where="post", color=COLOURS[1], label="rudder")
    for bound in (-LARGEST, LARGEST):
        below.axhline(bound, color="0.4", linewidth=0.8, linestyle=":")
    below.set(xlabel="time (s)", ylabel="side force on the tail (N)", xlim=(0, END))
    below.legend()
    figure.savefig("yaw_damper.png", dpi=120)

# The same problem on each integrator in turn, several times: medians and ratios.
solvers = {name: solver(step) for name, step in steps.items()}
seconds: dict[str, list[float]] = {name: [] for name in steps}
for _ in range(REPEATS):
    for name, solve in solvers.items():
        start = time.perf_counter()
        solve(**arguments)
        seconds[name].append(time.perf_counter() - start)
for name, solve in solvers.items() if REPEATS else ():
    middle = statistics.median(seconds[name])
    ratio = middle / statistics.median(seconds["rk45 compiled"])
    count = solve.stats()["iter_count"]
    print(f"{name:<22} {count:3} iterations {middle:8.3f} s, {ratio:6.2f} times rk45 compiled")
