"""`$(eval ...)`: a small calculator for the expressions that launch files are written with.

roslaunch hands them to Python. Here an expression is read into Python's syntax tree, and only what stands below is done:
numbers, texts, comparisons, `and`/`or`/`not`, a choice, arguments by name, a few functions. Nothing of it can hang, grow
without end or reach for a file.

Source: roslaunch `$(eval)`: names are arguments, converted as `auto` does; `arg('x')`, `env`, `optenv`, `find`, `anon`,
`dirname`, the functions of `math`, `true` and `false`.
"""

from __future__ import annotations

import ast
import math
import operator
import re
import warnings
from collections.abc import Callable, Mapping
from typing import Any

from simkit.launch.errors import Kind, LaunchRefused, Lesson, ours
from simkit.launch.files import MAX_STRING
from simkit.launch.rules import SUBSTITUTION

MAX_LENGTH = 2000
"""Characters of one expression."""
MAX_BITS = 4096
"""Size of a whole number."""
_MATH = (
    "acos acosh asin asinh atan atan2 atanh ceil copysign cos cosh degrees exp fabs floor fmod hypot "
    "isclose isfinite isinf isnan log log10 log2 pow radians sin sinh sqrt tan tanh trunc"
)
_FUNCTIONS: Mapping[str, Callable[..., Any]] = {
    **{name: getattr(math, name) for name in _MATH.split()},
    "abs": abs,
    "bool": bool,
    "float": float,
    "int": int,
    "len": len,
    "max": max,
    "min": min,
    "round": round,
    "str": str,
}
_CONSTANTS = {
    "true": True,
    "false": False,
    **{name: getattr(math, name) for name in ("e", "inf", "nan", "pi", "tau")},
}
_BINARY: Mapping[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv,
    ast.Mod: operator.mod,
    ast.Pow: operator.pow,
}
_UNARY: Mapping[type[ast.unaryop], Callable[[Any], Any]] = {
    ast.UAdd: operator.pos,
    ast.USub: operator.neg,
    ast.Not: operator.not_,
}
_COMPARE: Mapping[type[ast.cmpop], Callable[[Any, Any], Any]] = {
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
    ast.In: lambda item, container: item in container,
    ast.NotIn: lambda item, container: item not in container,
}


def evaluate_expression(
    text: str,
    *,
    arguments: Callable[[str], Any],
    functions: Mapping[str, Callable[..., Any]],
) -> str:
    """The value of an expression, as a text.

    Args:
        text: What stands between `$(eval ` and `)`.
        arguments: The value of an argument by its name; raises KeyError if there is none.
        functions: `arg`, `env` and their kin.

    Raises:
        LaunchRefused: It cannot be worked out; in the words of Python.
    """
    if "__" in text:
        words = "$(eval ...) may not contain double underscore expressions"
        raise LaunchRefused(
            Kind.SUBSTITUTION, words, _lesson("two underscores in a row are not allowed")
        )
    if len(text) > MAX_LENGTH:
        raise _beyond(f"an expression of {len(text)} characters")
    calculator = _Calculator(arguments, functions)
    try:
        value = str(calculator.value(_parsed(text)))
    except LaunchRefused:
        raise
    except (ArithmeticError, TypeError, ValueError, LookupError, RecursionError) as error:
        raise _python_says(error) from None
    if len(value) > MAX_STRING:
        raise _beyond("so long a text")
    return value


