"""The sky and the textures of the scene `explore`, for
scripts/make_explore.py.
"""

import math

from picture import (clouds, hdr, mix_colors, nearest_two, noise_at, picture,
                     png, smooth_step)

TO_SUN = (1.0, 0.42, 0.35)

# Capitals of five by seven, a row a number whose highest bit is on the left.
FONT = {
    "A": (14, 17, 17, 31, 17, 17, 17), "C": (14, 17, 16, 16, 16, 17, 14),
    "E": (31, 16, 16, 30, 16, 16, 31), "F": (31, 16, 16, 30, 16, 16, 16),
    "R": (30, 17, 17, 30, 20, 18, 17), "Y": (17, 17, 10, 4, 4, 4, 4),
    "B": (30, 17, 17, 30, 17, 17, 30), "O": (14, 17, 17, 17, 17, 17, 14),
    "K": (17, 18, 20, 24, 20, 18, 17), "S": (15, 16, 16, 14, 1, 1, 30),
    " ": (0, 0, 0, 0, 0, 0, 0),
}


def sky_color(u, v):
    """Radiance of an evening sky in latitude-longitude form."""
    longitude, latitude = 2 * math.pi * (u - 0.5), math.pi * (v - 0.5)
    direction = (math.sin(longitude) * math.cos(latitude), math.sin(latitude),
                 -math.cos(longitude) * math.cos(latitude))
    length = math.sqrt(sum(x * x for x in TO_SUN))
    near = max(0.0, sum(a * b for a, b in zip(direction, TO_SUN)) / length)
    up = max(0.0, direction[1])
    color = mix_colors((0.95, 0.5, 0.24), (0.42, 0.4, 0.5),
                       smooth_step(0, 0.22, up))
    color = mix_colors(color, (0.06, 0.13, 0.34), smooth_step(0.1, 0.75, up))
    puffs = clouds(u, 0.5 * v + 0.25 * up, 6, 5, 41)
    cover = smooth_step(0.5, 0.72, puffs) * smooth_step(0.02, 0.2, up)
    color = mix_colors(color, (0.95, 0.55, 0.38), 0.75 * cover)
    glow = 0.8 * near ** 12 + 1.2 * near ** 80
    color = tuple(c + glow * g for c, g in zip(color, (1.0, 0.62, 0.25)))
    return mix_colors((0.12, 0.11, 0.1), color,
                      smooth_step(-0.02, 0.01, direction[1]))


def sign(text, ink, ground):
    """color(u, v) of a line of text within a frame."""
    columns, rows = 6 * len(text) + 3, 11

    def color(u, v):
        x, y = u * columns, (1 - v) * rows
        if min(x, y, columns - x, rows - y) < 0.6:
            return ink
        column, row = math.floor(x) - 2, math.floor(y) - 2
        if 0 <= row < 7 and 0 <= column < 6 * len(text) and column % 6 < 5:
            bits = FONT[text[column // 6]][row]
            if bits >> (4 - column % 6) & 1:
                return ink
        return ground

    return color


def slab_height(u, v):
    edge = min((4 * u) % 1, 1 - (4 * u) % 1, (4 * v) % 1, 1 - (4 * v) % 1)
    rough = 0.8 + 0.2 * clouds(u, v, 16, 3, 53)
    return (smooth_step(0.01, 0.06, edge) * rough,) * 3


def slab(u, v):
    tone = noise_at(math.floor(4 * u), math.floor(4 * v), 51)
    stone = mix_colors((0.52, 0.5, 0.47), (0.7, 0.68, 0.64), tone)
    stone = mix_colors(stone, (0.42, 0.41, 0.4), 0.5 * clouds(u, v, 16, 4, 55))
    return mix_colors((0.26, 0.25, 0.24), stone, slab_height(u, v)[0])


def asphalt(u, v):
    grain = noise_at(math.floor(u * 256), math.floor(v * 256), 57)
    x = 0.24 + 0.1 * grain + 0.1 * (clouds(u, v, 4, 3, 59) - 0.5)
    return (x, x, 1.04 * x)


def plaster_height(u, v):
    return (clouds(u, v, 16, 4, 61),) * 3


def leaded_roof(u, v):
    nearest, second, cell = nearest_two(u, v, 12, 63)
    tone = noise_at(*cell, 65)
    tile = mix_colors((0.3, 0.14, 0.1), (0.5, 0.26, 0.18), tone)
    return mix_colors((0.15, 0.08, 0.06), tile,
                      smooth_step(0, 0.12, second - nearest))


def pictures():
    """File name -> bytes."""
    made = {
        "cafe.png": (128, 32, sign("RAY CAFE", (0.98, 0.85, 0.4),
                                   (0.22, 0.05, 0.06))),
        "books.png": (128, 32, sign("BOOKS", (0.95, 0.93, 0.85),
                                    (0.06, 0.2, 0.3))),
        "slab.png": (128, 128, slab),
        "slab_height.png": (128, 128, slab_height),
        "asphalt.png": (256, 256, asphalt),
        "plaster_height.png": (128, 128, plaster_height),
        "roof.png": (128, 128, leaded_roof),
    }
    files = {name: png(picture(*what)) for name, what in made.items()}
    files["sky.hdr"] = hdr(picture(512, 256, sky_color))
    return files
