"""generated/ is what derive/ makes, byte for byte, and works without a compiler or a cache."""

import ast
import os
import re
import shutil
import subprocess
import sys
from functools import cache
from pathlib import Path

import casadi as ca
import numpy as np
import pytest
import sympy as sp
from every import NAMES, OF_MODELS, OF_SCALARS, case
from hypothesis import given, settings
from hypothesis import strategies as st
from oracles import MODELS, Array, values

from groundroll import derive, generated
from groundroll.derive import __main__ as command
from groundroll.derive.emit.c_source import c_source
from groundroll.derive.emit.casadi_source import CasadiPrinter
from groundroll.derive.emit.pack import write
from groundroll.derive.emit.tree import files
from groundroll.generated import PACKS, library, pack_of
from groundroll.model.names import FUNCTIONS

FOLDER = Path(generated.__file__).parent
SOURCES = (".py", ".c", ".md", ".json")
FILES = sorted(p.relative_to(FOLDER).as_posix() for p in FOLDER.rglob("*") if p.suffix in SOURCES)


@cache
def fresh() -> dict[str, str]:
    return files()


# --- The text -------------------------------------------------------------------------------


def test_no_file_is_missing_and_none_is_left_over():
    assert sorted(fresh()) == FILES, "run `make derive`"


@pytest.mark.parametrize("name", FILES)
def test_generated_is_what_derive_makes(name: str):
    assert (FOLDER / name).read_text() == fresh()[name], f"{name} is stale: run `make derive`"


def test_no_docstring_folder_or_hash_seed_changes_a_byte_of_it(tmp_path: Path):
    """Equations are what counts: another docstring everywhere in derive/, and all comes out alike.

    But for what derive/ ships as it stands.
    """
    home, out = tmp_path / "groundroll", tmp_path / "out"
    shutil.copytree(Path(derive.__file__).parent, home / "derive")
    (home / "__init__.py").touch()
    changed = 0
    for path in (home / "derive").rglob("*.py"):
        if path.parent.name == "shipped":
            continue
        tree = ast.parse(path.read_text())
        for node in ast.walk(tree):
            is_documented = isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef)
            if is_documented and ast.get_docstring(node):
                node.body[0] = ast.Expr(ast.Constant("Something else."))
                changed += 1
        path.write_text(ast.unparse(ast.fix_missing_locations(tree)))
    assert changed > 200
    script = "import sys; from groundroll.derive import __main__ as m; print(m.__file__); m.main()"
    told = subprocess.run(
        [sys.executable, "-c", script, "--out", str(out)],
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(tmp_path), "PYTHONHASHSEED": "4321"},
        check=True,
        capture_output=True,
        text=True,
    )
    assert told.stdout.startswith(str(home))
    texts = {p.relative_to(out).as_posix(): p.read_text() for p in out.rglob("*") if p.is_file()}
    assert sorted(texts) == sorted(fresh())
    assert [name for name, text in fresh().items() if texts[name] != text] == []


@pytest.mark.parametrize("name", FILES)
def test_it_says_where_it_comes_from(name: str):
    lines = (FOLDER / name).read_text().splitlines()
    first = lines[name.endswith(".json")]  # after the brace
    pack = PACKS.get(name.split("/")[0])
    digest = f" (digest {pack.digest})" if pack else ""
    assert f"Generated from derive/{digest} with" in first
    assert f"SymPy {sp.__version__} and CasADi {ca.CasadiMeta.version()}" in first
    assert "run `make derive`" in first


@pytest.mark.parametrize("name", FILES)
def test_it_holds_no_date_and_no_path(name: str):
    text = (FOLDER / name).read_text()
    dates = re.findall(r"\b20\d\d-\d\d-\d\d\b|\b\d\d:\d\d:\d\d\b|__DATE__|__TIME__", text)
    places = [str(place) for place in (FOLDER.parent, Path.home()) if place != Path("/")]
    assert (dates, [place for place in places if place in text]) == ([], [])


def test_the_check_prints_the_difference_and_the_command(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
):
    monkeypatch.setattr(command, "files", fresh)
    write(tmp_path, fresh())
    assert command.check(tmp_path) == 0
    stability = tmp_path / "linear" / "stability.py"
    stability.write_text(stability.read_text().replace("2*C_alpha", "3*C_alpha"))
    assert command.check(tmp_path) == 1
    printed = capsys.readouterr()
    assert "-    C_f = 3*C_alpha" in printed.out
    assert "+    C_f = 2*C_alpha" in printed.out
    assert "linear/stability.py: not what derive/ makes; run `make derive`" in printed.err


