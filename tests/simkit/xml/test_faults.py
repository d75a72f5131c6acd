"""The mistakes of learners: one fault each, at the culprit, with the text to write; and the tree that was meant."""

from __future__ import annotations

import pytest

from simkit.xml import Document, Element, FaultKind, Span, parse_xml

ROBOT = """\
<?xml version="1.0"?>
<robot name="arm">
  <link name="base">
    <visual>
      <origin xyz="0 0 0.05" rpy="0 0 0"/>
      <geometry>
        <box size="1 1 0.1"/>
      </geometry>
    </visual>
    <inertial>
      <mass value="1"/>
      <inertia ixx="1" iyy="2"/>
    </inertial>
  </link>
  <link name="arm"/>
  <joint name="hip" type="revolute">
    <parent link="base"/>
    <child link="arm"/>
  </joint>
</robot>
"""


def read(text: str | bytes) -> Document:
    return parse_xml(text, file="arm.urdf")


def sketch(element: Element | None) -> str:
    """The tree in one line."""
    if element is None:
        return ""
    attributes = "".join(f" {one.name}={one.value!r}" for one in element.attributes)
    return f"{element.name}{attributes}({', '.join(map(sketch, element.children))})"


def slip(before: str, after: str) -> str:
    assert ROBOT.count(before) >= 1
    return ROBOT.replace(before, after, 1)


