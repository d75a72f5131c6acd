"""Rules on robots with driven wheels: what pushes them, and what drags."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.diagnostics import Find, Severity, rule
from simkit.urdf.rules.bodies import mass_of
from simkit.urdf.rules.drive_facts import Drive, Wheel, drives
from simkit.urdf.rules.entries import BodyEntry, LinkEntry
from simkit.urdf.rules.gazebo_words import tag_value
from simkit.urdf.rules.lumps import lumps
from simkit.urdf.rules.paste import short
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.values import read_number
from simkit.urdf.rules.wording import quoted
from simkit.urdf.rules.zero_pose import standing_shapes, zero_pose
from simkit.xml import Element

_PULL = 0.5
"A robot that cannot speed up by this [m/s^2] takes more than a second to reach half a metre per second."
_ON_FLOOR = 0.01
"What is no higher than this above the lowest point of the wheels [m] stands on the floor."
_SLIPPERY = 0.3
"From this friction on a shape drags."


@rule("GZ-W04", "wheels too weak for the robot", Severity.WARNING)
def weak_wheels(sheet: Sheet) -> Iterator[Find]:
    """The wheels are too weak for the robot.

    Symptom: The command arrives, and the robot does not move, or creeps.

    Cause: The torque of the plugin, divided by the radius of a wheel, is the force with which it pushes. It must overcome
    the friction in the joint, and speed up the whole mass of the robot.

    Remedy: A torque that suits the mass, and a small `<dynamics friction="...">`.

    Right:

        <wheelTorque>5</wheelTorque>
    """
    masses = sum(mass_of(link) for link in sheet.links)
    for drive in drives(sheet):
        torque, place = _torque(drive)
        radii = [wheel.radius for wheel in drive.wheels if wheel.radius is not None]
        if torque is None or len(radii) < len(drive.wheels) or not masses or torque <= 0.0:
            continue
        left_over = [torque - _joint_friction(wheel) for wheel in drive.wheels]
        pull = sum(rest / radius for rest, radius in zip(left_over, radii, strict=True)) / masses
        if pull >= _PULL:
            continue
        needed = masses * _PULL * radii[0] / len(radii) + max(map(_joint_friction, drive.wheels))
        gain = f"speeds up the robot of {short(masses)} kg by {short(pull)} m/s² at best"
        what = gain if pull > 0.0 else "does not overcome the friction in the joints"
        yield _weak(
            drive, place, f"a torque of {short(torque)} N m at each wheel {what}", 2 * needed
        )


def _weak(drive: Drive, place: Element, what: str, enough: float) -> Find:
    name = drive.torque_name
    is_read = place.name in (name, "plugin")
    follows = "The robot hardly moves, or not at all."
    if not is_read:  # another rule tells of that
        what = f"{what}, if it is read"
        follows = f"As it is the robot moves: <{place.name}> is not read, and 5 N m is the default of <{name}>."
    return Find(
        place,
        severity=Severity.WARNING if is_read else Severity.NOTE,
        what=what,
        both=follows,
        remedy=f"Write at least <{name}>{short(enough)}</{name}>.",
    )


@rule(
    "GZ-W05",
    "a caster that drags over the floor",
    Severity.NOTE,
    here="Part of the push of the wheels goes into it.",
    gazebo="Part of the push of the wheels goes into it; a <surface> in URDF is not read.",
)
def dragging_caster(sheet: Sheet) -> Iterator[Find]:
    """A caster that cannot roll drags over the floor.

    Symptom: The robot drives slower than it is told, turns jerkily, or creeps to one side.

    Cause: A ball on a fixed joint does not roll, it slides; and every shape has a friction of 1 unless it is told
    otherwise.

    Remedy: No friction for the link of the ball. In URDF that stands in a `<gazebo>`; `<surface>` in the collision is SDF,
    and is not read.

    Right:

        <gazebo reference="caster">
          <mu1>0.0</mu1>
          <mu2>0.0</mu2>
        </gazebo>
    """
    rubbing = _friction(sheet)
    standing = zero_pose(sheet)
    lump_of = lumps(sheet)
    for drive in drives(sheet):
        heights = [wheel.lowest for wheel in drive.wheels if wheel.lowest is not None]
        if not heights:
            continue
        for link in lump_of[drive.base].members:
            for collision in link.collisions:
                shapes = standing_shapes((collision,), standing.get(link.name or ""))
                floor = min(heights) + _ON_FLOOR
                is_down = any(shape.lowest() <= floor for shape in shapes)
                friction = rubbing.get(link.name or "", 1.0)
                if is_down and friction > _SLIPPERY:
                    yield _caster(link, collision, friction)


def _torque(drive: Drive) -> tuple[float | None, Element]:
    """The torque of each wheel [N m], and where it stands; also one that is written in the old way, and so is not read."""
    place = drive.place(drive.torque_name)
    old = drive.plugin.parameter("torque")
    if place is drive.plugin.element and old is not None:
        return read_number(old.text), old
    return drive.number(drive.torque_name), place


def _joint_friction(wheel: Wheel) -> float:
    element = wheel.joint.dynamics_element
    friction = None if element is None else read_number(element.get("friction") or "0")
    return max(0.0, friction or 0.0)


def _friction(sheet: Sheet) -> dict[str, float]:
    """The friction of each link that a `<gazebo>` gives one."""
    found: dict[str, float] = {}
    for block in sheet.gazebo:
        element = block.element.child("mu1")
        number = None if element is None else read_number(tag_value(element))
        if block.reference and number is not None:
            found[block.reference] = number
    return found


def _caster(link: LinkEntry, collision: BodyEntry, friction: float) -> Find:
    name = quoted(collision.element.get("name") or link.name)
    alone = len(link.collisions) == 1
    remedy = f'Add <gazebo reference="{link.name}"><mu1>0.0</mu1><mu2>0.0</mu2></gazebo>'
    if not alone:
        remedy += ", which counts for all shapes of the link; or give the caster a link of its own"
    return Find(
        collision.element,
        what=f"{name} stands on the floor beside the wheels, cannot roll, and has a friction of {short(friction)}: it drags",
        remedy=f"{remedy}.",
    )
