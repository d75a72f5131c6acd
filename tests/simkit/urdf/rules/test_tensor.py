"""Inertias that are impossible, zero or copied, and those that do not fit their shape."""

from __future__ import annotations

import math

import pytest

from simkit.diagnostics import Severity

WHEEL = '<geometry><cylinder radius="0.1" length="0.04"/></geometry>'
RIGHT = (0.000526667, 0.000526667, 0.001)


def inertia(ixx, iyy, izz, ixy=0.0):
    return f'<inertia ixx="{ixx}" ixy="{ixy}" ixz="0" iyy="{iyy}" iyz="0" izz="{izz}"/>'


def wheel(tensor, *, mass=0.2, rpy="0 0 0", shape=WHEEL, at="0 0 0", visual=""):
    """A robot whose second link is a wheel, written on line 3, its `<inertia>` on line 4."""
    return f"""<link name="base"><inertial><mass value="1"/>{inertia(0.1, 0.1, 0.1)}</inertial></link>
<link name="wheel"><inertial><mass value="{mass}"/><origin rpy="{rpy}"/>
{tensor}</inertial>{visual}<collision><origin rpy="{at}"/>{shape}</collision></link>
<joint name="axle" type="continuous"><parent link="base"/><child link="wheel"/></joint>"""


RULES = ("URDF-W11", "URDF-W12", "URDF-W13", "URDF-W41", "URDF-W42", "URDF-W43", "URDF-W47")


def of_tensors(found):
    return [one for one in found if one.rule in RULES]


@pytest.mark.parametrize(
    "text",
    [
        wheel(inertia(*RIGHT)),
        wheel(inertia(0.00053, 0.00053, 0.001)),
        wheel(inertia(*RIGHT), rpy="1.5708 0 0", at="1.5708 0 0"),
        wheel(inertia(0.000526667, 0.001, 0.000526667), at="1.5708 0 0"),
        wheel(inertia(0.0008, 0.0007, 0.0013)),
        wheel(inertia(1e-3, 1e-3, 2e-3 * 1.009)),
    ],
    ids=[
        "formula",
        "rounded",
        "turned with its shape",
        "about y",
        "not evenly filled",
        "almost flat",
    ],
)
def test_inertias_that_may_be_so(told, text):
    assert of_tensors(told(text)) == []


@pytest.mark.parametrize(
    ("rule", "tensor", "words"),
    [
        (
            "URDF-W11",
            inertia(0.0005, 0.0005, 0.01),
            "0.01 is more than the other two together, 0.0005 + 0.0005",
        ),
        (
            "URDF-W11",
            inertia(-0.0005, 0.0005, 0.001),
            "a principal moment is -0.0005, and must be more than 0",
        ),
        (
            "URDF-W11",
            inertia(0.0005, 0.0005, 0.001, ixy=0.0009),
            "without ixy, ixz and iyz it would be possible",
        ),
        ("URDF-W41", inertia(0, 0, 0), "0.2 kg and an inertia of zero"),
        ("URDF-W42", inertia(1, 1, 1), "not of 0.2 kg that reaches 0.102 m"),
        (
            "URDF-W13",
            inertia(0.0527, 0.0527, 0.1),
            "0.7071 m from the centre, and the link reaches 0.102 m; it fits a mass of 20",
        ),
        ("URDF-W43", inertia(0.00000527, 0.00000527, 0.00001), "100 times smaller"),
        (
            "URDF-W47",
            inertia(0.000526667, 0.000526667, 0.0008),
            "cylinder of radius 0.1 and length 0.04 m, but for izz: 0.0008 instead of 0.001",
        ),
    ],
)
def test_inertias_that_are_told_once_with_the_values_of_the_shape(told, rule, tensor, words):
    (one,) = of_tensors(told(wheel(tensor)))
    assert (one.rule, one.severity, one.span.line) == (rule, Severity.WARNING, 4)
    assert words in one.what
    assert 'ixx="0.0005267"' in one.remedy
    assert 'izz="0.001"' in one.remedy
    mended = one.remedy[one.remedy.index("<inertia ") : one.remedy.index("/>") + 2]
    assert of_tensors(told(wheel(mended))) == []