def test_writing_removes_what_is_no_longer_generated(tmp_path: Path):
    write(tmp_path, fresh())
    left = [
        tmp_path / "aircraft" / "c" / "unicycle.c",
        *(tmp_path / "unicycle" / name for name in ("model.py", "facts.json", "EQUATIONS.md")),
    ]
    left[1].parent.mkdir()
    sources = ("aircraft/c/tire.c", "linear/model.py", "linear/facts.json", "linear/EQUATIONS.md")
    for path, source in zip(left, sources, strict=True):
        path.write_text(fresh()[source])
    write(tmp_path, fresh())
    assert [path for path in left if path.exists()] == []


def test_writing_leaves_alone_what_was_never_generated(tmp_path: Path):
    notes = tmp_path / "thesis" / "notes.txt"
    notes.parent.mkdir()
    notes.write_text("mine")
    write(tmp_path, fresh())
    assert notes.exists()


# --- The printer ----------------------------------------------------------------------------

x, y = sp.symbols("x y", real=True)


@pytest.mark.parametrize(
    "expr",
    [
        *(sp.cot(x), sp.asinh(x), sp.erf(x), sp.Heaviside(x), sp.floor(x)),
        *(sp.gamma(x), sp.Function("f")(x), sp.Mod(x, y), sp.re(sp.Symbol("z"))),
        *(x**y, sp.cbrt(x), 2**x, x ** sp.Rational(3, 2)),
        *(sp.oo, sp.nan, sp.zoo, sp.Derivative(sp.Function("f")(x), x), sp.Integral(x, x)),
        *(sp.Matrix([x]), sp.Eq(x, y), x > y, sp.Piecewise((x, x > 0))),
    ],
    ids=str,
)
def test_what_is_not_on_the_list_is_refused(expr: sp.Basic):
    """SymPy's own printers fall back to names that CasADi does not know, or to NaN."""
    with pytest.raises(NotImplementedError):
        CasadiPrinter().doprint(expr)


@pytest.mark.parametrize("expr", [sp.pi * x, sp.E * x, sp.I * x, sp.Sum(x, (y, 1, 3))], ids=str)
def test_what_sympy_prints_by_itself_is_refused(expr: sp.Expr):
    with pytest.raises(NotImplementedError):
        CasadiPrinter().doprint(expr)


def test_the_refusal_names_what_there_is():
    with pytest.raises(
        NotImplementedError, match=r"floor has no CasADi operation; there are .*asin, atan"
    ):
        CasadiPrinter().doprint(sp.floor(x))


def run(expr: sp.Expr, at: tuple[float, float]) -> float:
    symbols = {"ca": ca, "x": ca.SX.sym("x"), "y": ca.SX.sym("y")}
    value = eval(CasadiPrinter().doprint(expr), symbols)
    return float(ca.Function("f", [symbols["x"], symbols["y"]], [value])(*at))


@pytest.mark.parametrize(
    "expr",
    [
        *(x - y, -(x - y), x - (y - 1), 2 * x / 3, -x / 2, -(x**2), (-x) ** 2, (x + y) ** 3),
        *(x / y, x / (y / 3), 1 / (x * y), x / (x + y), 1 / (x + y) ** 2, y / x**2, 3 / (x * y)),
        *(-1 / (2 * x), -1 / (x - y), sp.Rational(-3, 4) * x / y**2, x * (y + 1) / (x - 3)),
        *(sp.sqrt(x), 1 / sp.sqrt(x + y), y / sp.sqrt(x), -x * sp.sqrt(y), sp.sqrt(2) * x),
        *(sp.sin(x) * sp.cos(y), sp.tan(x) ** 2, sp.atan(x / y), sp.exp(-x), sp.log(x + y)),
        *(sp.Abs(x - y), -sp.Abs(x - 9) ** 3, sp.Max(x, y), sp.Min(x, y) * sp.Max(x, 1)),
        *(sp.Max(x, y, 1), sp.Min(x, 2, y, x * y), sp.sign(x - y), sp.tanh(x), sp.atan2(x, -y)),
        *(sp.asin(x / 3), sp.acos(y / 3), sp.sinh(x), sp.cosh(y)),
        *(sp.Integer(3) + 0 * x, sp.Rational(1, 3), sp.Float("0.1") * x),
    ],
    ids=str,
)  # fmt: skip
def test_what_is_printed_is_what_was_meant(expr: sp.Expr):
    for at in ((0.7, 1.9), (2.3, 0.4)):
        expected = float(expr.subs({x: at[0], y: at[1]}))
        assert run(expr, at) == pytest.approx(expected, rel=1e-14)


