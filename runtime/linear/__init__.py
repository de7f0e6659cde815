"""Equilibria and small motions about them: points, linear models, trim, responses."""
