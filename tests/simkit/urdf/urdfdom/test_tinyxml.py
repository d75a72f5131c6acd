"""XML as TinyXML reads it."""

from __future__ import annotations

import contextlib
import time

import pytest

from simkit.urdf.urdfdom.tinyxml import TinyXmlError, parse_tiny


def only(text):
    (element,) = parse_tiny(text.encode())
    return element


def test_elements_and_where_they_stand():
    root = only("<a x='1'> text <b/><c y=\"2\"><d/></c><b z='3'/></a>\n")
    assert (root.name, root.offset, root.attributes) == ("a", 1, {"x": "1"})
    assert [child.name for child in root.children] == ["b", "c", "b"]
    assert [child.get("z") for child in root.all("b")] == [None, "3"]
    inner = root.child("c")
    assert inner is not None
    assert [child.name for child in inner.children] == ["d"]
    assert root.child("zz") is None


@pytest.mark.parametrize(
    ("value", "read"),
    [
        ("'&lt;&amp;&gt;&quot;&apos;'", "<&>\"'"),
        ("'a&b'", "ab"),
        ("'&foo;'", "foo;"),
        ("'&#65;&#x42;'", "AB"),
        ("'&#228;'", "ä"),
        ("'a&#0;b'", "a"),
        ("'a\tb\nc'", "a\tb\nc"),
        ("'a>b<c'", "a>b<c"),
        ("'\"'", '"'),
        ("bare", "bare"),
        ("&amp;", "&amp;"),
        ("'車'", "車"),
    ],
)
def test_values(value, read):
    assert only(f"<?xml version='1.0'?><a x={value} />\n").get("x") == read


def test_a_number_is_a_byte_where_no_declaration_says_utf8():
    assert only("<a x='&#228;'/>\n").get("x") == r"\xe4"
    latin = "<?xml version='1.0' encoding='latin-1'?><a x='&#228;'/>\n"
    assert only(latin).get("x") == r"\xe4"
    assert only("\ufeff<a x='&#228;'/>\n").get("x") == "ä"


def test_a_letter_of_several_bytes_swallows_the_quotation_mark():
    """A file in Latin-1 whose declaration says nothing: the letter takes two more bytes along."""
    data = "<?xml version='1.0'?><a x='ä' y='2'/>\n".encode("latin-1")
    with pytest.raises(TinyXmlError, match=r"Error reading Attributes\."):
        parse_tiny(data)
    (element,) = parse_tiny("<a x='ä' y='2'/>\n".encode("latin-1"))
    assert element.get("y") == "2"


def test_only_the_text_before_a_zero_byte_counts():
    (element,) = parse_tiny(b"<a/>\0<b>")
    assert element.name == "a"


@pytest.mark.parametrize(
    "piece", ["<a>", "<!--", "<!-- -->", "&#1;", "<a x='", "<?xml", " ", "]]>", "<"]
)
def test_time_is_in_proportion_to_the_text(piece):
    def seconds(count):
        data = b"<r>" + piece.encode() * count
        start = time.process_time()
        with contextlib.suppress(TinyXmlError):
            parse_tiny(data)
        return time.process_time() - start

    seconds(100)
    assert seconds(80_000) < 0.02 + 8 * 4 * max(seconds(10_000), 0.001)
