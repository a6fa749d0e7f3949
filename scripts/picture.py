"""Pictures for the scripts that make scene assets: noise that repeats, and
files in PNG and Radiance form, with nothing but Python's own library.

A picture is a list of rows, from the top, of (r, g, b) in 0..1.
"""

import math
import struct
import zlib


def noise_at(x, y, seed=0):
    """A number in 0..1 for a pair of whole numbers; the same on any machine."""
    h = (x * 0x8DA6B343 + y * 0xD8163841 + seed * 0xCB1AB31F) & 0xFFFFFFFF
    for shift in (16, 13, 16):
        h = ((h ^ (h >> shift)) * 0x45D9F3B) & 0xFFFFFFFF
    return h / 0xFFFFFFFF


def mix(a, b, t):
    return a + (b - a) * t


def mix_colors(a, b, t):
    return tuple(mix(x, y, t) for x, y in zip(a, b))


def smooth_step(low, high, x):
    t = min(1.0, max(0.0, (x - low) / (high - low)))
    return t * t * (3 - 2 * t)


def value_noise(u, v, cells, seed=0):
    """Smooth noise in 0..1, of period 1 in u and v."""
    x, y = u * cells, v * cells
    i, j = math.floor(x), math.floor(y)
    s, t = smooth_step(0, 1, x - i), smooth_step(0, 1, y - j)
    corner = [noise_at((i + a) % cells, (j + b) % cells, seed)
              for b in (0, 1) for a in (0, 1)]
    return mix(mix(corner[0], corner[1], s), mix(corner[2], corner[3], s), t)


def clouds(u, v, cells, octaves, seed=0):
    """Sum of value noises, each of half the size and weight of the last."""
    total = sum(value_noise(u, v, cells << k, seed + k) / (2 << k)
                for k in range(octaves))
    return total / (1 - 0.5 ** octaves)


def nearest_two(u, v, cells, seed=0):
    """Of points strewn one to a grid cell, with period 1: the distances to the
    nearest two, in cells, and the nearest one's cell."""
    x, y = u * cells, v * cells
    found = []
    for j in range(math.floor(y) - 1, math.floor(y) + 2):
        for i in range(math.floor(x) - 1, math.floor(x) + 2):
            cell = (i % cells, j % cells)
            px = i + 0.5 + 0.6 * (noise_at(*cell, seed) - 0.5)
            py = j + 0.5 + 0.6 * (noise_at(*cell, seed + 1) - 0.5)
            found.append((math.hypot(px - x, py - y), cell))
    found.sort()
    return found[0][0], found[1][0], found[0][1]


def picture(width, height, color):
    """color(u, v) at each pixel's center, v upwards."""
    return [[color((i + 0.5) / width, 1 - (j + 0.5) / height)
             for i in range(width)] for j in range(height)]


def byte(x):
    return min(255, max(0, int(x * 255 + 0.5)))


def png(rows):
    """The bytes of an 8-bit RGB PNG; gray where all channels agree."""
    gray = all(p[0] == p[1] == p[2] for row in rows for p in row)
    channels = 1 if gray else 3
    lines = b"".join(b"\0" + bytes(byte(x) for p in row for x in p[:channels])
                     for row in rows)

    def chunk(kind, data):
        checked = kind + data
        return (struct.pack(">I", len(data)) + checked
                + struct.pack(">I", zlib.crc32(checked)))

    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8,
                         0 if gray else 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header)
            + chunk(b"IDAT", zlib.compress(lines, 9)) + chunk(b"IEND", b""))


def rgbe(color):
    """Radiance's pixel: three mantissas and their common exponent."""
    largest = max(color)
    if largest < 1e-30:
        return bytes(4)
    mantissa, exponent = math.frexp(largest)
    scale = mantissa * 256 / largest
    return bytes([*(int(x * scale) for x in color), exponent + 128])


def hdr(rows):
    """The bytes of a Radiance picture, not run-length encoded."""
    header = (f"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n"
              f"-Y {len(rows)} +X {len(rows[0])}\n")
    return header.encode() + b"".join(rgbe(p) for row in rows for p in row)
