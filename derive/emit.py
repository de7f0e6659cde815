"""Everything in `generated/`, as text."""

from __future__ import annotations

import hashlib
import sys
from collections.abc import Iterable, Mapping
from pathlib import Path
from types import ModuleType

import casadi as ca
import sympy as sp

from .c_source import c_source
from .catalogue import Module, all_quantities, modules
from .equation_sheet import equation_sheet
from .kernels import Kernel, SweepKernels, integration_kernels, stability_sweep
from .shipped import integrators

HERE = Path(__file__).resolve().parent
SHIPPED = ("compiler.py", "integrators.py", "kernels.py", "library.py")
_SOURCES = {".py", ".c", ".json"}


#: How every generated file begins, after the sign of a comment.
_MARK = b"Generated from derive/"


def digest() -> str:
    """Digest of the derivation: of every source file in `derive/`."""
    total = hashlib.sha256()
    for path in sorted(p for p in HERE.rglob("*") if p.suffix in _SOURCES):
        total.update(path.relative_to(HERE).as_posix().encode() + b"\0" + path.read_bytes())
    return total.hexdigest()[:16]


def provenance() -> str:
    """One line for the top of each generated file."""
    return (
        f"{_MARK.decode()} (digest {digest()}) with SymPy {sp.__version__} and CasADi"
        f" {ca.CasadiMeta.version()}: do not edit, run `make derive`."
    )


def files() -> dict[str, str]:
    """Text of every generated file by its path within `generated/`."""
    derived = modules()
    header = provenance()
    sources = {f"{module.name}.py": _module_source(module) for module in derived}
    package = _load(sources)
    kernels = tuple(integration_kernels(derived, package))
    sweeps = stability_sweep(derived, package)
    sources["names.py"] = _names_source(derived, kernels, sweeps)
    sources["__init__.py"] = _init_source(derived)
    for name in SHIPPED:
        sources[name] = (HERE / "shipped" / name).read_text()
    texts = {name: f"# {header}\n{text}" for name, text in sources.items()}
    texts["EQUATIONS.md"] = f"<!-- {header} -->\n{equation_sheet(derived)}"
    for name, functions in _compiled(derived, package).items():
        texts[f"c/{name}.c"] = c_source(name, functions, header)
    compiled = {sweeps.name: sweeps.text}
    for kernel in kernels:
        compiled[f"{kernel.name}_ensemble"] = kernel.ensemble
        compiled[f"{kernel.name}_trajectory"] = kernel.trajectory
    for name, text in compiled.items():
        texts[f"c/{name}.c"] = f"/* {header} */\n{text}"
    return texts


def write(folder: Path) -> None:
    """Write every generated file into `folder` and remove what is no longer generated."""
    texts = files()
    for path in sorted(folder.rglob("*")):
        is_wanted = path.relative_to(folder).as_posix() in texts
        if path.is_file() and not is_wanted and _MARK in path.read_bytes()[:200]:
            path.unlink()
    for name, text in texts.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def _module_source(module: Module) -> str:
    head = f'"""{module.summary}"""\n\nfrom functools import cache\n\nimport casadi as ca\n'
    if module.model is not None:
        head += "\nfrom . import integrators\n"
    return "\n\n".join([head, *_blocks(module)])


def _blocks(module: Module) -> Iterable[str]:
    for function in module.functions:
        yield function.source() + "\n"
    if module.model is not None:
        for method in integrators.METHODS:
            yield _integrator_source(module.name, method)


def _integrator_source(model: str, method: str) -> str:
    name = f"{model}_{method}"
    return (
        f"@cache\ndef {method}() -> ca.Function:\n"
        f'    """Integrate the model over an interval: see `integrators.interval`."""\n'
        f'    return integrators.interval(rhs(), "{name}", "{method}")\n'
    )


def _function_table(derived: Iterable[Module]) -> dict[str, tuple[str, str, str]]:
    """CasADi name -> module, builder, C file."""
    table: dict[str, tuple[str, str, str]] = {}
    for module in derived:
        for function in module.functions:
            table[function.casadi_name] = (module.name, function.name, module.name)
        if module.model is not None:
            for method in integrators.METHODS:
                name = f"{module.name}_{method}"
                table[name] = (module.name, method, name)
    return table


def _compiled(
    derived: Iterable[Module], package: Mapping[str, ModuleType]
) -> dict[str, list[ca.Function]]:
    """The functions of each C file."""
    contents: dict[str, list[ca.Function]] = {}
    for module, builder, c_file in _function_table(derived).values():
        function = getattr(package[module], builder)()
        contents.setdefault(c_file, []).extend(integrators.derivatives(function))
    return contents


