#!/usr/bin/python3
"""A session of the live mode in tmux: what a person sees, key by key.

Ends with status 77 (skipped, for ctest) where tmux is missing.
"""

import json
import re
import shutil
import subprocess
import sys
import time
import unittest

from program import ProgramTest

PATIENCE = 90

if not shutil.which("tmux"):
    print("skipped: there is no tmux")
    sys.exit(77)


class Tmux:
    """A tmux server of its own with one window, without a person."""

    def __init__(self, folder, size):
        self.socket = str(folder / "tmux")
        self.run("-f", "/dev/null", "new-session", "-d", "-x", str(size[0]),
                 "-y", str(size[1]), "env LC_ALL=C.UTF-8 PS1='$ ' sh")

    def run(self, *args):
        return subprocess.run(
            ["tmux", "-S", self.socket, *args], check=True,
            stdout=subprocess.PIPE, timeout=PATIENCE).stdout.decode()

    def keys(self, *keys):
        self.run("send-keys", *keys)

    def screen(self, colors=False):
        return self.run("capture-pane", "-p", *(["-e"] if colors else []))

    def flags(self):
        return self.run("display", "-p", "#{alternate_on} #{cursor_flag} "
                        "#{mouse_any_flag} #{wrap_flag}").split()

    def wait_for(self, condition, what):
        end = time.monotonic() + PATIENCE
        while True:
            screen = self.screen()
            if condition(screen):
                return screen
            if time.monotonic() > end:
                raise AssertionError(f"{what}: waited in vain\n{screen}")
            time.sleep(0.1)

    def close(self):
        self.run("kill-server")


class LiveTmuxTest(ProgramTest):

    def setUp(self):
        super().setUp()
        self.tmux = Tmux(self.folder, (120, 40))
        self.addCleanup(self.tmux.close)

    def start(self, *args):
        command = " ".join(["cd", str(self.folder), "&& stty -g >before;",
                            str(self.program), "live", "--scene=whitted",
                            *args, "; echo status $?; stty -g >after"])
        self.tmux.keys(command, "Enter")
        self.tmux.wait_for(lambda s: "? help" in s and "fps" in s, "panel")

    def quit(self):
        self.tmux.keys("C-c")
        self.tmux.wait_for(lambda s: "status 0" in s, "the end")
        self.assertEqual(self.tmux.flags(), ["0", "1", "0", "1"])
        before = self.folder / "before"
        self.assertEqual(before.read_text(),
                         (self.folder / "after").read_text())

    def test_a_session(self):
        tmux = self.tmux
        self.start("--color=truecolor")
        self.assertEqual(tmux.flags()[:3], ["1", "0", "1"])
        screen = tmux.screen(colors=True)
        self.assertRegex(screen, r"\[[\d;]*[34]8;2;\d+;\d+;\d+")
        # Moves: the picture is another one.
        tmux.keys("p")
        picture = [line[:80] for line in tmux.screen().split("\n")]
        tmux.keys("w", "w", "w", "d", "d")
        tmux.wait_for(
            lambda s: [line[:80] for line in s.split("\n")] != picture,
            "a moved camera")
        # Another encoder, a split screen, help and its end.
        tmux.keys("n")
        tmux.wait_for(lambda s: re.search(r"encoder +search", s), "encoder")
        tmux.keys("v")
        tmux.wait_for(lambda s: "left" in s and "right*" in s, "split")
        tmux.keys("?")
        tmux.wait_for(lambda s: "split screen of two encoders" in s, "help")
        tmux.keys("?")
        tmux.wait_for(lambda s: "split screen of two" not in s, "no help")
        tmux.keys("v")
        # Screenshot and recording.
        tmux.keys("x")
        tmux.wait_for(lambda s: "wrote rtbench-live-001" in s, "screenshot")
        tmux.keys("R")
        tmux.wait_for(lambda s: "REC" in s, "recording")
        tmux.keys("R")
        tmux.wait_for(lambda s: "recorded rtbench-live" in s, "recorded")
        self.quit()
        cells = json.loads((self.folder / "rtbench-live-001.json").read_text())
        self.assertEqual([cells["columns"], cells["rows"]], [86, 40])
        self.assertTrue((self.folder / "rtbench-live-001.png").exists())

    def test_resizes(self):
        self.start("--color=truecolor")
        for columns, rows in ((60, 20), (10, 3), (100, 30)):
            self.tmux.run("resize-window", "-x", str(columns), "-y", str(rows))
            time.sleep(0.5)
        self.tmux.wait_for(
            lambda s: re.search(r"grid +66 x 30", s), "the new size")
        self.quit()

    def test_scenes_are_picked(self):
        self.start("--color=truecolor")
        self.tmux.keys("l")
        self.tmux.wait_for(lambda s: "scene: arrows" in s, "list")
        self.tmux.keys("Down")
        self.tmux.wait_for(lambda s: "> cornell" in s, "a choice")
        self.tmux.keys("Enter")
        self.tmux.wait_for(lambda s: re.search(r"scene +cornell", s), "scene")
        self.quit()

    def test_ncurses_in_256_colors(self):
        self.start("--color=256", "--present=ncurses")
        self.assertRegex(self.tmux.screen(colors=True),
                         r"\[[\d;]*[34]8;5;\d+")
        self.assertIn("present  ncurses", self.tmux.screen())
        self.tmux.run("resize-window", "-x", "90", "-y", "30")
        self.tmux.wait_for(lambda s: re.search(r"grid +56 x 30", s), "size")
        self.quit()

    def test_suspends_in_a_shell(self):
        self.start("--color=truecolor")
        self.tmux.keys("C-z")
        self.tmux.wait_for(lambda s: "Stopped" in s, "the shell")
        self.assertEqual(self.tmux.flags(), ["0", "1", "0", "1"])
        self.tmux.keys("fg", "Enter")
        self.tmux.wait_for(lambda s: "? help" in s, "the picture again")
        self.tmux.keys("C-c")
        self.tmux.wait_for(lambda s: "? help" not in s, "the shell again")
        # The shell may still be about to write its prompt.
        self.tmux.keys("stty -g >after; echo do''ne", "Enter")
        self.tmux.wait_for(lambda s: re.search(r"(?m)done$", s), "the end")
        self.assertEqual(self.tmux.flags(), ["0", "1", "0", "1"])
        self.assertEqual((self.folder / "before").read_text(),
                         (self.folder / "after").read_text())


if __name__ == "__main__":
    unittest.main()
