#!/usr/bin/python3
"""`rtbench score`: images, ANSI and cells against a reference."""

import json
import unittest

from pictures import gradient, png, read_png
from program import ProgramTest

METRICS = ["flip", "flip_ppd30", "flip_ppd67", "flip_p95", "hdr_flip",
           "mse", "psnr", "rmse_linear", "rel_mse", "ssim", "ms_ssim", "ciede2000",
           "ciede2000_p95"]


class ScoreTest(ProgramTest):

    def setUp(self):
        super().setUp()
        self.write("a.png", png(32, 32, gradient))

    def metrics(self, *args):
        record = json.loads(self.succeed("score", "--reference=a.png", *args,
                                         "--json=-"))
        self.assertEqual(list(record), ["schema", "metrics", "ppd",
                                        "raster"])
        self.assertEqual(record["schema"], 1)
        return record["metrics"]

    def test_an_image_against_itself(self):
        metrics = self.metrics("--image=a.png")
        self.assertEqual(list(metrics), METRICS)
        for name in METRICS:
            expected = {"psnr": None, "ssim": 1, "ms_ssim": None,
                        "hdr_flip": None}.get(name, 0)
            self.assertEqual(metrics[name], expected, name)

    def test_hdr_flip_of_linear_renders(self):
        for name, spp in [("one.exr", 1), ("two.exr", 2)]:
            self.succeed("render", "--scene=cornell", "--size=48x32",
                         f"--spp={spp}", f"--output={name}")
        def hdr_flip(test):
            return json.loads(self.succeed(
                "score", "--reference=one.exr", f"--image={test}",
                "--json=-"))["metrics"]["hdr_flip"]
        self.assertEqual(hdr_flip("one.exr"), 0)
        self.assertGreater(hdr_flip("two.exr"), 0)
        self.succeed("render", "--scene=cornell", "--size=48x32",
                     "--output=one.png")
        self.assertIsNone(hdr_flip("one.png"))

    def test_mse_of_a_known_difference(self):
        def brighter(x, y):
            return tuple(min(c, 250) + 5 for c in gradient(x, y))

        self.write("b.png", png(32, 32, brighter))
        squares = [(p - q) ** 2 for y in range(32) for x in range(32)
                   for p, q in zip(brighter(x, y), gradient(x, y))]
        expected = sum(squares) / len(squares) / 255 ** 2
        self.assertAlmostEqual(self.metrics("--image=b.png")["mse"], expected,
                               delta=1e-6 * expected)

    def test_ansi_and_cells_of_one_grid_score_the_same(self):
        args = ["encode", "--input=a.png", "--encoder=quadrant", "--grid=4x2"]
        self.succeed(*args, "--output=grid.ansi")
        self.succeed(*args, "--output=grid.json")
        ansi = self.metrics("--ansi=grid.ansi", "--grid=4x2")
        self.assertEqual(ansi, self.metrics("--cells=grid.json"))
        self.assertGreater(ansi["mse"], 0)

    def test_standard_input(self):
        args = ["encode", "--input=a.png", "--encoder=quadrant", "--grid=4x2"]
        text = self.succeed(*args)
        record = json.loads(self.succeed(
            "score", "--reference=a.png", "--ansi=-", "--grid=4x2",
            "--json=-", stdin=text))
        self.assertEqual(list(record["metrics"]), METRICS)

    def test_lines_and_a_json_file(self):
        text = self.succeed("score", "--reference=a.png", "--image=a.png",
                            "--json=out.json").decode()
        title, *rest = text.splitlines()
        # Never a FLIP value without its pixels per degree and raster.
        self.assertRegex(title, r"^compared at \d+x\d+ pixels; .* 40 pixels")
        lines = dict(line.split() for line in rest)
        self.assertEqual(list(lines), METRICS)
        self.assertEqual(lines["psnr"], "-")
        self.assertEqual(lines["flip"], "0")
        record = json.loads((self.folder / "out.json").read_text())
        self.assertEqual(record["metrics"]["flip"], 0)
        self.assertEqual(record["ppd"], 40)

    def test_ansi_text_of_a_larger_grid_is_refused(self):
        self.fail_with(2, "score", "--reference=a.png", "--ansi=-",
                       "--grid=4x2", stdin=b"1\n2\n3\n", says="scrolled")

    def test_other_sizes_are_reduced(self):
        # Every pixel doubled: the area average gives the original back.
        self.write("large.png",
                   png(64, 64, lambda x, y: gradient(x // 2, y // 2)))
        self.assertLess(self.metrics("--image=large.png")["mse"], 1e-10)

    def test_grids_against_each_other(self):
        cells = [["▄", "#ff0000", "#0000ff"], [" ", "#123456", "#0000ff"],
                 ["█", "#ff0000", "#0000ff"]]
        other = [["▀", "#ff0000", "#0000ff"], ["\u00a0", "#ffffff", "#0000ff"],
                 ["█", "#ff0001", "#00ff00"]]
        for name, row in (("a.json", cells), ("b.json", other)):
            self.write(name, json.dumps(
                {"columns": 3, "rows": 1, "cells": row}))
        record = json.loads(self.succeed("score", "--cells=a.json",
                                         "--against=b.json", "--json=-"))
        self.assertEqual(record["difference"], {"total": 3, "cells": 2,
                                                "glyphs": 1, "colors": 1})

    def test_maps(self):
        # One pixel in the middle is 100 codes brighter in red.
        self.write("dark.png", png(32, 32, lambda x, y: (50, 60, 70)))
        self.write("b.png", png(32, 32, lambda x, y: (
            150 if (x, y) == (20, 10) else 50, 60, 70)))
        self.succeed("score", "--reference=dark.png", "--image=b.png",
                     "--maps=new/maps")
        maps = self.folder / "new" / "maps"
        width, height, pixels = read_png((maps / "difference.png").read_bytes())
        self.assertEqual((width, height), (32, 32))
        self.assertEqual({i: p for i, p in enumerate(pixels) if any(p)},
                         {10 * 32 + 20: (100, 0, 0)})
        width, height, pixels = read_png((maps / "flip.png").read_bytes())
        self.assertEqual((width, height), (32, 32))
        # Magma is black at 0, and the error is largest at that pixel.
        self.assertEqual(pixels[31 * 32], (0, 0, 4))
        self.assertEqual(max(range(32 * 32), key=lambda i: sum(pixels[i])),
                         10 * 32 + 20)

    def test_another_programs_output(self):
        # A red and a blue line, one of them reversed, as pictures and as text.
        self.write("out.ansi", "\x1b[38;2;255;0;0m\u2588\u2588\r\n"
                               "\x1b[48;2;0;0;255m\x1b[K\x1b[0m\n")
        self.write("reference.png", png(
            16, 32, lambda x, y: (255, 0, 0) if y < 16 else (0, 0, 255)))
        record = json.loads(self.succeed(
            "score", "--reference=reference.png", "--ansi=out.ansi",
            "--grid=2x2", "--json=-"))
        self.assertEqual(record["metrics"]["mse"], 0)
        self.assertEqual(record["raster"], [16, 32])

    def test_graphics_are_no_cells(self):
        self.fail_with(2, "score", "--reference=a.png", "--ansi=-",
                       "--grid=4x2", stdin=b"\x1bPq#0~\x1b\\",
                       says=("sixel", "cells"))

    def test_errors(self):
        self.write("wide.png", png(33, 32, gradient))
        self.write("broken.json", '{"columns": 3')
        self.fail_with(2, "score", says="--reference")
        self.fail_with(2, "score", "--reference=a.png", says="--image")
        self.fail_with(2, "score", "--reference=a.png", "--image=a.png",
                       "--cells=x", says="one of")
        self.fail_with(2, "score", "--reference=a.png", "--image=gone.png",
                       says="gone.png")
        self.fail_with(2, "score", "--reference=a.png", "--image=wide.png",
                       says=("32x32", "33x32", "aspect"))
        self.fail_with(2, "score", "--reference=a.png", "--ansi=a.png",
                       says="--grid")
        self.fail_with(2, "score", "--reference=a.png", "--cells=broken.json",
                       says="broken.json")
        self.fail_with(2, "score", "--reference=a.png", "--cells=gone.json",
                       says="gone.json")
        self.fail_with(2, "score", "--reference=a.png", "--ansi=gone.ansi",
                       "--grid=4x2", says="gone.ansi")
        self.write("one.json", json.dumps(
            {"columns": 1, "rows": 1, "cells": [["x", "#000000", "#000000"]]}))
        self.write("two.json", json.dumps(
            {"columns": 2, "rows": 1, "cells": 2 * [["x", "#000000",
                                                     "#000000"]]}))
        both = ["score", "--cells=one.json"]
        self.fail_with(2, *both, "--against=two.json", says=("1", "2"))
        self.fail_with(2, *both, "--against=gone.json", says="gone.json")
        self.fail_with(2, *both, "--against=one.json", "--reference=a.png",
                       says="expected")
        self.fail_with(2, *both, "--against=one.json", "--maps=maps",
                       says="--maps")
        self.fail_with(1, "score", "--reference=a.png", "--image=a.png",
                       "--maps=a.png/maps", says="a.png")


if __name__ == "__main__":
    unittest.main()
