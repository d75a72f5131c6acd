"""tf_echo: prints where one frame is in another, again and again.

Source: tf `tf_echo.cpp`: it waits up to a second for the transform, then prints at its rate.
"""

from __future__ import annotations

from simkit.graph import Node, Timer
from simkit.msgs import Duration
from simkit.nodes.program import Program
from simkit.nodes.tf_tools.numbers import leading_number
from simkit.tf import Buffer, TransformListener, echo_text
from simkit.tf.admission import without_slash

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
        self._precision = int(leading_number(str(node.get_param("~precision", 3))))
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
