"""The generated functions about stability: which chains, with which results."""

from __future__ import annotations

from collections.abc import Sequence

from groundroll.derive.core.equation import Chain, needed
from groundroll.derive.core.quantity import Quantity
from groundroll.derive.parts.gear import track
from groundroll.derive.parts.quantities import PARAMETERS
from groundroll.derive.theory import closed_forms as closed
from groundroll.derive.theory import gear_position, margins, toe, worst_speed

from .casadi_source import FunctionSpec
from .scalar_functions import ordered, scalar_function

_MODES = (
    *(closed.re_1, closed.im_1, closed.re_2, closed.im_2),
    *(closed.decay_rate, closed.natural_frequency),
    *(closed.damped_frequency, closed.damping_ratio),
)


def _closed_form(
    name: str, summary: str, results: Sequence[Quantity], chain: Chain
) -> FunctionSpec:
    """A function of whatever parameters of the aircraft its chain needs."""
    chain = needed((*closed.stiffnesses(), *chain), results)
    return scalar_function(name, summary, ordered(chain), results, chain)


def stability_functions() -> tuple[FunctionSpec, ...]:
    """The functions of `generated/stability.py`."""
    return (
        *_mode_functions(),
        *_margin_functions(),
        *_gear_functions(),
        _toe_function(),
    )


def _mode_functions() -> tuple[FunctionSpec, ...]:
    return (
        _closed_form(
            "state_matrix", "A of the linear model.", closed.STATE_MATRIX, closed.state_matrix()
        ),
        _closed_form(
            "routh_hurwitz",
            "Trace and determinant of A: stable if and only if trace < 0 < det.",
            (closed.trace, closed.det, closed.discriminant),
            closed.routh_hurwitz(),
        ),
        scalar_function(
            "modes",
            "Eigenvalues of a 2 x 2 state matrix and what is read from them.",
            closed.STATE_MATRIX,
            _MODES,
            closed.modes(),
        ),
        _closed_form(
            "linear_modes",
            "Eigenvalues of the linear model, straight from the aircraft's parameters.",
            _MODES,
            (*closed.state_matrix(), *closed.modes()),
        ),
        scalar_function(
            "times",
            "How fast a deviation dies out or grows.",
            (closed.decay_rate,),
            (margins.time_to_half, margins.time_to_double),
            margins.times(),
        ),
    )


def _margin_functions() -> tuple[FunctionSpec, ...]:
    speeds = closed.speed_polynomial()
    return (
        _closed_form(
            "speed_window",
            "Speeds between which the linear model is unstable; NaN where there are none.",
            (closed.u_low, closed.u_high),
            closed.speed_window(),
        ),
        _closed_form(
            "weakest_speed",
            "The speed at which det A is least, and det A there.",
            (worst_speed.u_weakest, worst_speed.det_weakest),
            (*speeds, *worst_speed.weakest_speed()),
        ),
        _closed_form(
            "stationary_decay",
            "Where over speed the decay rate may be least.",
            (*worst_speed.STATIONARY, worst_speed.u_trace),
            (*speeds, *worst_speed.stationary_decay()),
        ),
        _closed_form(
            "steady_margins",
            "What the steady response says of stability.",
            (margins.neutral_steer_point, margins.static_margin, margins.understeer_gradient),
            margins.steady_margins(),
        ),
        _closed_form(
            "tail_wheel_needed",
            "The tail wheel that stability asks for at a speed.",
            (margins.stiffness_needed,),
            margins.tail_wheel_needed(),
        ),
        _closed_form(
            "tail_wheel_always",
            "The tail wheel that stability asks for at every speed.",
            (margins.stiffness_needed_always, margins.speed_margin),
            margins.tail_wheel_needed(),
        ),
    )


def _gear_functions() -> tuple[FunctionSpec, ...]:
    loaded = gear_position.following_loads()
    return (
        _closed_form(
            "gear_position",
            "Gear positions between which the aircraft is unstable; NaN where there are none.",
            (gear_position.a_lost, gear_position.a_regained),
            gear_position.fixed_stiffness(),
        ),
        _closed_form(
            "gear_position_envelope",
            "The least gear position at which stability is lost at some speed.",
            (gear_position.a_always, gear_position.u_touch),
            gear_position.fixed_stiffness_envelope(),
        ),
        _closed_form(
            "loaded_gear_position",
            "Polynomial in the tail's load share with the sign of det A, loads following the gear.",
            gear_position.POSITION,
            (*loaded, *gear_position.position_polynomial()),
        ),
        _closed_form(
            "loaded_gear_envelope",
            "Polynomial in the tail's load share that is zero where a window of speeds opens.",
            gear_position.ENVELOPE,
            (*loaded, *gear_position.envelope_polynomial()),
        ),
        _at_tail_load((*loaded, *gear_position.at_tail_fraction())),
    )


def _toe_function() -> FunctionSpec:
    chain = needed((*closed.stiffnesses(), *toe.toe_effects()), toe.RESULTS)
    return scalar_function(
        "toe_effects",
        "What a little toe-in changes of yaw stiffness and det A: both terms of the dispute.",
        ordered(chain, (*PARAMETERS, track)),
        toe.RESULTS,
        chain,
    )


def _at_tail_load(chain: Chain) -> FunctionSpec:
    results = (gear_position.gear_arm, gear_position.u_touch)
    chain = needed((*closed.stiffnesses(), *chain), results)
    return scalar_function(
        "at_tail_load",
        "Gear position and weakest speed at a share of the weight on the tail wheel.",
        (gear_position.tail_fraction, *ordered(chain)),
        results,
        chain,
    )
