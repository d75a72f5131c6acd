"""Rules about the type of a joint, and about its limits."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.diagnostics import Find, Part, Severity, rule
from simkit.urdf.rules.entries import JointEntry, LimitEntry
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.vocabulary import JOINT_TYPES, nearest
from simkit.urdf.rules.wording import REFUSED, called, shown, six_digits

_OTHER_NAMES = {
    **dict.fromkeys(("hinge", "rotational", "rotary", "rotation", "rotate", "pivot"), "revolute"),
    **dict.fromkeys(("slider", "linear", "translational", "slide", "prism"), "prismatic"),
    **dict.fromkeys(("rigid", "weld", "static", "none", "fix"), "fixed"),
    **dict.fromkeys(("wheel", "endless", "spin"), "continuous"),
    **dict.fromkeys(("free", "6dof"), "floating"),
}
_NOT_THERE = {
    **dict.fromkeys(
        ("ball", "spherical"), "three revolute joints about x, y, z with small links between them"
    ),
    **dict.fromkeys(
        ("universal", "revolute2"), "two revolute joints at right angles with a small link between"
    ),
    **dict.fromkeys(
        ("screw", "gearbox"), "a prismatic joint, and a revolute one that follows it with <mimic>"
    ),
}


@rule("URDF-E20", "a type of joint that does not exist", Severity.ERROR)
def unknown_joint_type(sheet: Sheet) -> Iterator[Find]:
    """A joint of a type that URDF does not know.

    ROS says `Joint [hip] has no known type [revolut]` and refuses the robot. There are six types, in small letters: `fixed`,
    `revolute` (turns between limits), `continuous` (turns without end), `prismatic` (slides between limits), and, hardly ever
    used, `floating` and `planar`.

    Wrong:

        <joint name="hip" type="revolut">

    Right:

        <joint name="hip" type="revolute">
    """
    for joint in sheet.joints:
        if joint.type is None or joint.type in JOINT_TYPES:
            continue
        yield Find(
            Part(joint.element, "type"),
            what=f"{called(joint.element)} has the type {shown(joint.type)!r}, which does not exist",
            remedy=_remedy(joint.type),
            loss=REFUSED,
        )


def _remedy(written: str) -> str:
    folded = written.strip().lower()
    if folded in _NOT_THERE:
        return f"URDF has no such joint; take {_NOT_THERE[folded]}."
    near = _OTHER_NAMES.get(folded) or nearest(folded, JOINT_TYPES)
    types = f"The types are {', '.join(JOINT_TYPES)}."
    return f'Write type="{near}". {types}' if near else types


_UNITS = {"revolute": "rad", "prismatic": "m", "continuous": "rad"}


@rule("URDF-E05", "a revolute or prismatic joint without <limit>", Severity.ERROR)
def no_limit(sheet: Sheet) -> Iterator[Find]:
    """A revolute or prismatic joint without limits.

    ROS says `Joint [elbow] is of type REVOLUTE but it does not specify limits` and refuses the robot. A `revolute` joint turns
    between two angles, a `prismatic` one slides between two positions, so both need `<limit>`. A joint that may turn round and
    round is `continuous`, and needs none.

    Wrong:

        <joint name="elbow" type="revolute">
          ...
        </joint>

    Right:

        <joint name="elbow" type="revolute">
          ...
          <limit lower="-1.5708" upper="1.5708" effort="10" velocity="1"/>
        </joint>
    """
    for joint in sheet.joints:
        if joint.limit is not None or joint.type not in ("revolute", "prismatic"):
            continue
        turns = joint.type == "revolute"
        bounds = 'lower="-1.5708" upper="1.5708"' if turns else 'lower="0" upper="0.1"'
        other = ' Or write type="continuous" if it may turn without end.' if turns else ""
        yield Find(
            Part(joint.element, "type"),
            what=f"{called(joint.element)} is {joint.type} and has no <limit>",
            remedy=f'Add e.g. <limit {bounds} effort="10" velocity="1"/> ({_UNITS[joint.type]}).{other}',
            loss=REFUSED,
        )


@rule(
    "URDF-W06",
    "effort or velocity 0: the joint is unable to move",
    Severity.WARNING,
    here="With physics the joint does not follow its commands; sliders still move it.",
    gazebo="Gazebo applies no force beyond the effort and lets no motor exceed the velocity.",
)
def no_authority(sheet: Sheet) -> Iterator[Find]:
    """A joint that may not push, or may not move.

    The joint never moves, whatever the controller sends. `effort` is the largest force or torque of its motor, `velocity` the
    largest speed. 0 does not mean "no limit" but "none at all". Who does not know them writes a number that is big enough.

    Wrong:

        <limit lower="-1" upper="1" effort="0" velocity="0"/>

    Right:

        <limit lower="-1" upper="1" effort="10" velocity="1"/>
    """
    for joint in sheet.joints:
        limit = joint.limit
        if limit is None or not joint.moves:
            continue
        values = {"effort": limit.effort, "velocity": limit.velocity}
        bad = [name for name, value in values.items() if value is not None and value <= 0.0]
        if bad:
            yield _unable(joint, limit, bad)


def _unable(joint: JointEntry, limit: LimitEntry, bad: list[str]) -> Find:
    written = " and ".join(f'{name}="{limit.element.get(name)}"' for name in bad)
    able_to = {"effort": "10", "velocity": "1"}
    mended = " ".join(f'{name}="{able_to[name]}"' for name in bad)
    able = {"effort": "has no strength", "velocity": "may not move"}
    return Find(
        Part(limit.element, bad[0]),
        what=f"{called(joint.element)} has {written}: it {' and '.join(able[name] for name in bad)}",
        remedy=f"0 does not mean unlimited. Write what its motor can do, e.g. {mended}.",
    )


@rule("URDF-E08", "lower limit above the upper one, or equal to it", Severity.ERROR)
def lower_above_upper(sheet: Sheet) -> Iterator[Find]:
    """Limits the wrong way round, or without room between them.

    ROS accepts them without a word. The joint cannot be where it may be: Gazebo throws it about or holds it fast, and a slider
    has no room. Mostly a minus sign slipped. `lower` and `upper` that are left out are both 0, which leaves no room either.

    Wrong:

        <limit lower="1.57" upper="-1.57" effort="10" velocity="1"/>

    Right:

        <limit lower="-1.57" upper="1.57" effort="10" velocity="1"/>
    """
    for joint in sheet.joints:
        limit = joint.limit
        if limit is None or joint.type not in ("revolute", "prismatic"):
            continue
        if limit.lower is None or limit.upper is None:
            continue
        if limit.lower > limit.upper:
            yield _crossed(joint, limit, limit.lower, limit.upper)
        elif limit.lower == limit.upper:
            yield _no_room(joint, limit, limit.lower)


def _crossed(joint: JointEntry, limit: LimitEntry, lower: float, upper: float) -> Find:
    low, high = six_digits(lower), six_digits(upper)
    return Find(
        Part(limit.element, "upper" if limit.element.get("lower") is None else "lower"),
        what=f"{called(joint.element)} has lower {low} above upper {high}",
        remedy=f'Write lower="{high}" upper="{low}", if they are only swapped.',
        here="No position is allowed; a slider of this joint has no room.",
        gazebo="ROS accepts it; in Gazebo the joint is thrown about between two limits that it cannot keep.",
    )


def _no_room(joint: JointEntry, limit: LimitEntry, at: float) -> Find:
    is_default = not (limit.element.get("lower") or limit.element.get("upper"))
    why = "no lower and upper, so both are 0" if is_default else f"both limits at {six_digits(at)}"
    wide = 'lower="-1.5708" upper="1.5708"' if joint.type == "revolute" else 'lower="0" upper="0.1"'
    return Find(
        Part(limit.element, "lower"),
        severity=Severity.WARNING,
        what=f"{called(joint.element)} has {why}: it cannot move",
        remedy=f'Give it room, e.g. {wide} ({_UNITS[str(joint.type)]}); or write type="fixed" if it is not to move.',
        both="The joint stays where it is, and gets no slider.",
    )


@rule(
    "URDF-I34",
    "limits that a continuous joint does not look at",
    Severity.NOTE,
    remedy='Leave them out, or write type="revolute" if the joint is to stop there.',
    both="The joint turns without end.",
)
def limits_of_a_continuous_joint(sheet: Sheet) -> Iterator[Find]:
    """Limits of angle on a joint that has none.

    A `continuous` joint turns round and round; ROS and Gazebo do not look at its `lower` and `upper`. Either they are not
    needed, or the joint was meant to be `revolute`. `effort` and `velocity` do count.

    Wrong, if the wrist is to stop at 90 degrees:

        <joint name="wrist" type="continuous">
          <limit lower="-1.5708" upper="1.5708" effort="10" velocity="1"/>

    Right:

        <joint name="wrist" type="revolute">
          <limit lower="-1.5708" upper="1.5708" effort="10" velocity="1"/>
    """
    for joint in sheet.joints:
        limit = joint.limit
        if limit is None or joint.type != "continuous":
            continue
        given = [one for one in limit.element.attributes if one.name in ("lower", "upper")]
        if given and (limit.lower or limit.upper):
            yield Find(
                Part(limit.element, given[0].name),
                what=f"{called(joint.element)} is continuous: its {' and '.join(one.name for one in given)} have no effect",
            )
