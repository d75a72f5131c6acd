"""`$(eval ...)`."""

import math
import time

import pytest
from hypothesis import given
from hypothesis import strategies as st

from simkit.launch.errors import Kind, LaunchRefused
from simkit.launch.expression import evaluate_expression

ARGUMENTS = {"x": 3, "name": "robot", "flag": True, "speed": 0.5}
FUNCTIONS = {"arg": lambda name: ARGUMENTS[name], "find": lambda package: f"/ws/{package}"}


def calculate(text):
    return evaluate_expression(text, arguments=ARGUMENTS.__getitem__, functions=FUNCTIONS)


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1 + 2 * 3", "7"),
        ("7 // 2, 7 % 4, -7", "(3, 3, -7)"),
        ("2 ** 10", "1024"),
        ("x * speed", "1.5"),
        ("arg('x') + 1", "4"),
        ("name + '_' + str(x)", "robot_3"),
        ("'%s_%d' % (name, x)", "robot_3"),
        ("'ab' * 3", "ababab"),
        ("x == 3 and name != 'car'", "True"),
        ("not flag or x > 5", "False"),
        ("1 < x <= 3", "True"),
        ("1 < x <= 2", "False"),
        ("'bo' in name", "True"),
        ("x not in [1, 2]", "True"),
        ("'big' if x > 2 else 'small'", "big"),
        ("[1, 2, 3][x - 1]", "3"),
        ("true and True", "True"),
        ("cos(pi)", str(math.cos(math.pi))),
        ("round(sqrt(2), 3)", "1.414"),
        ("int('12') + len(name)", "17"),
        ("find('play') + '/x'", "/ws/play/x"),
        ("  1", "1"),
        ("False or name", "robot"),
    ],
)
def test_what_launch_files_are_written_with(text, value):
    assert calculate(text) == value


@pytest.mark.parametrize(
    ("text", "words", "kind"),
    [
        ("1 / 0", "division by zero", Kind.OTHER),
        ("nothing", "name 'nothing' is not defined", Kind.OTHER),
        ("int('x')", "invalid literal for int() with base 10: 'x'", Kind.VALUE),
        ("arg('y')", "'y'", Kind.KEY),
        ("1 + 'a'", "unsupported operand type(s) for +: 'int' and 'str'", Kind.OTHER),
        ("[1][3]", "list index out of range", Kind.OTHER),
        ("1 +", "invalid syntax (<string>, line 1)", Kind.OTHER),
        ("", "invalid syntax (<string>, line 0)", Kind.OTHER),
        ("x.__class__", "$(eval ...) may not contain double underscore expressions", None),
        ("cos(1, 2)", "cos() takes exactly one argument (2 given)", Kind.OTHER),
    ],
)
def test_python_has_the_word(text, words, kind):
    with pytest.raises(LaunchRefused) as caught:
        calculate(text)
    assert caught.value.text == words or "takes exactly one argument" in caught.value.text
    if kind is not None:
        assert caught.value.kind is kind


@pytest.mark.parametrize(
    "text",
    [
        "name.upper()",
        "open('/etc/passwd')",
        "eval('1')",
        "(lambda: 1)()",
        "[i for i in [1]]",
        "f'{x}'",
        "print(1)",
        "exit()",
        "str",
        "getattr(name, 'upper')",
        "x := 1",
        "name[0:2]",
        "int('1', base=2)",
        "{1: 2}",
        "b'x'",
        "...",
        "1 is 1",
        "cos(*[1])",
        "'%10000000d' % 1",
        "'%*d' % (10000000, 1)",
        "'a' * 10 ** 9",
        "10 ** 9 * 'a'",
        "[1] * 10 ** 9",
        "2 ** 10 ** 9",
        "2 ** -2 ** 63",
        "9 ** 9 ** 9",
        "10 ** 1000 * 10 ** 1000",
        "1 << 10000000",
        "x" * 3000,
        "pow(2.0, 10 ** 9)",
        "int(2 ** 1000000)",
        "(" * 1000 + ")" * 1000,
        "+".join(["'a' * 99999"] * 3),
    ],
)
def test_nothing_else_is_done_and_nothing_hangs(text):
    start = time.monotonic()
    with pytest.raises(LaunchRefused) as caught:
        calculate(text)
    assert time.monotonic() - start < 30.0
    assert caught.value.lesson.remedy


NUMBERS = st.integers(-50, 50).map(lambda n: f"({n})")
ARITHMETIC = st.recursive(
    NUMBERS,
    lambda inner: st.tuples(inner, st.sampled_from("+-*"), inner).map(
        lambda part: f"({part[0]} {part[1]} {part[2]})"
    ),
    max_leaves=8,
)


@given(ARITHMETIC)
def test_arithmetic_is_that_of_python(text):
    assert calculate(text) == str(eval(text))


@given(st.text("0123456789abcxyz+-*/%()[]'., <>=!_", max_size=40))
def test_any_text_has_a_value_or_a_clear_error(text):
    told = ""
    try:
        told = f"value {calculate(text)}"
    except LaunchRefused as refused:
        told = refused.lesson.what
    assert told
