#!/usr/bin/python3
"""Where output goes, and what happens when it cannot."""

import os
import pty
import subprocess
import unittest

from pictures import gradient, png
from program import ProgramTest


class StreamsTest(ProgramTest):

    def setUp(self):
        super().setUp()
        self.write("in.png", png(64, 64, gradient))
        self.encode = ["encode", "--input=in.png", "--encoder=half",
                       "--grid=200x80"]

    def test_full_disk(self):
        with open("/dev/full", "wb") as full:
            error = self.fail_with(1, *self.encode, stdout=full)
        self.assertIn("standard output", error)
        self.fail_with(1, *self.encode, "--output=/dev/full",
                       says="/dev/full")

    def test_closed_pipe(self):
        reader, writer = os.pipe()
        os.close(reader)
        try:
            error = self.fail_with(1, *self.encode, stdout=writer)
        finally:
            os.close(writer)
        self.assertIn("standard output", error)

    def test_closed_descriptors(self):
        command = f"'{self.program}' " + " ".join(self.encode)
        run = subprocess.run(["sh", "-c", command + " >&-"], cwd=self.folder,
                             stderr=subprocess.PIPE, check=False)
        self.assertEqual(run.returncode, 1)
        self.assertIn(b"standard output", run.stderr)
        run = subprocess.run(["sh", "-c", command + " 2>&- <&-"],
                             cwd=self.folder, stdout=subprocess.PIPE,
                             check=True)
        self.assertEqual(run.stdout, self.succeed(*self.encode))

    def test_unwritable_folder(self):
        self.write("file", "")
        self.fail_with(1, *self.encode, "--output=file/out.ansi",
                       says="file")
        self.fail_with(1, "--scene=cornell", "--encoder=half", "--grid=6x2",
                       "--reference=self", "--out=file/dir", "--quiet",
                       says="file/dir")

    def on_terminal(self, *args, env=None):
        """Exit status, and what standard output and errors show."""
        main, child = pty.openpty()
        process = subprocess.Popen([self.program, *args], cwd=self.folder,
                                   stdout=child, stderr=child,
                                   stdin=subprocess.DEVNULL,
                                   env={**os.environ, **(env or {})})
        os.close(child)
        shown = b""
        while True:
            try:
                part = os.read(main, 65536)
            except OSError:  # the other end is closed
                break
            if not part:
                break
            shown += part
        os.close(main)
        return process.wait(), shown

    def test_png_does_not_go_to_a_terminal(self):
        status, shown = self.on_terminal(*self.encode, "--format=png")
        self.assertEqual(status, 2)
        self.assertIn(b"terminal", shown)
        self.assertNotIn(b"PNG\r", shown[:8])

    def test_errors_are_red_on_a_terminal_unless_unwanted(self):
        red = b"\x1b[31mrtbench:\x1b[0m"
        self.assertIn(red, self.on_terminal("sweep", env={"NO_COLOR": ""})[1])
        status, shown = self.on_terminal("sweep", env={"NO_COLOR": "1"})
        self.assertEqual(status, 2)
        self.assertNotIn(b"\x1b", shown)
        self.assertNotIn(b"\x1b", self.run_program("sweep").stderr)


if __name__ == "__main__":
    unittest.main()
