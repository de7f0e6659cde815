"""What users ask of the motion: runs, ensembles, solvers, metrics."""
