"""Tires as people have them: a size and a pressure, measured forces, a `.tir` file."""
