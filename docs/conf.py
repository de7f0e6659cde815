"""Sphinx configuration: `make docs` builds with warnings as errors."""

project = "groundloop"
author = "The groundloop authors"
copyright = author
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinx.ext.mathjax"]
myst_enable_extensions = ["dollarmath"]
html_theme = "furo"
html_title = "groundloop"
autodoc_typehints = "none"  # the docstrings say more: unit, shape, sign
autodoc_member_order = "bysource"
napoleon_google_docstring = False
napoleon_use_ivar = True
exclude_patterns = ["_build", "examples"]
