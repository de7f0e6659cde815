"""What every test shares: hypothesis draws the same examples on each run, against no clock."""

import sys
from collections.abc import Iterator

import pytest
from hypothesis import Phase, settings

settings.register_profile(
    "groundroll",
    derandomize=True,
    database=None,
    deadline=None,
    max_examples=25,
    phases=(Phase.explicit, Phase.generate, Phase.shrink),
)
settings.load_profile("groundroll")


@pytest.fixture(autouse=True)
def closed_figures() -> Iterator[None]:
    """What one test draws is closed before the next: that another has many open is no fault."""
    yield
    if pyplot := sys.modules.get("matplotlib.pyplot"):
        pyplot.close("all")
