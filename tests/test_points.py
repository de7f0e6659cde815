"""Rates, outputs and Jacobians in lanes against CasADi's virtual machine, for every model."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from own_models import NAMES as OWN
from own_models import own

import groundroll as gr
from groundroll.generated import PACKS
from groundroll.linear import points as module
from groundroll.linear.operating_point import points_at
from groundroll.linear.points import NAMES, Points
from groundroll.model.models import Model, as_model

SHIPPED = [name for name, pack in PACKS.items() if pack.states]
MODELS = [*SHIPPED, *OWN]
NOBODY = gr.Aircraft("nobody", {})


def model_of(name: str) -> Model:
    return as_model(name) if name in SHIPPED else own(name)


def draw(model: Model, count: int, seed: int) -> Points:
    """Points at which nothing special happens, some values being single numbers."""
    rng = np.random.default_rng(seed)
    names = (*model.states, *model.inputs, *model.parameters)
    shapes = [(count,), *rng.choice(np.array([(), (count,)], object), len(names) - 1)]
    values = {s: np.asarray(rng.uniform(0.5, 1.5, n)) for s, n in zip(names, shapes, strict=True)}
    return Points(model, NOBODY, values, (count,))


def by_casadi(model: Model, points: Points, index: int) -> dict[str, np.ndarray]:
    """The same results from the functions that people read."""
    values = [float(c[index if c.size > 1 else 0]) for c in points.columns]
    n, m = len(model.states), len(model.inputs)
    split = values[:n], values[n : n + m], values[n + m :]
    f, g = (model.expression(name)(*split) for name in ("rhs", "outputs"))
    jacobians = model.expression("jacobians")(*split)
    found = dict(zip(("fx", "fu", "fp", "gx", "gu", "gp"), jacobians, strict=True))
    moving = [model.states.index(s) for s in model.dynamic]
    result = {}
    for name, value in {"f": f, "g": g, **found}.items():
        array = np.array(value)
        array = array[moving] if name[0] == "f" else array
        array = array[:, moving] if name[1:] == "x" else array
        result[name] = array if name[1:] else array[:, 0]
    return result


@pytest.mark.parametrize("name", MODELS)
def test_the_kernel_is_the_model(name):
    model = model_of(name)

    @settings(max_examples=10, deadline=None)
    @given(st.integers(1, 70), st.integers(0, 2**32 - 1))
    def check(count, seed):
        points = draw(model, count, seed)
        found = points.evaluate(*NAMES)
        index = count // 2
        for key, expected in by_casadi(model, points, index).items():
            largest = np.abs(expected).max(initial=0.0)
            np.testing.assert_allclose(
                found[key][index], expected, rtol=1e-11, atol=1e-13 * largest, err_msg=key
            )

    check()


@pytest.mark.parametrize("name", MODELS)
def test_nothing_depends_on_threads_or_on_what_else_is_asked_for(name):
    points = draw(model_of(name), 1000, 1)
    every = points.evaluate(*NAMES)
    for key in NAMES:
        alone = points.evaluate(key, threads=2)
        np.testing.assert_array_equal(alone[key], every[key], err_msg=key)


def test_all_states_can_be_asked_for():
    model = as_model("nonlinear")
    points = draw(model, 3, 2)
    over = points.evaluate("f", "fx", "gx", over=model.states)
    n = len(model.states)
    assert over["f"].shape == (3, n)
    assert over["fx"].shape == (3, n, n)
    assert over["gx"].shape == (3, len(model.outputs), n)
    moving = [model.states.index(s) for s in model.dynamic]
    np.testing.assert_array_equal(points.evaluate("fx")["fx"], over["fx"][:, moving][:, :, moving])


@pytest.mark.parametrize("name", ["nonlinear", "rollout"])
def test_without_a_compiler_the_numbers_are_the_same(name, monkeypatch):
    points = draw(model_of(name), 5, 3)
    compiled = points.evaluate(*NAMES)

    def refuse(*_):
        raise module.NoCompilerError("none")

    monkeypatch.setattr(module, "_kernel", refuse)
    monkeypatch.setattr(module, "say_slower", lambda problem: None)
    for key, values in points.evaluate(*NAMES).items():
        assert values.shape == compiled[key].shape
        np.testing.assert_allclose(
            values, compiled[key], rtol=1e-11, atol=1e-13 * np.abs(values).max(initial=1.0)
        )


def test_values_broadcast():
    plane, model = gr.Aircraft.load("brott"), as_model("nonlinear")
    v, a = np.linspace(-1, 1, 3)[:, None], np.linspace(-0.5, 0.5, 4)
    points = points_at(plane, model, {"v": v, "a": a}, {}, "here")
    assert points.shape == (3, 4)
    found = points.evaluate("f", "fx")
    assert found["f"].shape == (3, 4, 2)
    one = points_at(plane, model, {"v": v[1, 0], "a": a[2]}, {}, "here").evaluate("f")["f"]
    np.testing.assert_array_equal(found["f"][1, 2], one)
