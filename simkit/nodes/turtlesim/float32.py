"""Rounding to the 32-bit floats that turtlesim publishes and its services take."""

from __future__ import annotations

import math
import struct

_FLOAT32 = struct.Struct("<f")


def float32(value: float) -> float:
    """The 32-bit float nearest to `value`; infinite where it is too large for one, as in C++."""
    try:
        rounded: float = _FLOAT32.unpack(_FLOAT32.pack(value))[0]
    except OverflowError:
        return math.copysign(math.inf, value)
    return rounded
