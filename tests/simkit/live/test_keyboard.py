"""Keys of a terminal: what it sends, and that they reach a node in a real (pseudo) terminal."""

from __future__ import annotations

import os
import re
import select
import signal
import subprocess
import sys
import termios
import time
from pathlib import Path

import pytest

from simkit.live.keyboard import Keyboard, keys_of

UP, DOWN, RIGHT, LEFT = "\x1b[A", "\x1b[B", "\x1b[C", "\x1b[D"
GREETING = "Use arrow keys to move the turtle. 'q' to quit."


@pytest.mark.parametrize(
    ("sent", "keys", "rest"),
    [
        (b"\x1b[A\x1b[B\x1b[C\x1b[D", ["up", "down", "right", "left"], b""),
        (b"\x1bOA\x1bOD", ["up", "left"], b""),
        (b"xq", ["x", "q"], b""),
        (b"\x1b[1;5A\x1b[3~\x1b[H", [], b""),  # Ctrl and arrow, Del, Home
        (b"\x1b[A\x1b[", ["up"], b"\x1b["),
        (b"\x1b", [], b"\x1b"),
        (b"\x1bq", ["q"], b""),
        (b"\x1b\x1b[A", ["up"], b""),
    ],
)
def test_escape_sequences_are_keys(sent, keys, rest):
    assert keys_of(sent) == (keys, rest)


class Terminal:
    """A process in a terminal of its own: a session with a controlling pseudo terminal."""

    def __init__(self, words, folder):
        self.keyboard, self._slave = os.openpty()
        self.text = ""
        self.process = subprocess.Popen(
            [sys.executable, "-m", "simkit.cli", *words],
            cwd=folder,
            stdin=self._slave,
            stdout=self._slave,
            stderr=self._slave,
            preexec_fn=self._own,
        )

    def _own(self):
        import fcntl

        os.setsid()
        fcntl.ioctl(0, termios.TIOCSCTTY, 0)
        for end in (signal.SIGINT, signal.SIGHUP):  # ignored where the tests run in the background
            signal.signal(end, signal.SIG_DFL)

    @property
    def in_line_mode(self):
        """Whether keys are shown, and handed on with Return."""
        flags = termios.tcgetattr(self._slave)[3]
        return bool(flags & termios.ICANON and flags & termios.ECHO)

    def press(self, keys):
        os.write(self.keyboard, keys.encode())

    def shows(self, condition, seconds=30.0):
        """Whether the condition holds within some seconds; what is printed meanwhile is kept in `text`."""
        end = time.monotonic() + seconds
        while not condition() and time.monotonic() < end:
            if select.select([self.keyboard], [], [], 0.05)[0]:
                self.text += os.read(self.keyboard, 65536).decode()
        return condition()

    def close(self):
        self.process.kill()
        self.process.wait()
        os.close(self.keyboard)
        os.close(self._slave)


@pytest.fixture
def terminal(tmp_path, monkeypatch):
    """A function that runs a command line of simkit in a terminal."""
    monkeypatch.setenv("SIMKIT_SESSION", str(tmp_path / "session.json"))
    opened = []

    def begin(*words):
        opened.append(Terminal(words, tmp_path))
        return opened[-1]

    yield begin
    for one in opened:
        one.close()


def _place(tmp_path, terminal):
    """Where the turtle is, as another terminal hears it."""
    listener = terminal("rostopic", "echo", "-n", "1", "/turtle1/pose")
    assert listener.shows(lambda: "angular_velocity" in listener.text)
    return [float(found) for found in re.findall(r"(?:x|y|theta): (\S+)", listener.text)[:3]]


TELEOP = ("rosrun", "turtlesim", "turtle_teleop_key")
TURTLE = ("rosrun", "turtlesim", "turtlesim_node")


@pytest.mark.parametrize("order", [(TURTLE, TELEOP), (TELEOP, TURTLE)], ids=["joins", "hosts"])
def test_arrow_keys_move_the_turtle_in_either_order(terminal, tmp_path, order):
    opened = []
    for words in order:
        opened.append(terminal(*words))
        assert opened[0].shows((tmp_path / "session.json").exists)
    keys = opened[order.index(TELEOP)]
    assert keys.shows(lambda: GREETING in keys.text)
    assert keys.shows(lambda: not keys.in_line_mode)
    assert _place(tmp_path, terminal)[0] == pytest.approx(5.544, abs=0.001)
    keys.press("x\x1bOA")
    assert keys.shows(lambda: _place(tmp_path, terminal)[0] > 6.0)
    assert "[A" not in keys.text
    keys.press(LEFT)
    assert keys.shows(lambda: _place(tmp_path, terminal)[2] > 0.5)
    keys.press("q")
    assert keys.process.wait(30) == 0
    assert keys.in_line_mode


@pytest.mark.parametrize("end", [signal.SIGINT, signal.SIGTERM, signal.SIGHUP])
@pytest.mark.parametrize("joins", [True, False], ids=["joins", "hosts"])
def test_the_terminal_is_as_it_was_however_the_program_ends(terminal, tmp_path, end, joins):
    if joins:
        core = terminal("roscore")
        assert core.shows((tmp_path / "session.json").exists)
    keys = terminal(*TELEOP)
    assert keys.shows(lambda: not keys.in_line_mode)
    assert keys.shows(lambda: GREETING in keys.text)
    if end is signal.SIGINT:
        keys.press("\x03")
    else:
        keys.process.send_signal(end)
    keys.process.wait(30)
    assert keys.in_line_mode


def test_keys_reach_a_simulation_of_its_own(terminal):
    keys = terminal(*TELEOP, "--for", "60")
    assert keys.shows(lambda: GREETING in keys.text)
    assert keys.shows(lambda: not keys.in_line_mode)
    keys.press("q")
    assert keys.process.wait(30) == 0


def test_without_a_terminal_it_says_so(monkeypatch, capsys):
    with Path(os.devnull).open() as nothing:
        monkeypatch.setattr(sys, "stdin", nothing)
        keyboard = Keyboard()
        with keyboard.reading():
            assert keyboard.pressed() == []
    assert "standard input is not a terminal" in capsys.readouterr().err
