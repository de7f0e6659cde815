"""What the numbers of a study come from; no dates and no paths, so that they compare."""

from __future__ import annotations

import platform
from importlib.metadata import version

from groundroll.model.names import DIGEST

from .sources import digest, setup

_PACKAGES = ("groundroll", "casadi", "numpy", "matplotlib")


def provenance() -> dict[str, str]:
    """Digests and versions by name."""
    return {
        "equations": f"derive/ digest {DIGEST}",
        "study data": f"digest {digest()}",
        "aircraft": setup().aircraft,
        "python": platform.python_version(),
        **{name: version(name) for name in _PACKAGES},
    }
