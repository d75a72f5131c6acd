"""What a well-formed text becomes: elements, attributes and texts, each with its place."""

from __future__ import annotations

import pytest

from simkit.xml import Document, Element, FaultKind, Span, parse_xml

ROBOT = """\
<?xml version="1.0"?>
<!-- an arm -->
<robot name="arm" xmlns:xacro="http://ros.org/wiki/xacro">
  <link name="base">
    <visual>
      <origin xyz="0 0 0.5" rpy='0 0 0' />
    </visual>
    <visual/>
  </link >
  <joint
      name = "hip"
      type="revolute">some text</joint>
</robot>
<!-- the end -->
"""


def read(text: str | bytes) -> Document:
    return parse_xml(text, file="arm.urdf")


def root(text: str | bytes) -> Element:
    document = read(text)
    assert document.faults == ()
    assert document.root is not None
    return document.root


def test_elements_stand_in_each_other():
    robot = root(ROBOT)
    assert [one.name for one in robot.walk()] == [
        "robot",
        "link",
        "visual",
        "origin",
        "visual",
        "joint",
    ]
    assert [one.path for one in robot.walk()] == [
        "robot",
        "robot/link[base]",
        "robot/link[base]/visual[1]",
        "robot/link[base]/visual[1]/origin",
        "robot/link[base]/visual[2]",
        "robot/joint[hip]",
    ]


def test_elements_and_attributes_know_their_places():
    robot = root(ROBOT)
    joint = robot.children[1]
    origin = robot.children[0].children[0].children[0]
    assert (robot.span, joint.span) == (Span(3, 2, 5), Span(10, 4, 5))
    assert [(a.name, a.value) for a in origin.attributes] == [("xyz", "0 0 0.5"), ("rpy", "0 0 0")]
    assert origin.span_of("xyz") == Span(6, 20, 7)
    assert origin.span_of("nothing") == origin.span == Span(6, 8, 6)
    name = joint.attribute("name")
    assert name is not None
    assert (name.name_span, name.value_span) == (Span(11, 7, 4), Span(11, 15, 3))


def test_text_knows_its_place():
    joint = root(ROBOT).children[1]
    assert joint.text == "some text"
    assert joint.text_span == Span(12, 23, 9)
    assert root("<a>\n \n  two\n words <b/> more</a>").text_span == Span(3, 3, 3)
    assert root("<a> <b/> </a>").text_span is None


def test_lines_are_those_of_the_text():
    document = read(ROBOT)
    assert document.line(3) == '<robot name="arm" xmlns:xacro="http://ros.org/wiki/xacro">'
    assert document.line(0) == document.line(99) == ""
    assert "\n".join(document.lines) == document.text == ROBOT
    assert document.file == "arm.urdf"


def test_line_ends_of_any_system_are_the_same():
    other = [read(ROBOT.replace("\n", end)) for end in ("\r\n", "\r")]
    assert [document.text for document in other] == [ROBOT, ROBOT]
    assert other[0].root is not None
    assert [one.span for one in other[0].root.walk()] == [one.span for one in root(ROBOT).walk()]


def test_a_column_counts_letters():
    assert root("<a>\t<b/></a>").children[0].span == Span(1, 6, 1)
    assert root("<a>æøå日本<b/></a>").children[0].span == Span(1, 10, 1)


def test_a_line_ends_at_a_newline_only():
    text = "<a>\u2028\x85\u2029<b/></a>"
    assert read(text).lines == (text,)


def test_entities_and_numbers_of_letters_are_replaced():
    element = root("<a b='&lt;&amp;&quot;&apos;&gt;&#65;&#x42;' >&lt;&#x1F600;</a>")
    assert (element.get("b"), element.text) == ("<&\"'>AB", "<\U0001f600")


def test_white_space_in_a_value_becomes_spaces_but_not_that_of_references():
    assert root("<a b='1\t2\r\n3&#9;4&#10;5'/>").get("b") == "1 2 3\t4\n5"


