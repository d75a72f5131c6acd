"""What a script prints, and how much of it was shown."""

from hypothesis import given
from hypothesis import strategies as st

from simkit.graph.process.printout import Printout


@given(st.text(), st.integers(1, 5))
def test_what_comes_in_any_pieces_is_shown_once_and_whole(text, size):
    shown = []
    printout = Printout(shown.append)
    data = text.encode()
    for start in range(0, len(data), size):
        printout.data += data[start : start + size]
        printout.show_news()
        printout.show_news()
    assert "".join(shown) == text == printout.text
    assert all(shown)


def test_what_is_no_text_is_shown_nevertheless():
    shown = []
    printout = Printout(shown.append)
    printout.data += b"a\xffb"
    printout.show_news()
    assert shown == ["a\ufffdb"]
    assert printout.text == "a\ufffdb"
