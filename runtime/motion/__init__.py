"""Motion over time: one engine of compiled kernels behind everything that integrates."""
