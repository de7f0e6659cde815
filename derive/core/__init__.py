"""The language in which a model is written: quantities, equations, a body and its parts."""
