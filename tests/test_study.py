"""The study: each printed cell has a verdict that can fail; files appear whole or not at all."""

from __future__ import annotations

import csv
import dataclasses
import json
import math
import os
import subprocess
import sys
from html.parser import HTMLParser
from importlib import resources
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

import groundroll as gr
from groundroll import study
from groundroll.model.evaluate import elementwise
from groundroll.model.names import DIGEST
from groundroll.study import cases, figures, ledger, output, report, sources
from groundroll.study.cases import case
from groundroll.study.thesis_tire import normalised_rms
from groundroll.tires.data import TireData
from groundroll.tires.quality import compare, force_rms

FIGURES = [f"3.{k}" for k in range(3, 9)] + [f"4.{k}" for k in range(5, 43)]
TABLES = ["3.2", *(f"4.{k}" for k in range(1, 12))]

#: Typed table -> the printed tables that it holds.
FILES = {
    "table_3_2.csv": ["3.2"],
    "table_4_1.csv": ["4.1"],
    "table_4_2.csv": ["4.2"],
    "table_4_4.csv": ["4.3", "4.4"],
    "table_4_6.csv": ["4.5", "4.6"],
    "table_4_8.csv": ["4.7", "4.8"],
    "table_4_9_10_11.csv": ["4.9", "4.10", "4.11"],
}
PRINTED = [
    (table.number, row.get("trial", row.get("symbol")), key)
    for table in sources.tables().values()
    for row in table.rows
    for key in ([c.quantity for c in table.columns] or [row["symbol"]])
]


@pytest.fixture(scope="module")
def cells() -> dict[tuple[str, str, str], ledger.Cell]:
    found = ledger.ledger()
    keyed = {(c.table, c.row, c.quantity if c.trial else c.row): c for c in found}
    assert len(keyed) == len(found)
    return keyed


@pytest.fixture(scope="module")
def done(tmp_path_factory) -> tuple[study.Summary, list[tuple[int, int | None]]]:
    steps: list[tuple[int, int | None]] = []
    out = tmp_path_factory.mktemp("study") / "new" / "out"
    return study.run(out, lambda *step: steps.append(step)), steps


# --- verdicts ---


@pytest.mark.parametrize("key", PRINTED, ids="-".join)
def test_every_printed_cell_is_accounted_for(cells, key):
    cell = cells[key]
    assert cell.verdict in ("agrees", "explained"), (
        f"Table {cell.table}, {cell.row}, {cell.label}: printed {cell.as_printed},"
        f" computed {cell.computed}"
    )
    if cell.verdict == "explained":
        cover = sources.errata()[cell.erratum].coverage(cell.table, cell.row, cell.quantity)
        assert cover is not None
        assert ledger.judge(cover.right[cell.row], cell.computed, sources.Tolerance(digits=1))
        if cover.reading:
            column = next(
                (c for c in sources.tables()[cell.table].columns if c.quantity == cell.quantity),
                sources.tables()[cell.table],
            )
            assert ledger.judge(cell.as_printed, cell.reproduced, column.tolerance)


def test_every_typed_cell_is_in_the_ledger(cells):
    typed, folder = 0, resources.files("groundroll.study") / "data"
    for name, numbers in FILES.items():
        lines = [s for s in (folder / name).read_text("utf-8").splitlines() if s[0] != "#"]
        for row in csv.DictReader(lines):
            texts = [v for k, v in row.items() if k not in ("trial", "symbol", "unit", "unrounded")]
            typed += len(texts)
            own = [
                c
                for c in cells.values()
                if c.table in numbers and c.row == row.get("trial", row.get("symbol"))
            ]
            as_printed = sorted(c.as_printed for c in own)
            assert sorted(text or "N/A" for text in texts) == as_printed
    assert typed == len(cells) == 373


def test_tables_and_verdicts_are_those_of_the_thesis(cells):
    assert list(sources.tables()) == TABLES
    assert {c.table for c in cells.values()} == set(TABLES)
    assert ledger.count(list(cells.values())) == {"agrees": 363, "explained": 10, "differs": 0}


