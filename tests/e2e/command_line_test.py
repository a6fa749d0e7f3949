#!/usr/bin/python3
"""Help, version, unknown words, and `rtbench list`."""

import json
import re
import unittest

from pictures import gradient, png
from program import ProgramTest

COMMANDS = ["bench", "render", "encode", "score", "sweep", "reference",
            "export", "report", "live", "list"]
LISTS = ["encoders", "scenes", "backends", "metrics", "glyphs"]


class CommandLineTest(ProgramTest):

    def test_help_lists_the_commands_and_nothing_else(self):
        text = self.succeed("--help").decode()
        part = text[text.index("Subcommands:"):]
        found = re.findall(r"^  (\w+)  ", part, re.M)
        self.assertEqual(found, COMMANDS)

    def test_every_command_has_help(self):
        for command in COMMANDS:
            text = self.succeed(command, "--help").decode()
            self.assertIn("--help", text)

    def test_help_names_every_common_option(self):
        text = self.succeed("bench", "--help").decode()
        for option in ("--scene", "--encoder", "--grid", "--cell",
                       "--reference", "--integrator", "--backend", "--spp",
                       "--time", "--seed", "--threads", "--repeat",
                       "--decode", "--font", "--exposure", "--max-depth",
                       "--json", "--out", "--preview", "--quiet"):
            self.assertRegex(text, rf"(?m)^  {option}( |$)")

    def test_version(self):
        self.assertRegex(self.succeed("--version").decode(),
                         r"\Artbench \d+\.\d+\.\d+ \(.+\)\n\Z")

    def test_unknown_words(self):
        self.fail_with(2, "draw", says=("draw", "bench", "score"))
        self.fail_with(2, "rendr", says=("rendr", "render"))
        self.fail_with(2, "--scen=cornell", says="--scen")
        self.fail_with(2, "list", "everything", says=("everything", "glyphs"))
        self.fail_with(2, "list", says="WHAT")
        self.fail_with(2, "render", "--scene=cornell", "extra", "--output=a.png",
                       says="extra")

    def test_escape_sequences_never_reach_the_terminal(self):
        error = self.fail_with(2, "\x1b[31mred")
        self.assertNotIn("\x1b", error)
        error = self.fail_with(2, "render", "--scene=\x1b[2J",
                               "--output=a.png")
        self.assertNotIn("\x1b", error)
        error = self.fail_with(2, "bench", "--\x1b[2J")
        self.assertNotIn("\x1b", error)

    def test_lists(self):
        for what in LISTS:
            lines = self.succeed("list", what).decode().splitlines()
            entries = json.loads(self.succeed("list", what, "--json"))
            self.assertGreater(len(entries), 0, what)
            self.assertGreaterEqual(len(lines), len(entries))

    def test_list_contents(self):
        def names(what):
            return [entry["name"] for entry in
                    json.loads(self.succeed("list", what, "--json"))]

        self.assertLessEqual({"half", "quadrant", "tiv"},
                             set(names("encoders")))
        self.assertLessEqual({"cornell", "whitted"}, set(names("scenes")))
        self.assertEqual(names("metrics")[0], "flip")
        backends = {b["name"]: b["available"] for b in json.loads(
            self.succeed("list", "backends", "--json"))}
        self.assertTrue(backends["embree"])
        self.assertTrue(backends["bvh"])
        if not backends["cuda"]:
            # No silent fall-back: an error that says why not.
            self.fail_with(3, "render", "--scene=cornell", "--size=4x4",
                           "--backend=cuda", "--output=x.ppm",
                           says="--backend=cuda")

    def test_every_encoder_is_described(self):
        encoders = {e["name"]: e for e in json.loads(
            self.succeed("list", "encoders", "--json"))}
        for encoder in encoders.values():
            self.assertEqual(
                set(encoder),
                {"name", "samples_per_cell", "glyphs", "needs_parameters",
                 "version", "available", "why_not", "description",
                 "parameters", "modifiers"})
            self.assertEqual(encoder["available"], not encoder["why_not"])
            for parameter in encoder["parameters"]:
                self.assertEqual(set(parameter), {"name", "default", "values",
                                                  "description"})
        split = {p["name"]: p for p in encoders["quadrant"]["parameters"]}
        self.assertEqual(split["split"]["default"], "brightness")
        self.assertEqual(split["split"]["values"], "brightness|range|best")
        self.assertEqual(encoders["half"]["version"], "")
        chafa = encoders["chafa"]
        if chafa["available"]:
            self.assertRegex(chafa["version"], r"^\d+\.\d+")
        else:
            self.assertIn("libchafa", chafa["why_not"])
            self.write("in.png", png(4, 4, gradient))
            self.fail_with(3, "encode", "--input=in.png", "--encoder=chafa",
                           says="libchafa")
        self.assertEqual([name for name, encoder in encoders.items()
                          if encoder["needs_parameters"]], ["external"])

    def test_installed_data_is_used(self):
        for scene in json.loads(self.succeed("list", "scenes", "--json")):
            self.assertTrue(scene["file"].startswith(str(self.prefix)),
                            scene["file"])

    def test_data_folder_of_the_environment(self):
        cornell = self.prefix / "share/rtbench/scenes/cornell.yaml"
        self.write("x", "")
        (self.folder / "data" / "scenes").mkdir(parents=True)
        self.write("data/scenes/mine.yaml", cornell.read_bytes())
        env = {"RTBENCH_DATA": str(self.folder / "data")}
        text = self.succeed("list", "scenes", env=env).decode()
        self.assertRegex(text, r"(?m)^mine ")
        self.succeed("render", "--scene=mine", "--size=6x4",
                     "--output=a.png", env=env)


if __name__ == "__main__":
    unittest.main()
