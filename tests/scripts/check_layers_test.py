"""check_layers.py finds every kind of planted violation, and no other."""

import unittest

from script_case import ROOT, ScriptTest


class CheckLayersTest(ScriptTest):

    def check(self):
        return self.run_command(ROOT / "scripts/check_layers.py",
                                f"--root={self.tree}")

    def setUp(self):
        super().setUp()
        self.write("core/base/a.h", "#pragma once\n#include <vector>\n")
        self.write("core/math/m.h", '#include "core/base/a.h"\n')
        self.write("encoders/e.h", '#include "core/math/m.h"\n')
        self.write("harness/commands/c.cc",
                   '#include "encoders/e.h"\nint f() { std::cout << 1; }\n')

    def test_clean_tree_passes(self):
        self.assert_passes(self.check())

    def test_empty_tree_fails(self):
        run = self.run_command(ROOT / "scripts/check_layers.py",
                               f"--root={self.tree / 'none'}")
        self.assert_fails(run, "no sources found")

    def test_upward_between_top_folders(self):
        self.write("core/base/b.h", '\n#include "encoders/e.h"\n')
        self.assert_fails(self.check(), "core/base/b.h:2: core may not "
                          "include encoders/e.h")

    def test_reference_may_not_use_encoders(self):
        self.write("reference/r.cc", '#include "encoders/e.h"\n')
        self.assert_fails(self.check(), "reference/r.cc:1:")

    def test_upward_inside_core(self):
        self.write("core/base/b.h", '#include "core/math/m.h"\n')
        self.assert_fails(self.check(), "core/base/b.h:1:", "comes later")

    def test_unknown_folder_of_core(self):
        self.write("core/misc/b.h", '#include "core/math/m.h"\n')
        self.assert_fails(self.check(), "core/misc is not in the order")

    def test_sources_may_not_include_tests(self):
        self.write("tests/core/t.h")
        self.write("core/base/b.h", '#include "tests/core/t.h"\n')
        self.assert_fails(self.check(), "core may not include tests")

    def test_missing_and_relative_includes(self):
        self.write("core/base/b.h",
                   '#include "core/base/gone.h"\n#include "a.h"\n')
        self.assert_fails(self.check(), "core/base/b.h:1: core/base/gone.h",
                          "core/base/b.h:2: a.h")

    def test_a_file_that_the_build_writes(self):
        self.write("cmake/Info.cmake", "configure_file(x info.inc)\n")
        self.write("core/base/b.cc", '#include "info.inc"\n')
        self.assert_passes(self.check())

    def test_own_header_in_angle_brackets(self):
        self.write("core/base/b.h", "#include <core/base/a.h>\n")
        self.assert_fails(self.check(), "core/base/b.h:1: write")

    def test_libraries_of_one_folder(self):
        self.write("core/accel/ok.cc", "#include <embree3/rtcore.h>\n")
        self.write("core/cuda/ok.cc", "#include <cuda_runtime.h>\n")
        self.write("encoders/cuda/ok.cu", "#include <cuda_runtime.h>\n")
        self.write("harness/live/ok.cc", "#include <ncurses.h>\n")
        self.assert_passes(self.check())
        for header, folder in (("embree3/rtcore.h", "core/accel"),
                               ("cuda_runtime.h", "cuda"),
                               ("ncurses.h", "harness/live")):
            self.write("core/render/r.cc", f"#include <{header}>\n")
            self.assert_fails(self.check(), f"only {folder} may include")

    def test_cuda_sources_stand_in_folders_of_that_name(self):
        self.write("core/render/k.cu", "")
        self.assert_fails(self.check(), "core/render/k.cu:1:")

    def test_cycle(self):
        self.write("core/base/a.h", '#include "core/base/b.h"\n')
        self.write("core/base/b.h", '#include "core/base/a.h"\n')
        self.assert_fails(self.check(), "include cycle: core/base/a.h -> "
                          "core/base/b.h -> core/base/a.h")

    def test_printing_and_exiting(self):
        for code in ("std::cerr << 1;", "printf(\"x\");", "exit(1);",
                     "std::exit(1);", "fprintf(stderr, \"x\");",
                     "std::fputs(text, stdout);"):
            self.write("core/base/b.cc", f"// one\nvoid f() {{ {code} }}\n")
            self.assert_fails(self.check(), "core/base/b.cc:2: `")

    def test_what_only_looks_like_printing(self):
        self.write("core/base/b.cc", '''// std::cout << "exit(1)"
/* printf("x") */
const char* text = "std::cerr << \\" exit(1)";
const char* raw = R"(printf("x"); )";
int n = 1'000'000;  // the mark opens no character
void g() { std::snprintf(buffer, 4, "%d", n); loop.exit(); _exit(1); }
''')
        self.assert_passes(self.check())

    def test_exceptions_and_tests_may_print(self):
        self.write("core/base/check.cc", "void f() { std::cerr << 1; }\n")
        self.write("tests/core/t.cc", "void f() { std::cerr << 1; }\n")
        self.assert_passes(self.check())


if __name__ == "__main__":
    unittest.main()