@pytest.mark.parametrize(
    ("printed", "computed", "tolerance", "agrees"),
    [
        ("0.041", 0.0419, {"digits": 1}, True),
        ("0.041", 0.0421, {"digits": 1}, False),
        ("0.041", 0.0399, {"digits": 1}, False),
        ("441.630", 441.632, {"digits": 1}, False),
        ("-8.81055e-6", -8.81056e-6, {"digits": 1}, True),
        ("-8.81055e-6", -8.81057e-6, {"digits": 1}, False),
        ("-1.6868", -1.68662, {"absolute": 2e-4}, True),
        ("-1.6868", -1.68655, {"absolute": 2e-4}, False),
        ("-1.6868", 1.6868, {"absolute": 2e-4}, False),
        ("2.87", 2.79, {"digits": 1, "relative": 0.03}, True),
        ("2.87", 2.78, {"digits": 1, "relative": 0.03}, False),
        ("0.0279", 0.0280, {"digits": 1, "relative": 0.0}, True),
        ("281", 285.1, {"absolute": 4}, False),
        ("281", 277.1, {"absolute": 4}, True),
        ("281", math.nan, {"absolute": 4}, False),
        ("", math.nan, {"digits": 1}, True),
        ("", 0.0, {"digits": 1}, False),
    ],
)
def test_judge(printed, computed, tolerance, agrees):
    assert ledger.judge(printed, computed, sources.Tolerance(**tolerance)) is agrees


def test_no_overshoot_may_be_printed_as_none():
    tolerance = sources.Tolerance(absolute=4)
    assert ledger.judge("", 0.6, tolerance, none_means=0.0)
    assert not ledger.judge("", 4.5, tolerance, none_means=0.0)


def test_an_eigenvalue_printed_as_0_is_exact():
    found = {c.quantity: c for c in ledger.ledger(["4.4"]) if c.trial == 1}
    assert found["eigenvalue_2_real"].as_printed == "0"
    column = next(c for c in sources.tables()["4.4"].columns if c.quantity == "eigenvalue_2_real")
    row = sources.tables()["4.4"].rows[0]
    assert ledger._last_digit(row, column) == 0.01


def reprinted(number: str, row: int, key: str, text: str) -> dict[str, sources.Table]:
    table = sources.tables()[number]
    rows = [dict(r) for r in table.rows]
    rows[row][key] = text
    return {number: dataclasses.replace(table, rows=tuple(rows))}


@pytest.mark.parametrize(
    ("number", "row", "key", "text"),
    [
        ("3.2", 2, "value", "0.7225"),
        ("4.1", 0, "printed", "750"),
        ("4.2", 0, "printed", "900"),
        ("4.5", 0, "b_m", "3.92180"),
        ("4.7", 0, "Ct_N_per_deg", "147"),
        ("4.6", 1, "settling_time_s", "4.2538"),
        ("4.6", 1, "eig1_im", "3.3002"),
        ("4.6", 0, "settling_time_s", "2.3531"),  # covered, but the reading gives another print
        ("4.6", 8, "y_ss_m", "0.1"),  # unstable
        ("4.6", 1, "y_ss_m", ""),  # stable
        ("4.8", 0, "overshoot_pct", "8"),
        ("4.11", 2, "theta_ss_deg", "-1.2815"),
    ],
)
def test_a_wrong_print_differs(monkeypatch, number, row, key, text):
    changed = reprinted(number, row, key, text)
    before = ledger.ledger([number])
    monkeypatch.setattr(ledger, "tables", lambda: changed)
    after = ledger.ledger()
    differing = [
        k for k, (b, a) in enumerate(zip(before, after, strict=True)) if a.verdict != b.verdict
    ]
    assert [after[k].verdict for k in differing] == ["differs"]


def test_a_wrong_aircraft_differs_even_where_an_erratum_covers(monkeypatch):
    def heavier(number: int, model: str) -> cases.Case:
        trial = sources.trials()[number]
        return cases.Case(dataclasses.replace(trial, changes={**trial.changes, "m": 800.0}), model)

    monkeypatch.setattr(ledger, "case", heavier)
    found = {(c.trial, c.quantity): c.verdict for c in ledger.ledger(["4.6"])}
    assert found[5, "settling_time"] == "differs"
    assert found[5, "eigenvalue_1_real"] == "differs"


