"""Many trajectories at once: right, the same to the bit however they are cut, and isolated."""

from __future__ import annotations

import multiprocessing
import os
import pickle
import subprocess
import sys
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from oracles import MODELS, right_hand_side
from scipy.integrate import solve_ivp

import groundroll as gr
from groundroll.aircraft.values import given as given_to
from groundroll.base import memory
from groundroll.model.models import as_model
from groundroll.motion import engine, lanes
from groundroll.motion.plan import planned
from groundroll.motion.virtual import integrate_in_vm

PLANE = gr.Aircraft.load("brott-physical")
FIELDS = ("final", "samples", "largest", "first")


def cloud(count: int, seed: int = 1, **top: float) -> dict[str, np.ndarray]:
    """Random aircraft and starts."""
    rng = np.random.default_rng(seed)
    ranges = {
        "a": (-1.0, 1.0),
        "Ct": (0.0, 8000.0),
        "speed": (15.0, 40.0),
        "v0": (0.01, top.get("v0", 2.0)),
        "r0": (0.0, top.get("r0", 0.0)),
        "disturbance": (-300.0, 300.0),
    }
    return {name: rng.uniform(*ends, count) for name, ends in ranges.items()}


def same(one: gr.Ensemble, other: gr.Ensemble) -> bool:
    """Whether two ensembles are the same to the bit."""
    pairs = [(one.status, other.status), (one.steps, other.steps), (one.estimate, other.estimate)]
    for field in FIELDS:
        mine, theirs = getattr(one, field), getattr(other, field)
        assert list(mine) == list(theirs)
        pairs += [(mine[name], theirs[name]) for name in mine]
    return all(a.shape == b.shape and a.tobytes() == b.tobytes() for a, b in pairs)


#: Everything that can be asked for at once.
EVERYTHING = {
    "at": np.linspace(0.0, 3.0, 7),
    "names": ("v", "r", "psi", "Y", "alpha", "F_main"),
    "extremes": ("alpha", "r"),
    "limits": {"psi": 0.2, "Y": 3.0},
    "within": {"alpha": 0.3},
}


# --- Right ----------------------------------------------------------------------------------


@pytest.mark.parametrize("model", ["linear", "nonlinear"])
@pytest.mark.parametrize("tol", [1e-4, 1e-6, 1e-9])
def test_it_agrees_with_scipy_on_what_sympy_prints(model: str, tol: float):
    values = cloud(20, v0=6.0, r0=0.3)
    at = np.linspace(0.0, 4.0, 9)
    states = tuple(map(str, MODELS[model].states))
    ens = gr.ensemble(PLANE, 4.0, model, at=at, names=states, tol=tol, **values)
    end = gr.ensemble(PLANE, 4.0, model, names=states, tol=tol, **values)
    f = right_hand_side(model)
    parameters = ("a", "Ct", "speed")
    for k in range(20):
        plane = PLANE.replace(**{name: values[name][k] for name in parameters})
        x0 = np.zeros(7)
        x0[:2] = values["v0"][k], values["r0"][k]
        u, p = np.array([values["disturbance"][k]]), plane.parameters(model)
        exact = solve_ivp(
            lambda t, x, u=u, p=p: f(x, u, p),
            (0.0, 4.0),
            x0,
            "DOP853",
            dense_output=True,
            rtol=1e-12,
            atol=1e-14,
        )
        scale = np.abs(exact.sol(np.linspace(0.0, 4.0, 401))).max(axis=1)
        for n, name in enumerate(states):
            error = np.abs(ens[name][k] - exact.sol(at)[n]).max() / max(scale[n], 1e-6)
            assert error < tol + 2e-11, name
            assert abs(end[name][k] - exact.y[n, -1]) / max(scale[n], 1e-6) < tol + 2e-11, name
    assert ens.ok.all()
    assert (np.abs(ens.estimate) <= tol).all()


