#!/usr/bin/python3
"""`rtbench encode`: images to cells, in every format."""

import json
import re
import unittest

from pictures import gradient, png, read_png
from program import ROOT, ProgramTest


class EncodeTest(ProgramTest):

    def cells(self, *args, **more):
        return json.loads(self.succeed("encode", *args, "--format=json",
                                       **more))

    def test_image_of_the_plans_size_is_not_resampled(self):
        # `half` takes 1 x 2 samples: 5 x 3 cells are 5 x 6 pixels.
        self.write("in.png", png(5, 6, gradient))
        grid = self.cells("--input=in.png", "--encoder=half", "--grid=5x3")
        self.assertEqual((grid["columns"], grid["rows"]), (5, 3))
        expected = [["▄",
                     "#%02x%02x%02x" % gradient(x, 2 * y + 1),
                     "#%02x%02x%02x" % gradient(x, 2 * y)]
                    for y in range(3) for x in range(5)]
        self.assertEqual(grid["cells"], expected)

    def test_standard_input(self):
        image = png(8, 8, gradient)
        self.write("in.png", image)
        args = ["--encoder=quadrant", "--grid=8x4"]
        self.assertEqual(self.cells("--input=-", *args, stdin=image),
                         self.cells("--input=in.png", *args))

    def test_fit(self):
        # A white square on a picture of aspect 2 (8 x 2 cells of aspect 1/2).
        self.write("in.png", png(32, 32, lambda x, y: (255, 255, 255)))

        def whites(fit):
            grid = self.cells("--input=in.png", "--encoder=half",
                              "--grid=8x2", "--fit=" + fit)
            return sum(cell[1] == "#ffffff" for cell in grid["cells"])

        self.assertEqual(whites("contain"), 8)  # half of 16 cells
        self.assertEqual(whites("stretch"), 16)
        self.assertEqual(whites("cover"), 16)

    def test_exposure(self):
        # 55 is 0.0382 linear; two stops more are 0.1529: 109 encoded.
        self.write("in.png", png(2, 2, lambda x, y: (55, 55, 55)))
        grid = self.cells("--input=in.png", "--encoder=half", "--grid=2x1",
                          "--exposure=2")
        self.assertEqual(grid["cells"][0][1], "#6d6d6d")

    def test_ansi_is_the_default_and_resets_each_line(self):
        self.write("in.png", png(8, 8, gradient))
        text = self.succeed("encode", "--input=in.png", "--encoder=half",
                            "--grid=4x2").decode()
        lines = text.split("\n")
        self.assertEqual(len(lines), 3)
        for line in lines[:2]:
            self.assertTrue(line.endswith("\x1b[m"), line)
            plain = re.sub(r"\x1b\[[0-9;]*m", "", line)
            self.assertEqual(plain, "▄▄▄▄")

    def test_png_holds_the_decoded_raster(self):
        self.write("in.png", png(4, 4, gradient))
        args = ["encode", "--input=in.png", "--encoder=half", "--grid=4x2"]
        self.succeed(*args, "--output=out.png")
        data = (self.folder / "out.png").read_bytes()
        width, height, pixels = read_png(data)
        self.assertEqual((width, height), (32, 32))
        for y in range(32):
            for x in range(32):
                self.assertEqual(pixels[y * 32 + x], gradient(x // 8, y // 8))
        self.assertEqual(self.succeed(*args, "--format=png"), data)

    def test_output_extension_chooses_the_format(self):
        self.write("in.png", png(4, 4, gradient))
        args = ["encode", "--input=in.png", "--encoder=half", "--grid=4x2"]
        self.succeed(*args, "--output=a.json")
        self.succeed(*args, "--output=a.svg")
        json.loads((self.folder / "a.json").read_text())
        self.assertIn("<svg", (self.folder / "a.svg").read_text()[:300])

    def test_scene(self):
        grid = self.cells("--scene=cornell", "--encoder=half", "--grid=6x2")
        self.assertEqual(len(grid["cells"]), 12)
        self.assertGreater(len({tuple(cell) for cell in grid["cells"]}), 3)

    def test_threads_do_not_matter(self):
        self.write("in.png", png(97, 61, gradient))
        args = ["--input=in.png", "--encoder=tiv", "--grid=31x11"]
        self.assertEqual(self.cells(*args, "--threads=1"),
                         self.cells(*args, "--threads=3"))

    def test_another_program_as_encoder(self):
        self.write("in.png", png(6, 6, gradient))
        args = ["--input=in.png", "--grid=6x3"]
        half = self.cells(*args, "--encoder=half")
        program = ROOT / "tests" / "data" / "programs" / "half_blocks.py"
        spec = (f"external:samples=1x2:/usr/bin/python3 -B '{program}' "
                "{input} {cols} {rows}")
        self.assertEqual(self.cells(*args, "--encoder=" + spec), half)
        self.fail_with(3, "encode", *args,
                       "--encoder=external:no-such-program {input}",
                       says=("no-such-program", "install"))
        self.fail_with(1, "encode", *args,
                       "--encoder=external:sh -c 'echo dark >&2; exit 4' "
                       "{input}", says=("status 4", "dark"))

    def test_errors(self):
        self.write("in.png", png(4, 4, gradient))
        self.write("text.png", "no image")
        base = ["encode", "--encoder=half"]
        self.fail_with(2, *base, says=("--input", "--scene"))
        self.fail_with(2, *base, "--input=in.png", "--scene=cornell",
                       says="either")
        self.fail_with(2, "encode", "--input=in.png", says="--encoder")
        self.fail_with(2, *base, "--input=gone.png", says="gone.png")
        self.fail_with(2, *base, "--input=text.png", says="text.png")
        self.fail_with(2, *base, "--input=-", stdin=b"", says="standard input")
        self.fail_with(2, *base, "--input=in.png", "--fit=fill",
                       says=("'fill'", "contain, stretch or cover"))
        self.fail_with(2, *base, "--input=in.png", "--format=gif",
                       says=("gif", "ansi"))
        self.fail_with(2, "encode", "--input=in.png", "--encoder=thirds",
                       says=("thirds", "quadrant"))


if __name__ == "__main__":
    unittest.main()
