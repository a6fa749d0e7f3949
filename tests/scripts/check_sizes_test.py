"""check_sizes.py finds files that grew too long."""

import unittest

from script_case import ROOT, ScriptTest


class CheckSizesTest(ScriptTest):

    def check(self, *arguments):
        return self.run_command(ROOT / "scripts/check_sizes.py",
                                f"--root={self.tree}", *arguments)

    def test_up_to_300_lines_pass(self):
        self.write("core/base/a.cc", "int x;\n" * 300)
        self.assert_passes(self.check())

    def test_301_lines_fail(self):
        self.write("core/base/a.cc", "int x;\n" * 301)
        self.assert_fails(self.check(), "core/base/a.cc:301: 301 lines")

    def test_tables_are_exempt(self):
        self.write("core/base/a_table.cc", "int x;\n" * 301)
        self.write("core/base/b_table.inc", "1,\n" * 301)
        self.assert_passes(self.check())

    def test_an_allowance_needs_a_reason(self):
        self.write("core/base/a.cc", "int x;\n" * 301)
        self.write("scripts/size_allowances.txt",
                   "# why\ncore/base/a.cc one long table of states\n")
        self.assert_passes(self.check())
        self.write("scripts/size_allowances.txt", "core/base/a.cc\n")
        self.assert_fails(self.check(), "gives no reason")

    def test_an_allowance_that_nobody_needs_fails(self):
        self.write("core/base/a.cc", "int x;\n")
        self.write("scripts/size_allowances.txt", "core/base/a.cc once long\n")
        self.assert_fails(self.check(), "core/base/a.cc needs no allowance")

    def test_long_functions_are_advice(self):
        # 1 signature + 39 statements + 1 brace = 41 lines, and one of 40.
        self.write("core/base/a.cc",
                   "namespace rtb {\nvoid Long(int a,\n          int b) {\n"
                   + "  F(\"{\");\n" * 39 + "}\n\nvoid Short() {\n"
                   + "  F();\n" * 38 + "}\n}\n")
        run = self.check("--functions")
        self.assert_passes(run)
        self.assertEqual(run.stdout,
                         "core/base/a.cc:3: a function of 41 lines\n")


if __name__ == "__main__":
    unittest.main()