@pytest.mark.parametrize(
    "expr",
    [
        sp.Piecewise((x, x > y), (y, True)),
        sp.Piecewise((x, x > 1), (y, x <= 0), (x * y, True)),
        sp.Piecewise((x, x > 1), (sp.nan, True)),
    ],
    ids=str,
)
def test_piecewise_is_printed(expr: sp.Expr):
    for at in ((0.7, 1.9), (2.3, 0.4), (-1.0, 3.0)):
        expected = float(expr.subs({x: at[0], y: at[1]}))
        assert run(expr, at) == pytest.approx(expected, nan_ok=True)


# --- The C ----------------------------------------------------------------------------------


@pytest.mark.parametrize("name", [name for name in FILES if name.endswith(".c")])
def test_c_is_complete(name: str):
    assert "#error" not in (FOLDER / name).read_text()


def test_c_that_casadi_cannot_generate_is_an_error(capfd: pytest.CaptureFixture[str]):
    """CasADi itself warns, and leaves `#error` in the text."""
    t = ca.SX.sym("t")
    cvodes = ca.integrator("decay", "cvodes", {"x": t, "ode": -t}, 0.0, 1.0)
    with pytest.raises(NotImplementedError, match="CasADi cannot generate C for all of decay"):
        c_source("decay", [cvodes], "")


def test_every_function_is_in_the_c_file_that_the_table_names():
    compiled = [(p, n, c) for p in PACKS.values() for n, (*_, c) in p.functions.items() if c]
    assert len(compiled) > 30
    for pack, name, c_file in compiled:
        assert f"CASADI_SYMBOL_EXPORT int {name}(" in (pack.sources / f"{c_file}.c").read_text()


# --- The equation sheet ---------------------------------------------------------------------

SHEETS = {name: (pack.folder / "EQUATIONS.md").read_text() for name, pack in PACKS.items()}
SHEET = "\n".join(SHEETS.values())


@pytest.mark.parametrize("name", MODELS)
def test_the_sheet_has_every_equation_of_a_model_with_its_number(name: str):
    for equation in MODELS[name].chain:
        row = f"${equation.lhs.latex} = {sp.latex(equation.rhs)}$ | {equation.source} |"
        assert row in SHEETS[name]


@pytest.mark.parametrize(
    "number",
    [
        *("3.1", "3.2", "3.3", "3.5", "3.6", "3.8", "3.9", "3.10", "3.11"),
        *("4.7", "4.8", "4.9", "4.14", "4.19", "4.20", "4.21", "4.24", "4.26"),
        *("4.28", "4.29", "4.30", "4.31", "4.38"),
    ],
)
def test_the_sheet_can_be_followed_by_number(number: str):
    assert f"| Eq. {number} |" in SHEET


def test_the_sheet_has_what_the_thesis_does_not_print():
    for closed_form in (r"\operatorname{tr} A", r"\det A", r"u_{\mathrm{low}}", r"\zeta"):
        assert f"| ${closed_form} = " in SHEET


def test_tables_of_the_sheet_are_whole():
    """A bar inside a cell would open another."""
    for table in re.findall(r"(?:^\|.*\|\n)+", SHEET, re.MULTILINE):
        head, *rows = (line.count("|") for line in table.splitlines())
        assert [n for n in rows if n != head] == [], table


# --- The builders ---------------------------------------------------------------------------


def assert_same_function(builder: ca.Function, compiled: ca.Function, point: list[Array]) -> None:
    signature = f"{compiled.name_in()} -> {compiled.name_out()}"
    assert signature == f"{builder.name_in()} -> {builder.name_out()}"
    assert [builder.size_in(n) for n in range(builder.n_in())] == [(x.size, 1) for x in point]
    pairs = zip(builder.call(point), compiled.call(point), strict=True)
    for interpreted, native in pairs:
        size = np.abs(np.array(interpreted)).max(initial=1.0)
        np.testing.assert_allclose(native, interpreted, rtol=1e-14, atol=1e-14 * size)


