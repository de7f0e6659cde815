"""Motion over time: one engine of compiled kernels behind everything that integrates."""

import lazy_loader

__getattr__, __dir__, __all__ = lazy_loader.attach(__name__, submodules=["gusts", "signals"])
