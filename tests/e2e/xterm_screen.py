"""A real xterm under Xvfb, in the bitmap font 9x18, in which half blocks and
quadrants are drawn pixel for pixel."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

from pictures import read_ppm

FONT = "-misc-fixed-medium-r-normal--18-*-*-*-*-*-iso10646-1"
FONT_FILES = "/usr/share/fonts/X11/misc"
CELL = (9, 18)
PATIENCE = 60  # Seconds for what must happen, on a busy machine.


def missing():
    """What this needs and does not find."""
    for program in ("xterm", "Xvfb", "import", "convert"):
        if not shutil.which(program):
            return program
    if not list(Path(FONT_FILES).glob("9x18.pcf*")):
        return "the font 9x18 (xfonts-base)"
    return None


def need():
    """Ends the test with status 77 (skipped, for ctest) where it cannot run."""
    if missing():
        print(f"skipped: there is no {missing()}")
        sys.exit(77)


class Screen:
    """An X server without a display, on a number that was free.

    `grid` is the size of its one terminal in cells.
    """

    def __init__(self, grid):
        self.grid = grid
        self.size = (grid[0] * CELL[0], grid[1] * CELL[1])
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0",
             "%dx%dx24" % self.size, "-nolisten", "tcp"],
            pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as pipe:
            display = ":" + pipe.readline().strip()
        if display == ":":
            raise RuntimeError("Xvfb does not start")
        self.environment = dict(os.environ, DISPLAY=display, LC_ALL="C.UTF-8")
        self.environment.pop("NO_COLOR", None)

    def close(self):
        self.server.terminate()
        self.server.wait(PATIENCE)

    def start(self, command, folder=None):
        """An xterm that runs a command: the process."""
        return subprocess.Popen(
            ["xterm", "-b", "0", "-bw", "0", "+sb", "-u8", "-geometry",
             "%dx%d+0+0" % self.grid, "-fn", FONT, "-bg", "black", "-fg",
             "gray90", "-e", *command],
            env=self.environment, cwd=folder, stderr=subprocess.PIPE)

    def picture(self):
        """(width, height, pixels) of the screen."""
        shot = subprocess.run(
            ["import", "-window", "root", "ppm:-"], env=self.environment,
            stdout=subprocess.PIPE, check=True, timeout=PATIENCE)
        plain = subprocess.run(
            ["convert", "ppm:-", "-depth", "8", "-compress", "none", "ppm:-"],
            input=shot.stdout, stdout=subprocess.PIPE, check=True,
            timeout=PATIENCE)
        return read_ppm(plain.stdout)
