"""Models that nobody derived: CasADi expressions turned into kernels, and SciPy beside them."""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
from scipy.integrate import solve_ivp

from groundroll.derive.emit.simd.model import kernel_text, read_model
from groundroll.generated import Pack
from groundroll.generated.packs import Event

Array = np.ndarray[Any, np.dtype[np.float64]]
Expressions = Callable[[list[ca.SX], list[ca.SX], list[ca.SX]], list[ca.SX]]


@dataclass(frozen=True)
class Bare:
    """A model: its kernels, and its functions of (x, u, p)."""

    pack: Pack
    rhs: ca.Function
    outputs: ca.Function

    def exact(
        self,
        x0: Sequence[float],
        p: Sequence[float],
        at: Array,
        inputs: Callable[[float], Sequence[float]] = lambda t: (),
        breaks: Sequence[float] = (),
    ) -> Array:
        """States at ascending times by SciPy, restarted at breaks."""
        slots = [np.zeros(self.rhs.numel_in(k)) for k in range(3)]
        slots[2][:] = p
        result = np.zeros(self.rhs.numel_out(0))
        buffer, evaluate = self.rhs.buffer()
        for k, slot in enumerate(slots):
            buffer.set_arg(k, memoryview(slot))
        buffer.set_res(0, memoryview(result))
        ends = [0.0, *(b for b in breaks if 0 < b < at[-1]), float(at[-1])]
        states, x = np.empty((len(x0), at.size)), np.array(x0, dtype=float)
        for begin, end in pairwise(ends):

            def rate(t: float, x: Array, begin: float = begin, end: float = end) -> Array:
                slots[0][:] = x
                slots[1][:] = inputs(float(np.clip(t, *np.nextafter((begin, end), (end, begin)))))
                evaluate()
                return result.copy()

            here = (begin <= at) & (at <= end)
            when = np.union1d(at[here], [end])
            run = solve_ivp(rate, (begin, end), x, "DOP853", when, rtol=1e-13, atol=1e-16)
            assert run.success
            states[:, here], x = run.y[:, : here.sum()], run.y[:, -1]
        return states


def bare(
    folder: Path,
    rates: Expressions,
    sizes: tuple[int, int, int],
    seen: Expressions | None = None,
    events: Sequence[Event] = (),
    stiff: bool = False,
) -> Bare:
    """A model of so many states, inputs and parameters: x0, x1, ...; u0, ...; p0, ...; y0, ...."""
    vectors = [ca.SX.sym(name, size) for name, size in zip("xup", sizes, strict=True)]
    lists = [ca.vertsplit(v) if v.numel() else [] for v in vectors]
    rhs = ca.Function("rhs", vectors, [ca.vertcat(*rates(*lists))])
    shown = seen(*lists) if seen else [lists[0][0]]
    outputs = ca.Function("outputs", vectors, [ca.vertcat(*shown)])
    read = read_model(rhs, outputs)
    text = kernel_text(read)
    digest = hashlib.sha256(text.encode()).hexdigest()[:16]
    (folder / "c").mkdir(parents=True)
    (folder / "c" / "lanes.c").write_text(f"/* {digest} */\n{text}")
    names = [[f"{name}{k}" for k in range(size)] for name, size in zip("xup", sizes, strict=True)]
    y = [f"y{k}" for k in range(len(shown))]
    pack = Pack(
        folder=folder,
        name="bare",
        summary="",
        digest=digest,
        abilities=(),
        quantities={},
        functions={},
        sweeps={},
        states=tuple(names[0]),
        dynamic=tuple(names[0]),
        inputs=tuple(names[1]),
        parameters=tuple(names[2]),
        outputs=tuple(y),
        events=tuple(events),
        carried=tuple(tuple(names[0][j] for j in each.states) for each in read.carried),
        seen=tuple(tuple(y[j] for j in each.outputs) for each in read.carried),
    )
    return Bare(pack, rhs, outputs)
