"""YAML of `<rosparam>` and of `type="yaml"`: PyYAML's safe loader, as roslaunch uses it, and bounds."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from simkit.launch.refusal import Kind, Lesson, Refused
from simkit.launch.rules import YAML

if TYPE_CHECKING:
    import yaml

_REMEDY = "Write `name: value` with a blank behind the colon, and nest with blanks, not tabs."


def load_yaml(text: str, *, file: str | None = None) -> Any:
    """The value of a YAML text, with the angles of rosparam: `deg(90)`, `rad(pi/2)`, `!degrees 90`.

    Args:
        text: The text; an empty one is an empty mapping.
        file: The file that it comes from; None for text in the launch file itself.

    Raises:
        Refused: It is not YAML, or too much.
    """
    import yaml

    from simkit.tools.errors import ToolError
    from simkit.tools.parameter_yaml import ParameterLoader

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
        Refused: It is not YAML, or too much.
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
    from simkit.tools.yaml_bounds import REMEDY, TooManyValues, require_bounded

    loader = loader_class(text)
    try:
        node = loader.get_single_node()
        if node is None:
            return None
        require_bounded(node)
        return loader.construct_document(node)
    except TooManyValues as error:
        lesson = Lesson(rule=YAML, what=str(error), remedy=REMEDY)
        raise Refused(Kind.OURS, "too many values", lesson) from None
    finally:
        loader.dispose()


def _in_file(file: str, cause: object) -> str:
    return f"file {file} contains invalid YAML:\n{cause}"


def _not_yaml(words: str, error: BaseException) -> Refused:
    problem = getattr(error, "problem", None) or str(error).removeprefix("ERROR: ").split("\n")[0]
    place = _mark_of(error)
    where = f"in line {place[0]}, column {place[1]} of the YAML: " if place else ""
    lesson = Lesson(
        rule=YAML,
        what=f"{where}{problem}",
        remedy=getattr(error, "remedy", _REMEDY),
    )
    return Refused(Kind.VALUE, words, lesson, mark=place)
