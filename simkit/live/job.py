"""A command at work in a simulation whose time somebody else lets pass: it says more from time to time, and ends."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator

from simkit.commands.command import Call, Command, ErrorText, Keys, Wait
from simkit.commands.errors import ToolError
from simkit.errors import SimkitError
from simkit.live.keyboard import Keyboard


class Job:
    """A command at work.

    Args:
        call: What was called.
        command: The command; begun here, up to its first wait.

    Attributes:
        exit_code: None while it works.

    Raises:
        SimkitError: It cannot begin.
    """

    def __init__(self, call: Call, command: Command) -> None:
        self._sim = call.sim
        self._answer = command(call)
        self._wait: Wait | None = None
        self._due = 0.0
        self._press: Callable[[str], None] | None = None
        self._texts: list[str] = []
        self.exit_code: int | None = None if self._answer is not None else 0
        self._go_on()

    @property
    def takes_keys(self) -> bool:
        """Whether it reads the keyboard of its terminal."""
        return self._press is not None and self.exit_code is None

    def poll(self) -> list[str]:
        """What it has printed since the last time."""
        try:
            self._go_on()
        except (SimkitError, OSError) as error:
            self._texts.append(ErrorText(f"{error}\n"))
            self.exit_code = 1
        texts, self._texts = self._texts, []
        return texts

    def press(self, key: str) -> None:
        """A key was pressed in its terminal: `up`, `down`, `left`, `right`, or a character."""
        if self._press is not None and self.exit_code is None:
            self._press(key)

    def interrupt(self) -> None:
        """Ctrl-C was pressed in its terminal: it may have last words."""
        if self._answer is None or self.exit_code is not None:
            return
        try:
            self._take(self._answer.throw(KeyboardInterrupt()))
        except (StopIteration, KeyboardInterrupt):
            self.exit_code = 0

    def cancel(self) -> None:
        """Its terminal is gone."""
        self.interrupt()
        if self._answer is not None:
            self._answer.close()
        self.exit_code = self.exit_code or 0

    @contextlib.contextmanager
    def keys_of_this_terminal(self) -> Iterator[Callable[[], None]]:
        """A function that hands it the keys pressed in the terminal of this process."""
        keyboard = Keyboard()

        def hand_over() -> None:
            for key in keyboard.pressed():
                self.press(key)

        with keyboard.reading() if self.takes_keys else contextlib.nullcontext():
            yield hand_over

    def _go_on(self) -> None:
        while self.exit_code is None and not self._waits():
            try:
                assert self._answer is not None
                self._take(next(self._answer))
            except StopIteration as end:
                self.exit_code = end.value or 0
            except ToolError as error:
                self._texts.append(ErrorText(f"{error}\n"))
                self.exit_code = error.exit_code

    def _take(self, item: str | Wait | Keys) -> None:
        if isinstance(item, Wait):
            self._wait, self._due = item, self._sim.now.to_sec() + item.seconds
        elif isinstance(item, Keys):
            self._wait, self._press = None, item.press
        else:
            self._wait = None
            self._texts.append(item)

    def _waits(self) -> bool:
        wait = self._wait
        return wait is not None and not wait.until() and self._sim.now.to_sec() < self._due
