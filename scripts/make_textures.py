#!/usr/bin/python3
"""Writes the textures and bump maps of the small scenes, as PNG.

    scripts/make_textures.py [--out=FOLDER]

The folder is scenes/textures unless given. Every run makes the same pictures,
and they repeat without a seam.
"""

import argparse
import math
from pathlib import Path

from picture import (clouds, mix_colors, nearest_two, noise_at, picture, png,
                     smooth_step)

ROOT = Path(__file__).resolve().parent.parent
SIZE = 256
COLUMNS, ROWS = 4, 8  # bricks in a brick picture


def gray(x):
    return (x, x, x)


def brick_at(u, v):
    """The brick's column and row, and the distance to its edge in rows."""
    row = math.floor(v * ROWS)
    x = u * COLUMNS + 0.5 * (row % 2)
    column = math.floor(x)
    across, up = x - column, v * ROWS - row
    # A brick is twice as long as it is high.
    edge = min(2 * min(across, 1 - across), min(up, 1 - up))
    return column % COLUMNS, row, edge


def brick_height(u, v):
    edge = brick_at(u, v)[2] + 0.05 * (clouds(u, v, 32, 2, 5) - 0.5)
    face = 0.8 + 0.2 * clouds(u, v, 32, 3, 7)
    return gray(smooth_step(0.05, 0.16, edge) * face)


def brick(u, v):
    column, row, _ = brick_at(u, v)
    tone = noise_at(column, row, 3)
    clay = mix_colors((0.52, 0.2, 0.13), (0.82, 0.43, 0.27), tone)
    clay = mix_colors(clay, (0.3, 0.12, 0.1), 0.5 * clouds(u, v, 16, 4, 9))
    face = smooth_step(0.1, 0.5, brick_height(u, v)[0])
    return mix_colors((0.74, 0.71, 0.65), clay, face)


def cobble_height(u, v):
    nearest, second, _ = nearest_two(u, v, 8, 21)
    dome = smooth_step(0.02, 0.45, second - nearest)
    return gray(dome * (0.85 + 0.15 * clouds(u, v, 32, 3, 23)))


def cobble(u, v):
    cell = nearest_two(u, v, 8, 21)[2]
    stone = mix_colors((0.36, 0.37, 0.4), (0.7, 0.66, 0.6),
                       noise_at(*cell, 25))
    stone = mix_colors(stone, (0.24, 0.25, 0.28), 0.5 * clouds(u, v, 32, 3, 27))
    face = smooth_step(0.05, 0.4, cobble_height(u, v)[0])
    return mix_colors((0.2, 0.18, 0.15), stone, face)


def dimple_height(u, v):
    """Round hollows, staggered: ten rows of twenty, once around a sphere."""
    row = math.floor(v * 10)
    x = u * 20 + 0.5 * (row % 2)
    distance = math.hypot(x - math.floor(x) - 0.5, v * 10 - row - 0.5)
    return gray(smooth_step(0.1, 0.46, distance))


TEXTURES = {
    "brick.png": brick,
    "brick_height.png": brick_height,
    "cobble.png": cobble,
    "cobble_height.png": cobble_height,
    "dimple_height.png": dimple_height,
}


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--out", type=Path,
                        default=ROOT / "scenes" / "textures")
    folder = parser.parse_args().out
    folder.mkdir(parents=True, exist_ok=True)
    for name, color in TEXTURES.items():
        width = 2 * SIZE if color is dimple_height else SIZE
        (folder / name).write_bytes(png(picture(width, SIZE, color)))


if __name__ == "__main__":
    main()
