"""Loops of joints, and links with two parents."""

from __future__ import annotations

from simkit.urdf.rules.sheet import Sheet, read_sheet
from simkit.urdf.rules.tree_facts import loops, two_parents
from simkit.xml import parse_xml


def sheet(*edges: str) -> Sheet:
    """A robot of edges such as `ab`: link b hangs on link a."""
    links = "".join(f'<link name="{name}"/>' for name in sorted(set("".join(edges))))
    joints = "".join(
        f'<joint name="{edge}{number}" type="fixed"><parent link="{edge[0]}"/><child link="{edge[1]}"/></joint>'
        for number, edge in enumerate(edges)
    )
    return read_sheet(parse_xml(f'<robot name="r">{links}{joints}</robot>', file="r.urdf"))


def test_a_tree_has_none():
    found = sheet("ab", "ac", "cd")
    assert loops(found) == []
    assert list(two_parents(found)) == []


def test_a_ring_is_closed_by_its_last_joint():
    (loop,) = loops(sheet("ab", "bc", "ca"))
    assert loop.links == ("a", "b", "c")
    assert loop.joints[-1].name == "ca2"
    assert not loop.is_entered


def test_a_ring_with_a_way_in_is_closed_where_it_is_entered():
    (loop,) = loops(sheet("bc", "cb", "ab"))
    assert loop.links == ("b", "c")
    assert loop.joints[-1].name == "cb1"
    assert loop.is_entered


def test_a_link_on_itself():
    (loop,) = loops(sheet("ab", "bb"))
    assert loop.links == ("b",)


def test_two_rings_are_two():
    assert [loop.links for loop in loops(sheet("ab", "ba", "cd", "dc"))] == [("a", "b"), ("c", "d")]


def test_two_ways_round_are_one_find():
    (loop,) = loops(sheet("ab", "bc", "ca", "bd", "da"))
    assert len(loop.joints) == 3


def test_two_parents_are_the_first_and_the_later_ones():
    found = [(joint.name, before.name) for joint, before in two_parents(sheet("ac", "bc", "dc"))]
    assert found == [("bc1", "ac0"), ("dc2", "ac0")]


def test_the_way_into_a_ring_is_no_second_parent():
    assert list(two_parents(sheet("bc", "cb", "ab"))) == []
