"""Ground stability of light aircraft, from derived equations to compiled integrators.

>>> import groundroll as gr
>>> plane = gr.Aircraft.load("brott")
>>> run = gr.simulate(plane, model="nonlinear", v0=0.1, t=5.0)
>>> lin = gr.linearize(plane, model="linear")

SI units and radians throughout; SAE body axes: x forward, y right, z down.
"""

from __future__ import annotations

from typing import Any

import lazy_loader

_public, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)


def __getattr__(name: str) -> Any:
    if name == "__version__":
        from importlib.metadata import version

        return version(__name__)
    return _public(name)
