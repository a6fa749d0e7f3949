#!/usr/bin/python3
"""`rtbench sweep`: whole suites, resumed, sliced, in parallel."""

import os
import pty
import signal
import subprocess
import time
import unittest

from program import ROOT
from sweeps import UNITS, SweepTest, contents, records


class SweepCommandTest(SweepTest):

    def test_every_unit_has_its_record(self):
        said = self.sweep("out")
        self.assertEqual(said, "10 units done, 2 skipped for want of what "
                               "they need\n")
        units = records(self.folder / "out")
        self.assertEqual(len(units), UNITS)
        for unit in units:
            kind = unit["unit"]["kind"]
            for run in unit["runs"]:
                if kind == "quality":
                    self.assertEqual(run["ms"], {})
                    self.assertGreater(run["metrics"]["flip"], 0)
                else:
                    self.assertEqual(run["metrics"], {})
                    self.assertEqual(len(run["ms"]["render"]["samples"]), 2)
        timing = [unit for unit in units if unit["unit"]["kind"] == "timing"]
        self.assertEqual([len(unit["runs"]) for unit in timing], [3, 3])

    def test_pictures_of_the_first_seed(self):
        self.sweep("out", "--kinds=quality")
        folder = self.folder / "out" / "pictures"
        named = set()
        for unit in records(self.folder / "out"):
            for run in unit["runs"]:
                self.assertEqual(bool(run.get("pictures")),
                                 unit["unit"]["configuration"]["seed"] == 1)
                named |= set(run.get("pictures", {}).values())
        self.assertEqual(named, {path.name for path in folder.iterdir()})
        self.assertEqual(len(named), 6 * 2 + 1)  # One reference for all.

    def test_missing_programs_are_skipped_visibly(self):
        process = self.run_program("sweep", self.suite, "--out=out")
        self.assertEqual(process.returncode, 0)
        self.assertEqual(
            process.stderr.decode().count("no such program was found"), 1)
        skipped = [unit for unit in records(self.folder / "out")
                   if unit.get("failure")]
        self.assertEqual([unit["failure"]["kind"] for unit in skipped],
                         ["skipped"] * 4)
        quality = [unit for unit in skipped
                   if unit["unit"]["kind"] == "quality"]
        self.assertEqual([unit["runs"] for unit in quality], [[], []])
        self.assertIn("no-such-program", quality[0]["failure"]["encoder"])

    def test_a_failure_does_not_stop_the_rest(self):
        self.suite = self.write("failing.yaml", self.suite.read_text().replace(
            "no-such-program", "false"))
        process = self.run_program("sweep", self.suite, "--out=out")
        self.assertEqual(process.returncode, 1)
        self.assertIn(b"4 failed", process.stdout)
        self.assertIn(b"ended with status 1", process.stderr)
        units = records(self.folder / "out")
        self.assertEqual(len(units), UNITS)
        self.assertEqual(sum(len(unit["runs"]) for unit in units), 8 + 2 * 3)
        failed = [unit["failure"] for unit in units if "failure" in unit]
        self.assertEqual({failure["kind"] for failure in failed}, {"failed"})
        # What failed is tried again, and nothing else.
        process = self.run_program("sweep", self.suite, "--out=out", "--resume")
        self.assertEqual(process.returncode, 1)
        self.assertIn(b"0 units done, 8 there already, 4 failed",
                      process.stdout)

    def test_a_folder_is_continued_only_on_demand(self):
        self.sweep("out", "--kinds=quality")
        self.fail_with(2, "sweep", self.suite, "--out=out",
                       says=["--out", "--resume runs what is missing"])
        said = self.sweep("out", "--kinds=quality", "--resume")
        self.assertEqual(said, "0 units done, 8 there already, "
                               "2 skipped for want of what they need\n")

    def test_damaged_records_are_made_again(self):
        self.sweep("out")
        whole = contents(self.folder / "out")
        units = self.folder / "out" / "units"
        quality = sorted(units.glob("quality-*.json"))
        for path, text in zip(quality, ["", "{", "[1]", '{"schema": 2}']):
            path.write_text(text)
        quality[4].write_bytes(b"\xff" * 100)
        timing = sorted(units.glob("timing-*.json"))[0]
        timing.write_bytes(timing.read_bytes()[:-20])
        next((self.folder / "out" / "pictures").glob("*.gz")).unlink()
        self.sweep("out", "--resume")
        self.assertEqual(contents(self.folder / "out"), whole)

    def test_slices_make_the_whole(self):
        self.sweep("whole")
        for i in range(3):
            self.sweep("parts", f"--shard={i}/3", "--resume")
        self.assertEqual(contents(self.folder / "parts"),
                         contents(self.folder / "whole"))

    def test_jobs_change_no_figure(self):
        self.sweep("one", "--kinds=quality")
        said = self.sweep("two", "--jobs=2")
        self.assertIn("2 timing units left", said)
        self.assertEqual(contents(self.folder / "two"),
                         contents(self.folder / "one"))

    def test_dry_run_lists_and_writes_nothing(self):
        listed = self.sweep("out", "--dry-run").splitlines()
        self.assertEqual(len(listed), 2 + UNITS)
        self.assertIn("quality left.yaml 20x10 against reference.png seed=1 "
                      "half", listed[2])
        self.assertFalse((self.folder / "out").exists())
        self.sweep("out", "--kinds=timing")
        listed = self.sweep("out", "--dry-run", "--resume").splitlines()
        self.assertEqual([line.split()[0] for line in listed[-2:]],
                         ["done", "done"])

    def test_a_changed_scene_is_run_again(self):
        self.sweep("out", "--kinds=quality")
        path = self.folder / "left.yaml"
        path.write_text(path.read_text() + "# changed\n")
        said = self.sweep("out", "--kinds=quality", "--resume")
        self.assertTrue(said.startswith("4 units done, 4 there already"), said)
        self.assertEqual(len(records(self.folder / "out")), UNITS - 2)

    def test_bad_suites_are_named_with_their_place(self):
        self.write("bad.yaml", "rtbench_suite: 1\nname: bad\nencodres: []\n")
        self.fail_with(2, "sweep", "bad.yaml", "--out=out",
                       says=["bad.yaml:3:1", "did you mean `encoders`?"])
        self.fail_with(2, "sweep", "gone.yaml", "--out=out", says="gone.yaml")
        self.fail_with(2, "sweep", self.suite, "--out=out", "--shard=2/2",
                       says="--shard")
        self.fail_with(2, "sweep", self.suite, "--out=out", "--kinds=quality,x",
                       says="quality, timing")

    def test_the_suites_of_the_repository_are_read(self):
        for suite, least in [("smoke", 15), ("thesis", 500)]:
            listed = self.succeed(
                "sweep", ROOT / "results" / "suites" / f"{suite}.yaml",
                "--out=none", "--dry-run").decode().splitlines()
            self.assertGreater(len(listed), least, suite)


