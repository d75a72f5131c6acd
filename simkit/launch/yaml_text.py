"""YAML of `<rosparam>` and of `type="yaml"`: PyYAML's safe loader, as roslaunch uses it, and bounds for aliases.

An alias (`*name`) repeats what an anchor (`&name`) has marked. A few lines of aliases of aliases stand for billions of values,
so what a text unfolds to is counted before anything is made of it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from simkit.launch.refusal import Kind, Lesson, Refused
from simkit.launch.rules import YAML

if TYPE_CHECKING:
    import yaml

MAX_VALUES = 100_000
"""Values that one YAML text may unfold to."""
MAX_DEPTH = 50
"""How deep they may be nested."""


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
    loader = loader_class(text)
    try:
        node = loader.get_single_node()
        if node is None:
            return None
        _require_bounded(node)
        return loader.construct_document(node)
    finally:
        loader.dispose()


def _require_bounded(node: yaml.Node) -> None:
    sizes: dict[int, int] = {}
    if _size(node, sizes, 0) > MAX_VALUES:
        raise Refused(
            Kind.OURS,
            "too many values",
            Lesson(
                rule=YAML,
                what=f"this YAML unfolds to more than {MAX_VALUES} values",
                remedy="Write the values out, without aliases of aliases (*name).",
            ),
        )


def _size(node: yaml.Node, sizes: dict[int, int], depth: int) -> int:
    """How many values a node stands for, aliases unfolded; what is open counts as without end."""
    if id(node) in sizes:
        return sizes[id(node)]
    if depth > MAX_DEPTH:
        return MAX_VALUES + 1
    sizes[id(node)] = MAX_VALUES + 1  # an alias of what it stands in
    value = node.value
    parts = [] if isinstance(value, str) else value
    total = 1
    for part in parts:
        for one in part if isinstance(part, tuple) else (part,):
            total = min(total + _size(one, sizes, depth + 1), MAX_VALUES + 1)
    sizes[id(node)] = total
    return total


def _in_file(file: str, cause: object) -> str:
    return f"file {file} contains invalid YAML:\n{cause}"


def _not_yaml(words: str, error: BaseException) -> Refused:
    problem = getattr(error, "problem", None) or str(error).removeprefix("ERROR: ").split("\n")[0]
    place = _mark_of(error)
    where = f"in line {place[0]}, column {place[1]} of the YAML: " if place else ""
    lesson = Lesson(
        rule=YAML,
        what=f"{where}{problem}",
        remedy="Write `name: value` with a blank behind the colon, and nest with blanks, not tabs.",
    )
    return Refused(Kind.VALUE, words, lesson, mark=place)
