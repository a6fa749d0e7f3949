#!/usr/bin/python3
"""The live mode in a pseudo terminal: keys, sizes, signals, and a terminal
that is given back as it was."""

import json
import re
import signal
import unittest

from program import ProgramTest
from terminal import Terminal

LEAVE = (b"\x1b[?1006l", b"\x1b[?1002l", b"\x1b[?7h", b"\x1b[?25h",
         b"\x1b[?1049l")
# One frame ends with the question that the terminal answers.
FRAME = b"\x1b[5n"


class LiveTest(ProgramTest):

    def start(self, *args, **more):
        terminal = Terminal(
            [self.program, "live", "--scene=whitted", *args],
            cwd=self.folder, **more)
        self.addCleanup(terminal.close)
        return terminal

    def drawn(self, *args, **more):
        terminal = self.start(*args, **more)
        terminal.wait_for(lambda o: o.count(FRAME) >= 2, "two frames")
        return terminal

    def assert_given_back(self, terminal):
        """The last bytes leave what was entered; modes are as before."""
        entered = terminal.output.rfind(b"\x1b[?1049h")
        end = terminal.output[entered:]
        for sequence in LEAVE:
            self.assertIn(sequence, end)
        self.assertEqual(terminal.modes_now(), terminal.modes)

    def test_quits_by_key(self):
        terminal = self.drawn()
        terminal.send("\x03")
        self.assertEqual(terminal.wait(), 0)
        self.assert_given_back(terminal)

    def test_signals_end_it_and_the_terminal_is_given_back(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP,
                       signal.SIGQUIT):
            terminal = self.drawn()
            terminal.signal(number)
            self.assertEqual(terminal.wait(), -number)
            self.assert_given_back(terminal)

    def test_crashes_give_the_terminal_back(self):
        for number in (signal.SIGSEGV, signal.SIGABRT, signal.SIGBUS):
            terminal = self.drawn()
            terminal.signal(number)
            self.assertEqual(terminal.wait(), -number)
            self.assert_given_back(terminal)

    def test_resizes_down_to_one_cell_and_up(self):
        terminal = self.drawn("--no-sync")
        for size in ((10, 3), (1, 1), (400, 120), (100, 30)):
            before = len(terminal.output)
            terminal.resize(*size)
            terminal.signal(signal.SIGWINCH)
            terminal.wait_for_picture(before)
            terminal.read(0.3)
            places = [tuple(map(int, place)) for place in re.findall(
                rb"\x1b\[(\d+);(\d+)H", terminal.output[before:])]
            # What is drawn last is inside of the new size.
            row, column = places[-1]
            self.assertLessEqual(row, size[1])
            self.assertLessEqual(column, size[0])
        terminal.send("\x03")
        self.assertEqual(terminal.wait(), 0)

    def test_begins_in_a_tiny_terminal(self):
        terminal = self.drawn(size=(1, 1))
        terminal.send("?\x03")
        self.assertEqual(terminal.wait(), 0)

    def test_keys_show_help_and_scenes(self):
        terminal = self.drawn("--no-sync", size=(120, 40))
        terminal.send("?")
        terminal.wait_for(lambda o: b"split screen of two encoders" in o,
                          "help")
        terminal.send("\x1b")
        terminal.read(0.3)
        terminal.send("l")
        terminal.wait_for(lambda o: b"scene: arrows" in o, "list of scenes")
        terminal.send("\x03")
        self.assertEqual(terminal.wait(), 0)

    def test_garbage_does_not_hurt(self):
        terminal = self.drawn()
        terminal.send(bytes(b for b in range(256) if b not in (3, 17)) * 3)
        terminal.send(b"\x1b\\")
        terminal.read(0.5)
        terminal.send("\x03")
        self.assertEqual(terminal.wait(), 0)
        self.assert_given_back(terminal)

    def test_a_silent_terminal_does_not_hang_it(self):
        terminal = self.start(answers=[])
        terminal.wait_for_picture()
        terminal.send("w")
        terminal.read(0.3)
        terminal.send("\x03")
        self.assertEqual(terminal.wait(), 0)
        self.assert_given_back(terminal)

    def test_a_key_shows_within_two_frames(self):
        terminal = self.drawn("--no-sync", "--target-fps=20")
        terminal.send("p")
        terminal.read(1)
        # Frames are of the resting picture; the panel is off so that cells
        # are the picture's alone.
        terminal.send("i")
        terminal.read(2)
        frames = terminal.output.count(FRAME)
        quiet = len(terminal.output)
        terminal.read(0.5)
        still = self.largest_frame(terminal.output[quiet:])
        before = len(terminal.output)
        frames = terminal.output.count(FRAME)
        terminal.send("d")
        terminal.wait_for(lambda o: o.count(FRAME) >= frames + 3,
                          "three frames")
        pieces = terminal.output[before:].split(FRAME)
        # The frame that was on its way, and the two after the key.
        self.assertGreater(max(map(len, pieces[:3])), still)
        terminal.send("\x03")
        terminal.wait()

    @staticmethod
    def largest_frame(output):
        return max(map(len, output.split(FRAME)))

    def test_screenshot_and_recording(self):
        terminal = self.drawn("--no-sync")
        terminal.send("x")
        png = self.folder / "rtbench-live-001.png"
        terminal.wait_for(lambda o: png.exists(), "screenshot")
        terminal.wait_for(
            lambda o: (self.folder / "rtbench-live-001.json").exists(),
            "screenshot's cells")
        terminal.send("R")
        terminal.read(0.5)
        terminal.send("R")
        terminal.read(0.3)
        terminal.send("\x03")
        self.assertEqual(terminal.wait(), 0)
        self.assertTrue(png.read_bytes().startswith(b"\x89PNG"))
        cells = json.loads((self.folder / "rtbench-live-001.json").read_text())
        self.assertEqual(cells["rows"], 24)
        lines = (self.folder / "rtbench-live-001.cast").read_text().split("\n")
        self.assertEqual(json.loads(lines[0])["version"], 2)
        self.assertEqual(json.loads(lines[1])[1], "o")

    def test_kitty_keys_are_asked_for_and_given_back(self):
        answers = [(b"\x1b[?u", b"\x1b[?0u"), *Terminal.ANSWERS]
        terminal = self.drawn(answers=answers)
        self.assertIn(b"\x1b[>15u", terminal.output)
        terminal.send("\x1b[119u")  # W goes down ...
        terminal.read(0.3)
        terminal.send("\x1b[119;1:3u")  # ... and up.
        terminal.send("\x1b[99;5u")  # ^C
        self.assertEqual(terminal.wait(), 0)
        self.assert_given_back(terminal)
        end = terminal.output
        self.assertLess(end.rfind(b"\x1b[<u"), end.rfind(b"\x1b[?1049l"))
        self.assertGreater(end.rfind(b"\x1b[<u"), 0)
        terminal = self.drawn("--no-kitty-keys", answers=answers)
        self.assertNotIn(b"\x1b[>15u", terminal.output)

    def test_no_color_means_glyphs_alone(self):
        terminal = self.drawn("--no-sync", env={"NO_COLOR": "1"})
        terminal.send("\x03")
        self.assertEqual(terminal.wait(), 0)
        self.assertNotIn(b"[38;", terminal.output)

    def test_tells_what_the_terminal_can_do(self):
        terminal = self.start("--term-caps")
        self.assertEqual(terminal.wait(), 0)
        self.assertIn(b"colors           truecolor (answered)",
                      terminal.output)
        self.assertIn(b"synchronized     yes", terminal.output)
        self.assert_given_back(terminal)

    def test_suspends_and_resumes(self):
        terminal = self.drawn()
        terminal.signal(signal.SIGTSTP)
        # Its group is an orphan: the stop itself is ignored, all else is not.
        terminal.wait_for(lambda o: o.count(b"\x1b[?1049h") >= 2
                          and o.count(b"\x1b[?1049l") >= 1, "leave and enter")
        terminal.signal(signal.SIGCONT)
        terminal.read(0.3)
        terminal.send("\x03")
        self.assertEqual(terminal.wait(), 0)
        self.assert_given_back(terminal)

    def test_what_it_cannot_run_in(self):
        for env, says in (({"TERM": "dumb"}, "dumb"), ({"TERM": None}, "TERM"),
                          ({"TERM": "no-such"}, "no-such"),
                          ({"LC_ALL": "C"}, "UTF-8")):
            terminal = self.start(env=env)
            self.assertEqual(terminal.wait(), 2, env)
            self.assertIn(says.encode(), terminal.output)
            self.assertNotIn(b"\x1b[?1049h", terminal.output)
            self.assertEqual(terminal.output.count(b"\n"), 1)
        self.fail_with(2, "live", says="--headless")

    def test_escape_sequences_of_names_never_reach_the_terminal(self):
        terminal = self.start("--scene=\x1b]0;evil\x07")
        self.assertEqual(terminal.wait(), 2)
        self.assertNotIn(b"\x1b]0;evil", terminal.output)


if __name__ == "__main__":
    unittest.main()
