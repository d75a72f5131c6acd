"""tf_monitor: prints delays, rates and broadcasters of all frames, or of the chain between two.

Source: tf `tf_monitor.cpp`: it looks every 10 ms and prints at each 21st look.
"""

from __future__ import annotations

from typing import Any

from simkit.graph import Node, Timer
from simkit.msgs import Duration, message_class
from simkit.nodes.program import Program
from simkit.tf import Buffer, TransformException, TransformListener
from simkit.tf.admission import without_slash
from simkit.tf.monitor import ChainDelay, TransformMonitor

LOOK = Duration.from_nsec(10_000_000)
"""How often it looks."""
LOOKS_PER_REPORT = 21
"""So many looks after each other make a report."""
LOOKS_PER_DOT = 100
"""So often it looks for a missing chain before it prints another dot."""


class TfMonitor(Program):
    """The program `tf_monitor` of the package tf.

    Args:
        node: Its place in the graph.
        argv: Nothing for all frames, or two frames for the chain between them.
    """

    def __init__(self, node: Node, argv: list[str]) -> None:
        super().__init__(node)
        if len(argv) not in (0, 2):
            node.info("TF_Monitor: usage: tf_monitor framea frameb")
            self._exit(255)
            return
        self._looks = 0
        self._chain: ChainDelay | None = None
        self._monitor = TransformMonitor()
        self._buffer = Buffer()
        TransformListener(node, self._buffer)
        self._timer: Timer
        if argv:
            self._ends = (without_slash(argv[0]), without_slash(argv[1]))
            self._print(
                "Waiting for transform chain to become available between "
                f"{self._ends[0]} and {self._ends[1]} "
            )
            self._timer = node.create_timer(LOOK, self._wait_for_chain)
        else:
            self._listen()

    def _wait_for_chain(self) -> None:
        self._looks += 1
        first, last = self._ends
        if self._buffer.can_transform(first, last):
            self._timer.cancel()
            frames = self._buffer.core.chain(last, first, target_time=0, source_time=0, fixed=last)
            self._chain = ChainDelay(frames=frames or [first])
            self._print("\n")
            self._listen()
        elif self._looks % LOOKS_PER_DOT == 0:
            self._print(".")

    def _listen(self) -> None:
        self._looks = 0
        tf_message = message_class("tf2_msgs/TFMessage")
        self._node.subscribe("/tf", tf_message, lambda m: self._note(m, static=False))
        self._node.subscribe("/tf_static", tf_message, lambda m: self._note(m, static=True))
        self._timer = self._node.create_timer(LOOK, self._look)

    def _note(self, message: Any, *, static: bool) -> None:
        self._monitor.note(
            [(one.child_frame_id, one.header.stamp.to_nsec()) for one in message.transforms],
            authority=str(message._connection_header["callerid"]),
            now=self._node.now().to_nsec(),
            static=static,
        )

    def _look(self) -> None:
        self._looks += 1
        if self._chain is not None:
            self._note_chain(self._chain)
        if self._looks % LOOKS_PER_REPORT == 0:
            self._print(self._monitor.report(self._chain))

    def _note_chain(self, chain: ChainDelay) -> None:
        try:
            found = self._buffer.core.lookup(*self._ends)
        except TransformException as error:
            self._node.warn(f"Transform Exception {error}")
            return
        # A chain of static frames has no stamp, and is never late.
        chain.note((self._node.now().to_nsec() - found.stamp) / 1e9 if found.stamp else 0.0)
