""".ci/run runs every step, fails when one does, and says the verdict last."""

import shutil
import unittest

from fake_machine import FakeMachineTest
from script_case import ROOT

CHECKS = ["check_layers.py", "check_names.py", "check_sizes.py",
          "check_words.py", "check_format"]
SETUP = "setup build run report test test-report docs"
VERDICT = "50% tests passed, 1 tests failed out of 2"


class CiTest(FakeMachineTest):

    def setUp(self):
        super().setUp()
        shutil.copytree(ROOT / ".ci", self.tree / "repo/.ci")
        for tool in ("tee", "sed"):
            (self.tree / "bin" / tool).symlink_to(shutil.which(tool))
        for name in ["setup", "test", "build", "docs"] + CHECKS:
            self.stub(name)

    def stub(self, name, status=0):
        """A script that writes down its call."""
        self.write(f"repo/scripts/{name}",
                   f'#!/bin/bash\necho "{name} $*" >>"$STATE/calls"\n'
                   f'[[ {name} == test ]] && echo "{VERDICT}"\n'
                   f"exit {status}\n", executable=True)

    def ci(self, *steps):
        return self.script("../.ci/run", *steps)

    def test_runs_the_deciding_step_first(self):
        run = self.ci()
        self.assert_passes(run)
        self.assertEqual(
            [call.strip() for call in self.calls()],
            [SETUP, "test"] + CHECKS +
            ["docs", "build --preset=dev", "test --preset=asan",
             "test --all -L ^ptx$"])
        self.assertTrue(run.stdout.endswith(
            VERDICT + "\nci: everything succeeded\n"), run.stdout)

    def test_a_failing_step_fails_it_all_but_stops_nothing(self):
        for name, line in (("test", "test     FAILED"),
                           ("check_sizes.py", "checks   FAILED"),
                           ("docs", "docs     FAILED"),
                           ("build", "dev      FAILED")):
            self.write("state/calls")
            self.stub(name, status=1)
            run = self.ci()
            self.assertEqual(run.returncode, 1)
            self.assertIn(line, run.stdout)
            self.assertIn("test --preset=asan", self.calls())
            self.assertTrue(run.stdout.endswith("ci: FAILED\n"))
            self.stub(name)

    def test_single_steps(self):
        self.assert_passes(self.ci("docs"))
        self.assertEqual([call.strip() for call in self.calls()],
                         [SETUP, "docs"])
        self.assertEqual(self.ci("nonsense").returncode, 2)


if __name__ == "__main__":
    unittest.main()
