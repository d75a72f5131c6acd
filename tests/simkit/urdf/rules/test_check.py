"""All rules over a file: order, floods, faults of our own, and any bytes at all."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from simkit.diagnostics import Rule, Severity
from simkit.urdf.rules import check, check_robot
from simkit.urdf.rules.sheet import MOST_FINDS
from simkit.xml import parse_xml

FAULTS = Path(__file__).parents[1] / "faults"
ROBOTS = [path.read_text("utf-8") for path in sorted(FAULTS.rglob("*.urdf"))]
PIECES = [
    *('"', "'", "<", ">", "/", "</", "/>", "<!--", "-->", "&", "=", " ", "\n", "\t", "\0", "é"),
    *("<link>", "</link>", '<link name="a"/>', '<joint name="j" type="fixed">', "</joint>"),
    *("nan", "1e999", "-1", "0", "${x}", "xacro:if", "<robot>", "</robot>", "<gazebo>", ","),
    *('<parent link="a"/>', '<child link="a"/>', "<origin/>", '<mimic joint="j"/>', "<geometry>"),
]


def finds(text: str | bytes):
    return check_robot(parse_xml(text, file="r.urdf"))


def robot(*parts: str) -> str:
    return '<robot name="r">\n' + "\n".join(parts) + "\n</robot>\n"


def test_finds_are_in_the_order_of_the_file():
    many = (FAULTS / "many_faults.urdf").read_bytes()
    found = finds(many)
    assert [one.span for one in found] == sorted(one.span for one in found)
    assert found == finds(many)


def test_a_flood_is_cut_off_and_counted():
    parts = [f'<link name="a{number}"><pose/></link>' for number in range(50)]
    parts += [
        f'<joint name="j{number}" type="fixed"><parent link="a{number}"/>'
        f'<child link="a{number + 1}"/></joint>'
        for number in range(49)
    ]
    told = [one for one in finds(robot(*parts)) if one.rule == "URDF-W17"]
    assert len(told) == MOST_FINDS
    assert told[-1].what.endswith("; and 30 more like it")
    assert all("more like it" not in one.what for one in told[:-1])


def test_another_fault_is_not_lost_in_a_flood():
    parts = [f'<link name="a{number}"><pose/></link>' for number in range(50)]
    parts.append('<link name="b"><visual/></link>')
    assert "URDF-E26" in {one.rule for one in finds(robot(*parts))}


def test_a_rule_that_breaks_does_not_silence_the_others(monkeypatch):
    def broken(_sheet):
        raise ZeroDivisionError("oh")

    rule = Rule("URDF-E99", "x", Severity.ERROR, "", look=broken)
    asked = check.rules_for
    monkeypatch.setattr(check, "rules_for", lambda sheet: (rule, *asked(sheet)))
    found = finds(robot('<link name="a"><visual/></link>'))
    assert {"URDF-E99", "URDF-E26"} <= {one.rule for one in found}
    (ours,) = [one for one in found if one.rule == "URDF-E99"]
    assert ours.severity is Severity.NOTE
    assert "fault of simkit" in ours.remedy


@pytest.mark.parametrize(
    "part",
    [
        '<link name="a"/>',
        '<link name="a{n}"/>',
        '<joint name="j{n}" type="fixed"><parent link="x{n}"/><child link="y{n}"/></joint>',
        '<joint name="j{n}" type="fixed"><parent link="a{n}"/><child link="a{n}"/></joint>',
        '<joint name="j" type="revolut"><parent link="a"/><child link="a{n}"/></joint>',
        '<link name="a{n}"><visual><geometry><box size="1,1"/></geometry>'
        '<material name="m{n}"/></visual></link>',
        '<joint name="j{n}" type="continuous"><mimic joint="k{n}"/></joint>',
        "<wobble a='1' b='2'/>",
        "<link",
        '<gazebo reference="a{n}"><plugin name="p{n}" filename="x{n}.so"/></gazebo>',
    ],
)
def test_a_large_file_of_one_fault_takes_no_time(part):
    # Were any of it worse than quadratic, this would take minutes.
    text = robot(*(part.format(n=number) for number in range(1000)))
    assert len(finds(text)) < 20 * MOST_FINDS


def test_many_attributes_and_many_materials_take_no_time():
    # Comparing each with each, as these rules once did, would take hours.
    attributes = " ".join(f'a{number}=""' for number in range(20_000))
    assert len(finds(robot(f'<link name="a" {attributes}/>'))) < 2 * MOST_FINDS
    visual = '<visual><geometry><box size="1 1 1"/></geometry><material name="m{n}"/></visual>'
    visuals = "".join(visual.format(n=number) for number in range(4000))
    told = [
        one for one in finds(robot(f'<link name="a">{visuals}</link>')) if one.rule == "URDF-W22"
    ]
    assert told[-1].what.endswith("and 3980 more like it")


def test_a_long_chain_and_deep_nesting_are_no_trouble():
    links = [f'<link name="a{number}"/>' for number in range(1500)]
    joints = [
        f'<joint name="j{number}" type="fixed"><parent link="a{number}"/>'
        f'<child link="a{(number + 1) % 1500}"/></joint>'
        for number in range(1500)
    ]
    found = finds(robot(*links, *joints))
    assert [one.rule for one in found if one.severity is Severity.ERROR] == ["URDF-E04"]
    finds("<robot name='r'>" + "<link name='a'>" * 5000)
    finds(robot('<link name="' + "n" * 200_000 + '"/>'))


def mutated(rng: random.Random) -> bytes:
    """A robot with a few pieces lost, doubled, or put in."""
    text = rng.choice(ROBOTS)
    for _ in range(rng.randint(1, 6)):
        at, to = sorted(rng.randrange(len(text) + 1) for _ in range(2))
        to = min(to, at + rng.randint(0, 60))
        match rng.randrange(4):
            case 0:
                text = text[:at] + text[to:]
            case 1:
                text = text[:to] + text[at:to] + text[to:]
            case 2:
                text = text[:at] + rng.choice(PIECES) + text[at:]
            case _:
                text = text[:at] + rng.choice(PIECES) + text[to:]
    return text.encode("utf-8")


def look_at_mutated_robots(seed: int, count: int) -> None:
    rng = random.Random(seed)
    for number in range(count):
        data = mutated(rng)
        for one in finds(data):
            assert "could not be applied" not in one.what, (seed, number, one.what, data)
            assert one.span.line >= 1
            assert one.span.column >= 1
            assert one.what
            assert one.remedy.endswith((".", "?", "!")), one


def test_mutated_robots_break_nothing():
    look_at_mutated_robots(seed=1, count=150)


@pytest.mark.slow
def test_many_mutated_robots_break_nothing():
    look_at_mutated_robots(seed=2, count=1500)


@pytest.mark.parametrize(
    "data", [b"", b"\0\1\2", b"\xff\xfe<\0", b"hello", b"<", b"<a/>", "é".encode()]
)
def test_bytes_that_are_no_robot_break_nothing(data):
    assert finds(data) != ()
