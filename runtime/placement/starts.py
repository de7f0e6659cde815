"""Where the solver starts."""

from __future__ import annotations

from .case import Case


def begin(case: Case) -> list[dict[str, float]]:
    """Designs to start from: today's, and a spread over the box with the stablest first."""
    from scipy.stats import qmc

    count = 5 if len(case.variables) == 1 else 9
    spread = qmc.Halton(len(case.variables), scramble=False).random(count + 1)[1:]
    designs = [
        case.design(
            {v.symbol: v.low + x * (v.high - v.low) for v, x in zip(case.variables, z, strict=True)}
        )
        for z in spread
    ]
    inside = all(v.low <= case.today[v.symbol] <= v.high for v in case.variables)
    if inside:
        designs.append(dict(case.today))
    middle = {s: axis.values.mean() for s, axis in case.axes.items()}
    designs.sort(key=lambda d: -float(case.values(d, middle)["decay_rate"]))
    # each start of a simulated objective costs many runs
    return designs[:3] if _simulates(case) else designs


def _simulates(case: Case) -> bool:
    return case.objective == "displacement" or any(b.limit == "displacement" for b in case.bounds)