# what is written, what should be; the kind, line and column of the fault, what the remedy says, where the second place is
SLIPS = {
    "slash of a tag forgotten": ('<mass value="1"/>', '<mass value="1">',
     "UNCLOSED", 11, 8, '<mass value="1"/>', (13, 5)),
    "slash forgotten, only child": ('0.1"/>', '0.1">', "UNCLOSED", 7, 10, '<box size="1 1 0.1"/>', (8, 7)),
    "slash forgotten, more follow": ('rpy="0 0 0"/>', 'rpy="0 0 0">', "UNCLOSED", 5, 8, "</origin>", (9, 5)),
    "end tag forgotten": ("    </visual>\n", "",
     "UNCLOSED", 4, 6, "Write </visual> before <inertial> in line 9.", (13, 3)),
    "end tag forgotten, at the end": ("      </geometry>\n", "",
     "UNCLOSED", 6, 8, "Write </geometry> before </visual> in line 8.", (8, 5)),
    "end of a link forgotten": ("  </link>\n", "",
     "UNCLOSED", 3, 4, "Write </link> before <link> in line 14.", (19, 1)),
    "end of the last joint forgotten": ("  </joint>\n", "",
     "UNCLOSED", 16, 4, "Write </joint> before </robot> in line 19.", (19, 1)),
    "end of the root forgotten": ("</robot>\n", "", "UNCLOSED", 2, 2, "Write </robot> at the end of the file.", None),
    "end tag twice": ("      </geometry>\n", "      </geometry>\n</geometry>\n",
     "STRAY_END", 9, 1, "Delete this second </geometry>.", (8, 7)),
    "end of a link twice": ("  </link>\n", "  </link>\n  </link>\n",
     "STRAY_END", 15, 3, "Delete this second </link>.", (14, 3)),
    "end of the root twice": ("</robot>\n", "</robot>\n</robot>\n",
     "STRAY_END", 21, 1, "Delete this second </robot>.", (20, 1)),
    "end tag after a closed tag": ('<mass value="1"/>', '<mass value="1"/></mass>',
     "STRAY_END", 11, 24, "Delete the /", (11, 8)),
    "end tag misspelt": ("</visual>", "</visul>", "MISMATCHED_TAG", 9, 5, "Write </visual>", (4, 6)),
    "end tag in capitals": ("</visual>", "</Visual>", "MISMATCHED_TAG", 9, 5, "Write </visual>", (4, 6)),
    "end tag of another element": ("</visual>", "</collision>", "MISMATCHED_TAG", 9, 5, "Write </visual>.", (4, 6)),
    "end tags in the wrong order": ("      </geometry>\n    </visual>\n", "      </visual>\n    </geometry>\n",
     "UNCLOSED", 6, 8, "Write </geometry> before </visual> in line 8.", (8, 7)),
    "start tag instead of an end tag": ("</visual>", "<visual>",
     "DOUBLED_TAG", 9, 6, "Write </visual> instead if", (4, 6)),
    "closed tag instead of an end tag": ("</visual>", "<visual/>",
     "DOUBLED_TAG", 9, 6, "Write </visual> instead if", (4, 6)),
    "start tag without <": ("<visual>", "visual>", "MALFORMED_TAG", 4, 5, "Write <visual>.", (9, 5)),
    "end tag without <": ("</visual>", "/visual>", "MALFORMED_TAG", 9, 5, "Write </visual>.", (4, 6)),
    "end tag without </": ("</visual>", "visual>", "MALFORMED_TAG", 9, 5, "Write </visual>.", (4, 6)),
    "space behind <": ("<visual>", "< visual>", "MALFORMED_TAG", 4, 5, "Write <visual without", None),
    "space behind </": ("</visual>", "</ visual>", "MALFORMED_TAG", 9, 5, "Write </visual>.", None),
    "space before /": ("</visual>", "< /visual>", "MALFORMED_TAG", 9, 5, "Write </visual>.", None),
    "space behind /": ('value="1"/>', 'value="1"/ >', "MALFORMED_TAG", 11, 22, "Write />.", None),
    "backslash in an end tag": ("</visual>", "<\\visual>", "MALFORMED_TAG", 9, 5, "Write </visual>.", None),
    "backslash at the end": ('value="1"/>', 'value="1"\\>', "MALFORMED_TAG", 11, 22, "Write />.", None),
    "attribute in an end tag": ("</visual>", '</visual name="a">', "MALFORMED_TAG", 9, 5, "Write </visual>.", None),
    "> forgotten": ("<visual>", "<visual", "MALFORMED_TAG", 4, 11, "Write > behind visual", (4, 6)),
    "> forgotten behind attributes": ('name="base">', 'name="base"',
     "MALFORMED_TAG", 3, 19, 'Write > behind link name="base"', (3, 4)),
    "> forgotten behind /": ('value="1"/>', 'value="1"/', "MALFORMED_TAG", 11, 22, "Write > behind", (11, 8)),
    "/> forgotten": ('value="1"/>', 'value="1"', "MALFORMED_TAG", 11, 21, "or />", (11, 8)),
    "> of an end tag forgotten": ("</visual>", "</visual", "MALFORMED_TAG", 9, 5, "Write </visual>.", None),
    "< twice": ("<visual>", "<<visual>", "MALFORMED_TAG", 4, 5, "Delete it.", None),
    "no quotation marks": ('size="1 1 0.1"', "size=1 1 0.1", "MALFORMED_TAG", 7, 19, 'Write size="1 1 0.1".', None),
    "no first quotation mark": ('xyz="0 0 0.05"', 'xyz=0 0 0.05"',
     "MALFORMED_TAG", 5, 19, 'Write xyz="0 0 0.05".', None),
    "no second quotation mark": ('xyz="0 0 0.05"', 'xyz="0 0 0.05',
     "MALFORMED_TAG", 5, 19, 'Write xyz="0 0 0.05".', None),
    "no second one before />": ('size="1 1 0.1"', 'size="1 1 0.1',
     "MALFORMED_TAG", 7, 19, 'Write size="1 1 0.1".', None),
    "no second one before >": ('<robot name="arm"', '<robot name="arm',
     "MALFORMED_TAG", 2, 13, 'Write name="arm".', None),
    "two kinds of quotation marks": ('name="base"', "name=\"base'", "MALFORMED_TAG", 3, 14, 'Write name="base".', None),
    "quotation marks of a word processor": ('name="base"', "name=“base”",
     "MALFORMED_TAG", 3, 14, 'Write name="base".', None),
    "quotation mark twice behind": ('value="1"', 'value="1""', "MALFORMED_TAG", 11, 22, "Delete it", None),
    "no space between attributes": ('"1" iyy', '"1"iyy', "LOOSE_ATTRIBUTE", 12, 23, "space before iyy", None),
    "comma between attributes": ('"1" iyy', '"1", iyy', "MALFORMED_TAG", 12, 23, "Delete the comma.", None),
    "no-break space": ("<mass value", "<mass\u00a0value", "MALFORMED_TAG", 11, 12, "type a space", None),
    "no =": ('value="1"', 'value "1"', "MALFORMED_TAG", 11, 13, 'Write value="1".', None),
    "colon for =": ('value="1"', 'value: "1"', "MALFORMED_TAG", 11, 13, 'Write value="1".', None),
    "two =": ('value="1"', 'value=="1"', "MALFORMED_TAG", 11, 13, 'Write value="1".', None),
    "comment without end": ("    <visual>", "    <!-- looks\n    <visual>",
     "UNCLOSED_SECTION", 4, 5, "Write -->", None),
    "comment with half an end": ("    <visual>", "    <!-- looks ->\n    <visual>",
     "UNCLOSED_SECTION", 4, 5, "Write -->", None),
    "comment with half a beginning": ("    <visual>", "    <!- looks -->\n    <visual>",
     "MARKUP", 4, 5, "<!-- ... -->", None),
    "hyphens in a comment": ("    <visual>", "    <!-- a -- b -->\n    <visual>",
     "BAD_CHARACTER", 4, 12, "one hyphen", None),
    "declaration without ?": ('"1.0"?>', '"1.0">', "MARKUP", 1, 1, '<?xml version="1.0"?>', None),
    "declaration without quotation marks": ('"1.0"?>', "1.0?>", "MARKUP", 1, 1, '<?xml version="1.0"?>', None),
    "declaration without first ?": ("<?xml", "<xml", "MALFORMED_TAG", 1, 1, '<?xml version="1.0"?>', None),
    "comment before the declaration": ("<?xml", "<!-- mine -->\n<?xml",
     "DECLARATION", 2, 1, "line 1, column 1", (1, 1)),
    "blank line before the declaration": ("<?xml", "\n<?xml",
     "DECLARATION", 2, 1, "Delete the white space before it: 1 line.", None),
    "space before the declaration": ("<?xml", "  <?xml",
     "DECLARATION", 1, 3, "Delete the white space before it: 2 letters.", None),
    "declaration twice": ("<robot", '<?xml version="1.0"?>\n<robot', "DECLARATION", 2, 1, "line 1, column 1", (1, 1)),
    "fence of a text before": ("<?xml", "```xml\n<?xml", "STRAY_TEXT", 1, 1, "Delete it", None),
    "fence of a text behind": ("</robot>", "</robot>\n```", "STRAY_TEXT", 21, 1, "Delete it", None),
    "second root": ("</robot>\n", '</robot>\n<robot name="b"/>\n', "SECOND_ROOT", 21, 2, "</robot>", (2, 2)),
}  # fmt: skip


