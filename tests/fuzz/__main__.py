"""Doses of inputs from the command line; the package says how it is called."""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
from pathlib import Path

from .dose import SURFACES, dose
from .harness import BAD, attempt


def main() -> int:
    parser = argparse.ArgumentParser(prog="fuzz", description=__doc__)
    parser.add_argument("--dose", type=int, default=100_000, help="inputs of each surface")
    parser.add_argument("--seed", type=int, default=int.from_bytes(os.urandom(3), "big"))
    parser.add_argument("--only", choices=SURFACES, action="append")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--input", help="one input again: surface:seed:number")
    asked = parser.parse_args()
    if asked.input:
        surface, seed, number = asked.input.split(":")
        with tempfile.TemporaryDirectory() as folder:
            tally = attempt(surface, SURFACES[surface], int(seed), int(number), Path(folder))
        print(*tally.bad, tally, sep="\n")
        return bool(tally.bad)
    print(f"seed {asked.seed}", flush=True)
    is_bad = False
    for surface in asked.only or SURFACES:
        tally = dose(surface, asked.seed, asked.dose, asked.jobs)
        print(f"{surface}: {tally}", flush=True)
        is_bad |= any(tally.counts[verdict] for verdict in BAD)
    return int(is_bad)


if __name__ == "__main__":
    sys.exit(main())
