"""check_words.py finds marks of unfinished work and machines' paths."""

import unittest

from script_case import ROOT, ScriptTest

# Put together here, so that this file passes the check itself.
MARKS = ["TO" + "DO", "FIX" + "ME", "X" * 3, "HA" + "CK"]
PLACES = ["/" + place for place in ("home/ann/x", "root/x", "tmp/out.png",
                                    "Users/ann/x")]
WORK = "/work" + "/x"  # fine below another folder


class CheckWordsTest(ScriptTest):

    def check(self):
        return self.run_command(ROOT / "scripts/check_words.py",
                                f"--root={self.tree}")

    def test_each_mark_fails(self):
        for mark in MARKS:
            self.write("core/a.cc", f"int x;\n// {mark}: later\n")
            self.assert_fails(self.check(), f"core/a.cc:2: `{mark}`")

    def test_each_place_fails(self):
        for place in PLACES:
            self.write("docs/a.md", f"see `{place}`\n")
            self.assert_fails(self.check(), "docs/a.md:1: ")

    def test_files_without_suffix_are_read(self):
        self.write("scripts/run", f"#!/bin/bash\n# {MARKS[0]}\n")
        self.assert_fails(self.check(), "scripts/run:2:")

    def test_what_only_looks_like_it(self):
        self.write("core/a.cc", "mktemp a." + "X" * 6 + "; // hack, todo list\n"
                   "read(\"/usr/share/fonts/x.ttf\", \"$HOME" + WORK + "\",\n"
                   "     \"docs" + WORK + "\", \"/dev/stdout\")\n"
                   "picture({\"" + "X" * 3 + "\", \"X..\"});\n")
        self.write("build/a.cc", MARKS[0])
        self.write("results/local/a.md", MARKS[0])
        self.write("a.exr", MARKS[0])
        self.assert_passes(self.check())


if __name__ == "__main__":
    unittest.main()
