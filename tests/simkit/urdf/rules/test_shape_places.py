"""What is seen, what is touched, and where the mass is."""

from __future__ import annotations

import pytest

from simkit.diagnostics import Severity

MASS = (
    '<inertial><origin xyz="{}"/><mass value="1"/>'
    '<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>'
)
BOX = '<geometry><box size="0.4 0.2 0.1"/></geometry>'
BALL = '<geometry><sphere radius="0.05"/></geometry>'
POLE = '<geometry><cylinder radius="0.05" length="0.4"/></geometry>'


def seen(shape, xyz="0 0 0", rpy="0 0 0"):
    return f'<visual><origin xyz="{xyz}" rpy="{rpy}"/>{shape}</visual>'


def touched(shape, xyz="0 0 0", rpy="0 0 0"):
    return f'<collision><origin xyz="{xyz}" rpy="{rpy}"/>{shape}</collision>'


def link(*parts, name="body"):
    return "\n".join([f'<link name="{name}">', *parts, "</link>"])


@pytest.mark.parametrize(
    ("xyz", "words"),
    [
        ("0 0 0.115", "0.065 m above"),
        ("0 0 -0.115", "0.065 m below"),
        ("0.3 0 0", "0.1 m in front of"),
        ("-0.3 0 0", "0.1 m behind"),
        ("0 0.2 0", "0.1 m to the left of"),
        ("0 -0.2 0", "0.1 m to the right of"),
    ],
)
def test_a_centre_of_mass_outside_of_its_link(told, xyz, words):
    (one,) = told(link(MASS.format(xyz), touched(BOX)), "URDF-I14")
    assert (one.severity, one.span.line) == (Severity.NOTE, 3)
    assert words in one.what
    assert '<origin xyz="0 0 0"/>' in one.remedy


@pytest.mark.parametrize("xyz", ["0 0 0", "0.2 0.1 0.05", "0.2 0 0.055"])
def test_a_centre_of_mass_in_its_link_or_at_its_skin(told, xyz):
    assert told(link(MASS.format(xyz), touched(BOX)), "URDF-I14") == []


def test_between_its_parts_a_centre_of_mass_is_in_the_link(told):
    pair = touched(BALL, "0 0.3 0") + touched(BALL, "0 -0.3 0")
    assert told(link(MASS.format("0 0 0"), pair), "URDF-I14") == []


def test_a_link_that_is_only_painted(told):
    body = link(MASS.format("0 0 0"), touched(BOX), seen(BOX))
    arm = link(MASS.format("0 0 0"), seen(POLE, "0 0 0.2"), name="arm")
    joint = '<joint name="j" type="{}"><parent link="body"/><child link="arm"/></joint>'
    (one,) = told(body + "\n" + arm + joint.format("continuous"), "URDF-W15")
    assert (one.severity, one.span.line) == (Severity.WARNING, 9)
    element = one.remedy[one.remedy.index("<collision>") : one.remedy.index("</collision>") + 12]
    mended = body + arm.replace("</link>", element + "</link>") + joint.format("continuous")
    assert told(mended, "URDF-W15") == []
    assert told(mended, "URDF-I16") == []
    (one,) = told(body + arm + joint.format("fixed"), "URDF-W15")
    assert one.severity is Severity.NOTE


def test_if_nothing_can_be_touched_one_note_says_so(told):
    text = link(MASS.format("0 0 0"), seen(BOX)) + link(MASS.format("0 0 0"), seen(BOX), name="arm")
    (one,) = told(text, "URDF-W15")
    assert one.severity is Severity.NOTE
    assert "'body', 'arm' have masses and visuals" in one.what
    assert told(link(seen(BOX)), "URDF-W15") == []


@pytest.mark.parametrize(
    ("shape", "visual", "collision", "distance"),
    [
        (BALL, ("0.2 0 0",), ("0.35 0 0",), "0.15 m off"),
        (POLE, ("0 0 0.2",), ("0 0 0",), "0.2 m off"),
        (POLE, ("0 0 0", "1.570796 0 0"), ("0 0 0",), "0.15 m off"),
    ],
    ids=["elsewhere", "forgotten origin", "forgotten rpy"],
)
def test_seen_here_and_touched_there(told, shape, visual, collision, distance):
    (one,) = told(link(seen(shape, *visual), touched(shape, *collision)), "URDF-I16")
    assert (one.severity, one.span.line) == (Severity.NOTE, 4)
    assert distance in one.what
    assert f'<origin xyz="{visual[0]}"' in one.remedy
    assert one.related[0].span.line == 3


@pytest.mark.parametrize(
    "parts",
    [
        [seen(POLE, "0 0 0.2"), touched(POLE, "0 0 0.2")],
        [seen(POLE, rpy="1.570796 0 0"), touched(POLE, rpy="-1.570796 0 0")],
        [seen(POLE, "0 0 0.2"), touched(BOX, "0 0 0.21")],
        [
            seen(BALL, "0 0.3 0"),
            seen(BALL, "0 -0.3 0"),
            touched(BALL, "0 -0.3 0"),
            touched(BALL, "0 0.3 0"),
        ],
        [seen('<geometry><mesh filename="package://p/m.stl"/></geometry>'), touched(BOX, "1 0 0")],
        [seen(BALL), seen(BOX, "1 0 0"), touched(BOX, "1 0 0")],
    ],
    ids=[
        "the same",
        "turned about its axis",
        "roughly",
        "in another order",
        "a mesh",
        "less is touched",
    ],
)
def test_places_that_fit(told, parts):
    assert told(link(*parts), "URDF-I16") == []


def test_of_several_equal_shapes_only_the_one_that_is_off_is_told(told):
    parts = [
        seen(BALL, "0 0.3 0"),
        seen(BALL, "0 -0.3 0"),
        touched(BALL, "0 0.3 0"),
        touched(BALL, "0 -0.6 0"),
    ]
    (one,) = told(link(*parts), "URDF-I16")
    assert one.span.line == 6


def test_many_shapes_in_one_link_take_no_time(told):
    told(link(*[touched(BALL, f"0 0 {number}") + seen(BALL) for number in range(300)]), "URDF-I16")
