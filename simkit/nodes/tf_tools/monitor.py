"""tf_monitor: prints delays, rates and broadcasters of all frames, or of the chain between two.

Source: tf `tf_monitor.cpp`: it looks every 10 ms and prints at each 21st look.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Any, Final

from simkit.graph import Node, Timer
from simkit.msgs import Duration, message_class
from simkit.nodes.program import Program
from simkit.tf import Buffer, TransformException, TransformListener
from simkit.tf.admission import without_slash

LOOK = Duration.from_nsec(10_000_000)
"""How often it looks."""
LOOKS_PER_REPORT = 21
"""So many looks after each other make a report."""
LOOKS_PER_DOT = 100
"""So often it looks for a missing chain before it prints another dot."""
WINDOW: Final = 1000
"So many of the latest samples count."
_SHORTEST = 1e-8
"Least span that a rate is computed over [s]; one message alone has none."
_LOWPASS = 0.01
"Weight of the newest sample in the average delay of a chain."


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


@dataclass(slots=True, kw_only=True)
class _Broadcaster:
    """What is known about one broadcaster."""

    delays: deque[float] = field(default_factory=lambda: deque(maxlen=WINDOW))
    "Mean delay of the transforms in each message [s]."
    times: deque[int] = field(default_factory=lambda: deque(maxlen=WINDOW))
    "When each message arrived [ns]."

    @property
    def rate(self) -> float:
        """Messages per second: their number by the time from the first to the last [Hz]."""
        return len(self.times) / max(_SHORTEST, (self.times[-1] - self.times[0]) / 1e9)


@dataclass(slots=True, kw_only=True)
class ChainDelay:
    """Age of the newest transform over a chain of frames."""

    frames: Sequence[str]
    "The chain, from its first frame to its last."
    average: float = 0.0
    "Low-pass mean of the age [s]; it starts at 0."
    longest: float = 0.0
    "Greatest age so far [s]."

    def note(self, age: float) -> None:
        """Take in one age [s]."""
        self.average = _LOWPASS * age + (1.0 - _LOWPASS) * self.average
        self.longest = max(self.longest, age)


class TransformMonitor:
    """Statistics of transforms, by frame and by broadcaster.

    Source:
        tf `tf_monitor.cpp`: delay is the time of arrival minus the stamp, so it is negative for
        transforms that are dated ahead; a static transform counts as 0; the rate is the number
        of messages by the time between the first and the last, one more than there are gaps.
    """

    def __init__(self) -> None:
        self._delays: dict[str, deque[float]] = {}
        self._authorities: dict[str, str] = {}
        self._broadcasters: dict[str, _Broadcaster] = {}

    def note(
        self, transforms: Iterable[tuple[str, int]], *, authority: str, now: int, static: bool
    ) -> None:
        """Take in one message.

        Args:
            transforms: Child frame and stamp [ns] of each transform in it.
            authority: Node that sent it.
            now: When it arrived [ns].
            static: Whether it came on /tf_static.
        """
        sender = f"{authority}(static)" if static else authority
        delays = []
        for frame, stamp in transforms:
            delays.append(0.0 if static else (now - stamp) / 1e9)
            self._authorities[frame] = sender
            self._delays.setdefault(frame, deque(maxlen=WINDOW)).append(delays[-1])
        broadcaster = self._broadcasters.setdefault(sender, _Broadcaster())
        broadcaster.delays.append(sum(delays) / max(1, len(delays)))
        broadcaster.times.append(now)

    def report(self, chain: ChainDelay | None = None) -> str:
        """One block of tf_monitor's output, with three empty lines before it.

        Args:
            chain: Show the frames of this chain only, and its delay.
        """
        lines = ["", "", "", *_headline(chain), "", "Frames:"]
        lines += [
            f"Frame: {frame} published by {self._authorities[frame]} {_delay_text(delays)}"
            for frame, delays in sorted(self._delays.items())
            if chain is None or frame in chain.frames
        ]
        lines += ["", "All Broadcasters:"]
        lines += [
            f"Node: {name} {broadcaster.rate:g} Hz, {_delay_text(broadcaster.delays)}"
            for name, broadcaster in sorted(self._broadcasters.items())
        ]
        return "\n".join(lines) + "\n"


def _headline(chain: ChainDelay | None) -> list[str]:
    if chain is None:
        return ["RESULTS: for all Frames"]
    return [
        f"RESULTS: for {chain.frames[0]} to {chain.frames[-1]}",
        f"Chain is: {' -> '.join(chain.frames)}",
        f"Net delay     avg = {chain.average:g}: max = {chain.longest:g}",
    ]


def _delay_text(delays: deque[float]) -> str:
    average = sum(delays) / len(delays)
    return f"Average Delay: {average:g} Max Delay: {max(0.0, *delays):g}"
