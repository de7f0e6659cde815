"""The facts of a pack, as data: what a runtime must know of a model without knowing the model."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from typing import Any

from groundroll.derive.core.body import wind_x, wind_y
from groundroll.derive.core.frames import X, Y, Z, phi, psi, r, u, v
from groundroll.derive.core.quantity import Quantity

from .catalogue import Pack
from .kernels import Kernels, SweepKernels
from .shipped.version import FORMAT, VERSION

#: What a state, input or parameter is to whoever draws or judges a motion, whatever the model.
_ROLES = {
    "speed": u,
    "lateral_velocity": v,
    "yaw_rate": r,
    "distance": X,
    "offset": Y,
    "depth": Z,
    "roll": phi,
    "heading": psi,
    "tailwind": wind_x,
    "crosswind": wind_y,
}


def facts(
    pack: Pack,
    provenance: str,
    functions: Mapping[str, tuple[str, str, str]],
    kernels: Kernels | None,
    sweep: SweepKernels | None,
) -> str:
    """Text of ``facts.json``, which begins with its provenance as other generated files do."""
    model = pack.model
    content: dict[str, Any] = {
        "provenance": provenance,
        "format": FORMAT,
        "version": VERSION,
        "name": pack.name,
        "summary": pack.summary,
        "digest": pack.digest,
        "abilities": list(pack.abilities),
        "quantities": {q.name: _quantity(q) for q in pack.quantities},
        "functions": {name: list(entry) for name, entry in functions.items()},
        "sweeps": dict.fromkeys(sweep.functions, sweep.name) if sweep else {},
    }
    if model is not None and kernels is not None:
        named = {q.name for q in (*model.states, *model.parameters, *model.inputs)}
        content |= {
            "states": _names(model.states),
            "dynamic": _names(model.dynamic),
            "inputs": _names(model.inputs),
            "ranges": {q.name: list(q.within) for q in model.inputs if q.within != (None, None)},
            "parameters": _names(model.parameters),
            "outputs": _names(model.outputs),
            "roles": {role: q.name for role, q in _ROLES.items() if q.name in named},
            "places": [[place.name, place.kind] for place in model.places],
            "events": [[e.name, e.quantity.name, e.rising, e.meaning] for e in model.events],
            "carried": [list(each) for each in kernels.carried],
            "seen": [list(each) for each in kernels.seen],
            "stiff": kernels.stiff,
            "over_time": kernels.over_time,
        }
    return _text(content)


def _names(group: Sequence[Quantity]) -> list[str]:
    return [q.name for q in group]


def _quantity(q: Quantity) -> list[str]:
    """Name, unit, meaning, LaTeX, sign and kind."""
    return [q.full_name, q.unit, q.meaning, q.latex, q.sign, q.kind]


def _text(content: Mapping[str, Any]) -> str:
    """JSON with one line for each entry, so that it diffs well."""
    lines = []
    for key, value in content.items():
        if isinstance(value, dict) and value:
            entries = (f"  {json.dumps(k)}: {json.dumps(v)}" for k, v in value.items())
            lines.append(f" {json.dumps(key)}: {{\n" + ",\n".join(entries) + "\n }")
        else:
            lines.append(f" {json.dumps(key)}: {json.dumps(value)}")
    return "{\n" + ",\n".join(lines) + "\n}\n"
