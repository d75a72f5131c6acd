"""Rows of the table of diagnostics, and finds with their words."""

from __future__ import annotations

from simkit.diagnostics import Find, Related, Rule, Severity, rule
from simkit.diagnostics.table import in_table_order, rules_in
from simkit.xml import Span, parse_xml

TEXT = """\
<robot name="r">
<link name="a">
  <visual name="v"/>
</link>
</robot>
"""
DOCUMENT = parse_xml(TEXT, file="urdf/r.urdf")


@rule(
    "URDF-W98", "a visual", Severity.WARNING, remedy="Take it out.", here="Drawn.", gazebo="Drawn."
)
def visual(document):
    """A visual.

    It is there.
    """
    assert document.root is not None
    for link in document.root.children:
        yield from (Find(one, what=f"a visual in {link.get('name')}") for one in link.children)


def element():
    (found,) = visual.look(DOCUMENT)
    return found.at


def test_a_generator_becomes_a_row():
    assert (visual.id, visual.title, visual.severity) == ("URDF-W98", "a visual", Severity.WARNING)
    assert visual.explanation == "A visual.\n\nIt is there."


def test_a_find_has_the_words_of_its_row_its_place_path_and_line():
    (find,) = visual.look(DOCUMENT)
    one = visual.diagnostic(find, DOCUMENT)
    assert (one.rule, one.severity, one.what) == ("URDF-W98", Severity.WARNING, "a visual in a")
    assert (one.remedy, one.here, one.gazebo) == ("Take it out.", "Drawn.", "Drawn.")
    assert (one.file, one.span) == ("urdf/r.urdf", Span(3, 4, 6))
    assert (one.path, one.source) == ("robot/link[a]/visual[v]", '  <visual name="v"/>')


def test_words_of_its_own_come_first():
    name = element().attribute("name")
    find = Find(name, element=element(), what="w", remedy="r", here="h", severity=Severity.NOTE)
    one = visual.diagnostic(find, DOCUMENT)
    assert (one.span, one.path) == (Span(3, 17, 1), "robot/link[a]/visual[v]")
    assert (one.remedy, one.here, one.gazebo) == ("r", "h", "Drawn.")
    assert one.severity is Severity.NOTE


def test_a_second_place_is_in_the_same_file_if_no_other_is_said():
    other = Related(file="x.launch", span=Span(1, 1), text="there")
    find = Find(Span(1, 1), what="w", related=[(element(), "here"), other])
    first, second = visual.diagnostic(find, DOCUMENT).related
    assert (first.file, first.span, first.source) == (
        "urdf/r.urdf",
        Span(3, 4, 6),
        '  <visual name="v"/>',
    )
    assert second is other


def test_a_find_may_be_in_a_file_beside():
    beside = parse_xml("<launch/>", file="r.launch")
    find = Find(beside.root, what="w", companion=beside)
    one = visual.diagnostic(find, DOCUMENT)
    assert (one.file, one.source) == ("r.launch", "<launch/>")


def test_rows_stand_by_group_and_number():
    names = ["GZ-W01", "URDF-W10", "SDF-E01", "URDF-E02"]
    rows = [Rule(name, "x", Severity.NOTE, "") for name in names]
    assert [one.id for one in in_table_order(rows)] == ["URDF-E02", "URDF-W10", "GZ-W01", "SDF-E01"]


def test_a_module_declares_its_rows_by_having_them():
    class Module:
        row = visual
        other = "URDF-W99"

    assert rules_in(Module) == (visual,)
