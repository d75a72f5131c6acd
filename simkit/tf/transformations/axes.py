"""The 24 sequences of axes that Euler angles may turn about."""

from __future__ import annotations

from itertools import product
from typing import Final, NamedTuple, TypeAlias

from simkit.errors import UnknownNameError

Axes: TypeAlias = str | tuple[int, int, int, int]
"""A sequence as text (`sxyz`), or as (first axis, odd, repeated, rotating) in fixed-axes order."""


class AxisSequence(NamedTuple):
    """One sequence, told as turns about fixed axes.

    Turns about the axes of the body are the turns about fixed axes in reverse order.
    """

    i: int
    "First axis, 0, 1, 2 for x, y, z."
    j: int
    "Second axis."
    k: int
    "The axis that is neither; the third, unless the first is repeated."
    odd: bool
    "Whether i, j, k is x, z, y or a cyclic shift of it."
    repeated: bool
    "Whether the third axis is the first again."
    rotating: bool
    "Whether the angles are given in reverse order, as turns about the axes of the body."


def _parse(text: str) -> AxisSequence:
    letters = ["xyz".index(letter) for letter in text[1:]]
    if text[0] == "r":
        letters.reverse()
    i, j, third = letters
    odd = (i + 1) % 3 != j
    return AxisSequence(i, j, 3 - i - j, odd, third == i, text[0] == "r")


_BY_TEXT: Final = {
    text: _parse(text)
    for text in map("".join, product("sr", "xyz", "xyz", "xyz"))
    if text[1] != text[2] != text[3]
}
_BY_CODE: Final = {
    (s.i, int(s.odd), int(s.repeated), int(s.rotating)): s for s in _BY_TEXT.values()
}


def axis_sequence(axes: Axes) -> AxisSequence:
    """The sequence that a caller means.

    Raises:
        UnknownNameError: There is no such sequence (a KeyError, as in tf).
    """
    found = _BY_TEXT.get(axes.lower()) if isinstance(axes, str) else _BY_CODE.get(axes)
    if found is None:
        raise UnknownNameError("axis sequence", str(axes), _BY_TEXT)
    return found
