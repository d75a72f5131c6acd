"""YAML of parameters: with angles, `deg(90)` and `rad(pi/2)`, and one name for a block of output.

It ends, too: what a text unfolds to is counted before anything is made of it. An alias (`*name`) repeats what an anchor
(`&name`) has marked; a few lines of aliases of aliases stand for billions of values, and one that stands in itself has no end.

Source: rosparam of ROS Noetic: the tags `!degrees` and `!radians`, and words of these two forms.
"""

from __future__ import annotations

import ast
import math
import operator
import re
from collections.abc import Callable, Iterator
from typing import Any

import yaml

from simkit.commands.errors import ToolError

_OPERATORS: dict[type[ast.AST], Callable[..., float]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.USub: operator.neg,
    ast.UAdd: operator.pos,
}
MAX_VALUES = 100_000
"""Values that one YAML document may unfold to."""
MAX_DEPTH = 50
"""How deep they may be nested."""
REMEDY = "Write the values out, without aliases of aliases (*name)."
"""What to do about a text that unfolds to too much."""


class ParameterLoader(yaml.SafeLoader):  # type: ignore[misc]  # PyYAML tells no types
    """A safe loader that knows angles."""


class AngleError(ToolError):
    """An angle that cannot be read.

    Args:
        problem: What rosparam says.
        remedy: What would be right; a sentence.
        problem_mark: Where it stands, as in PyYAML's own errors.
    """

    def __init__(self, problem: str, remedy: str, problem_mark: Any) -> None:
        super().__init__(f"ERROR: {problem}")
        self.problem = problem
        self.remedy = remedy
        self.problem_mark = problem_mark


def load_parameters(text: str, *, file: str = "") -> list[Any]:
    """The values of a YAML text, one for each document in it.

    Args:
        text: The text.
        file: The file that it comes from; empty for words of a command line.

    Raises:
        ToolError: It is not YAML, or an angle cannot be read.
    """
    try:
        return list(load_documents(text, ParameterLoader))
    except yaml.YAMLError as error:
        problem = getattr(error, "problem", None) or " ".join(str(error).split())
        raise ToolError(f"ERROR: {_place_of(error, file)}not YAML: {problem}") from error
    except ToolError as error:
        words = str(error).removeprefix("ERROR: ")
        raise ToolError(f"ERROR: {_place_of(error, file)}{words}") from None
    except ValueError as error:  # e.g. the 31st of February
        raise ToolError(f"ERROR: {_place_of(error, file)}not YAML: {error}") from None


def _place_of(error: Exception, file: str) -> str:
    """File, line and column of a fault, with a colon behind it; empty for words of a command line."""
    mark = getattr(error, "problem_mark", None)
    place = "" if mark is None else f":{mark.line + 1}:{mark.column + 1}"
    return f"{file}{place}: " if file else ""


def dump_parameters(value: Any) -> str:
    """A value as YAML, with the line break at its end."""
    return str(yaml.safe_dump(value, default_flow_style=False))


def _degrees(loader: ParameterLoader, node: Any) -> float:
    text = str(loader.construct_scalar(node)).strip()
    number = text[4:-1] if text.startswith("deg(") else text
    try:
        return float(number) * math.pi / 180.0
    except ValueError:
        remedy = (
            "Write a number of degrees, deg(90); an expression must be one of radians, rad(pi/2)."
        )
        raise AngleError(f"invalid degree value: {text}", remedy, node.start_mark) from None


def _radians(loader: ParameterLoader, node: Any) -> float:
    text = str(loader.construct_scalar(node)).strip()
    expression = text[4:-1] if text.startswith("rad(") else text
    try:
        return _value(ast.parse(expression.strip(), mode="eval").body)
    except (SyntaxError, ValueError, ZeroDivisionError, RecursionError):
        remedy = "Write numbers, pi and + - * / in it: rad(pi/2)."
        raise AngleError(f"invalid radian expression: {text}", remedy, node.start_mark) from None


def _value(node: ast.AST) -> float:
    """The value of an expression of numbers, `pi` and + - * /."""
    match node:
        case ast.Constant(value=int() | float() as number):
            return float(number)
        case ast.Name(id="pi"):
            return math.pi
        case ast.BinOp(left=left, op=op, right=right) if type(op) in _OPERATORS:
            return _OPERATORS[type(op)](_value(left), _value(right))
        case ast.UnaryOp(op=op, operand=operand) if type(op) in _OPERATORS:
            return _OPERATORS[type(op)](_value(operand))
    raise ValueError(ast.dump(node))


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


for _tag, _construct, _word in (
    ("!degrees", _degrees, "deg"),
    ("!radians", _radians, "rad"),
):
    ParameterLoader.add_constructor(_tag, _construct)
    ParameterLoader.add_implicit_resolver(_tag, re.compile(rf"^{_word}\([^)]*\)$"), [_word[0]])
