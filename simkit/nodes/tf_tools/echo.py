"""tf_echo of tf, and echo.py of tf2_tools, with options and tf2's strict names: where one frame is in another.

Source: tf `tf_echo.cpp`: it waits up to a second for the transform, then prints at its rate.
tf2_tools `echo.py`, Noetic.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

from simkit.commands.errors import UsageError
from simkit.commands.parser import ArgumentParser
from simkit.geometry import roll_pitch_yaw
from simkit.graph import Node, Timer
from simkit.msgs import Duration
from simkit.nodes.program import Program, leading_number
from simkit.tf import (
    Buffer,
    InvalidArgumentException,
    LookupException,
    StampedTransform,
    TransformException,
    TransformListener,
    echo_text,
)
from simkit.tf.admission import without_slash
from simkit.tf.hints import hint_for

USAGE = """\
Usage: tf_echo source_frame target_frame [echo_rate]

Prints the pose of target_frame seen from source_frame:
the transform that takes data in target_frame to source_frame.
echo_rate is in Hz; 1 if it is not given.
"""
"""What the program prints when its arguments are wrong."""

FIRST_LOOK = Duration(1)
"""How long it waits for the transform before it prints the first time."""
POLL = Duration.from_nsec(10_000_000)
"""How often it looks meanwhile."""


class TfEcho(Program):
    """The program `tf_echo` of the package tf.

    Args:
        node: Its place in the graph; `~rate` [Hz] and `~precision` (digits) are its parameters.
        argv: Source frame, target frame, and perhaps a rate [Hz].
    """

    def __init__(self, node: Node, argv: list[str]) -> None:
        super().__init__(node)
        if len(argv) not in (2, 3):
            self._print(USAGE)
            self._exit(255)
            return
        rate = leading_number(argv[2] if len(argv) == 3 else str(node.get_param("~rate", 1.0)))
        if rate <= 0.0:
            self._print("Echo rate must be > 0.0\n")
            self._exit(255)
            return
        self._frames = (argv[0], argv[1])
        self._period = Duration.from_nsec(round(1e9 / rate))
        self._precision = _precision(node)
        self._buffer = Buffer()
        TransformListener(node, self._buffer)
        self._give_up = node.now() + FIRST_LOOK
        self._polling: Timer = node.create_timer(POLL, self._look)

    def _look(self) -> None:
        source, target = map(without_slash, self._frames)
        if self._buffer.can_transform(source, target) or self._node.now() >= self._give_up:
            self._polling.cancel()
            self._echo()
            self._node.create_timer(self._period, self._echo)

    def _echo(self) -> None:
        now = self._node.now()
        self._print(echo_text(self._buffer, *self._frames, now, precision=self._precision))


@dataclass(frozen=True, slots=True, kw_only=True)
class _Options:
    """What the command line asks for."""

    target_frame: str
    "Frame of the observer."
    source_frame: str
    "Frame that is observed."
    rate: float
    "Lookups per second [Hz]."
    cache_time: float | None
    "Length of the buffer [s]."
    offset: float | None
    "Look at the present time plus this [s]."
    time: float | None
    "Look at this time [s]."
    limit: int | None
    "So many lookups."
    precision: int
    "Digits after the point."


class Tf2Echo(Program):
    """The program `echo.py` of the package tf2_tools.

    Args:
        node: Its place in the graph; `~precision` (digits) is its parameter.
        argv: Target frame, source frame, and options (-r, -c, -o, -t, -l, -p).
    """

    def __init__(self, node: Node, argv: list[str]) -> None:
        super().__init__(node)
        try:
            self._options = _parse(argv, precision=_precision(node))
        except UsageError as error:
            self._print(f"{error}\n")
            self._exit(2)
            return
        seconds = self._options.cache_time
        length = None if seconds is None else Duration.from_nsec(round(seconds * 1e9))
        self._buffer = Buffer(length)
        self._count = 0
        TransformListener(node, self._buffer)
        node.create_timer(Duration.from_nsec(round(1e9 / self._options.rate)), self._look)

    def _look(self) -> None:
        self._count += 1
        options, now, core = self._options, self._node.now(), self._buffer.core
        if options.limit is not None and self._count > options.limit:
            self._exit(0)
            return
        time = 0
        if options.time is not None:
            time = round(options.time * 1e9)
        elif options.offset is not None:
            time = now.to_nsec() + round(options.offset * 1e9)
        try:
            found = core.lookup(options.target_frame, options.source_frame, time=time)
        except InvalidArgumentException as error:
            self._print(f"InvalidArgumentException: {error}\nhint: {hint_for(error, core)}\n")
            self._exit(1)
        except LookupException as error:
            self._node.error(f"At time {time / 1e9}, (current time {now.to_sec()}) {error}")
        except TransformException as error:
            self._node.error(f"(current time {now.to_sec()}) {error}")
        else:
            self._print(_block(found, now.to_sec(), precision=options.precision))


def _precision(node: Node) -> int:
    return int(leading_number(str(node.get_param("~precision", 3))))


def _parse(argv: list[str], *, precision: int) -> _Options:
    parser = ArgumentParser("echo.py")
    parser.add_argument("target_frame")
    parser.add_argument("source_frame")
    parser.add_argument("-r", "--rate", default=1.0, type=_positive)
    parser.add_argument("-c", "--cache_time", type=_positive)
    parser.add_argument("-o", "--offset", type=float)
    parser.add_argument("-t", "--time", type=float)
    parser.add_argument("-l", "--limit", type=_positive_count)
    parser.add_argument("-p", "--precision", default=precision, type=_positive_count)
    return _Options(**vars(parser.parse_args(argv)))


def _positive(text: str) -> float:
    if float(text) <= 0.0:
        raise ValueError(text)
    return float(text)


def _positive_count(text: str) -> int:
    if int(text) <= 0:
        raise ValueError(text)
    return int(text)


def _block(found: StampedTransform, now: float, *, precision: int) -> str:
    angles = roll_pitch_yaw(found.rotation)
    indent = " " * 12

    def row(values: tuple[float, ...]) -> str:
        return "[" + ", ".join(f"{value:.{precision}f}" for value in values) + "]"

    return (
        f"At time {found.stamp / 1e9}, (current time {now})\n"
        f"- Translation: {row(found.translation)}\n"
        f"- Rotation: in Quaternion {row(found.rotation)}\n"
        f"{indent}in RPY (radian) {row(angles)}\n"
        f"{indent}in RPY (degree) {row(tuple(math.degrees(angle) for angle in angles))}\n"
    )