def test_readings_matter():
    """f and C5 of the data files are those that reproduce Table 4.11."""
    fraction = dataclasses.replace(case(17, "nonlinear").trial, readings={"nonlinear": {"f": 1}})
    other = cases.Case(fraction, "nonlinear").metrics
    assert abs(float(other.displacement) - 0.0234) > 1e-4
    right_slope = case(19, "nonlinear").plane.replace(C5=-8.81055e-6)
    m = gr.simulate(right_slope, v0=0.1).metrics()
    assert float(m.displacement) == pytest.approx(0.27414, abs=5e-6)
    assert float(np.degrees(m.rotation)) == pytest.approx(-1.2834, abs=5e-5)


# --- errata: what they claim ---


def test_errata_are_numbered_and_whole():
    assert list(sources.errata()) == list(range(1, 21))
    for erratum in sources.errata().values():
        for text in (erratum.where, erratum.printed, erratum.right, erratum.evidence):
            assert text.strip() == text
            assert text.endswith(".") or text is erratum.where


def test_no_cell_has_two_errata(cells):
    for cell in cells.values():
        covering = [
            e.number
            for e in sources.errata().values()
            if e.coverage(cell.table, cell.row, cell.quantity)
        ]
        assert len(covering) <= 1
        if covering:
            assert covering[0] in (cell.erratum, cell.see)


def test_every_coverage_meets_cells(cells):
    for erratum in sources.errata().values():
        for cover in erratum.cells:
            for row in cover.right:
                assert any(cover.covers(c.table, c.row, c.quantity) for c in cells.values()), row


def test_evidence_on_the_tire():
    data = TireData.load("goodyear-6.00-6")
    program = gr.Aircraft.load("brott")
    printed = program.replace(C5=-8.81055e-6)
    fit = cases.tire_fit()
    assert force_rms(data, printed) == pytest.approx(27, abs=0.5)  # 1
    assert force_rms(data, program) == pytest.approx(932, abs=0.5)
    assert normalised_rms(fit.table, printed) == pytest.approx(0.0131, abs=5e-5)  # 5
    assert fit.rms == pytest.approx(0.0107, abs=5e-5)
    quality = compare(data, {"printed": printed})["printed"]
    assert math.degrees(quality.peak_slip_angle) == pytest.approx(25, abs=1)
    assert math.degrees(quality.reversal) == pytest.approx(70, abs=2)
    slope = math.prod(float(program[s]) for s in ("B1", "C1", "D1"))
    assert slope == pytest.approx(0.9245, abs=5e-5)  # 4
    stiffness = program.replace(C_alpha=None, f=0.867)["C_alpha"]
    assert math.radians(float(stiffness)) == pytest.approx(441.63, abs=5e-3)  # 19


def test_evidence_on_the_straight_lines():
    fit, pounds = cases.tire_fit(), cases.tire_fit_in_pounds()
    assert np.array_equal(np.round(pounds.table.forces), fit.table.forces)
    assert np.array_equal(np.round(pounds.table.loads), fit.table.loads)
    assert math.radians(pounds.parameters["B3"]) == pytest.approx(0.2117, abs=1e-9)
    assert pounds.parameters["B5"] == pytest.approx(0.7221, abs=1e-9)
    assert math.radians(pounds.parameters["C3"]) == pytest.approx(-2.2781e-5, abs=1e-9)
    assert pounds.parameters["C5"] == pytest.approx(-1.1016e-5, abs=1e-9)


def test_evidence_of_the_signs():
    """Erratum 2: with Cf < 0 most trials are unstable, and none is as printed."""
    unstable = []
    for number in sources.trials():
        plane = case(number, "linear").plane
        names = ("m", "Izz", "a", "b", "u", "rho", "Ap", "CL_gamma", "Ct")
        arguments = {s: plane[s] for s in names} | {"C_alpha": -plane["C_alpha"]}
        A = elementwise("state_matrix", arguments)
        found = np.linalg.eigvals([[A["A_vv"], A["A_vr"]], [A["A_rv"], A["A_rr"]]])
        if found.real.max() > 0:
            unstable.append(number)
        as_printed = case(number, "linear").linearization.eigenvalues
        assert np.abs(found[:, None] - as_printed).max() > 1
    assert unstable == [*range(1, 17), 19]


