"""From the text of an attribute to a value.

Source: roslaunch `convert_value`: `auto` takes a text with a dot for a float, one without for an integer, `true` and `false`
for truth, and all else for text.
"""

from __future__ import annotations

from typing import Any

from simkit.errors import near_names
from simkit.launch.refusal import Kind, Lesson, Refused
from simkit.launch.rules import ATTRIBUTE

TYPES = ("auto", "str", "string", "int", "double", "bool", "boolean", "yaml")
"""What `type=` may be."""
_LONGEST = 40
_TRUTH = {"true": True, "1": True, "false": False, "0": False}


def convert(text: str, type_name: str) -> Any:
    """The value of a text.

    Args:
        text: As it stands in the file, `$(...)` replaced.
        type_name: `auto`, `str`, `int`, `double`, `bool`, `yaml`, or one of their other names.

    Raises:
        Refused: The text is not of that type, or there is no such type.
    """
    kind = type_name.lower()
    if kind == "auto":
        return _automatic(text)
    if kind in ("str", "string"):
        return text
    if kind in ("int", "double"):
        try:
            return int(text) if kind == "int" else float(text)
        except ValueError as error:
            word = "a whole number" if kind == "int" else "a number"
            raise _wrong(str(error), f"{_short(text)} is not {word}", f"Write {word}.") from None
    if kind in ("bool", "boolean"):
        return truth(text, kind)
    if kind == "yaml":
        from simkit.launch.yaml_text import plain_yaml

        return plain_yaml(text)
    near = " or ".join(near_names(type_name, TYPES)) or "str, int, double, bool or yaml"
    raise _wrong(
        f"Unknown type '{kind}'", f"there is no type {type_name!r}", f"Did you mean {near}?"
    )


def truth(text: str, type_name: str = "bool") -> bool:
    """A text that says true or false.

    Raises:
        Refused: It says neither.
    """
    lowered = text.lower()
    if lowered not in _TRUTH:
        raise _wrong(
            f"{lowered} is not a '{type_name}' type",
            f"{_short(text)} is neither true nor false",
            "Write true, false, 1 or 0.",
        )
    return _TRUTH[lowered]


def flag(text: str | None, label: str) -> bool:
    """An attribute of `<node>` and its kin that is true or false; false if it is not there.

    Raises:
        Refused: It is neither.
    """
    if text is None or text.lower() == "false":
        return False
    if text.lower() == "true":
        return True
    words = f"invalid bool value for {label}: {text}"
    if not text:
        words = f"bool value for {label} must be non-empty"
    what = f"{label}={text!r} is neither true nor false"
    lesson = Lesson(rule=ATTRIBUTE, what=what, remedy=f'Write {label}="true" or {label}="false".')
    raise Refused(Kind.SYNTAX, words, lesson)


def seconds(text: str | None, label: str) -> float:
    """An attribute that is a number of seconds; 0 if it is not there.

    Raises:
        Refused: It is no number.
    """
    if text is None:
        return 0.0
    words = f"invalid float value for {label}: {text}"
    if not text:
        words = f"bool value for {label} must be non-empty"
    try:
        return float(text)
    except ValueError:
        what = f"{label}={text!r} is not a number of seconds"
        lesson = Lesson(rule=ATTRIBUTE, what=what, remedy="Write a number, e.g. 1.5.")
        raise Refused(Kind.SYNTAX, words, lesson) from None


def _short(text: str) -> str:
    """A text for a message: of a whole file only the beginning."""
    return repr(text if len(text) <= _LONGEST else text[: _LONGEST - 3] + "...")


def _automatic(text: str) -> Any:
    try:
        if "_" not in text:
            return float(text) if "." in text else int(text)
    except ValueError:
        pass
    lowered = text.lower()
    return lowered == "true" if lowered in ("true", "false") else text


def _wrong(words: str, what: str, remedy: str) -> Refused:
    return Refused(Kind.VALUE, words, Lesson(rule=ATTRIBUTE, what=what, remedy=remedy))