@settings(max_examples=10)
@given(
    st.fixed_dictionaries(
        {
            "a": st.integers(-10, 10).map(lambda n: n / 10),
            "Ct": st.integers(0, 8).map(lambda n: 1000.0 * n),
            "speed": st.integers(10, 45).map(float),
            "v0": st.integers(-50, 50).map(lambda n: n / 10),
            "r0": st.integers(-5, 5).map(lambda n: n / 10),
        }
    )
)
def test_it_agrees_with_the_compiled_integrator(values: dict[str, float]):
    own = {name: value for name, value in values.items() if name in ("a", "Ct", "speed")}
    start = {name: value for name, value in values.items() if name not in own}
    run = gr.simulate(PLANE.replace(**own), t=3.0, samples=31, **start)
    names = ("v", "r", "y", "theta", "X", "Y", "psi", "gamma", "a_y")
    ens = gr.ensemble(PLANE, 3.0, at=run.t, names=names, tol=1e-9, **values)
    for name in names:
        size = np.abs(run[name]).max()
        assert np.abs(ens[name] - run[name]).max() <= 1e-7 * max(size, 1e-3), name


def test_extremes_are_those_of_a_fine_run():
    values = cloud(60, v0=4.0)
    at = np.linspace(0.0, 3.0, 6001)
    fine = gr.ensemble(PLANE, 3.0, at=at, names=("alpha", "psi"), tol=1e-9, **values)
    ens = gr.ensemble(PLANE, 3.0, extremes=("alpha",), limits={"psi": 0.02}, **values)
    assert ens.largest["alpha"] == pytest.approx(np.abs(fine["alpha"]).max(axis=1), rel=2e-6)
    over = np.abs(fine["psi"]) >= 0.02
    first = np.where(over.any(axis=1), at[over.argmax(axis=1)], np.inf)
    found = ens.first["psi"]
    assert (np.isfinite(found) == np.isfinite(first)).all()
    some = np.isfinite(first)
    assert 5 < np.count_nonzero(some) < 60
    assert np.abs(found[some] - first[some]).max() < 5.1e-4
    assert ens.largest["psi"][some].min() >= 0.02 * (1 - 1e-6)


def test_x_squared_blows_up_where_it_should():
    """An unstable aircraft is an error of no lane but its own; see the isolation below."""
    fast = gr.ensemble(PLANE, 300.0, "linear", Ct=0.0, a=np.array([-0.5, 2.0]), v0=0.1)
    assert fast.status.tolist()[0] == 0
    assert gr.Ensemble.STATUS[fast.status[1]] in ("not finite", "ok", "step limit")


# --- The same to the bit --------------------------------------------------------------------


@pytest.fixture(scope="module")
def reference() -> gr.Ensemble:
    return gr.ensemble(PLANE, 3.0, threads=1, **EVERYTHING, **cloud(700, v0=6.0, r0=0.3))


@pytest.mark.parametrize("threads", [2, 3])
@pytest.mark.parametrize("chunk", [700, 64, 37])
def test_bits_do_not_depend_on_threads_or_chunks(reference: gr.Ensemble, threads: int, chunk: int):
    values = cloud(700, v0=6.0, r0=0.3)
    ens = gr.ensemble(PLANE, 3.0, threads=threads, chunk=chunk, **EVERYTHING, **values)
    assert same(ens, reference)


def test_bits_do_not_depend_on_company(reference: gr.Ensemble):
    values = {name: array[300:311] for name, array in cloud(700, v0=6.0, r0=0.3).items()}
    some = gr.ensemble(PLANE, 3.0, **EVERYTHING, **values)
    for field in FIELDS:
        for name, array in getattr(some, field).items():
            assert array.tobytes() == getattr(reference, field)[name][300:311].tobytes(), name


@pytest.mark.parametrize("method", ["spawn", "fork"])
def test_processes_give_the_same_bits(reference: gr.Ensemble, method: str):
    """Also after a fork, which OpenMP's threads do not survive."""
    context = multiprocessing.get_context(method)
    with ProcessPoolExecutor(2, mp_context=context) as executor:
        ens = gr.ensemble(
            PLANE, 3.0, executor=executor, chunk=101, **EVERYTHING, **cloud(700, v0=6.0, r0=0.3)
        )
    assert same(ens, reference)


