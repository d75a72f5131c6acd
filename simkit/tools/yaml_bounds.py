"""YAML that ends: what a text unfolds to is counted before anything is made of it.

An alias (`*name`) repeats what an anchor (`&name`) has marked. A few lines of aliases of aliases stand for billions of values,
and one that stands in itself has no end.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import yaml

from simkit.tools.errors import ToolError

MAX_VALUES = 100_000
"""Values that one YAML document may unfold to."""
MAX_DEPTH = 50
"""How deep they may be nested."""
REMEDY = "Write the values out, without aliases of aliases (*name)."
"""What to do about a text that unfolds to too much."""


class TooManyValues(ToolError):
    """A YAML text that unfolds to too much."""

    def __init__(self) -> None:
        super().__init__(f"this YAML unfolds to more than {MAX_VALUES} values")


def load_documents(text: str, loader_class: type[yaml.SafeLoader]) -> Iterator[Any]:
    """The value of each document in a YAML text; the next one is read when it is asked for.

    Args:
        text: The text.
        loader_class: PyYAML's safe loader, or one that knows more tags.

    Raises:
        yaml.YAMLError: It is not YAML.
        TooManyValues: It unfolds to too much, or is nested too deep.
    """
    loader = loader_class(text)
    try:
        while loader.check_node():
            node = loader.get_node()
            require_bounded(node)
            yield loader.construct_document(node)
    except RecursionError:
        raise TooManyValues from None
    finally:
        loader.dispose()


def require_bounded(node: yaml.Node) -> None:
    """Refuse what unfolds to too much.

    Raises:
        TooManyValues: It does.
    """
    if _size(node, {}, 0) > MAX_VALUES:
        raise TooManyValues


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
