"""scripts/build, rtbench and test on a fake machine."""

import unittest

from fake_machine import FakeMachineTest


class BuildTest(FakeMachineTest):

    def tools(self):
        """Which tools were called, in order, without their arguments."""
        return [call.split()[0] for call in self.calls()
                if not call.startswith("frontend")]

    def test_fresh_machine_installs_configures_builds_and_runs(self):
        run = self.script("rtbench", "--scene=cornell", "two words")
        self.assert_passes(run)
        self.assertEqual(self.tools(), ["apt-get", "cmake", "ninja"])
        self.assertIn("cmake --preset release", self.calls())
        self.assertEqual(self.calls()[-1],
                         f"ninja -C {self.tree}/repo/build/release rtbench")
        # Standard output is the program's alone, and it runs where one is.
        self.assertEqual(run.stdout, f"program in {self.tree} with: "
                         "--scene=cornell two words\n")

    def test_second_run_asks_ninja_alone(self):
        self.assert_passes(self.script("rtbench"))
        self.write("state/calls")
        self.assert_passes(self.script("rtbench"))
        self.assertEqual(self.tools(), ["ninja"])

    def test_exit_status_is_the_programs(self):
        self.write("state/program", "#!/bin/bash\nexit 7\n")
        self.assertEqual(self.script("rtbench").returncode, 7)

    def test_another_preset(self):
        self.assert_passes(self.script("build", "--preset=dev", "a", "b"))
        self.assertEqual(self.calls()[-1],
                         f"ninja -C {self.tree}/repo/build/dev a b")

    def test_failed_configuration_shows_why_and_is_tried_again(self):
        self.write("state/cmake-fails")
        run = self.script("rtbench")
        self.assertEqual(run.returncode, 1)
        self.assertIn("no such library", run.stderr)
        self.assertEqual(run.stdout, "")
        (self.tree / "state/cmake-fails").unlink()
        self.assert_passes(self.script("rtbench"))

    def test_failed_build_shows_the_compilers_words_and_runs_nothing(self):
        self.write("state/ninja-fails")
        run = self.script("rtbench")
        self.assertEqual(run.returncode, 1)
        self.assertIn("a.cc:1: error: bad", run.stderr)
        self.assertNotIn("Building CXX", run.stderr)
        self.assertEqual(run.stdout, "")

    def test_missing_rights_end_it_before_the_build(self):
        self.become(1000)
        self.assertEqual(self.script("rtbench").returncode, 3)
        self.assertEqual(self.calls(), [])

    def test_unknown_option_is_a_usage_error(self):
        self.assertEqual(self.script("build", "--fast").returncode, 2)


class TestTest(FakeMachineTest):

    def ctest(self, *arguments):
        """How ctest is called for these arguments of scripts/test."""
        run = self.script("test", *arguments)
        self.assert_passes(run)
        self.assertEqual(run.stdout, "100% tests passed\n")
        return self.calls()[-1]

    def setUp(self):
        super().setUp()
        self.fake("nproc", "#!/bin/bash\necho 4\n")

    def test_fresh_machine_installs_builds_everything_and_tests(self):
        self.assertEqual(self.ctest(),
                         "ctest --preset release -j 4 -LE ^slow$")
        self.assertIn(f"ninja -C {self.tree}/repo/build/release",
                      self.calls())
        installed = (self.tree / "state/installed").read_text().split()
        for package in self.packages("build", "run", "test"):
            self.assertIn(package, installed)

    def test_all_includes_the_slow_ones(self):
        self.assertEqual(self.ctest("--all"), "ctest --preset release -j 4")

    def test_arguments_go_to_ctest(self):
        self.assertEqual(
            self.ctest("--preset=asan", "-R", "Encoder|a b"),
            "ctest --preset asan -j 4 -LE ^slow$ -R Encoder|a b")
        self.assertEqual(self.ctest("-LE", "gpu"),
                         "ctest --preset release -j 4 -LE gpu")

    def test_status_is_that_of_ctest(self):
        self.fake("ctest", "#!/bin/bash\nexit 8\n")
        self.assertEqual(self.script("test").returncode, 8)

    def test_failed_build_tests_nothing(self):
        self.write("state/ninja-fails")
        self.assertEqual(self.script("test").returncode, 1)
        self.assertNotIn("ctest", self.calls()[-1])


if __name__ == "__main__":
    unittest.main()