class InterruptTest(SweepTest):

    def start(self, *args, **more):
        return subprocess.Popen(
            [self.program, "sweep", self.suite, "--out=out", *args],
            cwd=self.folder, env=self.environment(), **more)

    def wait_for_units(self, count):
        for _ in range(3000):
            if len(list((self.folder / "out").glob("units/*.json"))) >= count:
                return
            time.sleep(0.01)
        self.fail("no units were written")

    def test_signals_end_after_the_unit(self):
        whole = None
        for number in (signal.SIGINT, signal.SIGTERM):
            with self.subTest(signal=number):
                # Long enough that the signal comes while it works.
                self.suite.write_text(self.suite.read_text().replace(
                    "repeat: 2", "repeat: 300"))
                process = self.start(stdout=subprocess.PIPE,
                                     stderr=subprocess.PIPE)
                self.wait_for_units(1)
                process.send_signal(number)
                out, errors = process.communicate(timeout=120)
                self.assertEqual(process.returncode, -number, errors)
                self.assertRegex(out.decode(), r"units done.*, \d+ not begun")
                self.assertIn(b"--resume goes on", errors)
                found = records(self.folder / "out")
                self.assertGreaterEqual(len(found), 1)
                self.assertLess(len(found), UNITS)
                self.suite.write_text(self.suite.read_text().replace(
                    "repeat: 300", "repeat: 2"))
                self.sweep("out", "--resume")
                self.assertEqual(len(records(self.folder / "out")), UNITS)
                whole = whole or contents(self.folder / "out")
                self.assertEqual(contents(self.folder / "out"), whole)
                subprocess.run(["rm", "-r", self.folder / "out"], check=True)

    def test_a_terminal_shows_a_bar(self):
        master, slave = pty.openpty()
        process = self.start(stdout=subprocess.DEVNULL, stderr=slave)
        os.close(slave)
        shown = b""
        while True:
            try:
                data = os.read(master, 4096)
            except OSError:  # The other side is closed.
                break
            if not data:
                break
            shown += data
        os.close(master)
        self.assertEqual(process.wait(timeout=120), 0)
        self.assertRegex(shown.decode(), r"\r\x1b\[K\[[#-]{20}\] \d+ %")
        self.assertIn(b" left  ", shown)

    def test_elsewhere_there_are_plain_lines(self):
        process = self.run_program("sweep", self.suite, "--out=out")
        self.assertNotIn(b"\x1b", process.stderr)
        self.assertNotIn(b"\r", process.stderr)


if __name__ == "__main__":
    unittest.main()
