"""The arrow keys of a terminal, one by one as they are pressed, without waiting for Return.

Source: turtlesim's `teleop_turtle_key` puts the terminal into the same mode (no line editing, no echo; Ctrl-C still works)
and knows the same keys. Terminals send `ESC [ A` or, in application mode, `ESC O A` for the arrow up.
"""

from __future__ import annotations

import contextlib
import importlib
import os
import re
import select
import signal
import sys
import threading
import time
from collections.abc import Iterator
from types import FrameType
from typing import Any, NoReturn

NO_KEYS = "no keys can be read here: standard input is not a terminal"
"""What is printed on the error output where there is no keyboard."""
PERIOD = 0.02
"""Wall time between two looks at the keyboard [s]."""
ARROWS = {b"A": "up", b"B": "down", b"C": "right", b"D": "left"}
"""Last byte of the escape sequence of each arrow key."""
_WINDOWS_ARROWS = {"H": "up", "P": "down", "M": "right", "K": "left"}
_KEY = re.compile(rb"\x1b[\[O](?P<arrow>[A-D])|\x1b[\[O][0-9;]*[@-~]|\x1b(?=[^\[O])|[^\x1b]")
_ENDS = [getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name)]


class Keyboard:
    """Reads the keys of the terminal of this process while its body runs; then the terminal is as it was.

    A process in the background (`simkit rosrun ... &`) reads nothing until it comes to the front.
    """

    def __init__(self) -> None:
        self._bytes = b""
        self._next = 0.0
        self._before: list[Any] | None = None
        self._file = -1

    @property
    def works(self) -> bool:
        """Whether there is a terminal to read from."""
        return sys.stdin is not None and not sys.stdin.closed and sys.stdin.isatty()

    @contextlib.contextmanager
    def reading(self) -> Iterator[None]:
        """Leave line mode while the body runs, and come back to it however that ends; without a terminal say so."""
        if not self.works or sys.platform == "win32":
            if not self.works:
                print(NO_KEYS, file=sys.stderr)
            yield
            return
        import termios

        self._file = sys.stdin.fileno()
        self._before = termios.tcgetattr(self._file)
        self._leave_line_mode()
        try:
            with self._signals():
                yield
        finally:
            if self._is_in_front():
                termios.tcsetattr(self._file, termios.TCSADRAIN, self._before)
            self._before = None

    def pressed(self) -> list[str]:
        """The keys pressed since the last time: `up`, `down`, `left`, `right`, or the character; never waits."""
        if sys.platform == "win32":
            return _pressed_on_windows() if self.works else []
        now = time.monotonic()
        if self._before is None or now < self._next or not self._is_in_front():
            return []
        self._next = now + PERIOD
        while select.select([self._file], [], [], 0)[0]:
            data = os.read(self._file, 1024)
            if not data:
                break
            self._bytes += data
        keys, self._bytes = keys_of(self._bytes)
        return keys

    def _is_in_front(self) -> bool:
        try:
            return os.tcgetpgrp(self._file) == os.getpgrp()
        except OSError:  # the terminal was closed
            return False

    def _leave_line_mode(self) -> None:
        import termios
        import tty

        if self._is_in_front():
            tty.setcbreak(self._file, termios.TCSADRAIN)

    @contextlib.contextmanager
    def _signals(self) -> Iterator[None]:
        """After Ctrl-Z and `fg` keys are read again; a process that is ended puts its terminal back first."""
        if threading.current_thread() is not threading.main_thread():
            yield
            return
        before = {signal.SIGCONT: signal.signal(signal.SIGCONT, lambda *_: self._leave_line_mode())}
        for one in _ENDS:
            if signal.getsignal(one) is signal.SIG_DFL:
                before[one] = signal.signal(one, _end)
        try:
            yield
        finally:
            for one, handler in before.items():
                signal.signal(one, handler)


def keys_of(data: bytes) -> tuple[list[str], bytes]:
    """The keys in what a terminal has sent, and the rest: an escape sequence that is not complete yet."""
    keys, end = [], 0
    for match in _KEY.finditer(data):
        if match.start() != end:
            break
        end = match.end()
        if match["arrow"]:
            keys.append(ARROWS[match["arrow"]])
        elif len(match[0]) == 1 and match[0] != b"\x1b":
            keys.append(match[0].decode("latin-1"))
    return keys, data[end:]


def _end(number: int, _frame: FrameType | None) -> NoReturn:
    sys.exit(128 + number)


def _pressed_on_windows() -> list[str]:
    console: Any = importlib.import_module("msvcrt")
    keys = []
    while console.kbhit():
        key = console.getwch()
        if key in ("\x00", "\xe0"):  # what follows is no character
            key = _WINDOWS_ARROWS.get(console.getwch(), "")
        if key:
            keys.append(key)
    return keys
