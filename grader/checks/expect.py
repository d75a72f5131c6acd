"""Expectations that explain themselves: what was expected, what was found, and what to look at."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from grader.checks.values import shown
from grader.errors import CheckFailed


def expect(condition: object, message: str, *, hint: str = "") -> None:
    """Expect something to be true.

    Args:
        condition: True if the student's work is right.
        message: What is wrong if it is not, as a sentence to the student.
        hint: What to look at next.

    Raises:
        CheckFailed: The condition is false.
    """
    if not condition:
        raise CheckFailed(message, hint=hint)


def expect_equal(actual: Any, expected: Any, *, what: str, hint: str = "") -> None:
    """Expect a value of the student to be one exactly, in type and in value.

    Args:
        actual: What was found.
        expected: What would be right.
        what: Name of the value, e.g. "the parent of carrot1".
        hint: What to look at next.

    Raises:
        CheckFailed: They differ.
    """
    if _equal(actual, expected):
        return
    raise CheckFailed(_wrong(what), expected=shown(expected), actual=_found(actual), hint=hint)


def _equal(actual: Any, expected: Any) -> bool:
    # True == 1 in Python; a whole number for a float, and a list for a tuple, are fine.
    if isinstance(expected, list | tuple):
        same_shape = isinstance(actual, list | tuple) and len(actual) == len(expected)
        return same_shape and all(map(_equal, actual, expected))
    if isinstance(expected, bool) or isinstance(actual, bool):
        return actual is expected
    if isinstance(expected, int | float):
        return type(actual) in (int, float) and actual == expected
    return type(actual) is type(expected) and bool(actual == expected)


def expect_close(
    actual: Any,
    expected: float | Sequence[float],
    *,
    tolerance: float,
    what: str,
    unit: str = "",
    frame: str = "",
    hint: str = "",
) -> None:
    """Expect a number, or each of a row of numbers, to be near to another.

    Args:
        actual: What was found; anything, since a student wrote it.
        expected: What would be right: a number or a row of numbers.
        tolerance: Largest difference that is still right, in `unit`.
        what: Name of the quantity, e.g. "the position of carrot1".
        unit: Unit of the numbers, e.g. "m".
        frame: Frame that they are expressed in.
        hint: What to look at next.

    Raises:
        CheckFailed: It is no number, not finite, of another length, or too far away.
    """
    found, wanted = _numbers(actual), _numbers(expected)
    assert wanted is not None, "the check expects something that is not a number"
    if found is not None and len(found) == len(wanted):
        differences = [abs(a - b) for a, b in zip(found, wanted, strict=True)]
        if all(difference <= tolerance for difference in differences):
            return
    raise CheckFailed(
        _wrong(what),
        expected=_with_tolerance(expected, tolerance, unit, frame),
        actual=_found(actual) if found is None else shown(_literal(actual), unit=unit, frame=frame),
        hint=hint,
    )


def expect_close_angle(
    actual: Any, expected: float, *, tolerance: float, what: str, frame: str = "", hint: str = ""
) -> None:
    """Expect an angle to be near to another; full turns do not count.

    Args:
        actual: What was found.
        expected: What would be right [rad].
        tolerance: Largest difference that is still right [rad].
        what: Name of the angle, e.g. "the heading of turtle2".
        frame: Frame that it is measured in.
        hint: What to look at next.

    Raises:
        CheckFailed: It is no number, not finite, or too far away.
    """
    found = _numbers(actual)
    number = found[0] if found is not None and len(found) == 1 else math.nan
    turned = math.remainder(number - expected, math.tau) if math.isfinite(number) else math.nan
    if not abs(turned) <= tolerance:
        raise CheckFailed(
            _wrong(what),
            expected=_with_tolerance(expected, tolerance, "rad", frame),
            actual=_found(actual) if found is None else shown(_literal(actual), unit="rad"),
            hint=hint,
        )


def explanation(failure: CheckFailed) -> str:
    """What a failure says, with what was expected and found below it; the hint is kept apart."""
    lines = [failure.message]
    for label, value in (("expected", failure.expected), ("got", failure.actual)):
        if value is not None:
            lines.append(f"{label}: {value if isinstance(value, str) else shown(value)}")
    return "\n".join(lines)


def _wrong(what: str) -> str:
    return f"{what[:1].upper()}{what[1:]} is not right" if " " in what else f"{what} is not right"


def _numbers(value: Any) -> list[float] | None:
    """The value as floats, or None; exact types only, so that nothing of a student decides."""
    value = _literal(value)
    row = [_literal(item) for item in value] if isinstance(value, list | tuple) else [value]
    if not all(type(item) in (int, float) for item in row):
        return None
    try:
        return [float(item) for item in row]
    except OverflowError:
        return None


def _literal(value: Any) -> Any:
    """Arrays and numpy's numbers as lists and floats."""
    to_list = getattr(value, "tolist", None)
    return to_list() if to_list is not None else value


def _with_tolerance(
    expected: float | Sequence[float], tolerance: float, unit: str, frame: str
) -> str:
    text = shown(_literal(expected), unit=unit, frame=frame)
    return f"{text} (within {shown(tolerance, unit=unit)})" if tolerance > 0 else text


def _found(actual: Any) -> str:
    """A value of an unexpected kind, with the word for its kind."""
    if actual is None:
        return "nothing"
    kinds = [word for kind, word in _KINDS.items() if isinstance(actual, kind)]
    return f"{shown(actual)} ({kinds[0]})" if kinds else shown(actual)


_KINDS = {
    bool: "true or false",
    str: "a text",
    list: "a list",
    tuple: "a tuple",
    dict: "a dictionary",
}
