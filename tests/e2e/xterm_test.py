#!/usr/bin/python3
"""A real terminal shows what the program decodes: xterm, in a screenshot.

xterm draws half blocks and quadrants pixel for pixel in the bitmap font 9x18.
Ends with status 77 (skipped, for ctest) where xterm, Xvfb, ImageMagick or the
font is missing.
"""

import os
import shlex
import time
import unittest
from pathlib import Path

import xterm_screen
from pictures import png, read_png
from program import ProgramTest
from xterm_screen import CELL, PATIENCE, Screen

GRID = (40, 20)
SIZE = (GRID[0] * CELL[0], GRID[1] * CELL[1])

xterm_screen.need()


def show(screen, ansi, shown):
    """(width, height, pixels) of an xterm that shows a file's text.

    `shown` is a file that says when the terminal has drawn it all.
    """
    # The terminal answers the cursor report when it has drawn what came
    # before; the cursor is hidden, and so is whatever is typed.
    script = ("stty -echo -icanon min 1; printf '\\033[?25l';"
              "head -c -1 %s; printf '\\033[6n'; head -c 6 >/dev/null;"
              "touch %s; exec sleep %d" % (
                  shlex.quote(str(ansi)), shlex.quote(str(shown)), PATIENCE))
    terminal = screen.start(["sh", "-c", script])
    try:
        wait(terminal, shown)
        return screen.picture()
    finally:
        terminal.terminate()
        terminal.communicate(timeout=PATIENCE)


def wait(terminal, shown):
    deadline = time.monotonic() + PATIENCE
    while not shown.exists():
        if terminal.poll() is not None:
            raise RuntimeError(terminal.stderr.read().decode())
        if time.monotonic() > deadline:
            raise RuntimeError("xterm does not draw")
        time.sleep(0.05)


def differences(shown, decoded):
    """The pixels that xterm drew in another color than was decoded.

    The font is 9 pixels wide: it gives the column in the middle of a cell to
    one side of a vertical edge, where the decoder takes the mean of both.
    """
    width = SIZE[0]
    different = []
    for at, (one, other) in enumerate(zip(shown, decoded)):
        if at % width % CELL[0] == CELL[0] // 2:
            if one not in (shown[at - 1], shown[at + 1]):
                different.append((at % width, at // width, one, other))
        elif one != other:
            different.append((at % width, at // width, one, other))
    return different


def picture(x, y):
    """Slopes in every color, and edges in every direction."""
    return ((x * 5 + y) % 256, (y * 6 + x * x // 40) % 256,
            (x * y // 9) % 256)


class XtermTest(ProgramTest):

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.screen = Screen(GRID)
        cls.addClassCleanup(cls.screen.close)

    def compare(self, *args):
        """xterm's pixels and the decoded ones, after comparing them."""
        # As many samples as two half blocks of quadrants take.
        self.write("in.png", png(2 * GRID[0], 2 * GRID[1], picture))
        base = ["encode", "--input=in.png", "--grid=%dx%d" % GRID,
                "--fit=stretch", *args]
        self.succeed(*base, "--output=cells.ansi")
        self.succeed(*base, "--cell=%dx%d" % CELL, "--output=decoded.png")
        width, height, shown = show(self.screen,
                                    self.folder / "cells.ansi",
                                    self.folder / "shown")
        keep = os.environ.get("RTBENCH_SCREENSHOTS")
        if keep:
            name = "_".join(a.strip("-").replace("=", "_") for a in args)
            Path(keep, name + ".png").write_bytes(
                png(width, height, lambda x, y: shown[y * width + x]))
        self.assertEqual((width, height), SIZE)
        *size, decoded = read_png((self.folder / "decoded.png").read_bytes())
        self.assertEqual(tuple(size), SIZE)
        self.assertGreater(len(set(shown)), 7)
        self.assertEqual(differences(shown, decoded)[:9], [])
        return shown, decoded

    def test_truecolor_quadrants(self):
        self.compare("--encoder=quadrant")

    def test_truecolor_half_blocks_pixel_for_pixel(self):
        shown, decoded = self.compare("--encoder=half")
        # 18 rows halve exactly, and all colors come through.
        self.assertEqual(shown, decoded)

    def test_256_colors(self):
        self.compare("--encoder=quadrant", "--color=256")

    def test_16_colors(self):
        self.compare("--encoder=quadrant", "--color=16")


if __name__ == "__main__":
    unittest.main()
