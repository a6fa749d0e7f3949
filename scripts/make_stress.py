#!/usr/bin/python3
"""Writes the chart of the scene `stress`, as PNG: what is hardest for a few
samples a cell.

    scripts/make_stress.py [--out=FOLDER]

The folder is scenes/stress unless given. Every run makes the same picture: a
zone plate, noise, and lines one pixel wide, side by side, each third of it
320 x 640 pixels.
"""

import argparse
import math
from pathlib import Path

from picture import noise_at, picture, png

ROOT = Path(__file__).resolve().parent.parent
WIDTH, HEIGHT = 960, 640
THIRD = WIDTH // 3
LEVELS = 4  # of gray, in the noise
SPOKES = 48  # lines from the middle of the last third


def gray(x):
    return (x, x, x)


def zone_plate(x, y):
    """Rings that reach one period in two pixels at the upper and lower edge."""
    square = (x - THIRD / 2) ** 2 + (y - HEIGHT / 2) ** 2
    return gray(0.5 + 0.5 * math.cos(math.pi * square / HEIGHT))


def noise(x, y):
    """Squares of 1, 2, 4 and 8 pixels, in bands from the top."""
    side = 1 << (4 * int(y) // HEIGHT)
    value = noise_at(int(x) // side, int(y) // side, 41)
    return gray(min(int(LEVELS * value), LEVELS - 1) / (LEVELS - 1))


def lines(x, y):
    """Spokes over a ladder of rungs that come ever closer."""
    dx, dy = x - THIRD / 2, y - HEIGHT / 2
    turn = math.pi / SPOKES
    off = math.remainder(math.atan2(dy, dx), turn)
    spoke = abs(math.sin(off)) * math.hypot(dx, dy) < 0.5
    rung = int(y) % (4 + int(y) // 20) == 0
    if spoke:
        return (1.0, 0.9, 0.3) if dx > 0 else (0.4, 0.8, 1.0)
    return gray(0.75 if rung else 0.05)


def chart(u, v):
    x, y = u * WIDTH, v * HEIGHT
    return (zone_plate, noise, lines)[int(x) // THIRD](x % THIRD, y)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--out", type=Path, default=ROOT / "scenes" / "stress")
    folder = parser.parse_args().out
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "chart.png").write_bytes(png(picture(WIDTH, HEIGHT, chart)))


if __name__ == "__main__":
    main()
