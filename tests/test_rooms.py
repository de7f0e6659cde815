"""Three rooms, one direction of travel: derive writes generated, runtime imports generated."""

import ast
import importlib
import subprocess
import sys
from collections.abc import Iterator
from graphlib import CycleError, TopologicalSorter
from itertools import chain
from pathlib import Path

import pytest

import groundroll
from groundroll import derive, generated
from groundroll.model.names import QUANTITIES
from groundroll.results import doors

ROOMS = {
    "groundroll.derive": Path(derive.__file__).parent,
    "groundroll.generated": Path(generated.__file__).parent,
    "groundroll": Path(groundroll.__file__).parent,
}


def sources(room: str) -> dict[str, Path]:
    """Name of each module in a room, and its file."""
    folder = ROOMS[room]
    found = {}
    for path in sorted(folder.rglob("*.py")):
        parts = path.relative_to(folder).with_suffix("").parts
        found[".".join([room, *parts]).removesuffix(".__init__")] = path
    return found


MODULES = {name: path for room in ROOMS for name, path in sources(room).items()}
RUNTIME = sources("groundroll")


def imports(module: str) -> Iterator[str]:
    """Full names of what a module imports, wherever in it the import stands."""
    path = MODULES[module]
    package = module if path.name == "__init__.py" else module.rpartition(".")[0]
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        if isinstance(node, ast.ImportFrom):
            above = package.split(".")[: len(package.split(".")) - node.level + 1]
            home = ".".join([*above, node.module or ""]).strip(".") if node.level else node.module
            yield from (f"{home}.{alias.name}" for alias in node.names)


def importing(modules: dict[str, Path], *forbidden: str) -> list[str]:
    """Who imports what it must not."""
    return [
        f"{module} imports {name}"
        for module in modules
        for name in imports(module)
        if any(f"{name}.".startswith(f"{other}.") for other in forbidden)
    ]


def test_every_room_has_modules():
    assert {
        "groundroll.derive.core.frames",
        "groundroll.generated.nonlinear.model",
    } < MODULES.keys()
    assert "groundroll.runs.simulation" in RUNTIME
    assert not any(
        name.startswith(("groundroll.derive", "groundroll.generated")) for name in RUNTIME
    )


def test_derive_never_imports_runtime():
    assert importing(sources("groundroll.derive"), *RUNTIME.keys() - {"groundroll"}) == []


def test_runtime_never_imports_derive_or_sympy():
    """But for one door: the command that derives a model of the user's own."""
    others = {name: path for name, path in RUNTIME.items() if name != "groundroll.cli.derive"}
    assert len(others) == len(RUNTIME) - 1
    assert importing(others, "sympy", "groundroll.derive") == []


def test_generated_imports_only_casadi_numpy_and_the_standard_library():
    allowed = {"casadi", "numpy", *sys.stdlib_module_names}
    strangers = [
        f"{module} imports {name}"
        for module in sources("groundroll.generated")
        for name in imports(module)
        if name.split(".")[0] not in allowed and not name.startswith("groundroll.generated")
    ]
    assert strangers == []


