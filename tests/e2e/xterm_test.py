#!/usr/bin/python3
"""A real terminal shows what the program decodes: xterm, in a screenshot.

xterm draws half blocks and quadrants pixel for pixel in the bitmap font 9x18.
Ends with status 77 (skipped, for ctest) where xterm, Xvfb, ImageMagick or the
font is missing.
"""

import os
import shlex
import shutil
import subprocess
import sys
import time
import unittest
from pathlib import Path

from pictures import png, read_png, read_ppm
from program import ProgramTest

FONT = "-misc-fixed-medium-r-normal--18-*-*-*-*-*-iso10646-1"
FONT_FILES = "/usr/share/fonts/X11/misc"
CELL = (9, 18)
GRID = (40, 20)
SIZE = (GRID[0] * CELL[0], GRID[1] * CELL[1])
TIMEOUT = 60


def missing():
    """What this test needs and does not find."""
    for program in ("xterm", "Xvfb", "import", "convert"):
        if not shutil.which(program):
            return program
    if not list(Path(FONT_FILES).glob("9x18.pcf*")):
        return "the font 9x18 (xfonts-base)"
    return None


if missing():
    print(f"skipped: there is no {missing()}")
    sys.exit(77)


class Screen:
    """An X server without a display, on a number that was free."""

    def __init__(self):
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0",
             "%dx%dx24" % SIZE, "-nolisten", "tcp"],
            pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as pipe:
            self.display = ":" + pipe.readline().strip()
        if self.display == ":":
            raise RuntimeError("Xvfb does not start")
        self.environment = dict(os.environ, DISPLAY=self.display,
                                LC_ALL="C.UTF-8")

    def close(self):
        self.server.terminate()
        self.server.wait(TIMEOUT)

    def show(self, ansi, shown):
        """(width, height, pixels) of an xterm that shows a file's text.

        `shown` is a file that says when the terminal has drawn it all.
        """
        # The terminal answers the cursor report when it has drawn what came
        # before; the cursor is hidden, and so is whatever is typed.
        script = ("stty -echo -icanon min 1; printf '\\033[?25l';"
                  "head -c -1 %s; printf '\\033[6n'; head -c 6 >/dev/null;"
                  "touch %s; exec sleep %d" % (
                      shlex.quote(str(ansi)), shlex.quote(str(shown)),
                      TIMEOUT))
        options = ["-b", "0", "-bw", "0", "+sb", "-u8", "-geometry",
                   "%dx%d+0+0" % GRID, "-fn", FONT, "-bg", "black", "-fg",
                   "gray90"]
        terminal = subprocess.Popen(
            ["xterm", *options, "-e", "sh", "-c", script],
            env=self.environment, stderr=subprocess.PIPE)
        try:
            self.wait(terminal, shown)
            return self.picture()
        finally:
            terminal.terminate()
            terminal.communicate(timeout=TIMEOUT)

    @staticmethod
    def wait(terminal, shown):
        deadline = time.monotonic() + TIMEOUT
        while not shown.exists():
            if terminal.poll() is not None:
                raise RuntimeError(terminal.stderr.read().decode())
            if time.monotonic() > deadline:
                raise RuntimeError("xterm does not draw")
            time.sleep(0.05)

    def picture(self):
        shot = subprocess.run(
            ["import", "-window", "root", "ppm:-"], env=self.environment,
            stdout=subprocess.PIPE, check=True, timeout=TIMEOUT)
        plain = subprocess.run(
            ["convert", "ppm:-", "-depth", "8", "-compress", "none", "ppm:-"],
            input=shot.stdout, stdout=subprocess.PIPE, check=True,
            timeout=TIMEOUT)
        return read_ppm(plain.stdout)


def cell_means(width, pixels):
    """The mean color of each cell, row by row."""
    area = CELL[0] * CELL[1]
    means = []
    for row in range(GRID[1]):
        for column in range(GRID[0]):
            sums = [0, 0, 0]
            for y in range(row * CELL[1], (row + 1) * CELL[1]):
                begin = y * width + column * CELL[0]
                for pixel in pixels[begin:begin + CELL[0]]:
                    sums = [s + c for s, c in zip(sums, pixel)]
            means.append(tuple(s / area for s in sums))
    return means


def picture(x, y):
    """Slopes in every color, and edges in every direction."""
    return ((x * 5 + y) % 256, (y * 6 + x * x // 40) % 256,
            (x * y // 9) % 256)


class XtermTest(ProgramTest):

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.screen = Screen()
        cls.addClassCleanup(cls.screen.close)

    def compare(self, *args):
        """xterm's cells against the decoded ones, in 1/255."""
        # As many samples as two half blocks of quadrants take.
        self.write("in.png", png(2 * GRID[0], 2 * GRID[1], picture))
        base = ["encode", "--input=in.png", "--grid=%dx%d" % GRID,
                "--fit=stretch", *args]
        self.succeed(*base, "--output=cells.ansi")
        self.succeed(*base, "--cell=%dx%d" % CELL, "--output=decoded.png")
        width, height, shown = self.screen.show(self.folder / "cells.ansi",
                                                self.folder / "shown")
        keep = os.environ.get("RTBENCH_SCREENSHOTS")
        if keep:
            name = "_".join(a.strip("-").replace("=", "_") for a in args)
            Path(keep, name + ".png").write_bytes(
                png(width, height, lambda x, y: shown[y * width + x]))
        self.assertEqual((width, height), SIZE)
        size = read_png((self.folder / "decoded.png").read_bytes())
        self.assertEqual(size[:2], SIZE)
        self.assertGreater(len(set(shown)), 7)
        worst = max(abs(a - b)
                    for one, other in zip(cell_means(width, shown),
                                          cell_means(width, size[2]))
                    for a, b in zip(one, other))
        self.assertLessEqual(worst, 2)
        return shown, size[2]

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
