"""A model with its aircraft for other programs, a page to play with, aircraft of others."""

from .explorer import explore
from .exporting import export
from .importing import import_aircraft

__all__ = ["explore", "export", "import_aircraft"]
