"""The models, one file each: a body and a list of parts."""
