"""The explorer in a real browser: its numbers are Python's, and what the user does has effect."""

from __future__ import annotations

import io
import json
import math
import tempfile
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from browser import browser, needs_browser, opened, settled, until
from exported import NAMES, case
from unprivileged import read_only_folder

import groundroll as gr
from groundroll.cli import main
from groundroll.derive.emit.own import derive_file
from groundroll.exchange.subject import subject
from groundroll.model.models import Model, as_model
from groundroll.model.names import PARAMETERS

pytestmark = needs_browser
_FOLDER = tempfile.TemporaryDirectory(prefix="groundroll-page-")
#: A state and a parameter of each model that are changed on the page.
CHANGED = {
    "linear": {"x_main": 0.1, "Ct": 2500.0, "u": 20.0},
    "nonlinear": {"x_main": 0.1, "m": 800.0},
    "rollout": {"x_main": 0.6, "track": 2.4, "u": 15.0},
    "landing_roll": {"x_main": 0.6, "m": 900.0, "u": 15.0},
    "landing_roll_flown": {"x_main": 0.6, "tau_pilot": 0.3},
    "single_track": {"C_rear": 9e4, "u": 20.0},
    "four_wheels": {"width": 1.7, "grip": 0.5},
    "lagging": {"lag": 0.2, "arm": 0.3},
}
#: Arrays of a function of the page, filled with NaN first.
CALL = """([name, given, sizes]) => {
    const results = sizes.map((n) => new Float64Array(n).fill(NaN));
    groundroll[name](...given.map((v) => Float64Array.from(v)), ...results);
    return results.map((v) => [...v]);
}"""


@cache
def written(name: str) -> Path:
    """The page of a case, written once."""
    plane, model, values = case(name)
    values = {s: v for s, v in values.items() if s != "u0"}  # at the aircraft's own speed
    return gr.explore(plane, Path(_FOLDER.name) / f"{name}.html", model, **values)


@pytest.fixture(scope="module")
def chromium() -> Iterator[Any]:
    with browser() as found:
        yield found


@pytest.fixture(scope="module", params=NAMES)
def shown(request: pytest.FixtureRequest, chromium: Any) -> Iterator[tuple[str, Any]]:
    """A case and its page."""
    with opened(chromium, written(request.param)) as page:
        yield request.param, page


def numbers(name: str) -> list[np.ndarray]:
    """States, inputs and parameters where a case starts."""
    plane, model, values = case(name)
    found = subject(plane, model, values, "a test")
    return [np.array(list(g.values())) for g in (found.start, found.inputs, found.parameters)]


def changed_plane(name: str) -> gr.Aircraft:
    """The aircraft of a case as it is after the changes on the page."""
    plane, model, _ = case(name)
    own = {s: v for s, v in CHANGED[name].items() if s not in PARAMETERS}
    rest = {s: v for s, v in CHANGED[name].items() if s in PARAMETERS}
    full = {model.quantities[s].name: s for s in own}
    kept = {name: v for name, v in plane.own.items() if full.get(name, name) not in own}
    return plane.replace(**rest).with_own({**kept, **own})


def test_a_page_is_small(shown: tuple[str, Any]) -> None:
    assert written(shown[0]).stat().st_size < 500_000


def test_functions_are_the_models(shown: tuple[str, Any]) -> None:
    name, page = shown
    model, rng = case(name).model, np.random.default_rng(3)
    nx, ny = len(model.states), len(model.outputs)
    for _ in range(3):
        point = [
            v + s * rng.uniform(0, 1, v.size) * (1 + abs(v))
            for v, s in zip(numbers(name), (0.01, 0.01, 0.001), strict=True)
        ]
        change = [rng.normal(size=v.size) * (0.01 + abs(v)) for v in point]
        given = [list(v) for v in point]
        (rates,) = page.evaluate(CALL, ["rates", given, [nx]])
        (shown_y,) = page.evaluate(CALL, ["outputs", given, [ny]])
        moved = page.evaluate(CALL, ["along", [*given, *map(list, change)], [nx, ny]])
        places = page.evaluate(CALL, ["places", given, [3 * len(model.places)] * 2])
        close(rates, model.expression("rhs")(*point), 1e-12)
        close(shown_y, model.expression("outputs")(*point), 1e-12)
        J = [np.array(each) for each in model.function("jacobians")(*point)]
        for found, part in zip(moved, (J[:3], J[3:]), strict=True):
            close(found, sum(m @ d for m, d in zip(part, change, strict=True)), 1e-9)
        for found, exact in zip(places, model.expression("places")(*point), strict=True):
            close(found, np.array(exact).reshape(-1), 1e-12)


