"""Laws: what expat takes is well-formed here and means the same; what expat refuses has a fault, in its place."""

from __future__ import annotations

import random
import re
from xml.etree import ElementTree
from xml.parsers import expat

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from simkit.xml import Document, Element, Span, parse_xml

FILE = """\
<?xml version="1.0" encoding="utf-8"?>
<!-- a comment -->
<!DOCTYPE robot>
<robot name="arm" xmlns:x="y">
  <link name="base"><visual><origin xyz="0 0 1" rpy='0 0 0'/></visual>
   text &amp; more &#65; &#x41; <![CDATA[raw <b> ]] ]]>
  </link>
  <?pi some thing?>
  <joint name="j&quot;" type = "fixed" ><parent link="højre"/></joint >
</robot>
<!-- end -->
"""
PIECES = (
    *("<", ">", "/", "=", '"', "'", "&", ";", "]]>", "--", "-->", "<!--", "<?", "?>", "<![CDATA["),
    *("</", "/>", "<!", "<>", "<!-->", "&lt;", "&#0;", "&#x20;", "&nope;", "&amp", "\\", " ", "\n"),
    *(
        "\t",
        "\r",
        "\x00",
        "\x1f",
        "\x7f",
        "\u0085",
        "\u00a0",
        "\u2028",
        "\ufeff",
        "\ufffe",
        "æ",
        "日",
    ),
    *(
        "<?xml version='1.0'?>",
        "<!DOCTYPE a>",
        "<!DOCTYPE a SYSTEM 'x'>",
        "<!DOCTYPE a [ ]>",
        "x y",
    ),
    *(
        "<a>",
        "</a>",
        "<a/>",
        "</robot>",
        " a=1",
        ' a="1"',
        "standalone='yes'",
        "xml",
        ":",
        "-",
        "1",
    ),
)
CHARACTERS = st.characters(
    exclude_categories=["Cs"], exclude_characters=[*map(chr, range(32)), "\ufffe", "\uffff"]
) | st.sampled_from("\t\n &<>\"'æ日")
NAMES = st.from_regex(r"[A-Za-z_:æøå日][-A-Za-z0-9_.:æøå日]{0,5}", fullmatch=True)


def read(text: str | bytes) -> Document:
    return parse_xml(text, file="arm.urdf")


def expat_takes(text: str) -> bool:
    parser = expat.ParserCreate("utf-8")
    try:
        parser.Parse(text.encode("utf-8", "surrogatepass"), True)
    except expat.ExpatError:
        return False
    return True


def spoiled(rng: random.Random) -> str:
    text = FILE
    for _ in range(rng.choice((1, 1, 1, 2, 3))):
        at = rng.randrange(len(text) + 1)
        what = rng.randrange(3)
        behind = at + (0 if what == 0 else rng.randrange(1, 8))
        text = text[:at] + ("" if what == 1 else rng.choice(PIECES)) + text[behind:]
    return text


# our names are those of the fifth edition of XML, expat's those of the fourth: letters beyond
# Latin-1 and the common ones of CJK are left out of names
def test_a_spoiled_text_is_well_formed_for_both_or_for_none():
    rng = random.Random(20)
    taken = 0
    for _ in range(2500):
        text = spoiled(rng)
        takes = expat_takes(text)
        taken += takes
        assert read(text).is_well_formed == takes, text
    assert 200 < taken < 1250


def test_spoiled_bytes_are_well_formed_for_both_or_for_none():
    rng = random.Random(21)
    for _ in range(1200):
        data = bytearray(FILE.encode(rng.choice(("utf-8", "utf-8-sig"))))
        for _ in range(rng.randrange(1, 3)):
            data[rng.randrange(len(data))] = rng.choice((rng.randrange(256), 0x3C, 0x26, 0x22))
        names = re.findall(rb"encoding=.([\w.-]*).\?>", data)
        if names not in ([b"utf-8"], []):
            continue  # expat takes `utf8` and the like for encodings with one byte for each letter
        parser = expat.ParserCreate()
        try:
            takes = bool(parser.Parse(bytes(data), True))
        except (expat.ExpatError, LookupError, ValueError):
            takes = False
        assert read(bytes(data)).is_well_formed == takes, data


