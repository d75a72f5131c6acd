"""Graph side: what a script's process says on rosout."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from simkit.graph.log import LogLevel
from simkit.graph.process.protocol import Op, ProtocolError

if TYPE_CHECKING:
    from simkit.graph.process.script_node import ScriptNode

MAX_TEXT = 10_000
"""Longest line that a script may say [characters]."""
MAX_SAID = 64 * 1024 * 1024
"""How much a script may say over its life [characters]."""
OVERHEAD = 200
"""What keeping a line costs besides its text [characters]."""


class LogRequests:
    """Puts on rosout what one node says, as far as it can be kept."""

    def __init__(self, node: ScriptNode) -> None:
        self._node = node
        self._size_said = 0
        self.told: dict[Op, Callable[[bytes], None]] = {Op.LOG: self._log}
        """What is done without an answer."""

    def _log(self, body: bytes) -> None:
        try:
            level = LogLevel(body[0])
        except (ValueError, IndexError) as error:
            raise ProtocolError("not a log level") from error
        text = body[1:].decode("utf-8", "replace")[:MAX_TEXT]
        before = self._size_said
        self._size_said += len(text) + OVERHEAD
        if self._size_said <= MAX_SAID:
            self._node.graph.log(self._node.name, level, text)
        elif before <= MAX_SAID:
            warning = "this node says too much; no more is kept"
            self._node.graph.log(self._node.name, LogLevel.WARN, warning)