@pytest.mark.parametrize("name", SLIPS)
def test_a_slip_is_one_fault_and_leaves_the_tree_as_it_was_meant(name):
    before, after, kind, line, column, remedy, other = SLIPS[name]
    document = read(slip(before, after))
    assert [one.kind.name for one in document.faults] == [kind], document.faults
    fault = document.faults[0]
    assert (fault.span.line, fault.span.column) == (line, column)
    assert remedy in fault.remedy
    second = fault.other and (fault.other.line, fault.other.column)
    assert second == other
    if name != "start tag without <":
        assert sketch(document.root) == sketch(read(ROBOT).root)


# mistakes after which something is missing
LOSSES = {
    "quotation mark twice before": ('value="1"', 'value=""1"', "MALFORMED_TAG", 11, 21, "Delete it", None),
    "quotation marks twice": ('value="1"', 'value=""1""', "MALFORMED_TAG", 11, 21, "Delete it", None),
    "attribute twice": ('ixx="1" iyy="2"', 'ixx="1" ixx="2"', "DUPLICATE_ATTRIBUTE", 12, 24, "Delete one", (12, 16)),
    "start tag misspelt": ("<visual>", "<visul>", "MISMATCHED_TAG", 9, 5, "<visual> in line 4", (4, 6)),
    "start tag missing": ("    <visual>\n", "", "STRAY_END", 8, 5, "write <visual>", None),
    "name of a tag missing": ("<mass value", "< value", "MARKUP", 11, 7, "the name of the element", None),
    "tag without anything": ('<mass value="1"/>', "<>", "MARKUP", 11, 7, "the name of the element", None),
    "attribute without a value": ('value="1"', "value", "MALFORMED_TAG", 11, 13, 'value="..."', None),
    "attribute with = alone": ('value="1"', "value=", "MALFORMED_TAG", 11, 13, 'value="..."', None),
    "< in a value": ('"base"', '"a<b"', "BAD_CHARACTER", 3, 16, "&lt;", None),
    "& in a value": ('"base"', '"a&b"', "BAD_CHARACTER", 3, 16, "&amp;", None),
    "entity without semicolon": ('"base"', '"a &amp b"', "BAD_CHARACTER", 3, 17, "&amp;", None),
    "entity of HTML": ('"base"', '"h&oslash;jre"', "ENTITY", 3, 16, "ø", None),
    "entity of nothing": ('"base"', '"a&nix;b"', "ENTITY", 3, 16, "&amp;nix;", None),
    "number of no letter": ('"base"', '"&#0;"', "BAD_CHARACTER", 3, 15, "Unicode", None),
    "number with a capital x": ('"base"', '"&#X41;"', "BAD_REFERENCE", 3, 15, "&#x41;", None),
    "control character": ('"base"', '"b\x07e"', "BAD_CHARACTER", 3, 16, "Delete it", None),
    "end of a section in a text": ("<visual>", "<visual>]]>", "BAD_CHARACTER", 4, 13, "]]&gt;", None),
    "section without end": ("<visual>", "<visual><![CDATA[", "UNCLOSED_SECTION", 4, 13, "]]>", None),
    "instruction without end": ("<visual>", "<visual><?pi >", "UNCLOSED_SECTION", 4, 13, "?>", None),
    "comment in a comment": ("<visual>", "<!-- <visual> <!-- -->", "BAD_CHARACTER", 4, 19, "Delete this <!--", (4, 5)),
    "definitions": ("<robot", '<!DOCTYPE robot [<!ENTITY a "b">]>\n<robot', "ENTITY", 2, 1, "Delete", None),
    "document type inside": ("<visual>", "<visual><!DOCTYPE robot>", "MARKUP", 4, 13, "Delete it", None),
}  # fmt: skip


