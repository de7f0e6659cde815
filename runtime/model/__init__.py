"""A model as data: its pack, the names in it, its functions applied to arrays."""
