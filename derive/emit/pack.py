"""Everything in a pack, as text: sources, C, kernels, equation sheet and facts."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path
from types import ModuleType

import casadi as ca
import sympy as sp

from groundroll.derive.core.model import Derivation

from .c_source import c_source
from .catalogue import Pack
from .equation_sheet import equation_sheet
from .equilibrium_functions import EQUILIBRIUM
from .facts import facts
from .kernels import integration_kernels, points_text, sweep_of
from .module import Module
from .places import places_source
from .shipped import integrators
from .simd.points import function_kernel

#: How every generated file begins, after the sign of a comment.
MARK = "Generated from derive/"


def provenance(digest: str = "") -> str:
    """One line for the top of each generated file."""
    whose = f" (digest {digest})" if digest else ""
    return (
        f"{MARK}{whose} with SymPy {sp.__version__} and CasADi {ca.CasadiMeta.version()}: do not"
        " edit, run `make derive`."
    )


def pack_files(pack: Pack) -> dict[str, str]:
    """Text of every file of a pack by its path within the folder of the pack."""
    header = provenance(pack.digest)
    sources = {f"{module.name}.py": _module_source(pack, module) for module in pack.all_modules}
    modules = _load(sources)
    kernels = integration_kernels(pack.model, modules["model"]) if pack.model else None
    sweep = sweep_of(pack, modules)
    texts = {name: f"# {header}\n{text}" for name, text in sources.items()}
    texts["EQUATIONS.md"] = f"<!-- {header} -->\n{equation_sheet(pack)}"
    for name, functions in _compiled(pack, modules).items():
        texts[f"c/{name}.c"] = c_source(name, functions, header)
    compiled = {} if sweep is None else {sweep.name: sweep.text}
    if kernels is not None:
        compiled["lanes"] = kernels.text
        compiled["points"] = points_text(modules["model"])
    if EQUILIBRIUM in modules:
        compiled["bounds"] = function_kernel(modules[EQUILIBRIUM].bounds())
    for name, text in compiled.items():
        texts[f"c/{name}.c"] = f"/* {header} */\n{text}"
    texts["facts.json"] = facts(pack, header, _function_table(pack), kernels, sweep)
    return texts


def _module_source(pack: Pack, module: Module) -> str:
    head = f'"""{module.summary}"""\n\nfrom functools import cache\n\nimport casadi as ca\n'
    is_model = pack.model is not None and module.name == "model"
    helper = "integrators" if is_model else "intervals" if module.name == EQUILIBRIUM else ""
    if helper:
        head += f"\nfrom groundroll.generated import {helper}\n"
    return "\n\n".join([head, *_blocks(pack, module, is_model)])


def _blocks(pack: Pack, module: Module, is_model: bool) -> Iterator[str]:
    for function in module.functions:
        yield function.source() + "\n"
    if module.name == EQUILIBRIUM:
        yield _bounds_source(pack.name)
    if not is_model or pack.model is None:
        return
    if not module.is_readable:
        yield _jacobians_source(pack.model)
    yield places_source(pack.model)
    for method in integrators.METHODS:
        yield _integrator_source(pack.name, method)


def _bounds_source(model: str) -> str:
    return (
        "@cache\ndef bounds() -> ca.Function:\n"
        '    """Bounds of the moment and its slope over angles: see `intervals.bounds`."""\n'
        f'    return intervals.bounds({model}_equilibrium(), 2, "{model}_bounds")\n'
    )


def _jacobians_source(model: Derivation) -> str:
    groups = {"x": model.states, "u": model.inputs, "p": model.parameters}
    rows = {"f": ("xdot", len(model.states)), "g": ("y", len(model.outputs))}
    lines = [
        '"""Jacobians of states and outputs: see `integrators.jacobians`.',
        "",
        "Inputs",
        "------",
        *(f"{key} : column of {len(group)}" for key, group in groups.items()),
        "",
        "Outputs",
        "-------",
        *(
            f"{of}{by} : {height} x {len(group)}, derivatives of {what} by {by}"
            for of, (what, height) in rows.items()
            for by, group in groups.items()
        ),
        '"""',
        f'return integrators.jacobians(rhs(), outputs(), "{model.name}_jacobians")',
    ]
    body = "\n".join(f"    {line}" if line else "" for line in lines)
    return f"@cache\ndef jacobians() -> ca.Function:\n{body}\n"


def _integrator_source(model: str, method: str) -> str:
    return (
        f"@cache\ndef {method}() -> ca.Function:\n"
        f'    """Integrate the model over an interval: see `integrators.interval`."""\n'
        f'    return integrators.interval(rhs(), "{model}_{method}", "{method}")\n'
    )


def _function_table(pack: Pack) -> dict[str, tuple[str, str, str]]:
    """CasADi name -> module, builder, C file; an empty C file: not compiled."""
    is_readable = pack.all_modules[0].is_readable
    table: dict[str, tuple[str, str, str]] = {}
    for module in pack.all_modules:
        for function in module.functions:
            table[function.casadi_name] = (module.name, function.name, module.name)
        if module.name == EQUILIBRIUM:
            table[f"{pack.name}_bounds"] = (module.name, "bounds", "")
    if pack.model is not None:
        name = pack.name
        # those of a long model stand in C for many points alone
        table[f"{name}_jacobians"] = ("model", "jacobians", "model" if is_readable else "")
        table[f"{name}_places"] = ("model", "places", "")
        for method in integrators.METHODS:
            table[f"{name}_{method}"] = ("model", method, method)
    return table


#: What of a long model has derivatives in C; of a short one, all has.
_DIFFERENTIATED = ("rhs", "outputs")


def _compiled(pack: Pack, modules: Mapping[str, ModuleType]) -> dict[str, list[ca.Function]]:
    """The functions of each C file."""
    contents: dict[str, list[ca.Function]] = {}
    is_readable = pack.all_modules[0].is_readable
    for module, builder, c_file in _function_table(pack).values():
        if c_file:
            function = getattr(modules[module], builder)()
            is_plain = c_file == "model" and not is_readable and builder not in _DIFFERENTIATED
            made = [function] if is_plain else integrators.derivatives(function)
            contents.setdefault(c_file, []).extend(made)
    return contents


def _load(sources: Mapping[str, str]) -> dict[str, ModuleType]:
    """Run the Python just generated without installing it."""
    loaded = {}
    for path, text in sources.items():
        module = ModuleType(path.removesuffix(".py"))
        shipped = integrators.__name__.rpartition(".")[0]
        here = text.replace("from groundroll.generated import", f"from {shipped} import")
        exec(compile(here, path, "exec"), module.__dict__)
        loaded[module.__name__] = module
    return loaded


def write(folder: Path, texts: Mapping[str, str]) -> None:
    """Write generated files into a folder, and remove those that are no longer generated."""
    for path in sorted(folder.rglob("*")):
        is_wanted = path.relative_to(folder).as_posix() in texts
        if path.is_file() and not is_wanted and is_generated(path):
            path.unlink()
    for name, text in texts.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


def is_generated(path: Path) -> bool:
    """Whether a file says of itself that it is generated."""
    return MARK.encode() in path.read_bytes()[:200]