def test_sections_are_text_and_comments_are_none():
    assert root("<a>1<!-- 2 <b> & --><![CDATA[<3>&amp;]]><?pi 4?>5</a>").text == "1<3>&amp;5"


def test_a_greater_sign_is_text():
    element = root('<a b=">"><c/>></a>')
    assert (element.get("b"), element.text) == (">", ">")


@pytest.mark.parametrize(
    "text",
    [
        "<a/>",
        "<a></a>",
        "\ufeff<a/>",
        "<a b='1'\n\tc='2'\n/>",
        "<?xml version='1.0' encoding='UTF-8' standalone='yes' ?>\n<a/>",
        "<!DOCTYPE robot>\n<robot/>",
        "<!DOCTYPE robot []>\n<robot/>",
        "<!DOCTYPE robot [ <!-- nothing --> <?pi ]?> ]  >\n<robot/>",
        "<!DOCTYPE a PUBLIC '-//X//Y' \"z.dtd\"><a/>",
        "<?xml-stylesheet href='x'?><a/>",
        "<a><!----></a><!-- - -->\n<?pi?>\n",
        "<!-- <!--><a/>",
        "<:a :b='1' c:d='2' e.f-g_1='3'/>",
        "<længde/>",
        "<日本 è='1'/>",
    ],
)
def test_well_formed_texts(text):
    assert read(text).faults == ()
    assert read(text).is_well_formed


@pytest.mark.parametrize(
    "encoding",
    ["UTF-8", "utf8", "ISO-8859-1", "latin1", "windows-1252", "iso8859-15", "UTF-16"],
)
def test_a_declared_encoding_is_used(encoding):
    text = f'<?xml version="1.0" encoding="{encoding}"?><link name="højre"/>'
    element = root(text.encode(encoding))
    assert element.get("name") == "højre"
    assert element.span == Span(1, 35 + len(encoding), 4)


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16-le", "utf-16-be"])
def test_a_byte_order_mark_tells_the_encoding(encoding):
    text = '<robot name="Å"/>'
    data = text.encode(encoding) if "sig" in encoding else ("\ufeff" + text).encode(encoding)
    assert root(data).get("name") == "Å"
    assert root(data).span == Span(1, 2, 5)


def test_the_encoding_of_a_text_has_no_meaning():
    assert root('<?xml version="1.0" encoding="UTF-16"?><a b="æ"/>').get("b") == "æ"


@pytest.mark.parametrize(
    ("data", "place"),
    [
        (b"<a>\n b\xe6r</a>", Span(2, 3, 1)),
        (b'<?xml version="1.0" encoding="ascii"?><a b="\xc3\xa6"/>', Span(1, 45, 1)),
        (b'<?xml version="1.0" encoding="klingon"?><a/>', Span(1, 31, 1)),
        (b'<?xml version="1.0" encoding="UTF-16"?><a/>', Span(1, 31, 1)),
        (b'<?xml version="1.0" encoding="rot13"?><a/>', Span(1, 31, 1)),
        (b'<?xml version="1.0" encoding="cp500"?><a/>', Span(1, 31, 1)),
        ("\ufeff<?xml version='1.0' encoding='UTF-8'?><a/>".encode("utf-16-le"), Span(1, 31, 1)),
    ],
)
def test_a_wrong_encoding_is_a_fault(data, place):
    document = read(data)
    assert [(one.kind, one.span) for one in document.faults] == [(FaultKind.ENCODING, place)]
    assert document.root is not None
    assert document.root.name == "a"


def test_bytes_that_are_no_text_are_shown_as_replacements():
    document = read(b"<a>b\xe6r</a>")
    assert document.text == "<a>b\ufffdr</a>"
    assert "Windows-1252" in document.faults[0].what
    assert "æ" in document.faults[0].what
