"""From the text of an attribute to a value.

Source: roslaunch `convert_value`: `auto` takes a text with a dot for a float, one without for an integer, `true` and `false`
for truth, and all else for text.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from simkit.errors import near_names
from simkit.launch.errors import Kind, LaunchRefused, Lesson
from simkit.launch.rules import ATTRIBUTE, YAML

if TYPE_CHECKING:
    import yaml

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
        LaunchRefused: The text is not of that type, or there is no such type.
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
        from simkit.launch.values import plain_yaml

        return plain_yaml(text)
    near = " or ".join(near_names(type_name, TYPES)) or "str, int, double, bool or yaml"
    raise _wrong(
        f"Unknown type '{kind}'", f"there is no type {type_name!r}", f"Did you mean {near}?"
    )


def truth(text: str, type_name: str = "bool") -> bool:
    """A text that says true or false.

    Raises:
        LaunchRefused: It says neither.
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
        LaunchRefused: It is neither.
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
    raise LaunchRefused(Kind.SYNTAX, words, lesson)


def seconds(text: str | None, label: str) -> float:
    """An attribute that is a number of seconds; 0 if it is not there.

    Raises:
        LaunchRefused: It is no number.
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
        raise LaunchRefused(Kind.SYNTAX, words, lesson) from None


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


def _wrong(words: str, what: str, remedy: str) -> LaunchRefused:
    return LaunchRefused(Kind.VALUE, words, Lesson(rule=ATTRIBUTE, what=what, remedy=remedy))


_REMEDY = "Write `name: value` with a blank behind the colon, and nest with blanks, not tabs."


def load_yaml(text: str, *, file: str | None = None) -> Any:
    """The value of a YAML text, with the angles of rosparam: `deg(90)`, `rad(pi/2)`, `!degrees 90`.

    Args:
        text: The text; an empty one is an empty mapping.
        file: The file that it comes from; None for text in the launch file itself.

    Raises:
        LaunchRefused: It is not YAML, or too much.
    """
    import yaml

    from simkit.commands.errors import ToolError
    from simkit.commands.parameter_yaml import ParameterLoader

    try:
        value = _load(text, ParameterLoader)
    except yaml.MarkedYAMLError as error:
        words = f"Error within YAML block:\n\t{error}\n\nYAML is:\n{text}"
        raise _not_yaml(words if file is None else _in_file(file, error), error) from None
    except (yaml.YAMLError, ToolError, ValueError, TypeError, RecursionError) as error:
        cause = str(error).removeprefix("ERROR: ")
        words = f"invalid YAML: {cause}\n\nYAML is:\n{text}"
        raise _not_yaml(words if file is None else _in_file(file, cause), error) from None
    return {} if value is None else value


def plain_yaml(text: str) -> Any:
    """The value of a YAML text without angles: what `<param type="yaml">` takes.

    Raises:
        LaunchRefused: It is not YAML, or too much.
    """
    import yaml

    try:
        return _load(text, yaml.SafeLoader)
    except (yaml.YAMLError, ValueError, TypeError, RecursionError) as error:
        raise _not_yaml(str(error), error) from None


def _mark_of(error: BaseException) -> tuple[int, int] | None:
    """Line and column in the YAML text that an error is about, from 1; None if it has no place."""
    mark = getattr(error, "problem_mark", None)
    return None if mark is None else (mark.line + 1, mark.column + 1)


def _load(text: str, loader_class: type[yaml.SafeLoader]) -> Any:
    from simkit.commands.parameter_yaml import REMEDY, TooManyValues, require_bounded

    loader = loader_class(text)
    try:
        node = loader.get_single_node()
        if node is None:
            return None
        require_bounded(node)
        return loader.construct_document(node)
    except TooManyValues as error:
        lesson = Lesson(rule=YAML, what=str(error), remedy=REMEDY)
        raise LaunchRefused(Kind.OURS, "too many values", lesson) from None
    finally:
        loader.dispose()


def _in_file(file: str, cause: object) -> str:
    return f"file {file} contains invalid YAML:\n{cause}"


def _not_yaml(words: str, error: BaseException) -> LaunchRefused:
    problem = getattr(error, "problem", None) or str(error).removeprefix("ERROR: ").split("\n")[0]
    place = _mark_of(error)
    where = f"in line {place[0]}, column {place[1]} of the YAML: " if place else ""
    lesson = Lesson(
        rule=YAML,
        what=f"{where}{problem}",
        remedy=getattr(error, "remedy", _REMEDY),
    )
    return LaunchRefused(Kind.VALUE, words, lesson, mark=place)
