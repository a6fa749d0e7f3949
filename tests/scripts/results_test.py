#!/usr/bin/python3
"""scripts/results and scripts/readme.py --results."""

import shutil
import subprocess
import unittest

from fake_machine import FakeMachineTest
from script_case import ROOT, ScriptTest

# Writes down how it is called; the sweep ends as $STATE/sweep says.
PROGRAM = '''#!/bin/bash
echo "rtbench $*" >>"$STATE/calls"
if [[ $1 == sweep && -e $STATE/sweep ]]; then exit "$(cat "$STATE/sweep")"; fi
'''


class ResultsTest(FakeMachineTest):

    def setUp(self):
        super().setUp()
        self.write("state/program", PROGRAM, executable=True)

    def runs(self):
        """How the program was called."""
        return [call for call in self.calls() if call.startswith("rtbench")]

    def test_one_command_from_nothing_to_the_report(self):
        self.assert_passes(self.script("results", "--jobs=2"))
        self.assertEqual(self.runs(), [
            "rtbench sweep results/suites/thesis.yaml "
            "--out=results/thesis --resume --jobs=2",
            "rtbench report results/thesis --out=results/report"])
        installed = (self.tree / "state/installed").read_text().split()
        for package in self.packages("build", "run", "report"):
            self.assertIn(package, installed)

    def test_another_suite_and_place(self):
        self.assert_passes(self.script("results", "--suite=a/smoke.yaml",
                                       "--out=b"))
        sweep, report = self.runs()
        self.assertRegex(sweep, r"^rtbench sweep (/\S+)/a/smoke.yaml "
                         r"--out=\1/b/smoke --resume$")
        self.assertRegex(report, r"^rtbench report (/\S+)/b/smoke "
                         r"--out=\1/b/report$")

    def test_failed_units_are_reported(self):
        self.write("state/sweep", "1")
        self.assertEqual(self.script("results").returncode, 1)
        self.assertEqual(len(self.runs()), 2)

    def test_an_ended_sweep_is_not(self):
        self.write("state/sweep", "130")
        self.assertEqual(self.script("results").returncode, 130)
        self.assertEqual(len(self.runs()), 1)


class ReadmeResultsTest(ScriptTest):

    def setUp(self):
        super().setUp()
        (self.tree / "scripts").mkdir()
        shutil.copy(ROOT / "scripts" / "readme.py", self.tree / "scripts")

    def readme(self, *arguments):
        return subprocess.run(
            ["/usr/bin/python3", self.tree / "scripts" / "readme.py",
             "--results", *arguments], capture_output=True, text=True,
            check=False)

    def test_it_quotes_the_overview(self):
        file = self.write("README.md", "a\n<!-- results -->\nold\n"
                          "<!-- /results -->\nb\n")
        run = self.readme()
        self.assertEqual(run.returncode, 1)
        self.assertIn("overview.md is missing", run.stderr)
        self.write("results/report/overview.md", "| x \\\\1 |\n")
        self.assertEqual(self.readme().returncode, 0)
        self.assertEqual(file.read_text(), "a\n<!-- results -->\n\n"
                         "| x \\\\1 |\n\n<!-- /results -->\nb\n")

    def test_without_marks_it_changes_nothing(self):
        file = self.write("README.md", "a\n")
        self.assertEqual(self.readme().returncode, 0)
        self.assertEqual(file.read_text(), "a\n")


if __name__ == "__main__":
    unittest.main()
