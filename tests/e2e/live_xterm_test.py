#!/usr/bin/python3
"""The live mode in a real xterm under Xvfb: its screen shows, pixel for pixel,
what the program has sent.

Ends with status 77 (skipped, for ctest) where xterm, Xvfb, ImageMagick or the
font is missing.
"""

import json
import re
import time
import unittest

import xterm_screen
from program import ProgramTest
from xterm_screen import CELL, Screen

GRID = (40, 16)
PICTURE_ROWS = GRID[1] - 1  # The last row is the status line.
TIMEOUT = 120

PIECE = re.compile(r"\x1b\[(\d+);(\d+)H|\x1b\[([\d;]*)m|\x1b\[2J|(.)", re.S)


xterm_screen.need()


def replay(text):
    """{(column, row): (glyph, foreground, background)} of what was sent."""
    cells, colors = {}, {"38": None, "48": None}
    column = row = 0
    for match in PIECE.finditer(text):
        if match.group(1):
            row, column = int(match.group(1)) - 1, int(match.group(2)) - 1
        elif match.group(3):
            numbers = match.group(3).split(";")
            for at in range(0, len(numbers), 5):
                assert numbers[at + 1] == "2", match.group(0)
                colors[numbers[at]] = tuple(map(int, numbers[at + 2:at + 5]))
        elif match.group(4):
            cells[column, row] = (match.group(4), colors["38"], colors["48"])
            column += 1
    return cells


def pixel(cell, y):
    """The color of a pixel row of a cell with a half block."""
    glyph, fg, bg = cell
    upper = y < CELL[1] // 2
    covered = {" ": False, "█": True, "▀": upper, "▄": not upper}[glyph]
    return fg if covered else bg


class LiveXtermTest(ProgramTest):

    def test_the_screen_shows_what_was_sent(self):
        screen = Screen(GRID)
        self.addCleanup(screen.close)
        terminal = screen.start(
            [str(self.program), "live", "--scene=whitted", "--encoder=half",
             "--record=a.cast"], self.folder)
        self.addCleanup(terminal.communicate, timeout=TIMEOUT)
        self.addCleanup(terminal.terminate)
        cells = self.wait_until_still(terminal)
        width, height, shown = screen.picture()
        self.assertEqual((width, height), screen.size)
        wrong = []
        for y in range(PICTURE_ROWS * CELL[1]):
            for x in range(width):
                cell = cells[x // CELL[0], y // CELL[1]]
                wanted = pixel(cell, y % CELL[1])
                if shown[y * width + x] != wanted:
                    wrong.append((x, y, shown[y * width + x], wanted))
        self.assertGreater(len({cell[1] for cell in cells.values()}), 20)
        self.assertEqual(wrong[:9], [])

    def wait_until_still(self, terminal):
        """The picture's cells when they have not changed for a while."""
        end = time.monotonic() + TIMEOUT
        last, since = None, time.monotonic()
        while time.monotonic() < end:
            if terminal.poll() is not None:
                raise AssertionError(terminal.stderr.read().decode())
            cells = self.recorded()
            if cells != last or len(cells) < GRID[0] * PICTURE_ROWS:
                last, since = cells, time.monotonic()
            elif time.monotonic() - since > 2:
                return cells
            time.sleep(0.3)
        raise AssertionError("the picture is never finished")

    def recorded(self):
        cast = self.folder / "a.cast"
        if not cast.exists():
            return {}
        lines = cast.read_text(encoding="utf-8").split("\n")
        events = [json.loads(line) for line in lines[1:-1]]
        sent = "".join(data for _, kind, data in events if kind == "o")
        return {place: cell for place, cell in replay(sent).items()
                if place[1] < PICTURE_ROWS}


if __name__ == "__main__":
    unittest.main()
