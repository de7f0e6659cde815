"""Closed forms over arrays: margins, sweeps, maps, and what `check` says."""
