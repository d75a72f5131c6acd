from __future__ import annotations

import io

import pytest

from simkit.graph.process.failure import LONGEST_TEXT, describe, print_traceback


class TaughtError(Exception):
    hint = "do this"


def caught(error: Exception) -> Exception:
    try:
        raise error
    except Exception as raised:
        return raised


def printed(error: Exception) -> str:
    stream = io.StringIO()
    print_traceback(error, stream)
    return stream.getvalue()


def test_the_hint_of_any_error_stands_last():
    error = caught(TaughtError("no"))
    assert printed(error).splitlines()[-1] == "hint: do this"
    assert describe(error, "a.py")["text"].endswith("TaughtError: no\nhint: do this")


def test_a_hint_that_is_a_note_already_stands_once():
    error = caught(TaughtError("no"))
    error.add_note("hint: do this")
    assert printed(error).count("hint: ") == 1


@pytest.mark.parametrize("hint", ["", None, 3])
def test_what_is_no_hint_is_left_out(hint):
    error = TaughtError("no")
    error.hint = hint
    assert "hint: " not in printed(caught(error))
    assert "hint: " not in printed(caught(ValueError("no")))


def test_a_property_named_hint_is_not_run():
    class Trap(Exception):
        @property
        def hint(self) -> str:
            raise RuntimeError

    assert "hint: " not in printed(caught(Trap("no")))


def test_a_long_text_keeps_its_end():
    text = describe(caught(TaughtError("x" * 5000)), "a.py")["text"]
    assert len(text) <= LONGEST_TEXT
    assert text.endswith("hint: do this")
    assert "TaughtError: xxx" in text
