"""What the tests of the scripts share: a temporary tree, and running in it."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent


class ScriptTest(unittest.TestCase):
    """A test case with a temporary folder of its own, `self.tree`."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.tree = Path(folder.name).resolve()

    def write(self, name, text="", executable=False):
        """Writes a file of the tree and returns its path."""
        path = self.tree / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
        if executable:
            path.chmod(0o755)
        return path

    def run_command(self, *command, **environment):
        """Runs a program to its end; None removes a variable."""
        variables = {k: v for k, v in {**os.environ, **environment}.items()
                     if v is not None}
        return subprocess.run([str(c) for c in command], env=variables,
                              cwd=self.tree, stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=60,
                              check=False)

    def assert_passes(self, run):
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)

    def assert_fails(self, run, *words):
        """Exit status 1, and all the words in the output."""
        self.assertEqual(run.returncode, 1, run.stdout + run.stderr)
        for word in words:
            self.assertIn(word, run.stdout)
