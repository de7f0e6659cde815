"""The vocabulary of parts: what a model is put together from."""
