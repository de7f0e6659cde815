"""What every test shares: hypothesis draws the same examples on each run, against no clock."""

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