def close(found: Any, exact: Any, rtol: float) -> None:
    """Each number to a tolerance relative to itself, or to a hundredth of that to the largest."""
    exact = np.array(exact, dtype=float).ravel()
    np.testing.assert_allclose(found, exact, rtol, 0.01 * rtol * abs(exact).max() + 1e-300)


def test_parameters_follow_as_in_python_whatever_is_changed(shown: tuple[str, Any]) -> None:
    name, page = shown
    plane, model, _ = case(name)
    found = page.evaluate("[...groundroll.parametersOf(groundroll.design).p]")
    close(found, plane.parameters(model), 1e-12)
    found = page.evaluate(
        "(changes) => [...groundroll.parametersOf({given: {...groundroll.design.given,"
        " ...changes}}).p]",
        CHANGED[name],
    )
    close(found, changed_plane(name).parameters(model), 1e-12)


def test_eigenvalues_are_those_of_the_linear_model(shown: tuple[str, Any]) -> None:
    """At the steady roll that the page finds, whose core rates vanish."""
    name, page = shown
    plane, model, _ = case(name)
    point = page.evaluate(
        "(() => { const d = structuredClone(groundroll.design); for (const s in d.inputs)"
        " d.inputs[s] = 0; const found = groundroll.operatingPoint(d); return {ok: found.ok,"
        " x: [...found.x], roots: found.roots}; })()"
    )
    assert point["ok"]
    held = {model.roles.get("speed")}
    if model.roles.get("offset") not in model.dynamic:  # nobody steers
        held.add(model.roles.get("heading"))
    lin = gr.linearize(plane, model, dict(zip(model.states, point["x"], strict=True)))
    core = [k for k, s in enumerate(lin.states) if s not in held]
    np.testing.assert_allclose(lin.drift[core], 0.0, atol=1e-7)
    A = lin.A[np.ix_(core, core)]
    live = (abs(A).max(axis=1) > 0) & (abs(A).max(axis=0) > 0)
    expected = np.linalg.eigvals(A[np.ix_(live, live)])
    found = np.array([complex(root["re"], root["im"]) for root in point["roots"]])
    for each in found:
        assert abs(expected - each).min() < 1e-7 * max(1.0, abs(each))
    np.testing.assert_allclose(found.sum(), expected.sum(), rtol=1e-9)


def test_the_roll_is_that_of_simulate(shown: tuple[str, Any]) -> None:
    name, page = shown
    plane, model, _ = case(name)
    found = page.evaluate(
        "(() => { const roll = groundroll.rollOf({...groundroll.design, duration: 4},"
        " {tolerance: 1e-11, samples: 41}); while (!roll.done) roll.advance(100);"
        " return {series: [...roll.series], first: roll.first.map((t) => t === Infinity ? -1 : t),"
        " inputs: groundroll.design.inputs, start: groundroll.design.start}; })()"
    )
    acting = {**found["inputs"], **found["start"]}
    run = gr.simulate(plane, model, t=4.0, samples=41, tol=1e-11, **acting)
    series = np.reshape(found["series"], (41, -1)).T
    for s, values in zip(model.states, series, strict=True):
        assert abs(values - run[s]).max() <= 1e-9 + 1e-8 * abs(run[s]).max(), s
    for event, t in zip(model.events, found["first"], strict=True):
        when = float(run.events[event.name])
        assert t == -1 if math.isinf(when) else t == pytest.approx(when, abs=1e-6), event.name