@pytest.mark.parametrize("name", LOSSES)
def test_a_mistake_is_one_fault_at_its_place(name):
    before, after, kind, line, column, remedy, other = LOSSES[name]
    text = slip(before, after)
    if name == "comment in a comment":
        text = text.replace("</visual>", "</visual> -->")
    document = read(text)
    assert [one.kind.name for one in document.faults] == [kind], document.faults
    fault = document.faults[0]
    assert (fault.span.line, fault.span.column) == (line, column)
    assert remedy in fault.remedy
    second = fault.other and (fault.other.line, fault.other.column)
    assert second == other
    assert [one.get("name") for one in document.root.children] == [
        "base" if before != '"base"' else document.root.children[0].get("name"),
        "arm",
        "hip",
    ]


def test_the_rare_name_is_the_misspelt_one():
    text = "<r>\n<visul>\n</visual>\n<visual/>\n</r>"
    (fault,) = read(text).faults
    assert (fault.span, fault.remedy) == (Span(2, 2, 5), "Write <visual> here.")
    assert fault.other == Span(3, 1, 9)


def test_several_faults_are_all_found_in_the_order_of_the_text():
    text = (
        ROBOT.replace('xyz="0', "xyz=0")
        .replace('<mass value="1"/>', '<mass value="1">')
        .replace("  </joint>", "  </join>")
        .replace('<link name="arm"/>', '<link name="arm" name="b"/>')
    )
    assert [(one.span.line, one.kind.name) for one in read(text).faults] == [
        (5, "MALFORMED_TAG"),
        (11, "UNCLOSED"),
        (15, "DUPLICATE_ATTRIBUTE"),
        (19, "MISMATCHED_TAG"),
    ]


def test_a_file_that_is_cut_off_has_one_fault_wherever_it_is_cut():
    for end in range(len(ROBOT) - 2):
        text = ROBOT[:end]
        assert len(read(text).faults) == 1, text