def _load(sources: Mapping[str, str]) -> dict[str, ModuleType]:
    """Run the Python just generated without installing it."""
    package = "groundroll_freshly_generated"
    sys.modules[package] = ModuleType(package)
    sys.modules[package].integrators = integrators  # type: ignore[attr-defined]
    sys.modules[f"{package}.integrators"] = integrators
    loaded = {}
    for name in (path.removesuffix(".py") for path in sources):
        module = ModuleType(f"{package}.{name}")
        module.__package__ = package
        exec(compile(sources[f"{name}.py"], f"{name}.py", "exec"), module.__dict__)
        loaded[name] = module
    return loaded


def _names_source(
    derived: tuple[Module, ...], kernels: Iterable[Kernel], sweeps: SweepKernels
) -> str:
    lines = [
        '"""Names, units and meanings; signatures of the models; where each function is."""',
        "",
        "from typing import NamedTuple",
        "",
        "",
        "class Quantity(NamedTuple):",
        '    """What a symbol stands for; SI units with radians."""',
        "",
        "    symbol: str",
        "    name: str",
        "    unit: str",
        "    meaning: str",
        "    latex: str",
        "    sign: str",
        "",
        "",
        "class Signature(NamedTuple):",
        '    """Order of the vectors of a model: x\' = f(x, u, p) and y = g(x, u, p)."""',
        "",
        "    states: tuple[str, ...]",
        "    dynamic: tuple[str, ...]",
        "    inputs: tuple[str, ...]",
        "    parameters: tuple[str, ...]",
        "    outputs: tuple[str, ...]",
        "",
        "",
        "class Kernel(NamedTuple):",
        '    """Some states of a model; C files ..._ensemble and ..._trajectory integrate them."""',
        "",
        "    model: str",
        "    states: tuple[str, ...]",
        "",
        "",
        f'DIGEST = "{digest()}"',
        "",
        "QUANTITIES = {",
        "    q.symbol: q",
        "    for q in (",
    ]
    for q in all_quantities(derived):
        values = (q.name, q.full_name, q.unit, q.meaning, q.latex, q.sign)
        fields = ", ".join(map(_quoted, values))
        lines.append(f"        Quantity({fields}),")
    lines += ["    )", "}", "", "MODELS = {"]
    for model in (module.model for module in derived if module.model is not None):
        groups = (model.states, model.dynamic, model.inputs, model.parameters, model.outputs)
        lines.append(f'    "{model.name}": Signature(')
        lines += [f"        ({', '.join(_quoted(str(q)) for q in group)},)," for group in groups]
        lines.append("    ),")
    lines += ["}", "", "#: Name of a function -> module, builder, C file.", "FUNCTIONS = {"]
    for name, entry in _function_table(derived).items():
        lines.append(f"    {_quoted(name)}: ({', '.join(map(_quoted, entry))}),")
    lines += [
        "}",
        "",
        "#: How the names of a kernel's C files begin -> what it carries.",
        "KERNELS = {",
    ]
    for kernel in kernels:
        states = ", ".join(map(_quoted, kernel.states))
        lines.append(f'    "{kernel.name}": Kernel({_quoted(kernel.model)}, ({states},)),')
    lines += [
        "}",
        "",
        "#: Name of a function that has a kernel for many points -> C file.",
        "SWEEPS = {",
    ]
    lines += [f"    {_quoted(name)}: {_quoted(sweeps.name)}," for name in sweeps.functions]
    return "\n".join([*lines, "}", ""])


def _init_source(derived: tuple[Module, ...]) -> str:
    lines = [
        '"""CasADi functions generated from the derivation; see `names.FUNCTIONS` for the list.',
        "",
        "`from groundroll.generated import nonlinear_rk45` gives the compiled function; the",
        "modules (`nonlinear`, `linear`, ...) hold the readable builders.",
        '"""',
        "",
        "import difflib",
        "",
        "import casadi as ca",
        "",
        "from .library import SOURCES, StaleError, build, load",
        "from .names import DIGEST, FUNCTIONS, MODELS, QUANTITIES, Quantity, Signature",
        "",
        "__all__ = [",
        *(f'    "{name}",' for name in _EXPORTED),
        "]",
        "",
        "",
        "def __getattr__(name: str) -> ca.Function:",
        "    if name in FUNCTIONS:",
        "        return load(name)",
        "    near = difflib.get_close_matches(name, FUNCTIONS, n=3)",
        '    hint = f"; did you mean {\' or \'.join(near)}?" if near else ""',
        '    raise AttributeError(f"module {__name__!r} has no attribute {name!r}{hint}")',
        "",
        "",
        "def __dir__() -> list[str]:",
        "    return [*__all__, *FUNCTIONS]",
        "",
    ]
    return "\n".join(lines)


_EXPORTED = (
    *("DIGEST", "FUNCTIONS", "MODELS", "QUANTITIES", "SOURCES"),
    *("Quantity", "Signature", "StaleError", "build", "load"),
)


def _quoted(text: str) -> str:
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'
