"""How late transforms arrive, how often, and who sends them: what `rosrun tf tf_monitor` prints."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import Final

WINDOW: Final = 1000
"So many of the latest samples count."
_SHORTEST = 1e-8
"Least span that a rate is computed over [s]; one message alone has none."
_LOWPASS = 0.01
"Weight of the newest sample in the average delay of a chain."


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