def test_all_that_is_open_at_the_end_of_a_file_is_named():
    (fault,) = read("<robot>\n  <link>\n    <visual>").faults
    assert fault.what == "the file ends, and <visual>, <link>, <robot> are not closed"
    assert fault.remedy == "Write </visual></link></robot> at the end of the file."
    assert fault.span == Span(3, 6, 6)


def test_a_bracket_that_ends_a_tag_too_early():
    text = '<launch>\n<rosparam file="a.yaml">\n  command="load"/>\n</launch>'
    (fault,) = read(text).faults
    assert (fault.span, fault.remedy) == (Span(2, 24, 1), "Delete this >.")


def test_the_end_of_the_root_too_early():
    (fault,) = read(slip('  <link name="arm"/>', '</robot>\n  <link name="arm"/>')).faults
    assert (fault.kind, fault.span) == (FaultKind.SECOND_ROOT, Span(16, 4, 4))
    assert fault.remedy == "Move it before </robot>: a file has one root."


def test_a_missing_quotation_mark_does_not_reach_to_the_end_of_the_file():
    lines = [f'<link name="l{number}"/>' for number in range(50)]
    lines[20] = '<link name="l20/>'
    document = read("<robot>\n" + "\n".join(lines) + "\n</robot>")
    assert [one.span for one in document.faults] == [Span(22, 12, 4)]
    assert document.root is not None
    assert [one.get("name") for one in document.root.children] == [f"l{n}" for n in range(50)]


def test_without_indentation_only_the_end_tags_count():
    (fault,) = read("<r>\n<link>\n<visual>\n<a/>\n</link>\n</r>").faults
    assert fault.remedy == "Write </visual> before </link> in line 5."


def test_nothing_at_all():
    for text in ("", " \n\t", "<!-- only this -->", b"", "\ufeff"):
        assert [one.kind for one in read(text).faults] == [FaultKind.EMPTY]
        assert read(text).root is None


@pytest.mark.parametrize(
    "text",
    [
        "print('hello')",
        "if a < b:\n    print('x & y')\n",
        "arm_controller:\n  joints: [hip]\n",
        "404: Not Found",
        "PK\x03\x04\x14 & <",
    ],
)
def test_text_without_a_tag_is_one_fault(text):
    (fault,) = read(text).faults
    assert fault.kind is FaultKind.EMPTY
    assert fault.what == "this is no XML: there is no tag in it"


def test_a_faulty_declaration_that_swallows_the_file_is_the_fault_not_what_is_missing_behind_it():
    (fault,) = read('<?xml version="1.0"\n').faults
    assert fault.kind is not FaultKind.EMPTY


def test_a_conflict_that_git_has_left_is_one_fault():
    text = '<robot name="r">\n<<<<<<< HEAD\n  <link name="a"/>\n=======\n  <link name="b"/>\n>>>>>>> x\n</robot>'
    (fault,) = read(text).faults
    assert (fault.kind, fault.span) == (FaultKind.CONFLICT, Span(2, 1, 12))
    assert "<<<<<<<, ======= and >>>>>>>" in fault.remedy


@pytest.mark.parametrize("line", range(2, 18))
def test_a_line_that_stands_there_twice_is_one_fault_if_it_opens_or_closes(line):
    lines = ROBOT.split("\n")
    document = read("\n".join(lines[: line + 1] + lines[line:]))
    kinds = [one.kind for one in document.faults]
    assert kinds in ([], [FaultKind.STRAY_END], [FaultKind.DOUBLED_TAG])
    if kinds:
        assert document.faults[0].span.line == line + 2
        assert sketch(document.root) == sketch(read(ROBOT).root)


def test_nothing_in_a_message_moves_a_terminal():
    texts = (
        "<a \x1b[2J/>",
        "<\x1b>",
        "<a>\u202e&\u202e;</a>",
        "<a></\x1b[31mb></a>",
        "<a b='\x1b' b='\x1b'/>",
    )
    for text in texts:
        for fault in read(text).faults:
            assert fault.what.isprintable()
            assert fault.remedy.isprintable()
