"""From derived models to packs: readable CasADi source, C, kernels, equation sheet and facts."""
