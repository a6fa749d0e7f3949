#!/usr/bin/python3
"""The page's glyphs: outlines by definition, and grids in compact form."""

import base64
import gzip
import re
import unittest
import zlib

from report_case import ReportTest, need

need()

from report import grids, shapes
from report.errors import BadInput


def area(path):
    """The area that a path of polygons and rectangles encloses."""
    total = 0.0
    for part in filter(None, path.split("Z")):
        points, x, y = [], 0.0, 0.0
        for letter, arguments in re.findall(r"([MLHV])([-\d. ]+)", part):
            values = [float(v) for v in arguments.split()]
            if letter in "ML":
                x, y = values
            elif letter == "H":
                x = values[0]
            else:
                y = values[0]
            points.append((x, y))
        total += abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in
                         zip(points, points[1:] + points[:1]))) / 2
    return total / (shapes.WIDTH * shapes.HEIGHT)


class ShapesTest(ReportTest):

    def covered(self, character):
        path, opacity = shapes.geometric(ord(character))
        return area(path) * opacity

    def test_areas(self):
        # Shares of the cell that the names say.
        for character, share in [
                ("█", 1), ("▀", 1 / 2), ("▄", 1 / 2), ("▁", 1 / 8),
                ("▇", 7 / 8), ("▉", 7 / 8), ("▏", 1 / 8), ("▐", 1 / 2),
                ("▔", 1 / 8), ("▕", 1 / 8), ("░", 1 / 4), ("▓", 3 / 4),
                ("▖", 1 / 4), ("▛", 3 / 4), ("▞", 1 / 2), (" ", 0),
                ("\U0001fb00", 1 / 6), ("\U0001fb3b", 5 / 6),
                # LOWER LEFT ... LOWER MIDDLE LEFT TO LOWER CENTRE: a triangle
                # of a third of the height and half of the width.
                ("\U0001fb3c", 1 / 12),
                # ... UPPER MIDDLE LEFT TO LOWER RIGHT: two thirds by all.
                ("\U0001fb3f", 1 / 3),
                ("\U0001fb68", 3 / 4), ("\U0001fb6f", 1 / 4),
                ("\U0001cd00", 1 / 8), ("\U0001cde5", 7 / 8),
                ("\U0001cea8", 1 / 8), ("\U0001fb82", 1 / 4),
                ("\U0001fb85", 3 / 4), ("\U0001fbe6", 1 / 4)]:
            # Coordinates are rounded to 0.01.
            self.assert_close(self.covered(character), share, 0.002)

    def test_first_and_last_of_the_numbered(self):
        # BLOCK SEXTANT-1: the upper left; BLOCK OCTANT-3 likewise pattern 4.
        self.assertEqual(shapes.SEXTANTS[0x1FB00], 1)
        self.assertEqual(max(shapes.SEXTANTS), 0x1FB3B)
        self.assertEqual(shapes.OCTANTS[0x1CD00], 4)
        self.assertEqual(shapes.OCTANTS[0x1CDE5], 0xFE)
        # No pattern twice.
        self.assertEqual(len(set(shapes.OCTANTS.values())),
                         len(shapes.OCTANTS))

    def test_where_things_are(self):
        self.assertEqual(shapes.geometric(0x2596)[0], "M0 8H4V16H0Z")
        self.assertEqual(shapes.geometric(0x258F)[0], "M0 0H1V16H0Z")
        # The two upper sub-cells of a sextant are one rectangle.
        self.assertEqual(shapes.geometric(0x1FB02)[0], "M0 0H8V5.33H0Z")

    def test_glyphs_of_a_font(self):
        found = shapes.outlines(["A", "━", "⠿", "\U0010ffff", "ab"])
        for character in "A━⠿":
            path, opacity = found[character]
            self.assertRegex(path, r"^M.*Z$")
            self.assertEqual(opacity, 1)
        # A heavy line runs over the whole width, thinner than a third.
        xs = [float(x) for x in re.findall(r"[ML]([-\d.]+) ", found["━"][0])]
        self.assertLessEqual(min(xs), 0)
        self.assertGreaterEqual(max(xs), 8)
        self.assertLess(area(found["━"][0]), 1 / 3)
        self.assertIsNone(found["\U0010ffff"])
        self.assertIsNone(found["ab"])

    def test_packed_grids_unpack(self):
        grid = {"columns": 2, "rows": 2, "cells": [
            ["▄", "#102030", "#ffffff"], ["A", "#0f2030", "#000000"],
            [" ", "#123456", "#010203"], ["█", "#aabbcc", "#000000"]]}
        alphabet = grids.Alphabet()
        alphabet.numbers = {chr(0x4E00 + i): i for i in range(300)}
        planes = zlib.decompress(base64.b64decode(grids.pack(grid, alphabet)))
        self.assertEqual(len(planes), 8 * 4)
        plane = [list(planes[4 * i:4 * i + 4]) for i in range(8)]
        # Numbers 300 to 303: low bytes 44 to 47, high bytes 1.
        self.assertEqual(plane[:2], [[44, 45, 46, 47], [1] * 4])
        # Red of the foregrounds: 16, then -1 mod 256; the space takes its
        # background's 1, then aa - 1.
        self.assertEqual(plane[2], [16, 255, 1, 0xA9])
        # Red of the backgrounds: 255, 0 - 255; 1, the full block's own aa.
        self.assertEqual(plane[5], [255, 1, 1, 0xA9])

    def test_broken_grids(self):
        file = self.folder / "x.cells.json.gz"
        for data in (b"", b"\x1f\x8b12", gzip.compress(b"{}"),
                     gzip.compress(b'{"columns":2,"rows":1,"cells":[]}')):
            file.write_bytes(data)
            with self.assertRaisesRegex(BadInput, "not a cell grid"):
                grids.read(file)


if __name__ == "__main__":
    unittest.main()
