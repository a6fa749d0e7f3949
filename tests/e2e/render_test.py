#!/usr/bin/python3
"""`rtbench render`, `export` and `reference`."""

import json
import unittest

from pictures import read_png, read_ppm
from program import ProgramTest


class RenderTest(ProgramTest):

    def render(self, name, *args, scene="cornell"):
        self.succeed("render", f"--scene={scene}", "--size=24x16",
                     f"--output={name}", *args)
        return (self.folder / name).read_bytes()

    def test_ppm_is_ascii_and_equals_the_png(self):
        data = self.render("a.ppm")
        self.assertTrue(data.startswith(b"P3\n"), data[:20])
        self.assertTrue(data.isascii())
        self.assertLessEqual(max(map(len, data.split(b"\n"))), 70)
        picture = read_ppm(data)
        self.assertEqual(picture[:2], (24, 16))
        self.assertGreater(len(set(picture[2])), 20)
        self.assertEqual(read_png(self.render("a.png")), picture)
        self.assertEqual(read_png(self.render("b.PNG")), picture)

    def test_exr(self):
        self.assertEqual(self.render("a.exr")[:4], b"\x76\x2f\x31\x01")

    def test_threads_do_not_matter(self):
        for spp in (1, 4):
            one = self.render("1.ppm", "--threads=1", f"--spp={spp}")
            self.assertEqual(one, self.render("2.ppm", "--threads=2",
                                              f"--spp={spp}"))

    def test_options_reach_the_renderer(self):
        plain = self.render("a.ppm")
        for option in ("--spp=4", "--exposure=1"):
            self.assertNotEqual(self.render("b.ppm", option), plain, option)
        self.assertNotEqual(self.render("b.ppm", scene="whitted"),
                            self.render("c.ppm", "--max-depth=0",
                                        scene="whitted"))
        self.assertNotEqual(self.render("b.ppm", "--spp=4", "--seed=1"),
                            self.render("c.ppm", "--spp=4", "--seed=2"))

    def test_exposure_doubles_light(self):
        # Codes of a pixel and of twice its light, where neither is clipped.
        def linear(code):
            v = code / 255
            return v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4

        plain = read_ppm(self.render("a.ppm"))[2]
        twice = read_ppm(self.render("b.ppm", "--exposure=1"))[2]
        checked = 0
        for p, q in zip(plain, twice):
            for a, b in zip(p, q):
                if 40 < a and b < 255:
                    self.assertAlmostEqual(linear(b) / linear(a), 2, delta=0.1)
                    checked += 1
        self.assertGreater(checked, 100)

    def test_sequence(self):
        self.succeed("render", "--scene=cornell", "--size=6x4", "--frames=3",
                     "--fps=2", "--output=movie/f.png")
        names = sorted(p.name for p in (self.folder / "movie").iterdir())
        self.assertEqual(names, ["f_0000.png", "f_0001.png", "f_0002.png"])

    def test_errors(self):
        base = ["render", "--scene=cornell", "--size=6x4"]
        self.fail_with(2, *base, says="--output")
        self.fail_with(2, *base, "--output=a.gif", says=("a.gif", ".ppm"))
        self.fail_with(2, "render", "--output=a.png", says=("scene", "cornell"))
        self.fail_with(2, "render", "--scene=cornel", "--output=a.png",
                       says=("'cornel'", "cornell"))
        self.fail_with(2, *base, "--output=a.png", "--fps=5", says="--frames")
        for size in ("0x4", "6", "-6x4", "6x4x2", "axb", "70000x1",
                     "65536x65536"):
            self.fail_with(2, "render", "--scene=cornell", "--output=a.png",
                           f"--size={size}", says=(size, "WIDTHxHEIGHT"))
        for option, expected in (("--spp=0", "from 1"), ("--spp=-1", "from 1"),
                                 ("--spp=x", "whole number"),
                                 ("--spp=1e9", "whole number"),
                                 ("--seed=-1", "from 0"),
                                 ("--seed=1.5", "whole number"),
                                 ("--time=nan", "a number"),
                                 ("--exposure=99", "from -64 to 64"),
                                 ("--max-depth=65", "0 to 64"),
                                 ("--threads=-1", "from 0"),
                                 ("--integrator=radiosity", "expected whitted"),
                                 ("--backend=vulkan", "embree")):
            self.fail_with(2, *base, "--output=a.png", option, says=expected)
        self.fail_with(3, *base, "--output=a.png", "--backend=cuda",
                       says="cuda")

    def test_scene_errors_name_line_and_column(self):
        self.write("bad.yaml", "rtbench_scene: 1\nname: bad\ncamra: {}\n")
        self.fail_with(2, "render", "--scene=bad.yaml", "--output=a.png",
                       says=("bad.yaml:3:1", "camra"))


class ExportTest(ProgramTest):

    def test_pov(self):
        text = self.succeed("export", "--scene=cornell", "--format=pov")
        self.assertIn(b"#version 3.7", text)
        self.succeed("export", "--scene=cornell", "--format=pov",
                     "--output=a.pov")
        self.assertEqual((self.folder / "a.pov").read_bytes(), text)

    def test_blender(self):
        text = self.succeed("export", "--scene=cornell", "--format=blender")
        described = json.loads(text)
        self.assertGreater(len(described["materials"]), 2)

    def test_errors(self):
        self.fail_with(2, "export", "--scene=cornell", says="--format")
        self.fail_with(2, "export", "--scene=cornell", "--format=obj",
                       says=("obj", "blender", "pov"))
        self.fail_with(2, "export", "--format=pov", says="cornell")


class ReferenceTest(ProgramTest):

    def test_cycles_is_missing(self):
        self.fail_with(3, "reference", "--scene=cornell", "--renderer=cycles",
                       "--output=a.exr", env={"PATH": str(self.folder)},
                       says=("blender", "apt-get install blender"))

    def test_povray_is_missing(self):
        self.fail_with(3, "reference", "--scene=cornell", "--renderer=povray",
                       "--output=a.exr", env={"PATH": str(self.folder)},
                       says="povray")

    def test_errors(self):
        self.fail_with(2, "reference", "--scene=cornell", says="--renderer")
        # A small image must not take the canonical one's place unasked.
        self.fail_with(2, "reference", "--scene=cornell", "--renderer=povray",
                       "--size=48x32", says="--output")
        self.fail_with(2, "reference", "--scene=cornell", "--renderer=embree",
                       says=("embree", "povray"))
        self.fail_with(2, "reference", "--renderer=povray", says="cornell")


if __name__ == "__main__":
    unittest.main()
