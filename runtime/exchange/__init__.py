"""Out of Python: a model with its aircraft for other programs, and a page to play with."""

from .explorer import explore
from .exporting import export

__all__ = ["explore", "export"]
