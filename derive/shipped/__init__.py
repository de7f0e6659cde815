"""Support code that `make derive` copies into `generated/` as it stands.

`generated/` must work without `derive/`, so what it needs beside the equations goes along:
integrators built on a right-hand side, the loader of compiled functions, and the kernels for many
aircraft at once.
"""
