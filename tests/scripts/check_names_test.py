"""check_names.py finds two types of one name."""

import unittest

from script_case import ROOT, ScriptTest


class CheckNamesTest(ScriptTest):

    def check(self):
        return self.run_command(ROOT / "scripts/check_names.py",
                                f"--root={self.tree}")

    def setUp(self):
        super().setUp()
        self.write("core/scene/a.h",
                   "namespace rtb {\nstruct Plane {\n};\n}  // namespace rtb\n")

    def test_same_name_in_another_file_fails(self):
        for text in ("class Plane {\n};\n", "class Plane final : Base {\n};\n",
                     "enum class Plane { kOne };\n", "struct Plane : Base {};\n"):
            self.write("harness/b.h", "namespace rtb {\n" + text)
            self.assert_fails(self.check(), "harness/b.h:2: Plane is also the "
                              "name of a type at core/scene/a.h:2")

    def test_other_uses_of_the_name_pass(self):
        self.write("harness/b.cc", """namespace rtb {
struct Plane;
struct Planes {};
struct Outer::Plane {};
struct Plane<int> {};
namespace {
struct Plane {};
}  // namespace
}  // namespace rtb
""")
        self.assert_passes(self.check())


if __name__ == "__main__":
    unittest.main()
