"""Node side: the usual cause of an error that beginners meet, and what to do, as a sentence."""

from __future__ import annotations

import re

_BRACKET = "Count the brackets of this line and of those above it: each one that opens must close."
_QUOTES = "Type the quotation marks anew: those of a text or a web page are other characters."
_COLON = (
    "A line that begins with if, for, while, def, class, else, try or except ends with a colon."
)
_INDENT = "Begin the lines of one block below each other, four spaces deeper than the line with the colon."

_REMEDIES: tuple[tuple[type[BaseException], str, str], ...] = (
    (SyntaxError, "expected ':'", _COLON),
    (
        SyntaxError,
        "inconsistent use of tabs",
        "Replace each tab by four spaces: the two are mixed here.",
    ),
    (SyntaxError, "expected an indented block|unindent does not|unexpected indent", _INDENT),
    (SyntaxError, "was never closed|unmatched|does not match opening", _BRACKET),
    (
        SyntaxError,
        "in call to 'print'",
        'This is the print of Python 2; ROS Noetic has Python 3: write print("text").',
    ),
    (
        SyntaxError,
        "multiple exception types",
        "This is Python 2; in Python 3 write `except ValueError as error:`.",
    ),
    (
        SyntaxError,
        "unterminated .*string",
        "A text ends with the quotation mark that it begins with.",
    ),
    (SyntaxError, "invalid character '[\u2018-\u201f\u00ab\u00bb\u00b4]'", _QUOTES),
    (
        EOFError,
        "EOF when reading a line",
        "No keys come to this node here: instead of input(), give it the value as a parameter, _speed:=1.5, or as an argument.",
    ),
    (
        ValueError,
        r"could not convert string to float: '-?\d+,\d+'",
        "Write a decimal point, 1.5: a comma separates two values.",
    ),
    (
        ImportError,
        "No module named 'roslib'",
        "Delete `import roslib` and `roslib.load_manifest(...)`: catkin packages need neither.",
    ),
    (NameError, "'(raw_input|unicode|xrange)'", "Python 3 calls it input, str and range."),
)
"""Kind of error, what its text holds (as a pattern), and what to say."""


def remedy_of(error: BaseException) -> str:
    """What to do about an error, as a sentence; empty if nothing is known."""
    text = str(error)
    return next(
        (say for kind, has, say in _REMEDIES if isinstance(error, kind) and re.search(has, text)),
        "",
    )