def test_eigenvalues_of_any_matrix(chromium: Any) -> None:
    rng = np.random.default_rng(5)
    with opened(chromium, written("linear")) as page:
        for n in (1, 2, 3, 5, 8, 12, 20):
            for scale in (0.0, 3.0):
                A = rng.normal(size=(n, n)) * 10 ** rng.normal(scale=scale, size=(n, 1))
                roots = page.evaluate("([a, n]) => groundroll.eigenvalues(a, n)", [[*A.ravel()], n])
                found = np.array([complex(r["re"], r["im"]) for r in roots])
                expected = np.linalg.eigvals(A)
                assert len(found) == n
                for each in found:
                    size = max(abs(each), 1e-3 * abs(expected).max())
                    assert abs(expected - each).min() < 1e-9 * size


def test_the_speed_window_is_the_closed_form(chromium: Any) -> None:
    plane = gr.Aircraft.load("brott").replace(Ct=2500.0)
    window = gr.speed_window(plane)
    path = gr.explore(plane, Path(_FOLDER.name) / "window.html", "linear")
    with opened(chromium, path) as page:
        pieces = page.evaluate(
            "(() => { const task = groundroll.bandsOf('u', {low: 1, high: 80}); let step;"
            " do step = task.next(); while (!step.done); return step.value.pieces; })()"
        )
        assert [piece["good"] for piece in pieces] == [True, False, True]
        assert pieces[1]["from"] == pytest.approx(float(window.low), rel=1e-9)
        assert pieces[1]["to"] == pytest.approx(float(window.high), rel=1e-9)
        # on the page, in words and in the units of the file
        settled(page)
        note = page.text_content("#note-u")
        assert f"{float(window.low) * 3.6:.4g}" in note
        assert "km/h" in note


def test_the_map_is_that_of_python(chromium: Any) -> None:
    plane = gr.Aircraft.load("brott")
    with opened(chromium, gr.explore(plane, Path(_FOLDER.name) / "map.html")) as page:
        settled(page)
        found = page.evaluate(
            "(({x, y, ends, values}) => ({x, y, ends, values: [...values]}))(groundroll.mapped)"
        )
    values = np.reshape(found["values"], (48, 64))
    x, y = (
        np.linspace(end["low"], end["high"], n)
        for end, n in zip(found["ends"], (64, 48), strict=True)
    )
    at = {found["x"]: x[None, ::7], found["y"]: y[::5, None]}
    exact = gr.linearize(plane, "nonlinear", **at).decay_rate
    np.testing.assert_allclose(values[::5, ::7], exact, rtol=1e-9, atol=1e-9)


