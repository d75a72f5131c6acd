import pytest

from simkit.graph.process.failure import describe
from simkit.graph.process.remedies import remedy_of


@pytest.mark.parametrize(
    ("code", "said"),
    [
        ("while True\n    x = 1\n", "ends with a colon"),
        ("if 1:\n\tx = 1\n        y = 2\n", "four spaces: the two are mixed"),
        ("def f():\nx = 1\n", "four spaces deeper"),
        ("if 1:\n    x = 1\n  y = 2\n", "four spaces deeper"),
        ("x = f(1\ny = 2\n", "each one that opens must close"),
        ("x = [1)\n", "each one that opens must close"),
        ("print 'a'\n", 'write print("text")'),
        ("try:\n    x\nexcept ValueError, e:\n    pass\n", "except ValueError as error"),
        ("x = \u201ca\u201d\n", "quotation marks anew"),
        ("x = 'a\n", "ends with the quotation mark"),
        ("float('1,5')", "decimal point"),
        ("import roslib; roslib.load_manifest('a')", "Delete `import roslib`"),
        ("raw_input('?')", "Python 3 calls it input"),
        ("raise EOFError('EOF when reading a line')", "_speed:=1.5"),
    ],
)
def test_the_usual_cause_is_named(code, said):
    with pytest.raises(Exception) as caught:
        exec(compile(code, "a.py", "exec"), {})
    assert said in remedy_of(caught.value)
    assert describe(caught.value, "a.py")["text"].endswith(f"hint: {remedy_of(caught.value)}")


@pytest.mark.parametrize("error", [ValueError("1,5"), SyntaxError("invalid syntax"), KeyError()])
def test_nothing_is_said_of_what_is_not_known(error):
    assert remedy_of(error) == ""


def test_a_syntax_error_shows_its_line_of_code():
    with pytest.raises(SyntaxError) as caught:
        compile("x = 1\nwhile True\n", "a.py", "exec")
    told = describe(caught.value, "a.py")
    assert (told["file"], told["line"]) == ("a.py", 2)
    assert told["text"].splitlines()[:2] == ["SyntaxError: expected ':'", "    while True"]
