#!/usr/bin/python3
"""Prints a PNG of COLUMNS x 2 ROWS pixels as half blocks.

    half_blocks.py FILE COLUMNS ROWS
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "e2e"))
from pictures import read_png  # noqa: E402

columns, rows = int(sys.argv[2]), int(sys.argv[3])
width, height, pixels = read_png(Path(sys.argv[1]).read_bytes())
assert (width, height) == (columns, 2 * rows), (width, height)
for row in range(rows):
    line = ""
    for column in range(columns):
        upper = pixels[2 * row * width + column]
        lower = pixels[(2 * row + 1) * width + column]
        line += "\x1b[38;2;%d;%d;%d;48;2;%d;%d;%dm▄" % (*lower, *upper)
    print(line + "\x1b[m")