def test_wheels_are_dragged_by_pointer_and_by_keys(chromium: Any) -> None:
    with opened(chromium, written("landing_roll")) as page:
        handle = "#plan .handle.wheel[aria-label^=left]"
        before = page.evaluate("({...groundroll.design.given})")
        box = page.locator(f"{handle} .mark").bounding_box()
        middle = (box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
        page.mouse.move(*middle)
        page.mouse.down()
        page.mouse.move(middle[0] + 20, middle[1] - 8, steps=4)
        page.mouse.up()
        page.wait_for_timeout(100)
        after = page.evaluate("({...groundroll.design.given})")
        moved = page.locator(f"{handle} .mark").bounding_box()
        assert moved["x"] - box["x"] == pytest.approx(20, abs=1.5)
        assert moved["y"] - box["y"] == pytest.approx(-8, abs=1.5)
        assert after["x_main"] < before["x_main"]  # stations count aft, the nose is to the right
        assert after["track"] > float(case("landing_roll").plane["track"])
        page.focus(handle)
        page.keyboard.press("ArrowLeft")
        page.wait_for_timeout(50)
        by = page.evaluate("groundroll.design.given.x_main") - after["x_main"]
        assert by == pytest.approx(0.01, rel=0.05)
        page.focus("#plan .handle.cg")
        page.keyboard.press("Shift+ArrowLeft")
        page.wait_for_timeout(50)
        limit = page.evaluate("groundroll.design.given.x_cg")
        plane = case("landing_roll").plane
        assert limit == pytest.approx(
            min(float(plane["x_cg"]) + 0.1, float(plane["x_aft"])), rel=0.05
        )


#: Events that are no harm.
HARMLESS = ("stopped", "wheel_lifted")
#: What matters, each a slider that is seen at once where the model knows it.
MATTERS = (
    *("x_main", "x_tail", "track", "toe", "x_cg", "m", "u", "wind_x", "wind_y"),
    *("Ct", "swivels", "tau_pilot"),
)


@pytest.fixture(scope="module")
def flown() -> Any:
    """The landing roll with a pilot, which nobody ships, derived as its user would."""
    folder = Path(_FOLDER.name)
    file = folder / "flown.py"
    file.write_text(
        "from groundroll.derive.models.landing_roll_flown import LANDING_ROLL_FLOWN as model\n"
    )
    derive_file(file, folder / "flown")
    return Model.load(folder / "flown")


def test_what_matters_has_a_slider_and_limits_that_are_the_models(
    chromium: Any, flown: Any
) -> None:
    """How late a pilot may be, as the eigenvalues of the model in Python say."""
    plane = gr.Aircraft.load("cessna-170")
    path = gr.explore(plane, Path(_FOLDER.name) / "flown.html", flown, u0=15.0)
    assert path.stat().st_size < 500_000
    with opened(chromium, path) as page:
        for s in MATTERS:
            assert page.is_visible(f"#slider-{s}"), s
        assert page.is_visible("#surface")
        whole = page.locator("#slider-swivels")
        assert [whole.get_attribute(key) for key in ("min", "max", "step")] == ["0", "1", "1"]
        found = page.evaluate(
            "(() => { const task = groundroll.bandsOf('tau_pilot', {low: 0.05, high: 3}); let step;"
            " do step = task.next(); while (!step.done); const edge = step.value.pieces[0].to;"
            " const at = (delay) => { const d = structuredClone(groundroll.design);"
            " d.given.tau_pilot = delay; for (const s in d.inputs) d.inputs[s] = 0;"
            " const { x } = groundroll.operatingPoint(d);"
            " return { delay, x: [...x], p: [...groundroll.parametersOf(d).p] }; };"
            " return { pieces: step.value.pieces, sides: [at(0.99 * edge), at(1.01 * edge)] }; })()"
        )
        assert [piece["good"] for piece in found["pieces"]] == [True, False]
        for side, good in zip(found["sides"], (True, False), strict=True):
            delay = side["p"][flown.parameters.index("tau_pilot")]
            assert delay == pytest.approx(side["delay"], rel=1e-15)
            u = np.zeros(len(flown.inputs))
            A = np.array(flown.expression("jacobians")(side["x"], u, side["p"])[0])
            held = {flown.roles["speed"]}
            steered = {*flown.dynamic, flown.roles["offset"], flown.roles["heading"]} - held
            core = [k for k, s in enumerate(flown.states) if s in steered]
            A = A[np.ix_(core, core)]
            live = abs(A).max(axis=1) > 0
            assert (np.linalg.eigvals(A[np.ix_(live, live)]).real.max() < 0) == good


def test_the_limit_of_crosswind_is_that_of_simulate(chromium: Any) -> None:
    """On either side of it a roll in Python ends as the page says."""
    plane = gr.Aircraft.load("cessna-172p")
    path = gr.explore(plane, Path(_FOLDER.name) / "wind.html", "landing_roll")
    with opened(chromium, path) as page:
        found = page.evaluate(
            "(() => { const task = groundroll.bandsOf('wind_y', {low: 0, high: 15}); let step;"
            " do step = task.next(); while (!step.done); return { pieces: step.value.pieces,"
            " start: groundroll.design.start, u: groundroll.design.given.u }; })()"
        )
    edge = next(piece["to"] for piece in found["pieces"] if piece["to"] < 15)
    fates = []
    for factor in (0.98, 1.02):
        acting = {**found["start"], "u0": found["u"], "wind_y": factor * edge}
        run = gr.simulate(plane, "landing_roll", t=10.0, samples=301, **acting)
        hard = [t for name, t in run.events.items() if not name.startswith(HARMLESS)]
        lost = abs(run["psi"]).max() >= math.radians(45) or abs(run["Y"]).max() >= 15.0
        fates.append(bool(lost) or any(0 < float(t) < math.inf for t in hard))
    first_good = found["pieces"][0]["good"]
    assert fates == [not first_good, first_good]


def test_a_wheel_is_dragged_from_the_side_too(chromium: Any) -> None:
    with opened(chromium, written("landing_roll")) as page:
        handle = page.locator("#side .handle.wheel[aria-label^=left] .mark")
        before = page.evaluate("groundroll.design.given.x_main")
        box = handle.bounding_box()
        middle = (box["x"] + box["width"] / 2, box["y"] + box["height"] / 2)
        page.mouse.move(*middle)
        page.mouse.down()
        page.mouse.move(middle[0] - 15, middle[1], steps=3)
        page.mouse.up()
        page.wait_for_timeout(100)
        assert handle.bounding_box()["x"] - box["x"] == pytest.approx(-15, abs=1.5)
        assert page.evaluate("groundroll.design.given.x_main") > before


DEFICIENCIES = ("none", "protanopia", "deuteranopia", "tritanopia", "achromatopsia")


@pytest.mark.parametrize("deficiency", DEFICIENCIES)
def test_good_and_bad_can_be_told_apart_by_every_eye(deficiency: str, chromium: Any) -> None:
    """In the key, and in the map where it is surest."""
    from matplotlib import image

    with opened(chromium, written("nonlinear")) as page:
        settled(page)
        session = page.context.new_cdp_session(page)
        session.send("Emulation.setEmulatedVisionDeficiency", {"type": deficiency})

        def look(**clip: Any) -> np.ndarray:
            return np.asarray(image.imread(io.BytesIO(page.screenshot(**clip)))[..., :3])

        def key(kind: str) -> np.ndarray:
            locator = page.locator(f".controls .key.{kind}").last
            whole = np.asarray(image.imread(io.BytesIO(locator.screenshot()))[..., :3])
            return whole[2:-2, 3:-3]  # without its round corners

        apart = abs(key("good").mean((0, 1)) - key("bad").mean((0, 1))).max()
        streaks = key("bad").std((0, 1)).max() - key("good").std((0, 1)).max()
        assert apart > 0.15 or streaks > 0.1
        found = page.evaluate(
            "(() => { scrollTo(0, 0); const { values } = groundroll.mapped, box ="
            " document.getElementById('map').getBoundingClientRect();"
            " const at = (k) => [box.x + 64 + (k % 64 + 0.5) / 64 * (box.width - 76),"
            " box.y + 10 + (1 - (Math.floor(k / 64) + 0.5) / 48) * (box.height - 54)];"
            " const sorted = [...values.keys()].filter((k) => values[k] === values[k])"
            ".sort((a, b) => values[a] - values[b]);"
            " return [at(sorted[0]), at(sorted.at(-1))]; })()"
        )
        bad, good = (look(clip={"x": x - 2, "y": y - 2, "width": 4, "height": 4}) for x, y in found)
        hatched = bad.std((0, 1)).max() > 0.02
        assert abs(bad.mean((0, 1)) - good.mean((0, 1))).max() > 0.15 or hatched


def test_a_link_carries_the_design(chromium: Any) -> None:
    with opened(chromium, written("nonlinear")) as page:
        page.fill("#slider-x_main >> xpath=../input[@type='text']", "-14.5 in")
        page.keyboard.press("Tab")
        page.fill("#slider-F_disturbance >> xpath=../input[@type='text']", "12")
        page.keyboard.press("Tab")
        page.select_option("#units", "US")
        page.select_option("#map-y", "Ct")
        until(page, "location.hash.includes('map_y')")
        design = page.evaluate("groundroll.design")
        page.click("#link")
        address = page.input_value("#offered")
    assert design["given"]["x_main"] == pytest.approx(-14.5 * 0.0254, rel=1e-12)
    with opened(chromium, written("nonlinear"), "#" + address.partition("#")[2]) as page:
        assert page.evaluate("groundroll.design") == design
        assert page.input_value("#units") == "US"
        assert page.input_value("#map-y") == "Ct"
        page.click("#reset")
        until(page, "location.hash === '' || location.hash.includes('units')")
        assert page.evaluate("groundroll.design.given.x_main") != design["given"]["x_main"]


@pytest.mark.parametrize("fragment", ["#x_main=1e400&nothing=3&u=oops&m=", "#%zz&&=&units=x"])
def test_an_address_that_makes_no_sense_is_passed_over(chromium: Any, fragment: str) -> None:
    with opened(chromium, written("nonlinear"), fragment) as page:
        assert page.evaluate("groundroll.design.given") == page.evaluate(
            "groundroll.DATA.design.given"
        )


@pytest.mark.parametrize("name", [*NAMES, "brott-physical", "cessna-172p"])
def test_the_file_of_a_design_reads_to_the_same_numbers(
    name: str, chromium: Any, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    if name in NAMES:
        path, model, changes = written(name), case(name).model, CHANGED[name]
    else:
        path = gr.explore(gr.Aircraft.load(name), tmp_path / "page.html", "landing_roll")
        model, changes = as_model("landing_roll"), {"m": 901.0}
    with opened(chromium, path) as page:
        for todo in ({}, changes):
            page.evaluate(
                "(changes) => { for (const s in changes) groundroll.change(s, changes[s]); }", todo
            )
            page.click("#toml")
            (tmp_path / "plane.toml").write_text(page.input_value("#offered"), encoding="utf-8")
            page.click("#close")
            expected = page.evaluate("[...groundroll.parametersOf(groundroll.design).p]")
            plane = gr.Aircraft.load(tmp_path / "plane.toml")
            np.testing.assert_allclose(plane.parameters(model), expected, rtol=1e-13)
            given = page.evaluate("groundroll.design.given")
            kept = {s: float(x) for s, x in plane.given.items()}
            assert kept == {s: given[s] for s in kept}
    again = tmp_path / "again.html"
    arguments = ["explore", str(tmp_path / "plane.toml"), "--model", model.key, "--out", str(again)]
    assert main(arguments) == 0
    assert facts_of(again)["design"]["given"] == given
    capsys.readouterr()


def facts_of(path: Path) -> Any:
    """What a page holds as data."""
    text = path.read_text(encoding="utf-8")
    return json.loads(text.partition('id="data">')[2].partition("</script>")[0])


def test_units_and_surfaces_are_switched(chromium: Any) -> None:
    with opened(chromium, written("landing_roll")) as page:
        number = "#slider-m >> xpath=../input[@type='text']"
        assert page.input_value(number).endswith("lb")
        page.select_option("#units", "metric")
        page.wait_for_timeout(100)
        assert page.input_value(number).endswith("kg")
        page.select_option("#surface", "wet")
        page.wait_for_timeout(50)
        assert page.evaluate("groundroll.design.given.surface_left") == 0.5
        page.select_option("#surface", "")
        page.wait_for_timeout(50)
        assert page.evaluate("groundroll.design.given.surface_left") is None


def test_a_wrong_number_is_marked_and_changes_nothing(chromium: Any) -> None:
    with opened(chromium, written("nonlinear")) as page:
        field = "#slider-m >> xpath=../input[@type='text']"
        before = page.evaluate("groundroll.design.given.m")
        for text in ("heavy", "12 parsec", "", "1e999"):
            page.fill(field, text)
            page.keyboard.press("Tab")
            assert page.evaluate("groundroll.design.given.m") == before
        assert "wrong" in page.get_attribute(field, "class")
        page.fill(field, "-5")
        page.keyboard.press("Tab")
        assert page.evaluate("groundroll.design.given.m") > 0


def test_the_roll_is_played_and_its_fate_told(chromium: Any) -> None:
    plane = gr.Aircraft.load("brott")
    path = gr.explore(plane, Path(_FOLDER.name) / "loop.html", "nonlinear", F_disturbance=900.0)
    with opened(chromium, path) as page:
        until(page, "document.getElementById('fate').textContent")
        assert page.get_attribute("#fate", "data-fate") in ("ground loop", "leaves the runway")
        run = gr.simulate(plane, t=10.0, samples=301, F_disturbance=900.0)
        first = min(
            run.t[np.argmax(abs(run[s]) >= limit)]
            for s, limit in (("psi", math.radians(45)), ("Y", 15.0))
            if (abs(run[s]) >= limit).any()
        )
        assert f"after {first:.3g}" in page.text_content("#fate").replace("\u202f", " ")
        page.click("#play")
        until(page, "Number(document.getElementById('time').value) > 0.02")
        page.click("#play")
        assert page.text_content("#play") == "Play"


def test_names_with_markup_stay_text(chromium: Any, tmp_path: Path) -> None:
    given = gr.Aircraft.load("brott").given
    bad = "</script><img src=x onerror=alert(1)><b>@FUNCTIONS@\u2028 & 'x' \"y\" \\ \x1b"
    odd = gr.Aircraft("odd", given, title=bad, description=bad, source=bad)
    path = gr.explore(odd, tmp_path / "odd.html", "nonlinear")
    with opened(chromium, path) as page:
        assert page.evaluate("document.querySelectorAll('img, b').length") == 0
        assert "<img src=x onerror=alert(1)>" in page.text_content("h1")
        page.click("#toml")
        (tmp_path / "odd.toml").write_text(page.input_value("#offered"), encoding="utf-8")
    assert "<img" in gr.Aircraft.load(tmp_path / "odd.toml").title


def test_it_fits_a_phone_and_paper(chromium: Any) -> None:
    phone = {"viewport": {"width": 360, "height": 740}, "has_touch": True}
    with opened(chromium, written("landing_roll"), **phone) as page:
        assert page.evaluate("document.documentElement.scrollWidth") <= 360
        smallest = page.evaluate(
            "Math.min(...[...document.querySelectorAll('svg text')].filter((e) =>"
            " e.getClientRects().length && e.textContent)"
            ".map((e) => e.getBoundingClientRect().height))"
        )
        assert smallest > 9  # px: it can be read
        page.emulate_media(media="print")
        assert not page.is_visible("#slider-m")
        assert page.is_visible("#slider-m >> xpath=../input[@type='text']")
        assert not page.is_visible("#print")


def test_everything_is_reached_by_keys_and_has_a_name(chromium: Any) -> None:
    with opened(chromium, written("nonlinear")) as page:
        nameless = page.evaluate(
            "[...document.querySelectorAll('input, select, button, [tabindex]')].filter((e) =>"
            " !(e.labels?.length || e.getAttribute('aria-label') || e.textContent.trim())).length"
        )
        assert nameless == 0
        page.focus("#map")
        before = page.evaluate("groundroll.design.given.u")
        page.keyboard.press("ArrowUp")
        assert page.evaluate("groundroll.design.given.u") > before
        page.focus("#slider-u")
        page.keyboard.press("ArrowDown")
        page.wait_for_timeout(50)
        assert page.evaluate("groundroll.design.given.u") < before * 1.02


def test_the_command_writes_it(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / "plane.html"
    assert main(["explore", "brott", "--out", str(path), "--set", "v0=1 kt"]) == 0
    text = path.read_text(encoding="utf-8")
    assert facts_of(path)["design"]["start"]["v0"] == pytest.approx(0.514444, rel=1e-5)
    assert "http" not in text.replace("http://www.w3.org/2000/svg", "").replace("http-equiv", "")
    capsys.readouterr()
    assert main(["explore", "brott", "--out", str(tmp_path / "nowhere" / "page.html")]) == 1
    assert "cannot write" in capsys.readouterr().err


def test_what_cannot_be_is_said_and_nothing_is_left(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plane, out = gr.Aircraft.load("brott"), tmp_path / "page.html"
    with pytest.raises(gr.GroundrollError, match="explore takes one aircraft, but mass"):
        gr.explore(plane, out, m=[900.0, 950.0])
    with pytest.raises(gr.GroundrollError, match="unknown model"):
        gr.explore(plane, out, "linea")
    monkeypatch.setattr("groundroll.exchange.explorer.MOST", 100_000)
    with pytest.raises(gr.GroundrollError, match=r"landing_roll is too large for a page: .* kB"):
        gr.explore(gr.Aircraft.load("cessna-170"), out, "landing_roll")
    assert list(tmp_path.iterdir()) == []
    monkeypatch.undo()
    with read_only_folder() as folder, pytest.raises(gr.GroundrollError, match="cannot write"):
        gr.explore(plane, folder / "page.html", "linear")
