#!/usr/bin/python3
"""The live mode without a person: what it prints, and how it ends."""

import json
import unittest

from program import ProgramTest

SMALL = {"scene": "whitted", "grid": "20x10", "frames": "8", "warmup": "2"}


def options(given):
    """Those of SMALL that are not given, and the given ones."""
    names = [option.lstrip("-").split("=")[0] for option in given]
    return [f"--{name}={value}" for name, value in SMALL.items()
            if name not in names] + list(given)


class HeadlessTest(ProgramTest):

    def figures(self, *args, **more):
        return json.loads(self.succeed("live", "--headless", "--json=-",
                                       *options(args), **more))

    def test_figures(self):
        for present, shown in (("auto", "direct, pseudo terminal"),
                               ("direct", "direct, pseudo terminal"),
                               ("string", "string, memory")):
            figures = self.figures(f"--present={present}")
            self.assertEqual(figures["schema"], 1)
            self.assertEqual(figures["present"], shown)
            self.assertEqual(figures["frames"], 8)
            self.assertEqual(figures["grid"], [20, 10])
            self.assertEqual(figures["scene"], "whitted")
            self.assertEqual(figures["encoder"], "quadrant")
            self.assertGreater(figures["fps"], 0)
            self.assertGreater(figures["bytes_per_frame"], 0)
            self.assertLessEqual(figures["cells_per_frame"], 200)
            times = figures["frame_ms"]
            self.assertLessEqual(times["p50"], times["p95"])
            self.assertLessEqual(times["p95"], times["p99"])

    def test_without_governor_every_sample_is_traced(self):
        figures = self.figures("--target-fps=0")
        self.assertAlmostEqual(figures["rays_per_cell"], 4)  # Quadrant's 2 x 2.
        figures = self.figures("--target-fps=0", "--encoder=half")
        self.assertAlmostEqual(figures["rays_per_cell"], 2)

    def test_a_still_picture_is_sent_once(self):
        # After 280 frames the picture has converged.
        longer = ["--target-fps=0", "--warmup=280", "--frames=20"]
        moving = self.figures("--motion=orbit", *longer)
        still = self.figures("--motion=still", *longer)
        self.assertGreater(moving["cells_per_frame"], 0)
        self.assertLess(still["cells_per_frame"],
                        moving["cells_per_frame"] / 3)

    def test_needs_no_terminal_and_no_locale(self):
        for present in ("direct", "string"):
            self.figures(f"--present={present}",
                         env={"TERM": "dumb", "LC_ALL": "C"})

    def test_ncurses(self):
        figures = self.figures("--present=ncurses", "--color=256",
                               env={"TERM": "xterm-256color"})
        self.assertEqual(figures["present"], "ncurses, pseudo terminal")
        self.fail_with(2, "live", "--headless", "--present=ncurses",
                       "--color=256", env={"TERM": "no-such"}, says="no-such")
        self.fail_with(2, "live", "--headless", "--present=ncurses",
                       "--color=256", env={"TERM": "xterm"}, says="8 colors")

    def test_split_panel_path_and_recording(self):
        self.figures("--encoder=quadrant,half", "--panel", "--grid=80x12",
                     "--record=a.cast")
        lines = (self.folder / "a.cast").read_text().rstrip("\n").split("\n")
        self.assertEqual(json.loads(lines[0])["width"], 80)
        self.assertGreaterEqual(len(lines), 2)

    def test_mistakes(self):
        self.fail_with(2, "live", "--headless", "--scene=no-such",
                       says="no-such")
        self.fail_with(2, "live", "--headless", "--encoder=no-such",
                       says="no-such")
        self.fail_with(2, "live", "--headless", "--encoder=half,tiv,quadrant",
                       says="two")
        self.fail_with(2, "live", "--json=-", says="--headless")


if __name__ == "__main__":
    unittest.main()