def test_a_forked_child_may_ask_for_threads(reference: gr.Ensemble):
    gr.ensemble(PLANE, 1.0, threads=2, v0=np.ones(100))
    with ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("fork")) as executor:
        run = partial(gr.ensemble, PLANE, 3.0, threads=2, **EVERYTHING)
        assert same(executor.submit(run, **cloud(700, v0=6.0, r0=0.3)).result(60), reference)


@pytest.mark.filterwarnings("ignore")  # of distributed's own dependencies
def test_a_dask_cluster_gives_the_same_bits(reference: gr.Ensemble):
    distributed = pytest.importorskip("distributed")
    with (
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=None, processes=True
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        ens = gr.ensemble(
            PLANE,
            3.0,
            executor=client.get_executor(),
            chunk=150,
            **EVERYTHING,
            **cloud(700, v0=6.0, r0=0.3),
        )
    assert same(ens, reference)


def test_the_second_run_is_the_first_again(reference: gr.Ensemble):
    again = gr.ensemble(PLANE, 3.0, **EVERYTHING, **cloud(700, v0=6.0, r0=0.3))
    assert same(again, reference)
    assert same(pickle.loads(pickle.dumps(again)), reference)


# --- Isolation ------------------------------------------------------------------------------


def test_broken_lanes_are_told_and_leave_the_others_alone():
    """At the kernel's own door: the public one lets no such number through."""
    values = cloud(100)
    (task,) = (plan_of(values).task(range(100)),)
    sound = lanes.integrate(task)
    x0, p = dict(task.x0), dict(task.parameters)
    x0["v"], p["u"] = x0["v"].copy(), p["u"].copy()
    x0["v"][[5, 40]] = np.nan, np.inf
    p["u"][[17, 33]] = 0.0, np.nan
    broken = lanes.integrate(type(task)(**{**vars(task), "x0": x0, "parameters": p}))
    bad = np.isin(np.arange(100), [5, 17, 33, 40])
    assert (broken.status[bad] != 0).all()
    assert (broken.status[[5, 33, 40]] == lanes.STATUS.index("not finite")).all()
    assert (broken.status[~bad] == 0).all()
    for name, final in broken.final.items():
        assert np.isnan(final[bad]).all()
        assert final[~bad].tobytes() == sound.final[name][~bad].tobytes()


def plan_of(values: dict[str, np.ndarray]):
    model = as_model("nonlinear")
    made = planned(given_to(PLANE, model, values, "test"), model, 3.0, 1e-6, np.empty(0))
    return replace(made, final=model.carried[1])


def test_what_leaves_the_range_ends_there():
    values = cloud(200, v0=6.0)
    free = gr.ensemble(PLANE, 3.0, extremes=("alpha",), **values)
    bound = float(np.median(free.largest["alpha"]))
    ens = gr.ensemble(PLANE, 3.0, within={"alpha": bound}, **values)
    left = ens.status == ens.STATUS.index("left the range")
    clear = np.abs(free.largest["alpha"] / bound - 1) > 1e-2
    assert (left == (free.largest["alpha"] > bound))[clear].all()
    assert np.isnan(ens["v"][left]).all()
    assert ens["v"][~left].tobytes() == free["v"][~left].tobytes()
    assert ens.counts == {"ok": int((~left).sum()), "left the range": int(left.sum())}
    assert "left the range" in repr(ens)


# --- Without a compiler ---------------------------------------------------------------------


def test_the_virtual_machine_gives_the_same_numbers(monkeypatch: pytest.MonkeyPatch):
    values = cloud(12, v0=6.0, r0=0.3)
    fast = gr.ensemble(PLANE, 3.0, tol=1e-9, **EVERYTHING, **values)
    monkeypatch.setattr(lanes, "can_compile", lambda model: False)
    slow = gr.ensemble(PLANE, 3.0, tol=1e-9, **EVERYTHING, **values)
    assert (slow.status == fast.status).all()
    ok = fast.ok
    assert ok.sum() > 0
    for name in EVERYTHING["names"]:
        size = np.abs(fast[name][ok]).max()
        assert np.abs(slow[name][ok] - fast[name][ok]).max() < 1e-7 * size, name
    for name in fast.largest:
        assert slow.largest[name][ok] == pytest.approx(fast.largest[name][ok], rel=1e-3)
    both = np.isfinite(fast.first["psi"]) & ok
    assert slow.first["psi"][both] == pytest.approx(fast.first["psi"][both], abs=1e-3)


def test_the_virtual_machine_isolates_too():
    task = plan_of(cloud(9)).task(range(9))
    x0 = {**task.x0, "v": np.where(np.arange(9) == 4, np.nan, task.x0["v"])}
    outcome = integrate_in_vm(type(task)(**{**vars(task), "x0": x0}))
    assert outcome.status.tolist() == [0, 0, 0, 0, 1, 0, 0, 0, 0]
    assert np.isfinite(outcome.final["v"]).tolist() == (outcome.status == 0).tolist()


def test_without_a_compiler_it_warns_and_works():
    script = (
        "import groundroll as gr, numpy as np\n"
        "e = gr.ensemble(gr.Aircraft.load('brott'), 1.0, v0=np.array([0.1, 0.2]))\n"
        "print(e.counts, gr.solver(t=[0.0, 1.0])(np.array([0.1] + [0] * 6), np.zeros(1),"
        " gr.Aircraft.load('brott').parameters('nonlinear')).shape)"
    )
    environment = {**os.environ, "CC": "no-such-compiler", "PATH": "/nowhere"}
    run = subprocess.run(
        [sys.executable, "-W", "always", "-c", script],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stderr
    assert run.stdout == "{'ok': 2} (4, 2)\n"
    assert "ensembles run in CasADi's virtual machine" in run.stderr


# --- What people do -------------------------------------------------------------------------


def test_arrays_broadcast_and_names_work_both_ways():
    plane = PLANE.replace(Ct=1000.0)  # else it follows from a load that a tricycle has not
    a, speeds = np.linspace(-1, 1, 5)[:, None], np.array([20.0, 30.0, 40.0])
    ens = gr.ensemble(plane, 1.0, main_gear_arm=a, u=speeds, v0=0.5)
    assert ens["v"].shape == ens.status.shape == (5, 3)
    assert ens["lateral_velocity"] is ens["v"]
    one = gr.ensemble(plane, 1.0, a=-0.5, speed=40.0, v0=0.5)
    assert one["v"].shape == ()
    assert float(one["v"]) == ens["v"][1, 2]
    own = gr.ensemble(plane.replace(a=a, u=speeds), 1.0, v0=0.5)
    assert same(own, ens)
    assert "5 x 3 trajectories" in repr(ens)


def test_what_follows_from_an_array_follows():
    stations = np.linspace(0.30, 0.45, 7)
    ens = gr.ensemble(PLANE, 2.0, x_cg=stations, v0=0.5, chunk=32)
    for k, station in enumerate(stations.tolist()):
        one = gr.ensemble(PLANE.replace(x_cg=station), 2.0, v0=0.5)
        assert float(one["r"]) == ens["r"][k]


def test_the_path_is_carried_where_it_is_wanted():
    assert set(gr.ensemble(PLANE, 1.0, v0=1.0).final) == {"v", "r", "y", "theta", "psi"}
    assert {"X", "Y"} < set(gr.ensemble(PLANE, 1.0, v0=1.0, Y0=2.0).final)
    assert list(gr.ensemble(PLANE, 1.0, v0=1.0, names=["offset", "v"]).final) == ["Y", "v"]


def test_progress_counts_trajectories_and_interrupts():
    seen: list[tuple[int, int]] = []
    values = cloud(100)
    gr.ensemble(PLANE, 1.0, chunk=40, progress=lambda *x: seen.append(x), **values)
    assert seen == [(40, 100), (80, 100), (100, 100)]

    def stop(done: int, total: int) -> None:
        if done >= 40:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        gr.ensemble(PLANE, 1.0, chunk=20, progress=stop, **values)
    with ThreadPoolExecutor(1) as executor, pytest.raises(KeyboardInterrupt):
        gr.ensemble(PLANE, 1.0, chunk=1, progress=stop, executor=executor, **values)


def test_memory_stays_bounded(monkeypatch: pytest.MonkeyPatch):
    """No task holds more than a chunk, and no more than a few wait."""
    alive: list[int] = []
    work = engine.integrate

    def counted(task: lanes.Task, *how: object) -> lanes.Outcome:
        alive.append(task.count)
        assert all(array.size in (1, task.count) for array in task.x0.values())
        return work(task, *how)

    monkeypatch.setattr(engine, "integrate", counted)
    gr.ensemble(PLANE, 0.1, r0=np.linspace(-1, 1, 300)[:, None], v0=np.ones(10), chunk=256)
    assert sum(alive) == 3000
    assert max(alive) == 256


# --- Bad input ------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"t": 0.0}, "t must be a positive number, not 0.0"),
        ({"t": np.nan}, "t must be finite"),
        ({"model": "linaer"}, "did you mean linear"),
        ({"tol": 1e-13}, r"tol must be from 1e-11 to 0.001, not 1e-13"),
        ({"tol": 0.1}, "tol must be from"),
        ({"a": [0.1, np.inf]}, r"main_gear_arm \(a\) must be finite, but .*\[1\] = inf"),
        ({"v0": [[0.1], [np.nan]]}, r"v0 must be finite, but v0\[1, 0\] = nan"),
        ({"speed": [20.0, -1.0]}, r"speed \(u\) must be positive"),
        ({"m": "heavy"}, "heavy"),
        ({"a": [1.0, 2.0], "v0": [1.0, 2.0, 3.0]}, r"do not broadcast.*a \(2,\).*v0 \(3,\)"),
        ({"v0": []}, "nothing to simulate"),
        ({"sped": 3.0}, "unknown argument 'sped'.*speed"),
        ({"v1": 3.0}, "unknown argument 'v1'.*v0"),
        ({"at": [0.0, 6.0]}, "at must lie within 0 to t = 5 s"),
        ({"at": [1.0, 1.0]}, "at must be a list of increasing times"),
        ({"names": ("alpha",)}, "unknown name 'alpha'"),
        ({"names": "v"}, "names must be a list of names, not 'v'"),
        ({"extremes": ("alfa",)}, "unknown name 'alfa' in extremes; did you mean .*alpha"),
        ({"limits": {"psi": -1.0}}, r"limits\['psi'\] must be a positive number"),
        ({"limits": ("psi",)}, "limits must be a mapping"),
        ({"within": {"phi": 1.0}}, "unknown name 'phi'"),
        ({"threads": 0}, "threads must be a whole number from 1"),
        ({"chunk": 2.5}, "chunk must be a whole number from 1"),
        ({"a": 0.1, "main_gear_arm": 0.2}, "are the same parameter"),
    ],
)
def test_mistakes_are_named_before_any_work(
    arguments: dict[str, object], message: str, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setattr(engine, "integrate", lambda *args: pytest.fail("work was started"))
    with pytest.raises(gr.GroundrollError, match=message):
        gr.ensemble(PLANE, **arguments)


def test_more_memory_than_there_is_is_refused(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(memory, "_available", lambda: 10**6)
    with pytest.raises(gr.GroundrollError, match=r"memory for the results: .* GiB are needed"):
        gr.ensemble(PLANE, v0=np.ones(1000), at=np.linspace(0, 5, 501))
    huge = np.broadcast_to(1.0, (10**6, 10**6))
    with pytest.raises(gr.GroundrollError, match="GiB"):
        gr.ensemble(PLANE, v0=huge[:, :1], r0=huge[:1])


def test_what_cannot_follow_is_found_before_any_work(monkeypatch: pytest.MonkeyPatch):
    """A CG behind the tail leaves no load on a main tire."""
    monkeypatch.setattr(engine, "integrate", lambda *args: pytest.fail("work was started"))
    stations = np.where(np.arange(100) == 99, 6.0, 0.38)
    with pytest.raises(gr.GroundrollError, match="must be positive"):
        gr.ensemble(PLANE, x_cg=stations, v0=0.1, chunk=32)
