#!/usr/bin/python3
"""The README's figures are what the main job prints."""

import subprocess
import unittest

from program import ROOT, ProgramTest


class ReadmeTest(ProgramTest):

    def test_table_is_the_programs(self):
        check = subprocess.run(
            [ROOT / "scripts" / "readme.py", "--check",
             f"--program={self.program}"],
            stderr=subprocess.PIPE, text=True, check=False)
        self.assertEqual(check.returncode, 0, check.stderr)

    def test_pictures_it_shows_exist(self):
        text = (ROOT / "README.md").read_text()
        names = [part.split(")")[0] for part in text.split("](")[1:]]
        self.assertIn("docs/images/whitted-octant.png", names)
        for name in names:
            if "://" not in name:
                self.assertTrue((ROOT / name).exists(), name)


if __name__ == "__main__":
    unittest.main()
