"""Cell grids in the compact form of the page.

Planes of one byte a cell: the glyph's number (low, then high), then red,
green and blue of the foreground and of the background, colors as differences
to the cell on the left; then deflated and in base64.
"""

import base64
import functools
import gzip
import json
import zlib

import numpy

from report.errors import BadInput

FULL_BLOCK = "\u2588"


def read(file):
    """{"columns", "rows", "cells"} of a .cells.json.gz or .json."""
    try:
        data = file.read_bytes()
        if data[:2] == b"\x1f\x8b":
            data = gzip.decompress(data)
        grid = json.loads(data)
        if len(grid["cells"]) != grid["columns"] * grid["rows"]:
            raise ValueError(f"{len(grid['cells'])} cells")
        return grid
    except (OSError, EOFError, zlib.error, ValueError, KeyError,
            TypeError) as error:
        raise BadInput(f"{file}: not a cell grid: {error}") from error


@functools.lru_cache(maxsize=1 << 16)
def color(text):
    return int(text[1:3], 16), int(text[3:5], 16), int(text[5:7], 16)


def canonical(glyph, foreground, background):
    """A color that does not count becomes the other."""
    if glyph in (" ", "\u00a0"):
        return glyph, background, background
    if glyph == FULL_BLOCK:
        return glyph, foreground, foreground
    return glyph, foreground, background


class Alphabet:
    """The characters of all grids of a page, numbered."""

    def __init__(self):
        self.numbers = {}

    def number(self, character):
        return self.numbers.setdefault(character, len(self.numbers))

    def characters(self):
        return list(self.numbers)


def pack(grid, alphabet):
    """Base64 text of the planes."""
    columns, rows = grid["columns"], grid["rows"]
    cells = [canonical(*cell) for cell in grid["cells"]]
    numbers = numpy.array([alphabet.number(c[0]) for c in cells], "<u2")
    planes = [numbers & 255, numbers >> 8]
    for side in (1, 2):
        colors = numpy.array([color(c[side]) for c in cells], numpy.uint8)
        for channel in colors.reshape(rows, columns, 3).transpose(2, 0, 1):
            left = numpy.zeros_like(channel)
            left[:, 1:] = channel[:, :-1]
            planes.append((channel - left).ravel())
    data = b"".join(plane.astype(numpy.uint8).tobytes() for plane in planes)
    return base64.b64encode(zlib.compress(data, 9)).decode("ascii")
