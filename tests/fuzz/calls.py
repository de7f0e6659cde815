"""Calls of the public functions with all kinds of values."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

import groundroll as gr
from groundroll.model.names import MODELS, PARAMETERS

from . import judges, mutation
from .harness import Case
from .values import ODD, number, same, shown

_AIRCRAFT = ("brott-physical", "cessna-170", "cessna-172p", "brott")
#: Where values are drawn from, by unit.
_RANGES = {
    "m/s": (-2.0, 2.0),
    "rad/s": (-0.3, 0.3),
    "rad": (-0.1, 0.1),
    "m": (-2.0, 2.0),
    "N": (-500.0, 500.0),
    "1": (0.0, 0.3),
}
_SPEED = (3.0, 60.0)


@cache
def _plane(name: str) -> gr.Aircraft:
    return gr.Aircraft.load(name)


def calls(rng: np.random.Generator, model: str, folder: Path) -> Case:
    """A call of one function."""
    makers, weights = zip(*_MAKERS, strict=True)
    maker = makers[int(rng.choice(len(makers), p=np.array(weights) / sum(weights)))]
    plane = _plane(str(mutation.pick(rng, _AIRCRAFT)))
    return maker(rng, model, plane)


class Drawn:
    """Arguments that were drawn, and what they mean."""

    def __init__(self, rng: np.random.Generator) -> None:
        self.rng = rng
        self.given: dict[str, Any] = {}
        self.truth: dict[str, Any] = {}
        self.speeds: list[str] = []

    def add(self, name: str, low: float, high: float, unit: str, share: float = 1.0) -> None:
        """An argument, given in this share of the calls."""
        if self.rng.random() < share:
            self.given[name], self.truth[name] = number(self.rng, low, high, unit)

    def shape(self) -> tuple[int, ...]:
        return np.broadcast_shapes(*(np.shape(t) for t in self.truth.values()))

    def taken(self) -> str:
        """Which of them means nothing; a call that has one must be refused."""
        odd = [name for name, value in self.truth.items() if value is None]
        return f"{odd[0]} means nothing, and is taken" if odd else ""


def _states(drawn: Drawn, model: str, ending: str, share: float = 0.4) -> None:
    pack = MODELS[model]
    for s in pack.states:
        unit = pack.quantities[s].unit
        low, high = _SPEED if s == "u" else _RANGES.get(unit, (-0.1, 0.1))
        if s not in ("Z", "w", "phi", "theta", "chi_third", "chi_rate_third"):
            drawn.add(f"{s}{ending}", low, high, unit, share)


def _inputs(drawn: Drawn, model: str, share: float = 0.3) -> None:
    pack = MODELS[model]
    for s in pack.inputs:
        q = pack.quantities[s]
        low, high = _RANGES.get(q.unit, (0.0, 0.1))
        drawn.add(str(mutation.pick(drawn.rng, (s, q.name))), low, high, q.unit, share)


def _speed(drawn: Drawn, model: str, share: float = 0.5) -> None:
    name = str(mutation.pick(drawn.rng, ("u", "speed")))
    if "u" not in MODELS[model].states:
        drawn.speeds.append(name)
        drawn.add(name, *_SPEED, "m/s", share)


def _plane_taken(drawn: Drawn, plane: gr.Aircraft) -> str:
    for name in ("u", "speed"):
        if name in drawn.speeds and name in drawn.truth and not same(plane["u"], drawn.truth[name]):
            return f"speed {plane['u']} for {drawn.truth[name]}"
    return ""


# --- One maker for each function --------------------------------------------------------------


def _simulate(rng: np.random.Generator, model: str, plane: gr.Aircraft) -> Case:
    drawn = Drawn(rng)
    _states(drawn, model, "0")
    _inputs(drawn, model)
    _speed(drawn, model)
    drawn.add("t", 0.001, 0.02, "s")
    tol = float(10 ** -rng.uniform(3, 10))
    options = {"samples": int(rng.integers(2, 12)), "tol": tol}

    def judge(run: gr.Trajectory) -> str:
        pack = MODELS[model]
        for name, value in drawn.truth.items():
            s = name.removesuffix("0")
            if s in pack.states and not same(run[s][..., 0], np.broadcast_to(value, shape(run))):
                return f"{name}: {run[s][..., 0]} for {value}"
        fine = same(run.t[-1], drawn.truth["t"]) and run.t.size == options["samples"]
        return (
            drawn.taken()
            or _plane_taken(drawn, run.aircraft)
            or ("" if fine else f"t {run.t}")
            or judges.trajectory(run, tol)
        )

    def shape(run: gr.Trajectory) -> tuple[int, ...]:
        return run.status.shape

    words = f"simulate({plane.name}, {model}, {shown({**drawn.given, **options})})"
    return Case(words, lambda: gr.simulate(plane, model, **drawn.given, **options), judge)


def _ensemble(rng: np.random.Generator, model: str, plane: gr.Aircraft) -> Case:
    drawn = Drawn(rng)
    _states(drawn, model, "0")
    _inputs(drawn, model)
    _speed(drawn, model)
    drawn.add("t", 0.001, 0.02, "s")
    options: dict[str, Any] = {"threads": int(rng.integers(1, 10**6)), "chunk": 7}
    options["tol"] = float(10 ** -rng.uniform(3, 11))

    def judge(ens: gr.Ensemble) -> str:
        fine = same(ens.t, drawn.truth["t"])
        return (
            drawn.taken()
            or _plane_taken(drawn, ens.aircraft)
            or ("" if fine else f"t {ens.t}")
            or judges.ends(ens)
        )

    words = f"ensemble({plane.name}, {model}, {shown({**drawn.given, **options})})"
    call = {**drawn.given, **options}
    return Case(words, lambda: gr.ensemble(plane, model=model, **call), judge)


def _linearize(rng: np.random.Generator, model: str, plane: gr.Aircraft) -> Case:
    drawn = Drawn(rng)
    _states(drawn, model, "", 0.3)
    _inputs(drawn, model)
    _speed(drawn, model)

    def judge(lin: gr.Linearization) -> str:
        taken = drawn.taken() or _plane_taken(drawn, lin.aircraft)
        return taken or judges.linearization(lin, drawn.truth)

    words = f"linearize({plane.name}, {model}, {shown(drawn.given)})"
    return Case(words, lambda: gr.linearize(plane, model, **drawn.given), judge)


def _trim(rng: np.random.Generator, model: str, plane: gr.Aircraft) -> Case:
    drawn = Drawn(rng)
    drawn.add("speed", *_SPEED, "m/s", 0.5)
    drawn.add("disturbance", -500.0, 500.0, "N", 0.7)
    drawn.add("slip", 0.05, 0.6, "rad", 0.3)

    def judge(found: gr.Trim) -> str:
        return drawn.taken() or _plane_taken(drawn, found.aircraft) or judges.turns(found)

    words = f"trim({plane.name}, {model}, {shown(drawn.given)})"
    return Case(words, lambda: gr.trim(plane, model, **drawn.given), judge)


def _margins(rng: np.random.Generator, model: str, plane: gr.Aircraft) -> Case:
    drawn = Drawn(rng)
    drawn.add("speed", *_SPEED, "m/s")
    changed = plane.replace(a=float(rng.uniform(-1, 2)), Ct=float(rng.uniform(0, 1e4)))
    as_sweep = rng.random() < 0.5

    def run() -> Any:
        if as_sweep:
            return gr.sweep(changed, ["decay_rate"], **drawn.given)["decay_rate"]
        return gr.margins(changed, **drawn.given).decay_rate

    def judge(found: Any) -> str:
        if drawn.taken():
            return drawn.taken()
        right = judges.decays(changed.replace(u=drawn.truth["speed"]), drawn.shape())
        fine = np.allclose(found, right, 1e-7, 1e-7)
        return "" if fine else f"{found} for {right}"

    function = "sweep" if as_sweep else "margins"
    return Case(f"{function}({plane.name}, {shown(drawn.given)})", run, judge)


def _window(rng: np.random.Generator, model: str, plane: gr.Aircraft) -> Case:
    drawn = Drawn(rng)
    drawn.add("a", -1.0, 2.5, "m")
    drawn.add("Ct", 0.0, 1e4, "N/rad")

    def judge(found: gr.SpeedWindow) -> str:
        if drawn.taken():
            return drawn.taken()
        changed = plane.replace(**drawn.truth)
        for index in np.ndindex(*drawn.shape()):
            one = changed.replace(
                **{s: np.broadcast_to(v, drawn.shape())[index] for s, v in drawn.truth.items()}
            )
            low, high = (
                float(np.broadcast_to(v, drawn.shape())[index]) for v in (found.low, found.high)
            )
            sides = [(low * 0.99, 1), (low * 1.01, -1), (high * 0.99, -1), (high * 1.01, 1)]
            if np.isnan(low):
                sides = [(u, 1) for u in (1.0, 10.0, 30.0, 100.0)]
            for u, sign in sides:
                if 0 < u < 1e3 and not (low > 0 and high / low < 1.03):
                    det = np.linalg.det(judges.state_matrices(one.replace(u=u), ()))
                    if np.sign(det) != sign and abs(det) > 1e-9:
                        return f"{low} to {high}, but det {det:.2g} at {u}"
        return ""

    words = f"speed_window({plane.name}, {shown(drawn.given)})"
    return Case(words, lambda: gr.speed_window(plane.replace(**drawn.given)), judge)


def _map(rng: np.random.Generator, model: str, plane: gr.Aircraft) -> Case:
    low, high = np.sort(rng.uniform(*_SPEED, 2))
    x = ("speed", np.linspace(low, high, int(rng.integers(1, 6))))
    y = (
        str(mutation.pick(rng, ("a", "main_gear_arm"))),
        rng.uniform(-1, 2, int(rng.integers(1, 4))),
    )

    def judge(found: gr.StabilityMap) -> str:
        grid = plane.replace(u=x[1][None, :], a=np.sort(y[1])[:, None])
        right = judges.decays(grid, found.values.shape)
        return "" if np.allclose(found.values, right, 1e-7, 1e-7) else f"{found.values} for {right}"

    words = f"stability_map({plane.name}, {x!r}, {y!r})"
    return Case(words, lambda: gr.stability_map(plane, x, y), judge)


def _replace(rng: np.random.Generator, model: str, plane: gr.Aircraft) -> Case:
    drawn = Drawn(rng)
    for s in map(str, rng.permutation(list(PARAMETERS))[: int(rng.integers(1, 4))]):
        q = PARAMETERS[s]
        drawn.add(str(mutation.pick(rng, (s, q.name))), 0.1, 5.0, q.unit)

    def judge(found: gr.Aircraft) -> str:
        wrong = [n for n, v in drawn.truth.items() if v is not None and not same(found[n], v)]
        return drawn.taken() or "; ".join(f"{n}: {found[n]}" for n in wrong)

    return Case(f"replace({shown(drawn.given)})", lambda: plane.replace(**drawn.given), judge)


def _gust(rng: np.random.Generator, model: str, plane: gr.Aircraft) -> Case:
    drawn = Drawn(rng)
    is_step = rng.random() < 0.5
    drawn.add("size" if is_step else "peak", -500.0, 500.0, "N")
    drawn.add("start", 0.0, 1.0, "s")
    drawn.add("end" if is_step else "length", 1.1, 3.0, "s")
    t = np.sort(rng.uniform(0, 4, 9))

    def run() -> Any:
        make = gr.gusts.step if is_step else gr.gusts.one_minus_cosine
        return make(**drawn.given)(t)

    def judge(found: Any) -> str:
        if drawn.taken():
            return drawn.taken()
        size, begin, last = (np.asarray(v)[..., None] for v in drawn.truth.values())
        if is_step:
            right = size * ((t >= begin) & (t < last))
        else:
            inside = np.clip((t - begin) / last, 0, 1)
            right = size / 2 * (1 - np.cos(2 * np.pi * inside))
        return "" if np.allclose(found, right, 1e-6, 1e-6) else f"{found} for {right}"

    return Case(f"{'step' if is_step else 'one_minus_cosine'}({shown(drawn.given)})", run, judge)


_FUNCTIONS: tuple[Callable[..., Any], ...] = (
    *(gr.simulate, gr.ensemble, gr.linearize, gr.trim, gr.margins, gr.sweep, gr.stability_map),
    *(gr.speed_window, gr.gear_limit, gr.gear_envelope, gr.survival, gr.basin, gr.check),
    *(gr.frequency_response, gr.step_response, gr.root_locus, gr.place_gear, gr.integrator),
    *(gr.solver, gr.fit_tire, gr.Aircraft, gr.Aircraft.load, gr.TireData.load, gr.Result.load),
)
_STRANGE: tuple[Any, ...] = (*ODD, 5, -1, 0, 1e300, "v", "nonlinear", ["v", "r"], ("u", [1, 2]), [])


def _strange(rng: np.random.Generator, model: str, plane: gr.Aircraft) -> Case:
    """A function with something in the place of an argument that may not belong there."""
    function = _FUNCTIONS[int(rng.integers(len(_FUNCTIONS)))]
    parameters = inspect.signature(function).parameters.values()
    given: dict[str, Any] = {}
    for parameter in parameters:
        if parameter.kind in (parameter.VAR_KEYWORD, parameter.VAR_POSITIONAL):
            continue
        if parameter.name in ("executor", "progress", "out", "threads"):
            continue
        if parameter.name in ("plane", "of") and parameter.default is parameter.empty:
            strange = _STRANGE[int(rng.integers(len(_STRANGE)))]
            given[parameter.name] = plane if rng.random() < 0.9 else strange
        elif parameter.default is parameter.empty or rng.random() < 0.3:
            given[parameter.name] = _STRANGE[int(rng.integers(len(_STRANGE)))]
    if given.get("t", 0) is not plane and "t" in given and not isinstance(given["t"], str | bool):
        given["t"] = given["t"] if rng.random() < 0.5 else 0.01
    words = f"{function.__qualname__}({shown(given)})"
    return Case(words, lambda: function(**given), lambda found: None)


_MAKERS: tuple[tuple[Callable[..., Case], float], ...] = (
    *((_simulate, 20), (_ensemble, 15), (_linearize, 12), (_trim, 5), (_margins, 8), (_window, 5)),
    *((_map, 3), (_replace, 12), (_gust, 8), (_strange, 12)),
)
