"""Sphinx configuration: ./braidx shell sphinx-build -W docs docs/_build"""

project = "braidx"
author = "the braidx authors"
copyright = author
extensions = ["myst_parser"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 3
exclude_patterns = ["_build"]
html_theme = "alabaster"
html_theme_options = {
    "description": "Mechanics of braided and twisted ropes",
    "page_width": "1100px",
}
