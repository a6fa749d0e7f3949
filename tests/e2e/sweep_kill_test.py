#!/usr/bin/python3
"""A sweep that is killed at any moment loses nothing and can go on."""

import json
import random
import shutil
import subprocess
import time
import unittest

from sweeps import SweepTest, contents

KILLS = 20


class KillTest(SweepTest):

    def check_whole(self, folder):
        """What is there under a unit's name is a whole record, and so are the
        pictures that it names."""
        for path in folder.glob("units/*.json"):
            unit = json.loads(path.read_text())
            for run in unit["runs"]:
                for name in run.get("pictures", {}).values():
                    picture = folder / "pictures" / name
                    self.assertGreater(picture.stat().st_size, 0, name)

    def test_twenty_kills(self):
        # Little work, so that twenty rounds of it take little time.
        self.suite.write_text(self.suite.read_text().replace(
            "quadrant, search,", "search,").replace("repeat: 2", "repeat: 1"))
        began = time.monotonic()
        self.sweep("whole")
        duration = time.monotonic() - began
        whole = contents(self.folder / "whole")
        folder = self.folder / "killed"
        moments = random.Random(5)
        kills = 0
        interrupted = False
        while kills < KILLS:
            process = subprocess.Popen(
                [self.program, "sweep", self.suite, f"--out={folder}",
                 "--resume", "--quiet"], cwd=self.folder,
                env=self.environment(), stdout=subprocess.DEVNULL)
            try:
                process.wait(moments.uniform(0, duration))
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
                kills += 1
                interrupted = True
                self.check_whole(folder)
                continue
            # It came to its end: what many pieces made is what one run made.
            self.assertEqual(process.returncode, 0)
            self.assertEqual(contents(folder), whole)
            shutil.rmtree(folder)
            interrupted = False
        if interrupted:
            self.sweep("killed", "--resume")
            self.assertEqual(contents(folder), whole)


if __name__ == "__main__":
    unittest.main()
