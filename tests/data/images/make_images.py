#!/usr/bin/env python3
"""Writes the PNG files of this folder, with nothing but zlib.

They are made apart from the library that reads them, and hold what its writer
cannot make: palettes, transparent colors, one-bit gray, impossible sizes.
"""
import os
import struct
import zlib

GRAY, RGB, PALETTE, GRAY_ALPHA, RGB_ALPHA = 0, 2, 3, 4, 6


def chunk(kind, data):
    return (struct.pack(">I", len(data)) + kind + data +
            struct.pack(">I", zlib.crc32(kind + data)))


def png(name, width, height, depth, color_type, rows, extra=()):
    """rows: bytes of each row; extra: chunks (kind, data) before the pixels."""
    head = struct.pack(">IIBBBBB", width, height, depth, color_type, 0, 0, 0)
    pixels = b"".join(b"\0" + row for row in rows)
    chunks = [(b"IHDR", head), *extra, (b"IDAT", zlib.compress(pixels)),
              (b"IEND", b"")]
    folder = os.path.dirname(os.path.abspath(__file__))
    with open(os.path.join(folder, name), "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        for kind, data in chunks:
            file.write(chunk(kind, data))


def main():
    # Every code of 8 bits, in a row.
    png("gray8.png", 256, 1, 8, GRAY, [bytes(range(256))])
    png("gray1.png", 2, 1, 1, GRAY, [b"\x40"])  # black, white
    png("gray_alpha8.png", 2, 1, 8, GRAY_ALPHA, [bytes([10, 255, 200, 128])])
    png("rgb8.png", 2, 2, 8, RGB,
        [bytes([255, 0, 0, 0, 255, 0]), bytes([0, 0, 255, 10, 20, 30])])
    png("rgba8.png", 3, 1, 8, RGB_ALPHA,
        [bytes([10, 20, 30, 255, 200, 100, 50, 128, 200, 100, 50, 0])])
    # 1000 and 1001 are the same code once rounded to 8 bits.
    png("rgb16.png", 1, 1, 16, RGB, [struct.pack(">3H", 1000, 1001, 65535)])
    png("rgba16.png", 1, 1, 16, RGB_ALPHA,
        [struct.pack(">4H", 1000, 2000, 3000, 32768)])
    palette = (b"PLTE", bytes([1, 2, 3, 200, 100, 50]))
    png("palette.png", 2, 1, 8, PALETTE, [bytes([1, 0])], [palette])
    png("palette_alpha.png", 2, 1, 8, PALETTE, [bytes([1, 0])],
        [palette, (b"tRNS", bytes([255, 128]))])
    png("transparent_color.png", 2, 1, 8, RGB,
        [bytes([10, 20, 30, 200, 100, 50])],
        [(b"tRNS", struct.pack(">3H", 10, 20, 30))])
    # 2^28 + 2^14 pixels, a little more than is read; and none at all.
    png("too_large.png", 16384, 16385, 8, RGB, [])
    png("zero_width.png", 0, 1, 8, RGB, [b""])


if __name__ == "__main__":
    main()
