"""scripts/setup installs what is missing, and nothing when nothing is."""

import unittest

from fake_machine import FakeMachineTest

INSTALL = ("apt-get -o DPkg::Lock::Timeout=300 install -y "
           "--no-install-recommends ")
UPDATE = "apt-get -o DPkg::Lock::Timeout=300 update"


class SetupTest(FakeMachineTest):

    def apt_calls(self):
        return [call for call in self.calls() if call.startswith("apt-get")]

    def test_nothing_missing_calls_nothing_and_says_nothing(self):
        self.install(self.packages("build", "run"))
        run = self.script("setup", "build", "run")
        self.assert_passes(run)
        self.assertEqual(self.calls(), [])
        self.assertEqual(run.stdout + run.stderr, "")

    def test_installs_just_what_is_missing_and_says_so(self):
        packages = self.packages("build")
        self.install(packages[2:])
        run = self.script("setup", "build")
        self.assert_passes(run)
        missing = " ".join(packages[:2])
        self.assertEqual(self.apt_calls(), [INSTALL + missing])
        self.assertIn("frontend noninteractive", self.calls())
        self.assertIn("installing 2 Debian packages: " + missing, run.stderr)
        self.assertEqual(run.stdout, "")
        self.assertNotIn("noise", run.stderr)

    def test_second_run_finds_everything(self):
        self.assert_passes(self.script("setup", "all"))
        self.assertEqual(len(self.apt_calls()), 1)
        self.assert_passes(self.script("setup", "all"))
        self.assertEqual(len(self.apt_calls()), 1)

    def test_optional_sections_are_left_alone(self):
        self.assert_passes(self.script("setup", "build", "run", "test"))
        self.assertNotIn("povray", self.apt_calls()[0])
        self.assertNotIn("doxygen", self.apt_calls()[0])

    def test_removed_package_with_its_configuration_left_is_missing(self):
        self.write("repo/scripts/packages.txt", "[x]\nhalf-removed # a\n")
        self.assert_passes(self.script("setup", "x"))
        self.assertEqual(self.apt_calls(), [INSTALL + "half-removed"])

    def test_fetches_the_package_lists_when_it_must(self):
        (self.tree / "state/lists").unlink()
        self.write("repo/scripts/packages.txt", "[x]\none\n")
        self.assert_passes(self.script("setup", "x"))
        self.assertEqual(self.apt_calls(),
                         [INSTALL + "one", UPDATE, INSTALL + "one"])

    def test_without_network_it_fails_and_shows_why(self):
        (self.tree / "state/lists").unlink()
        self.write("state/offline")
        run = self.script("setup", "build")
        self.assertEqual(run.returncode, 1)
        self.assertIn("apt-get failed", run.stderr)

    def test_user_with_sudo_installs_through_it(self):
        self.become(1000)
        self.fake("sudo", '#!/bin/bash\necho "sudo $*" >>"$STATE/calls"\n'
                  '[[ $1 == -n ]] && shift\nexec "$@"\n')
        self.fake("true", "#!/bin/bash\n")
        self.write("repo/scripts/packages.txt", "[x]\none\n")
        self.assert_passes(self.script("setup", "x"))
        self.assertEqual(self.apt_calls(), [INSTALL + "one"])
        self.assertTrue(any(call.startswith("sudo -n env DEBIAN_FRONTEND")
                            for call in self.calls()), self.calls())

    def test_user_without_sudo_is_told_the_command(self):
        self.become(1000)
        for sudo in (None, "#!/bin/bash\nexit 1\n"):  # absent; wants to ask
            if sudo:
                self.fake("sudo", sudo)
            self.write("repo/scripts/packages.txt", "[x]\none\ntwo\n")
            run = self.script("setup", "x")
            self.assertEqual(run.returncode, 3)
            self.assertIn("sudo apt-get install --no-install-recommends one "
                          "two\n", run.stderr)
            self.assertEqual(self.calls(), [])

    def test_user_with_everything_installed_needs_no_sudo(self):
        self.become(1000)
        self.install(self.packages("build"))
        self.assert_passes(self.script("setup", "build"))

    def test_other_systems_are_told_the_names(self):
        (self.tree / "bin/dpkg-query").unlink()
        run = self.script("setup", "reference")
        self.assertEqual(run.returncode, 3)
        self.assertIn("not a Debian system", run.stderr)
        self.assertIn("povray", run.stderr)
        run = self.run_command(
            self.tree / "repo/scripts/setup", "reference",
            PATH=str(self.tree / "bin"), RTB_SKIP_SETUP="1")
        self.assert_passes(run)

    def test_unknown_section_and_no_section_are_usage_errors(self):
        for arguments in (["nonsense"], []):
            run = self.script("setup", *arguments)
            self.assertEqual(run.returncode, 2, run.stderr)
            self.assertEqual(self.calls(), [])


if __name__ == "__main__":
    unittest.main()
