"""Which kernels are emitted for speed, from which functions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import ModuleType

from groundroll.derive.core.frames import u
from groundroll.derive.core.model import Derivation

from .catalogue import Pack
from .simd.model import kernel_text, read_model
from .simd.points import points_kernel
from .simd.sweep import can_sweep, sweep_kernels


@dataclass(frozen=True)
class Kernels:
    """Emitted integrators of a model.

    Attributes
    ----------
    carried : tuple of tuple of str
        The sets of states that they can carry, the smallest first.
    seen : tuple of tuple of str
        For each set the outputs that need no other state.
    stiff : bool
        Whether the model can come to rest, where friction is stiff.
    over_time : bool
        Whether they know inputs over time only.
    text : str
        C of all of them.
    """

    carried: tuple[tuple[str, ...], ...]
    seen: tuple[tuple[str, ...], ...]
    stiff: bool
    over_time: bool
    text: str


@dataclass(frozen=True)
class SweepKernels:
    """Emitted closed forms: name of the C file, the functions in it, and its text."""

    name: str
    functions: tuple[str, ...]
    text: str


def integration_kernels(model: Derivation, module: ModuleType) -> Kernels:
    """Kernels of the states in body axes, of those that differ among them, and of everything."""
    body = _in_body_axes(model)
    offered = (_distinct(model, body), body)
    read = read_model(module.rhs(), module.outputs(), offered, stiff=u in model.states)
    return Kernels(
        carried=tuple(tuple(str(model.states[j]) for j in each.states) for each in read.carried),
        seen=tuple(tuple(str(model.outputs[j]) for j in each.outputs) for each in read.carried),
        stiff=read.stiff,
        over_time=read.is_large,
        text=kernel_text(read),
    )


def _in_body_axes(model: Derivation) -> list[int]:
    """The states whose rates need nothing but the motion in body axes."""
    beyond = set(model.states) - set(model.dynamic)
    return [k for k, rate in enumerate(model.rates) if not rate.free_symbols & beyond]


def _distinct(model: Derivation, states: list[int]) -> list[int]:
    """The states but those that move as an earlier one does (psi as theta)."""
    return [k for k in states if model.rates[k] not in [model.rates[j] for j in states if j < k]]


def points_text(module: ModuleType) -> str:
    """The kernel of a model and its Jacobians at many points."""
    return points_kernel(module.rhs(), module.outputs())


def sweep_of(pack: Pack, modules: Mapping[str, ModuleType]) -> SweepKernels | None:
    """The closed forms of a pack that a kernel can be emitted for."""
    if not pack.swept:
        return None
    module = next(module for module in pack.modules if module.name == pack.swept)
    every = [getattr(modules[pack.swept], spec.name)() for spec in module.functions]
    functions = [function for function in every if can_sweep(function)]
    names = tuple(function.name() for function in functions)
    return SweepKernels(f"{pack.swept}_sweep", names, sweep_kernels(functions))