@st.composite
def elements(draw: st.DrawFn, depth: int = 3) -> str:
    """A well-formed element."""
    name = draw(NAMES)
    attributes = "".join(
        f"{draw(st.sampled_from([' ', chr(10), '  ']))}{key}{draw(st.sampled_from(['=', ' = ']))}"
        + draw(st.sampled_from(['"{}"', "'{}'"])).format(
            escaped(draw(st.text(CHARACTERS, max_size=6)))
        )
        for key in draw(st.lists(NAMES.filter(lambda key: key != "xmlns"), unique=True, max_size=3))
    )
    kinds = ["empty", "text"] + ["elements"] * (depth > 0)
    kind = draw(st.sampled_from(kinds))
    if kind == "empty":
        return f"<{name}{attributes}{draw(st.sampled_from(['', ' ']))}/>"
    if kind == "text":
        inner = draw(contents())
    else:
        inner = "".join(
            draw(contents()) + one for one in draw(st.lists(elements(depth=depth - 1), max_size=3))
        )
    return f"<{name}{attributes}>{inner}</{name}{draw(st.sampled_from(['', ' ']))}>"


@st.composite
def contents(draw: st.DrawFn) -> str:
    """A text between tags, or something that is none."""
    text = draw(st.text(CHARACTERS, max_size=8))
    kind = draw(st.sampled_from(["text", "section", "comment", "instruction", "number"]))
    return {
        "text": escaped(text),
        "section": f"<![CDATA[{text.replace(']]', '')}]]>".replace("]]]>", "]]>"),
        "comment": f"<!--{text.replace('-', '')}-->",
        "instruction": f"<?pi {text.replace('?', '')}?>",
        "number": "".join(f"&#{ord(letter)};" for letter in text),
    }[kind]


def escaped(text: str) -> str:
    for sign, name in (("&", "amp"), ("<", "lt"), (">", "gt"), ('"', "quot"), ("'", "apos")):
        text = text.replace(sign, f"&{name};")
    return text


def ours(element: Element) -> list[tuple[str, dict[str, str], str, int]]:
    return [
        (one.name, {a.name: a.value for a in one.attributes}, one.text, len(one.children))
        for one in element.walk()
    ]


def theirs(text: str) -> list[tuple[str, dict[str, str], str, int]]:
    """The same as expat reads it, without namespaces."""
    builder = ElementTree.TreeBuilder()
    parser = expat.ParserCreate("utf-8")
    parser.StartElementHandler = builder.start
    parser.EndElementHandler = builder.end
    parser.CharacterDataHandler = builder.data
    parser.Parse(text.encode("utf-8"), True)
    return [
        (
            one.tag,
            dict(one.attrib),
            (one.text or "") + "".join(child.tail or "" for child in one),
            len(one),
        )
        for one in builder.close().iter()
    ]


@settings(max_examples=100)
@given(elements())
def test_a_well_formed_text_is_read_as_expat_reads_it(text):
    document = read(text)
    assert document.is_well_formed
    assert document.root is not None
    assert ours(document.root) == theirs(text)


def places(document: Document) -> list[tuple[Span, str | None]]:
    """All places of a document, and what must stand there if it is a name."""
    found: list[tuple[Span, str | None]] = [(fault.span, None) for fault in document.faults]
    found += [(fault.other, None) for fault in document.faults if fault.other is not None]
    for element in document.root.walk() if document.root is not None else ():
        found.append((element.span, element.name))
        found += [(a.name_span, a.name) for a in element.attributes]
        found += [(a.value_span, None) for a in element.attributes]
        found += [] if element.text_span is None else [(element.text_span, None)]
    return found


def check_places(document: Document) -> None:
    for span, name in places(document):
        line = document.line(span.line)
        assert 1 <= span.line <= len(document.lines)
        assert span.column >= 1
        assert span.length >= 1
        assert span.column + span.length - 1 <= max(1, len(line))
        if name is not None:
            assert line[span.column - 1 : span.column - 1 + span.length] == name


@settings(max_examples=100)
@given(st.text(), st.text(CHARACTERS | st.sampled_from("<>/=&;!?-[]")), st.binary())
def test_nothing_raises_and_all_places_are_in_the_text(text, markup, data):
    for one in (text, markup, data, f"<a>{markup}</a>", f"<a {markup}/>", f"<a b='{markup}' />"):
        check_places(read(one))


def test_places_of_spoiled_texts(mutated):
    rng = random.Random(22)
    for _ in range(300):
        document = read(mutated(FILE, rng))
        check_places(document)
        faults = [fault.span for fault in document.faults]
        assert faults == sorted(faults)


def test_the_same_text_has_the_same_faults(mutated):
    for seed in range(40):
        first, second = (read(mutated(FILE, random.Random(seed))) for _ in range(2))
        assert first.faults == second.faults
        assert first.lines == second.lines


@pytest.mark.parametrize("text", ["<a>&#xD800;</a>", "<a>\ud800</a>", "<\ud800/>", "\udcff"])
def test_halves_of_letters_are_faults(text):
    assert not read(text).is_well_formed
