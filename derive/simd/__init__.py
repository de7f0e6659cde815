"""From CasADi functions to C kernels that treat many aircraft side by side.

`ensemble` emits integrators, `sweep` emits closed forms. Both start from the instruction lists of
the functions in `generated/`, so no physics is written again.
"""