def test_evidence_on_the_settling_times():
    run = case(5, "linear").run
    outside = np.abs(run["y"] / case(5, "linear").metrics.displacement - 1) > 0.05
    last_exit = run.t[np.flatnonzero(~outside[:-1] & outside[1:])[-1] + 1]
    assert last_exit == pytest.approx(2.52, abs=0.011)


def test_evidence_on_figures_and_text():
    assert case(13, "nonlinear").run["alpha"][400] == pytest.approx(0.219, abs=5e-4)  # 13
    offsets = {n: case(n, "linear").run["Y"][-1] for n in (5, 17, 19)}
    assert offsets == pytest.approx({5: 0.46, 17: 0.15, 19: -0.90}, abs=5e-3)  # 14
    moved = [float(case(n, "linear").metrics.displacement) for n in (5, 7)]
    fixed = case(7, "linear").plane.replace(a=-0.5 + 3.2 * 0.0254)
    left = float(gr.simulate(fixed, "linear", v0=0.1).metrics().displacement)
    assert [*moved, left] == pytest.approx([4.32e-3, 4.23e-3, 4.34e-3], abs=5e-6)  # 15
    window = gr.speed_window(case(13, "linear").plane)
    assert (window.low, window.high * 3.6) == pytest.approx((0, 173), abs=0.5)  # 16
    assert all(case(n, "linear").linearization.decay_rate > 0 for n in range(17, 23))
    linear, nonlinear = (case(17, m).metrics for m in ("linear", "nonlinear"))
    assert nonlinear.displacement / linear.displacement - 1 == pytest.approx(-0.05, abs=5e-3)  # 17
    assert nonlinear.rotation / linear.rotation - 1 == pytest.approx(0.31, abs=5e-3)
    run = case(13, "linear").run  # notes of Figures 4.17 and 4.18
    assert run["y"][400] == pytest.approx(17.4, abs=0.05)
    assert np.interp(10, run["y"], run.t) == pytest.approx(3.7, abs=0.05)
    assert np.interp(10, -np.degrees(run["theta"]), run.t) == pytest.approx(2.4, abs=0.05)


# --- figures ---


def test_every_figure_with_data_is_there():
    assert list(sources.figures()) == FIGURES
    sections = {section.number for section in sources.sections()}
    assert {spec.section for spec in sources.figures().values()} <= sections


@pytest.mark.parametrize("number", FIGURES)
def test_figure_is_labelled_and_nothing_is_cut_off(number):
    spec = sources.figures()[number]
    figure = figures.draw(spec)
    FigureCanvasAgg(figure).draw()
    box = figure.get_tightbbox()
    width, height = figure.get_size_inches()
    assert 0 <= box.x0 <= box.x1 <= width
    assert 0 <= box.y0 <= box.y1 <= height
    for axis in figure.axes:
        assert axis.get_lines()
        for label in (axis.get_xlabel(), axis.get_ylabel()):
            assert label
            dimensionless = any(w in label for w in ("normalised", "ratio", "friction"))
            assert ("(" in label) != dimensionless
    assert figure.get_suptitle().startswith(f"Figure {number} ")


def test_figures_show_both_models_where_the_thesis_does():
    for number in range(29, 41):
        spec = sources.figures()[f"4.{number}"]
        assert spec.options["models"] == ["nonlinear", "linear"]
        lines = [s for s in figures.draw(spec).axes[0].get_lines() if len(s.get_xdata()) > 1]
        assert len(lines) == 2 * len(spec.options["trials"])


def test_unstable_runs_leave_the_frame_at_a_mark():
    axis = figures.draw(sources.figures()["4.17"]).axes[0]
    run = case(13, "linear").run
    top = axis.get_ylim()[1]
    marks = [s for s in axis.get_lines() if s.get_marker() == "^"]
    assert [s.get_ydata()[0] for s in marks] == [top]
    assert marks[0].get_xdata()[0] == pytest.approx(np.interp(top, run["y"], run.t), abs=2e-3)


