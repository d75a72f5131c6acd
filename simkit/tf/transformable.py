"""Questions that a buffer cannot answer yet, and answers by a call as soon as it can."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final, TypeAlias

from simkit.tf.errors import TransformException

if TYPE_CHECKING:
    from simkit.tf.buffer_core import BufferCore

ALREADY: Final = 0
"Handle of a question that needs no waiting: the answer is there."
NEVER: Final = 0xFFFF_FFFF_FFFF_FFFF
"Handle of a question that comes too late: the buffer has forgotten that time."

OnTransformable: TypeAlias = "Callable[[TransformableRequest, bool], None]"
"Is given the question, and whether it can be answered now; if not, it never will be."


@dataclass(frozen=True, slots=True, kw_only=True)
class TransformableRequest:
    """One question that waits."""

    handle: int
    """Its number, from 1."""
    target: str
    """Frame of the result."""
    source: str
    """Frame of the data."""
    time: int
    """When [ns]; the latest common time if 0."""
    callback: OnTransformable
    """Who wants to know."""


class TransformableRequests:
    """The questions that wait at one buffer.

    Args:
        core: The buffer; it calls `test` after each transform that it stored, if somebody waits.

    Attributes:
        waiting: The questions by handle.

    Source:
        tf2 `BufferCore::addTransformableRequest`, which message filters are made of.
    """

    def __init__(self, core: BufferCore) -> None:
        self._core = core
        self.waiting: dict[int, TransformableRequest] = {}
        self._last = ALREADY

    def __len__(self) -> int:
        return len(self.waiting)

    def add(self, callback: OnTransformable, *, target: str, source: str, time: int) -> int:
        """Ask to be called as soon as `lookup(target, source, time=time)` answers.

        Args:
            callback: Is given the question and True, or False if the time was forgotten meanwhile.
            target: Frame of the result.
            source: Frame of the data.
            time: When [ns]; the latest common time if 0.

        Returns:
            A handle to cancel by; `ALREADY` or `NEVER` if there is nothing to wait for.
        """
        if self._core.can_transform(target, source, time=time)[0]:
            return ALREADY
        if self._is_forgotten(target, source, time):
            return NEVER
        self._last += 1
        self.waiting[self._last] = TransformableRequest(
            handle=self._last, target=target, source=source, time=time, callback=callback
        )
        return self._last

    def cancel(self, handle: int) -> None:
        """Wait no more; harmless if nobody waits under that handle."""
        self.waiting.pop(handle, None)

    def test(self) -> None:
        """Call whoever can be answered now, or never, in the order of asking."""
        for request in list(self.waiting.values()):
            can = self._core.can_transform(request.target, request.source, time=request.time)[0]
            if not can and not self._is_forgotten(request.target, request.source, request.time):
                continue
            # An earlier callback may have cancelled it.
            if self.waiting.pop(request.handle, None) is not None:
                request.callback(request, can)

    def _is_forgotten(self, target: str, source: str, time: int) -> bool:
        if time == 0:
            return False
        try:
            newest = self._core.latest_common_time(target, source)
        except TransformException:
            return False
        return newest > 0 and time + self._core.cache_time < newest
