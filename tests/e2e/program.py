"""Runs the installed program as a user would."""

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
BUILD = Path(os.environ.get("RTBENCH_BUILD", ROOT / "build" / "dev"))
CMAKE = os.environ.get("RTBENCH_CMAKE", "cmake")


class ProgramTest(unittest.TestCase):
    """A test class with the program installed in a prefix of its own."""

    @classmethod
    def setUpClass(cls):
        cls.prefix = Path(tempfile.mkdtemp(prefix="rtbench_prefix_"))
        cls.addClassCleanup(shutil.rmtree, cls.prefix)
        subprocess.run([CMAKE, "--install", BUILD, "--prefix", cls.prefix],
                       check=True, stdout=subprocess.DEVNULL)
        cls.program = cls.prefix / "bin" / "rtbench"

    def setUp(self):
        # Paths relative to an empty working folder, as a user's.
        self.folder = Path(tempfile.mkdtemp(prefix="rtbench_work_"))
        self.addCleanup(shutil.rmtree, self.folder)

    def run_program(self, *args, stdin=b"", env=None, **more):
        """The finished process: output and errors are bytes."""
        environment = {k: v for k, v in os.environ.items()
                       if k not in ("NO_COLOR", "RTBENCH_DATA")}
        environment.update(env or {})
        streams = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
        return subprocess.run([self.program, *map(str, args)], input=stdin,
                              cwd=self.folder, env=environment, timeout=300,
                              check=False, **{**streams, **more})

    def succeed(self, *args, **more):
        """Standard output (bytes) of a run that must succeed."""
        process = self.run_program(*args, **more)
        self.assertEqual(process.returncode, 0,
                         (args, process.stderr.decode()))
        return process.stdout

    def fail_with(self, status, *args, says=(), **more):
        """One clear line on standard error, nothing on standard output."""
        process = self.run_program(*args, **more)
        error = process.stderr.decode()
        self.assertEqual(process.returncode, status, (args, error))
        self.assertEqual(process.stdout or b"", b"", args)
        self.assertRegex(error, r"\Artbench: [^\n]+\n\Z", args)
        for part in [says] if isinstance(says, str) else says:
            self.assertIn(part, error, args)
        return error

    def write(self, name, content):
        """A file in the working folder."""
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes)
                         else content.encode())
        return path
