"""A pseudo terminal with the program in it, as a person's terminal would be."""

import fcntl
import os
import pty
import re
import select
import signal
import struct
import termios
import time

PATIENCE = 60  # Seconds for what must happen, on a busy machine.


class Terminal:
    """Runs a program in a terminal of its own and reads what it draws.

    `answers` is what the terminal says to its questions: a list of pairs
    (question, answer), both bytes.
    """

    ANSWERS = [(b"\x1b[5n", b"\x1b[0n"), (b"\x1b[c", b"\x1b[?62c"),
               (b"\x1b[?2026$p", b"\x1b[?2026;2$y"),
               (b"\x1bP$qm\x1b\\", b"\x1bP1$r48:2:1:2:3m\x1b\\")]

    def __init__(self, command, size=(80, 24), env=None, answers=None,
                 cwd=None):
        self.answers = self.ANSWERS if answers is None else answers
        self.output = b""
        self.answered = 0  # Bytes of output that were looked through.
        environment = dict(os.environ, TERM="xterm-256color",
                           LC_ALL="C.UTF-8")
        environment.pop("NO_COLOR", None)
        environment.pop("COLORTERM", None)
        environment.update(env or {})
        environment = {k: v for k, v in environment.items() if v is not None}
        self.master, self.terminal = pty.openpty()
        self.resize(*size)
        self.modes = termios.tcgetattr(self.terminal)
        self.pid = os.fork()
        if self.pid == 0:
            self._exec(command, environment, cwd)
        self.status = None

    def _exec(self, command, environment, cwd):
        try:
            os.setsid()
            fcntl.ioctl(self.terminal, termios.TIOCSCTTY, 0)
            for descriptor in (0, 1, 2):
                os.dup2(self.terminal, descriptor)
            os.closerange(3, 256)
            if cwd:
                os.chdir(cwd)
            os.execvpe(str(command[0]), [str(c) for c in command],
                       environment)
        finally:
            os._exit(127)

    def resize(self, columns, rows):
        fcntl.ioctl(self.master, termios.TIOCSWINSZ,
                    struct.pack("HHHH", rows, columns, 0, 0))

    def send(self, text):
        os.write(self.master, text if isinstance(text, bytes)
                 else text.encode())

    def signal(self, number):
        os.kill(self.pid, number)

    def read(self, seconds):
        """What is drawn within that time, at the latest until it is silent."""
        begin = len(self.output)
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0:
            if not select.select([self.master], [], [], left)[0]:
                break
            try:
                piece = os.read(self.master, 65536)
            except OSError:  # Nobody has the terminal open.
                break
            self.output += piece
            self._answer()
        return self.output[begin:]

    def _answer(self):
        """Answers the questions that have come in whole."""
        while True:
            found = [(self.output.find(q, self.answered), q, a)
                     for q, a in self.answers]
            found = [f for f in found if f[0] >= 0]
            if not found:
                # A question may have begun.
                self.answered = max(self.answered, len(self.output) - 16)
                return
            at, question, answer = min(found)
            self.answered = at + len(question)
            self.send(answer)

    def wait_for(self, condition, what):
        """Reads until condition(output) holds."""
        end = time.monotonic() + PATIENCE
        while not condition(self.output):
            if time.monotonic() > end or self.poll() is not None:
                raise AssertionError(
                    f"{what}: waited in vain; the end is "
                    f"{self.output[-300:]!r}")
            self.read(0.05)

    def wait_for_picture(self, after=0):
        """Waits until a frame has been drawn past that many bytes."""
        self.wait_for(lambda o: b"\x1b[5n" in o[after:]
                      or re.search(rb"\x1b\[\d+;\d+H", o[after:]), "picture")

    def poll(self):
        if self.status is None:
            pid, status = os.waitpid(self.pid, os.WNOHANG)
            if pid:
                self.status = os.waitstatus_to_exitcode(status)
        return self.status

    def wait(self):
        """The exit status; minus the signal that ended the program."""
        end = time.monotonic() + PATIENCE
        while self.poll() is None:
            self.read(0.05)
            if time.monotonic() > end:
                self.signal(signal.SIGKILL)
                raise AssertionError("the program does not end")
        self.read(0.2)
        return self.status

    def modes_now(self):
        return termios.tcgetattr(self.terminal)

    def close(self):
        if self.poll() is None:
            self.signal(signal.SIGKILL)
            os.waitpid(self.pid, 0)
        os.close(self.master)
        os.close(self.terminal)