@pytest.mark.parametrize("name", OF_SCALARS)
@settings(max_examples=10)
@given(data=st.data())
def test_compiled_functions_give_the_numbers_of_their_builders(name: str, data: st.DataObject):
    builder = generated.build(name)
    point = [data.draw(values([argument])) for argument in builder.name_in()]
    assert_same_function(builder, generated.load(name), point)


@pytest.mark.parametrize("function", OF_MODELS)
@pytest.mark.parametrize("name", NAMES)
def test_compiled_models_give_the_numbers_of_their_builders(name: str, function: str):
    model = case(name)
    builder, compiled = model.pack.expression(function), model.pack.function(function)
    for point in model.some(3, seed=5):
        arguments = [*point, np.array([1e-2])][: builder.n_in()]
        assert_same_function(builder, compiled, arguments)


def docstrings() -> dict[str, str]:
    """By CasADi name, of the builders that are generated from equations."""
    found = {}
    for name, (module, builder, _) in FUNCTIONS.items():
        tree = ast.parse((pack_of(name).folder / f"{module}.py").read_text())
        functions = [node for node in tree.body if isinstance(node, ast.FunctionDef)]
        doc = next(ast.get_docstring(f) for f in functions if f.name == builder)
        # where it is said once for all models
        if not re.search(r": see `(integrators|intervals)\.", doc):
            found[name] = doc
    return found


@pytest.mark.parametrize(("name", "doc"), docstrings().items())
def test_docstrings_state_the_shapes(name: str, doc: str):
    function = generated.build(name)
    summary, inputs, outputs, *_ = re.split(r"\n\s*\w+\n\s*-+\n", doc)
    assert summary.strip().endswith(".")
    stated = re.findall(r"^\s*(\w+) : (?:scalar|column of (\d+))", inputs, re.MULTILINE)
    assert [(n, int(size or 1)) for n, size in stated] == [
        (n, function.size1_in(n)) for n in function.name_in()
    ]
    stated = re.findall(r"^\s*(\w+) : (\d+) x (\d+), \S", outputs, re.MULTILINE)
    assert [(n, (int(rows), int(columns))) for n, rows, columns in stated] == [
        (n, function.size_out(n)) for n in function.name_out()
    ]


@pytest.mark.parametrize("name", [name for name in FILES if name.endswith(".py")])
def test_generated_python_is_ordinary(name: str):
    """It parses, and every function in it has a docstring, but for the module's hooks."""
    tree = ast.parse((FOLDER / name).read_text())
    assert ast.get_docstring(tree)
    functions = [node for node in tree.body if isinstance(node, ast.FunctionDef)]
    public = [f for f in functions if not f.name.startswith("_")]
    assert [f.name for f in public if not ast.get_docstring(f)] == []


# --- Functions by name ------------------------------------------------------------------


def test_stale_c_is_refused(tmp_path: Path):
    old, pack = tmp_path / "tire.c", PACKS["aircraft"]
    text = (pack.sources / "tire.c").read_text()
    old.write_text(text.replace(pack.digest, "0123456789abcdef"))
    with pytest.raises(generated.StaleError, match=r"tire\.c .*run `make derive`"):
        library.compiled(old, pack.digest, symbol="magic_formula")


@pytest.mark.parametrize("get", [generated.load, generated.build])
def test_an_unknown_function_is_an_error_that_names_the_nearest(get):
    with pytest.raises(KeyError, match=r"no generated function 'nonlinear_rk54'; .*nonlinear_rk45"):
        get("nonlinear_rk54")


def test_functions_are_attributes():
    assert generated.nonlinear_rk45 is generated.load("nonlinear_rk45")
    assert set(FUNCTIONS) < set(dir(generated))
    with pytest.raises(AttributeError, match="nonlinear_rk54"):
        _ = generated.nonlinear_rk54


def test_a_misspelt_function_is_answered_with_the_nearest():
    with pytest.raises(AttributeError, match=r"did you mean .*nonlinear_rk45"):
        generated.nonlinear_rk54  # noqa: B018
