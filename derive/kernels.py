"""Which kernels are emitted for speed, from which functions."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from types import ModuleType

import casadi as ca

from .catalogue import Module
from .model import Model
from .simd.ensemble import ensemble_kernel
from .simd.model import read_model
from .simd.sweep import can_sweep, sweep_kernels
from .simd.trajectory import trajectory_kernel

#: Module whose functions are applied to millions of points.
_SWEPT = "stability"


@dataclass(frozen=True)
class Kernel:
    """Emitted integrators of some states of a model: of many trajectories, and of a single one."""

    name: str
    model: str
    states: tuple[str, ...]
    ensemble: str
    trajectory: str


@dataclass(frozen=True)
class SweepKernels:
    """Emitted closed forms: name of the C file, the functions in it, and its text."""

    name: str
    functions: tuple[str, ...]
    text: str


def integration_kernels(
    derived: Iterable[Module], package: Mapping[str, ModuleType]
) -> Iterator[Kernel]:
    """For each model kernels of the thesis's states, of all but the path, and of everything."""
    for model in (module.model for module in derived if module.model is not None):
        rhs, outputs = package[model.name].rhs(), package[model.name].outputs()
        every = range(len(model.states))
        body = _in_body_axes(model)
        for name, keep in (
            ("least", _distinct(model, body)),
            ("body", body),
            ("path", every),
        ):
            read = read_model(rhs, outputs, keep)
            yield Kernel(
                name=f"{model.name}_{name}",
                model=model.name,
                states=tuple(str(model.states[j]) for j in read.states),
                ensemble=ensemble_kernel(read),
                trajectory=trajectory_kernel(read),
            )


def _in_body_axes(model: Model) -> list[int]:
    """The states whose rates need nothing but the motion in body axes."""
    beyond = set(model.states) - set(model.dynamic)
    return [k for k, rate in enumerate(model.rates) if not rate.free_symbols & beyond]


def _distinct(model: Model, states: list[int]) -> list[int]:
    """The states but those that move as an earlier one does (psi as theta)."""
    return [k for k in states if model.rates[k] not in [model.rates[j] for j in states if j < k]]


def stability_sweep(derived: Iterable[Module], package: Mapping[str, ModuleType]) -> SweepKernels:
    """The closed forms of the linear model that a kernel can be emitted for."""
    module = next(module for module in derived if module.name == _SWEPT)
    functions: list[ca.Function] = []
    for function in (getattr(package[_SWEPT], spec.name)() for spec in module.functions):
        if can_sweep(function):
            functions.append(function)
    names = tuple(function.name() for function in functions)
    return SweepKernels(f"{_SWEPT}_sweep", names, sweep_kernels(functions))
