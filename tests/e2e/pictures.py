"""Small pictures and readers for what the program writes."""

import struct
import zlib


def png(width, height, pixel):
    """An 8-bit RGB PNG; pixel(x, y) gives (r, g, b)."""
    rows = b"".join(
        b"\0" + bytes(c for x in range(width) for c in pixel(x, y))
        for y in range(height))

    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data)))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) +
            chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def _paeth(a, b, c):
    p = a + b - c
    return min((a, b, c), key=lambda v: abs(p - v))


def read_png(data):
    """(width, height, [(r, g, b), ...]) of an 8-bit RGB PNG."""
    assert data.startswith(b"\x89PNG\r\n\x1a\n")
    packed, at = b"", 8
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", body[:10])
            assert (depth, color, body[12]) == (8, 2, 0)
        if kind == b"IDAT":
            packed += body
        at += 12 + size
    raw, stride, before, out = zlib.decompress(packed), width * 3, None, []
    for y in range(height):
        line = bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        mode = raw[y * (stride + 1)]
        for i in range(stride):
            a = line[i - 3] if i >= 3 else 0
            b = before[i] if before else 0
            c = before[i - 3] if before and i >= 3 else 0
            add = (0, a, b, (a + b) // 2, _paeth(a, b, c))[mode]
            line[i] = (line[i] + add) & 255
        before = line
        out += list(zip(line[0::3], line[1::3], line[2::3]))
    return width, height, out


def read_ppm(data):
    """(width, height, [(r, g, b), ...]) of an ASCII PPM."""
    words = data.split()
    assert words[0] == b"P3" and words[3] == b"255"
    width, height = int(words[1]), int(words[2])
    values = list(map(int, words[4:]))
    assert len(values) == 3 * width * height
    return width, height, list(zip(values[0::3], values[1::3], values[2::3]))


def gradient(x, y):
    """Colors that differ from pixel to pixel."""
    return (x * 7 % 256, y * 11 % 256, (x * 3 + y * 5) % 256)
