"""A pattern finds the same in a text of plain letters as in any text."""

from hypothesis import given
from hypothesis import strategies as st

from simkit.xml.letters import FOREIGN_LETTERS, NAME, NAME_START, SPACE, Pattern

PATTERNS = [Pattern(one) for one in (NAME, NAME_START, FOREIGN_LETTERS, rf"<{SPACE}*+({NAME})?")]


@given(st.text(st.characters(max_codepoint=127)))
def test_plain_letters_mean_the_same_in_both_patterns(text):
    for pattern in PATTERNS:
        plain = [found.span() for found in pattern.finditer(text)]
        assert plain == [found.span() for found in pattern.finditer(text + "\u2028")]