def test_a_factor_of_three_is_a_note_and_of_ten_a_warning(told):
    assert of_tensors(told(wheel(inertia(*(value / 2.9 for value in RIGHT))))) == []
    (note,) = of_tensors(told(wheel(inertia(*(value / 5 for value in RIGHT)))))
    assert (note.rule, note.severity) == ("URDF-W43", Severity.NOTE)
    (warning,) = of_tensors(told(wheel(inertia(*(value / 11 for value in RIGHT)))))
    assert warning.severity is Severity.WARNING
    assert "it fits a mass of 0.01818 kg" in warning.what


def test_units_are_recognised(told):
    (one,) = told(wheel(inertia(*(value * 1e4 for value in RIGHT))), "URDF-W13")
    assert "as if it were written in kg cm²" in one.what


def test_where_a_mesh_is_seen_a_rough_collision_shape_proves_little(told):
    mesh = '<visual><geometry><mesh filename="package://p/wheel.stl"/></geometry></visual>'
    (one,) = of_tensors(told(wheel(inertia(*(value * 20 for value in RIGHT)), visual=mesh)))
    assert (one.rule, one.severity) == ("URDF-W43", Severity.NOTE)
    assert of_tensors(told(wheel(inertia(*(value * 5 for value in RIGHT)), visual=mesh))) == []


def test_a_wheel_whose_inertia_was_not_turned_with_its_shape(told):
    (one,) = of_tensors(told(wheel(inertia(*RIGHT), at="1.570796 0 0")))
    assert (one.rule, one.severity, one.span.line) == ("URDF-W12", Severity.WARNING, 4)
    assert 'rpy="1.570796 0 0"' in one.remedy
    assert of_tensors(told(wheel(inertia(*RIGHT), rpy="1.570796 0 0", at="1.570796 0 0"))) == []
    assert 'iyy="0.001"' in one.remedy
    assert of_tensors(told(wheel(inertia(RIGHT[0], RIGHT[2], RIGHT[0]), at="1.570796 0 0"))) == []


def test_a_wheel_whose_inertia_was_turned_and_its_shape_was_not(told):
    (one,) = of_tensors(told(wheel(inertia(*RIGHT), rpy="1.570796 0 0")))
    assert one.rule == "URDF-W12"
    assert of_tensors(told(wheel(inertia(*RIGHT), rpy="0 0 1.570796"))) == []


def test_the_mass_was_changed_and_the_inertia_was_not(told):
    """A wheel of a learner: 10 g, 43 mm radius, with the inertia of a wheel of 0.1 kg and 10 cm."""
    shape = '<geometry><cylinder radius="0.043" length="0.02"/></geometry>'
    (one,) = of_tensors(told(wheel(inertia(0.00025, 0.00025, 0.00045), mass=0.01, shape=shape)))
    assert one.rule == "URDF-W13"
    assert "0.2121 m from the centre, and the link reaches 0.04415 m" in one.what


def test_what_cannot_turn_is_only_worth_a_note(told):
    fixed = wheel(inertia(0.0527, 0.0527, 0.1)).replace("continuous", "fixed")
    heavy = fixed.replace('"base"', '"world"').replace('<mass value="1"/>', '<mass value="1"/>')
    for text in (fixed.replace('<mass value="1"/>', '<mass value="9"/>'), heavy):
        (one,) = told(text, "URDF-W13")
        assert one.severity is Severity.NOTE
    (one,) = told(fixed, "URDF-W13")  # a fifth of the body it is a part of
    assert one.severity is Severity.WARNING


def test_a_link_of_one_body_with_another_may_have_no_inertia(told):
    (one,) = told(wheel(inertia(0, 0, 0)).replace("continuous", "fixed"), "URDF-W41")
    assert one.severity is Severity.NOTE


def test_a_box_with_a_copied_number(told):
    box = '<geometry><box size="0.5 0.3 0.07"/></geometry>'
    text = wheel(inertia(0.0395416667, 0.106208333, 0.106208333), mass=5, shape=box)
    (one,) = of_tensors(told(text))
    assert one.rule == "URDF-W47"
    assert one.source[one.span.column - 1 :].startswith("0.106208333")
    assert one.source[: one.span.column - 1].endswith('izz="')


def test_numbers_beyond_the_world_do_not_break_it(told):
    for value in ("1e300", "-1e300", "1e-300", "nan", "1e999"):
        told(wheel(inertia(value, value, value), mass=value, rpy=f"{value} 0 0"))
        told(wheel(inertia(*RIGHT), shape=f'<geometry><sphere radius="{value}"/></geometry>'))
    assert math.isfinite(RIGHT[0])
