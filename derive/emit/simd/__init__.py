"""From CasADi functions to C kernels that fill the lanes of a processor.

`ensemble` emits integrators of many trajectories side by side, `trajectory` those of a single one,
`sweep` closed forms at many points. All start from the instruction lists of the functions in
`generated/` (`sums`, `graph`), so no physics is written again.
"""