def test_svg_is_well_formed_titled_and_the_same_each_time():
    spec = sources.figures()["4.39"]
    text = figures.svg(spec)
    assert text == figures.svg(spec)
    root = ElementTree.fromstring(text)
    assert root.find("{http://www.w3.org/2000/svg}title").text == f"Figure 4.39: {spec.caption}"
    ids = [e.get("id") for e in root.iter() if e.get("id")]
    assert len(ids) == len(set(ids))
    assert all(i.startswith("f4-39-") for i in ids)


# --- files ---


def test_everything_is_written(done):
    summary, _ = done
    names = {str(p.relative_to(summary.folder)) for p in summary.folder.rglob("*") if p.is_file()}
    drawings = {study.file_name(n) for n in FIGURES} | set(sources.placement_captions())
    figures = {f"figures/{name}.svg" for name in drawings}
    assert names == {"report.html", "ledger.json", "ledger.csv", "tables.md", *figures}
    assert (summary.agrees, summary.explained, summary.differs) == (363, 10, 0)
    assert summary.figures == len(FIGURES) == 44
    assert "363 agree" in str(summary)
    assert str(summary.report) in str(summary)


def test_progress_is_told(done):
    _, steps = done
    total = len(steps)
    assert steps == [(k, total) for k in range(1, total + 1)]
    assert total == len(TABLES) + len(FIGURES) + 10 + 2 * 7 + len(sources.placement_captions()) + 1


def test_ledger_holds_every_cell(done, cells):
    data = json.loads(done[0].ledger.read_text("utf-8"))
    assert data["counts"] == {"agrees": 363, "explained": 10, "differs": 0}
    assert len(data["rows"]) == len(cells)
    for row, cell in zip(data["rows"], cells.values(), strict=True):
        assert {"table", "trial", "quantity", "printed", "computed", "verdict", "erratum"} <= set(
            row
        )
        assert row["verdict"] == cell.verdict
        assert (row["erratum"] is not None) == (row["verdict"] == "explained")
        if row["computed"] is None:
            assert row["as_printed"] == "N/A"
        else:
            assert row["computed"] == pytest.approx(cell.computed, rel=1e-7, abs=1e-11)
    with (done[0].folder / "ledger.csv").open(encoding="utf-8", newline="") as file:
        assert len(list(csv.DictReader(file))) == len(cells)


def test_tables_for_people(done):
    text = (done[0].folder / "tables.md").read_text("utf-8")
    assert all(f"## Table {n}: " in text for n in TABLES)
    assert text.count("✓") == 363 + 1
    assert "| 5 | -1.6868 / -1.68677 ✓ |" in text
    assert "2.2531 / 2.76218 E10" in text


class Page(HTMLParser):
    def __init__(self, text: str) -> None:
        super().__init__()
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.tags.append((tag, dict(attrs)))


def test_report_needs_nothing_else(done):
    text = done[0].report.read_text("utf-8")
    page = Page(text)
    used = {tag for tag, _ in page.tags}
    assert not used & {"script", "link", "img", "iframe", "object", "embed", "base"}
    ids = [a["id"] for _, a in page.tags if "id" in a]
    assert len(ids) == len(set(ids))
    for _, attributes in page.tags:
        assert "src" not in attributes
        for key in ("href", "xlink:href"):
            if key in attributes:
                assert attributes[key].startswith("#")
                assert attributes[key][1:] in ids
        for value in attributes.values():
            assert "url(" not in (value or "") or "url(#" in value
    style = text[text.index("<style>") : text.index("</style>")]
    assert "url(" not in style
    assert "@import" not in style


def test_report_holds_everything(done):
    text = done[0].report.read_text("utf-8")
    page = Page(text)
    ids = {a["id"] for _, a in page.tags if "id" in a}
    assert {f"figure-{n}" for n in FIGURES} | {f"table-{n}" for n in TABLES} <= ids
    assert {f"erratum-{n}" for n in sources.errata()} | {"provenance"} <= ids
    pictures = len(FIGURES) + len(sources.placement_captions())
    assert sum(tag == "svg" for tag, _ in page.tags) == pictures
    assert text.count('<td class="value') == 373
    assert DIGEST in text
    assert '(<a href="#erratum-3">erratum 3</a>)' in text
    assert "&lt;" not in text
    assert str(done[0].folder) not in text