def test_a_forbidden_import_would_be_seen(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    path = tmp_path / "intruder.py"
    path.write_text("def f():\n    from .derive import units\n    import sympy.physics as p\n")
    monkeypatch.setitem(MODULES, "groundroll.intruder", path)
    seen = importing({"groundroll.intruder": path}, "sympy", "groundroll.derive")
    assert seen == [
        "groundroll.intruder imports groundroll.derive.units",
        "groundroll.intruder imports sympy.physics",
    ]


def loaded_after(statement: str) -> set[str]:
    """Top-level names and groundroll's subpackages in a fresh interpreter's `sys.modules`."""
    script = f"{statement}\nimport sys\nprint(*sys.modules)"
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    return set(run.stdout.split())


def test_import_groundroll_loads_nothing_heavy():
    loaded = loaded_after("import groundroll")
    assert "groundroll" in loaded
    assert not loaded & {"sympy", "groundroll.derive", "matplotlib", "pydantic"}


def test_nothing_in_runtime_or_generated_loads_sympy():
    names = [n for n in chain(RUNTIME, sources("groundroll.generated")) if "__main__" not in n]
    loaded = loaded_after(f"import importlib\nfor n in {names}: importlib.import_module(n)")
    assert set(names) <= loaded
    assert not [
        name
        for name in loaded
        if name.split(".")[0] == "sympy" or name.startswith("groundroll.derive")
    ]


# --- Rooms of the runtime -------------------------------------------------------------------

#: In this order: a room imports only rooms before it.
ORDER = (
    "base",
    "model",
    "tires",
    "aircraft",
    "results",
    "motion",
    "stability",
    "linear",
    "runs",
    "view",
    "fates",
    "placement",
    "control",
    "study",
    "exchange",
    "cli",
)


def needed(module: str) -> set[str]:
    """Modules of the runtime that a module imports, early or late, but not for types alone."""
    path = MODULES[module]
    package = module if path.name == "__init__.py" else module.rpartition(".")[0]
    tree = ast.parse(path.read_text())
    for node in ast.walk(tree):
        if isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING":
            node.body = []
    found = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom):
            home = node.module or ""
            if node.level:
                above = package.split(".")[: len(package.split(".")) - node.level + 1]
                home = ".".join([*above, home]).strip(".")
            each = [f"{home}.{alias.name}" for alias in node.names]
            found |= {name if name in RUNTIME else home for name in each}
    return found & RUNTIME.keys() - {module, "groundroll"}


def room(module: str) -> str:
    return module.split(".")[1]


INSIDE = {name: needed(name) for name in RUNTIME if name.count(".") > 1}


def test_each_room_imports_only_rooms_before_it():
    assert {room(name) for name in INSIDE} == set(ORDER)
    backwards = [
        f"{name} imports {other}"
        for name, others in INSIDE.items()
        for other in others
        if ORDER.index(room(other)) > ORDER.index(room(name))
    ]
    assert backwards == []


def test_no_module_imports_itself_in_a_circle():
    """Neither when it is loaded nor inside functions."""
    assert list(TopologicalSorter(INSIDE).static_order())
    with pytest.raises(CycleError):
        TopologicalSorter({**INSIDE, "groundroll.base.errors": {"groundroll.base.units"}}).prepare()


def test_what_results_open_late_is_there():
    for places in (doors.KINDS, doors.PICTURES):
        for place in places.values():
            module, _, name = place.rpartition(".")
            assert hasattr(importlib.import_module(f"groundroll.{module}"), name)


# --- Runtime holds no formula ---------------------------------------------------------------

UNITS = {name: q.unit for q in QUANTITIES.values() for name in (q.symbol, q.name)}


def quantity(node: ast.expr) -> str:
    """The quantity that `plane["m"]`, `plane.mass` or `state.v` stands for, if any."""
    if isinstance(node, ast.Attribute) and node.attr in UNITS:
        return node.attr
    if isinstance(node, ast.Subscript) and isinstance(node.slice, ast.Constant):
        return node.slice.value if node.slice.value in UNITS else ""
    return ""


def is_formula(node: ast.AST) -> bool:
    """Arithmetic between two different quantities of the model, but for a mere proportion."""
    if not isinstance(node, ast.BinOp):
        return False
    left, right = quantity(node.left), quantity(node.right)
    proportion = isinstance(node.op, ast.Div) and UNITS.get(left) == UNITS.get(right)
    return bool(left and right and left != right and not proportion)


def formulas(text: str) -> set[str]:
    return {ast.unparse(node) for node in ast.walk(ast.parse(text)) if is_formula(node)}


@pytest.mark.parametrize("module", RUNTIME)
def test_runtime_holds_no_formula(module: str):
    """What joins two quantities of the model belongs in derive, and comes out of generated."""
    assert formulas(RUNTIME[module].read_text()) == set()


def test_a_formula_would_be_seen():
    weight, wheelbase = 'load = plane["m"] * plane["g"] / 2', "arm = plane.main_gear_arm + plane.b"
    harmless = 'gap = 100 * (run["v"] - lin["v"])\nshape = plane.a / plane.b'
    seen = formulas("\n".join([weight, wheelbase, harmless]))
    assert seen == {"plane['m'] * plane['g']", "plane.main_gear_arm + plane.b"}
