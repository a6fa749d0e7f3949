"""check_format finds a file that clang-format would change."""

import shutil
import unittest

from script_case import ROOT, ScriptTest


@unittest.skipUnless(shutil.which("clang-format"), "no clang-format")
class CheckFormatTest(ScriptTest):

    def setUp(self):
        super().setUp()
        shutil.copy(ROOT / ".clang-format", self.tree)

    def check(self, *arguments, **environment):
        return self.run_command(ROOT / "scripts/check_format", *arguments,
                                self.tree, **environment)

    def test_formatted_file_passes(self):
        self.write("core/base/a.cc", "int Two() { return 2; }\n")
        self.assert_passes(self.check())

    def test_other_spacing_fails_and_can_be_fixed(self):
        self.write("core/base/a.cc", "int Two(){ return 2; }\n")
        self.assert_fails(self.check(), "core/base/a.cc:1:")
        self.assert_passes(self.check("--fix"))
        self.assert_passes(self.check())

    def test_headers_of_tests_too(self):
        self.write("tests/core/a.h", "int  x;\n")
        self.assert_fails(self.check(), "tests/core/a.h:1:")

    def test_no_sources_fails(self):
        self.assertEqual(self.check().returncode, 1)

    def test_without_clang_format_it_is_skipped(self):
        self.write("core/base/a.cc", "int  x;\n")
        (self.tree / "bin").mkdir()
        for tool in ("bash", "env"):
            (self.tree / "bin" / tool).symlink_to(shutil.which(tool))
        run = self.check(PATH=str(self.tree / "bin"))
        self.assertEqual(run.returncode, 77, run.stderr)


if __name__ == "__main__":
    unittest.main()