@pytest.mark.parametrize(
    ("printed", "computed", "shown"),
    [
        ("2.2531", 2.762180, "2.76218"),
        ("3.92176", 3.92176, "3.921760"),
        ("281", 280.512, "280.5"),
        ("-8.81055e-6", -1.1031558e-5, "-1.10316e-5"),
        ("0.000", 1e-17, "0"),
        ("N/A", 0.64, "0.6"),
        ("N/A", None, "—"),
    ],
)
def test_computed_values_are_shown_like_the_print(cells, printed, computed, shown):
    cell = dataclasses.replace(next(iter(cells.values())), as_printed=printed, computed=computed)
    assert report.computed_text(cell) == shown


@pytest.mark.parametrize("at", [1, len(TABLES) + 2, None], ids=["table", "figure", "report"])
def test_an_interrupted_study_leaves_nothing(done, tmp_path, at, monkeypatch):
    drawing = (done[0].folder / "figures" / "figure-3-03.svg").read_text("utf-8")
    monkeypatch.setattr(figures, "svg", lambda spec: drawing)

    def interrupt(step: int, total: int | None) -> None:
        if step == (at or total):
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        study.run(tmp_path / "out", interrupt)
    assert not (tmp_path / "out").exists()

    kept = tmp_path / "kept"
    kept.mkdir()
    for name in ("report.html", "ledger.json", "notes.txt"):
        (kept / name).write_text("earlier")
    with pytest.raises(KeyboardInterrupt):
        study.run(kept, interrupt)
    assert {p.name: p.read_text() for p in kept.iterdir()} == dict.fromkeys(
        ("report.html", "ledger.json", "notes.txt"), "earlier"
    )


def test_moving_files_that_fails_does_not_look_whole(tmp_path, monkeypatch):
    target = tmp_path / "out"
    target.mkdir()
    (target / "last").write_text("earlier")
    move, moved = os.replace, []

    def breaks(source, destination):
        if moved:
            raise OSError(28, "No space left on device")
        moved.append(destination)
        move(source, destination)

    def write() -> None:
        with output.whole(target, ["last"]) as scratch:
            for name in ("a", "b", "last"):
                (scratch / name).write_text("new")

    monkeypatch.setattr(os, "replace", breaks)
    with pytest.raises(gr.GroundrollError, match="No space left"):
        write()
    assert [p.name for p in target.iterdir()] == ["a"]


def test_other_files_in_the_folder_are_left_alone(tmp_path):
    (tmp_path / "mine.txt").write_text("mine")
    with output.whole(tmp_path, ["last"]) as scratch:
        (scratch / "deep").mkdir()
        (scratch / "deep" / "a").write_text("a")
        (scratch / "last").write_text("b")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["deep", "last", "mine.txt"]


def test_a_folder_that_cannot_be_written_is_named(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(gr.GroundrollError, match=r"cannot write the study to .*file"):
        study.run(tmp_path / "file" / "out")


def test_the_bytes_do_not_depend_on_the_process(done):
    program = (
        "import hashlib, sys; from groundroll.study import figures, ledger, report, sources\n"
        "cells = ledger.ledger(['4.1', '4.9'])\n"
        "drawing = figures.svg(sources.figures()['4.30'])\n"
        "print(hashlib.sha256((drawing + report.as_csv(cells)).encode()).hexdigest())"
    )
    seen = {
        subprocess.run(
            [sys.executable, "-c", program],
            env={**os.environ, "PYTHONHASHSEED": seed},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for seed in ("1", "2")
    }
    assert len(seen) == 1
    drawing = (done[0].folder / "figures" / "figure-4-30.svg").read_text("utf-8")
    assert drawing == figures.svg(sources.figures()["4.30"])


def test_data_files_are_packaged():
    folder = Path(str(resources.files("groundroll.study")))
    assert {p.suffix for p in (folder / "data").iterdir()} == {".csv", ".toml"}
    assert (folder / "report.html.j2").is_file()
    assert (folder / "report.css").is_file()