class _Calculator:
    """Works out a syntax tree."""

    def __init__(
        self, arguments: Callable[[str], Any], functions: Mapping[str, Callable[..., Any]]
    ) -> None:
        self._arguments = arguments
        self._functions = {**_FUNCTIONS, **functions}

    def value(self, node: ast.expr) -> Any:
        """The value of a part of the expression."""
        match node:
            case ast.Constant(value=bool() | int() | float() | str() | None as value):
                return value
            case ast.Name(id=name):
                return self._named(name)
            case ast.BinOp(left=left, op=op, right=right) if type(op) in _BINARY:
                return self._binary(_BINARY[type(op)], self.value(left), self.value(right))
            case ast.UnaryOp(op=op, operand=operand) if type(op) in _UNARY:
                return _UNARY[type(op)](self.value(operand))
            case ast.BoolOp():
                return self._all_or_any(node)
            case ast.Compare():
                return self._compared(node)
            case ast.IfExp(test=test, body=body, orelse=other):
                return self.value(body if self.value(test) else other)
            case ast.List(elts=items) | ast.Tuple(elts=items):
                values = [self.value(item) for item in items]
                return values if isinstance(node, ast.List) else tuple(values)
            case ast.Subscript(value=container, slice=index) if not isinstance(index, ast.Slice):
                return self.value(container)[self.value(index)]
            case ast.Call(func=ast.Name(id=name), args=arguments, keywords=[]):
                return self._called(name, [self.value(argument) for argument in arguments])
        raise _beyond(f"{ast.unparse(node)!r}")

    def _named(self, name: str) -> Any:
        if name in _CONSTANTS:
            return _CONSTANTS[name]
        try:
            return self._arguments(name)
        except KeyError:
            words = f"name '{name}' is not defined"
            what = f"{name!r} is no argument of this file"
            lesson = Lesson(
                rule=SUBSTITUTION, what=what, remedy=f'Declare it: <arg name="{name}" ...>.'
            )
            raise LaunchRefused(Kind.OTHER, words, lesson, name="NameError") from None

    def _called(self, name: str, arguments: list[Any]) -> Any:
        if name not in self._functions:
            raise _beyond(f"a call of {name!r}")
        return self._functions[name](*arguments)

    def _binary(self, function: Callable[[Any, Any], Any], left: Any, right: Any) -> Any:
        _require_small(function, left, right)
        result = function(left, right)
        if isinstance(result, int) and result.bit_length() > MAX_BITS:
            raise _beyond("so large a number")
        if isinstance(result, str | list | tuple) and len(result) > MAX_STRING:
            raise _beyond("so long a text")
        return result

    def _all_or_any(self, node: ast.BoolOp) -> Any:
        wanted = isinstance(node.op, ast.Or)
        value: Any = not wanted
        for part in node.values:
            value = self.value(part)
            if bool(value) is wanted:
                break
        return value

    def _compared(self, node: ast.Compare) -> Any:
        left = self.value(node.left)
        result: Any = True
        for op, part in zip(node.ops, node.comparators, strict=True):
            if type(op) not in _COMPARE:
                raise _beyond(f"{ast.unparse(node)!r}")
            right = self.value(part)
            result = _COMPARE[type(op)](left, right)
            if not result:
                return result
            left = right
        return result


def _parsed(text: str) -> ast.expr:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # about "\d" and the like, which are for programs
            tree = compile(text.strip(" \t"), "<string>", "eval", ast.PyCF_ONLY_AST)
    except (SyntaxError, ValueError, MemoryError, RecursionError) as error:
        raise _python_says(error) from None
    assert isinstance(tree, ast.Expression)
    return tree.body


def _require_small(function: Callable[[Any, Any], Any], left: Any, right: Any) -> None:
    """Refuse what would be too large even before it is done."""
    sequences = [len(one) for one in (left, right) if isinstance(one, str | list | tuple)]
    numbers = [one for one in (left, right) if isinstance(one, int)]
    repeats = function is operator.mul and len(sequences) == len(numbers) == 1
    if repeats and sequences[0] * numbers[0] > MAX_STRING:
        raise _beyond("so long a text")
    powers = function is operator.pow and len(numbers) == 2
    if powers and abs(right) * max(left.bit_length(), 1) > MAX_BITS:
        raise _beyond("so large a number")
    if function is operator.mod and isinstance(left, str) and re.search(r"\*|\d{4}", left):
        raise _beyond("so wide a field")


def _python_says(error: BaseException) -> LaunchRefused:
    """What Python says, in the kind that roslaunch's handlers take it for."""
    name = type(error).__name__
    kind = Kind.OTHER
    if isinstance(error, ValueError) and not isinstance(error, SyntaxError):
        kind = Kind.VALUE
    if isinstance(error, KeyError):
        kind = Kind.KEY
    return LaunchRefused(kind, str(error), _lesson(str(error)), name=name)


def _lesson(what: str) -> Lesson:
    return Lesson(
        rule=SUBSTITUTION,
        what=f"$(eval ...) cannot be worked out: {what}",
        remedy="Write an expression of numbers, texts and arguments, e.g. $(eval 2 * speed).",
    )


def _beyond(what: str) -> LaunchRefused:
    return ours(
        SUBSTITUTION,
        f"{what} is not possible in $(eval ...) here",
        "Use + - * / **, comparisons, and, or, not, arguments by name, arg('x'), and functions of math.",
    )
