"""Rules about robots with driven wheels: sides, sizes, torque, and what drags on the floor."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.diagnostics import Find, Part, Severity, rule
from simkit.urdf.rules.bodies import lumps, mass_of, standing_shapes, zero_pose
from simkit.urdf.rules.entries import BodyEntry, LinkEntry
from simkit.urdf.rules.plugin_joints import Drive, Wheel, drives, middle_of
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.vocabulary import tag_value
from simkit.urdf.rules.wording import four_digits, quoted, read_number, triple
from simkit.xml import Element

_NEAR = 0.001
"Wheels that are less apart than this [m] are in one place."
_NOTED, _BAD = 0.02, 0.1
"A size that is off by these shares is reported, as a note and as a warning."
_ROLLS = '<axis xyz="0 1 0"/>'


@rule(
    "GZ-W02",
    "wheels on the wrong side, or turning the wrong way",
    Severity.WARNING,
    here="simkit drives the joints that are named.",
    gazebo="Gazebo drives the joints that are named.",
)
def wheels_on_wrong_side(sheet: Sheet) -> Iterator[Find]:
    """The wheels are on the wrong side, or turn the wrong way.

    Symptom: The robot turns right when it is told to turn left, drives backward, or spins on the spot when it is told to
    drive.

    Cause: The frames of a robot have x forward and y to the left (REP 103). The left wheel is the one with the larger y. A
    wheel that turns about +y rolls forward, one that turns about -y rolls backward.

    Remedy: Swap the names in `<leftJoint>` and `<rightJoint>`, or the signs of y in the joints; `<axis xyz="0 1 0"/>` for
    both wheels, in axes where y points to the left.

    Right:

        <joint name="joint_left_wheel" type="continuous">
          <origin xyz="-0.05 0.15 0"/>
          <axis xyz="0 1 0"/>
          ...
    """
    for drive in drives(sheet):
        found = _side_fault(drive)
        if found is None:
            continue
        severity, wheel, what, remedy = found
        yield Find(
            Part(wheel.element),
            severity=severity,
            what=what,
            remedy=remedy,
            related=[(wheel.joint.origin.element or wheel.joint.element, "this joint")],
        )


@rule("GZ-W03", "wheelSeparation or wheelDiameter not that of the robot", Severity.WARNING)
def wheel_sizes(sheet: Sheet) -> Iterator[Find]:
    """`<wheelSeparation>` or `<wheelDiameter>` is not that of the robot.

    Symptom: The robot turns or drives faster or slower than it is told, and its odometry is off by the same factor.

    Cause: The plugin does not look at the robot. It computes with the two numbers it is given: the distance between the
    wheels, and their diameter (not their radius).

    Remedy: The distance from the middle of the left wheel to the middle of the right one, and twice the radius.

    Right:

        <wheelSeparation>0.3</wheelSeparation>
        <wheelDiameter>0.2</wheelDiameter>
    """
    for drive in drives(sheet):
        apart = abs(middle_of(drive.left)[1] - middle_of(drive.right)[1])
        if apart > _NEAR:
            what = f"the wheels are {four_digits(apart)} m apart"
            yield from _size(drive, "wheelSeparation", apart, what, "turns", grows=True)
        radii = [wheel.radius for wheel in drive.wheels if wheel.radius is not None]
        if len(radii) == len(drive.wheels) and max(radii) <= min(radii) * (1.0 + _NOTED):
            what = f"the wheels have a diameter of {four_digits(2 * radii[0])} m (radius {four_digits(radii[0])} m)"
            yield from _size(drive, "wheelDiameter", 2 * radii[0], what, "drives", grows=False)


def _side_fault(drive: Drive) -> tuple[Severity, Wheel, str, str] | None:
    """What is wrong with the sides: how bad, which wheel, what, and the remedy."""
    left, right = middle_of(drive.left), middle_of(drive.right)
    first, base = drive.left[0], f"in {quoted(drive.base)}"
    if abs(left[1] - right[1]) < _NEAR:
        what = f"the left and the right wheel are not side by side: {triple(left)} and {triple(right)} {base}"
        return Severity.WARNING, first, what, "Put them apart along y, which points to the left."
    across = [wheel for wheel in drive.wheels if abs(wheel.axis[1]) < 0.5 and any(wheel.axis)]
    if across:
        name, axis = quoted(across[0].joint.name), triple(across[0].axis)
        what = f"the wheel of {name} turns about {axis} {base}: it cannot roll forward"
        remedy = f"Let it turn about y: {_ROLLS} in axes whose y points to the left."
        return Severity.WARNING, across[0], what, remedy
    turns = {wheel.axis[1] > 0.0 for wheel in drive.wheels}
    if len(turns) > 1:
        what = "the wheels turn against each other: told to drive forward (+linear.x), the robot spins on the spot"
        remedy = "Give both wheels the same <axis>, in axes that point the same way."
        return Severity.WARNING, first, what, remedy
    is_swapped, is_forward = left[1] < right[1], turns == {True}
    if is_swapped and is_forward:
        return Severity.WARNING, first, *_swapped(drive, left[1], right[1])
    if is_swapped:
        what = f"the front of the robot is at -x: its left wheel has y = {four_digits(left[1])} m, and its wheels turn about -y"
        return Severity.NOTE, first, what, "Right if you mean so; by REP 103 x points to the front."
    return None if is_forward else (Severity.WARNING, first, *_backward(first))


def _swapped(drive: Drive, left: float, right: float) -> tuple[str, str]:
    """What is wrong, and the remedy, if the left wheel is at the right and they roll forward; y of both [m]."""
    places = f"y = {four_digits(left)} m is to the right of y = {four_digits(right)} m"
    what = f"the left and the right wheel are swapped ({places}): told to turn left (+angular.z), the robot turns right"
    names = [quoted(wheel.joint.name).strip("'") for wheel in (drive.right[0], drive.left[0])]
    swap = f"<leftJoint>{names[0]}</leftJoint> and <rightJoint>{names[1]}</rightJoint>"
    return what, f"Swap the names: {swap}, or the signs of y in the two joints."


def _backward(wheel: Wheel) -> tuple[str, str]:
    """What is wrong, and the remedy, if the wheels are on their sides and roll backward."""
    x, y, z = wheel.joint.axis or (0.0, 0.0, 0.0)
    turned = triple((0.0 - x, 0.0 - y, 0.0 - z))
    what = "the wheels turn about -y: told to drive forward (+linear.x), the robot drives backward"
    return what, f'Turn the axes of both wheels round: <axis xyz="{turned}"/>.'


def _size(
    drive: Drive, name: str, real: float, what: str, verb: str, *, grows: bool
) -> Iterator[Find]:
    given_size = drive.number(name)
    if given_size is None or given_size <= 0.0 or abs(given_size / real - 1.0) <= _NOTED:
        return
    factor = given_size / real if grows else real / given_size
    given = drive.plugin.parameter(name)
    stands = (
        f"<{name}> is {four_digits(given_size)} m"
        if given is not None
        else f"<{name}> is not given, so {four_digits(given_size)} m"
    )
    yield Find(
        (given.text_span or given) if given is not None else drive.plugin.element,
        severity=Severity.WARNING if abs(given_size / real - 1.0) > _BAD else Severity.NOTE,
        element=drive.place(name),
        what=f"{stands}, but {what}",
        both=f"The robot {verb} {four_digits(factor)} times as fast as it is told; odometry from the wheels is off by that "
        "factor.",
        remedy=f"Write <{name}>{four_digits(real)}</{name}>.",
        related=[
            (drive.left[0].joint.element, "the left wheel"),
            (drive.right[0].joint.element, "the right wheel"),
        ],
    )


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
        gain = (
            f"speeds up the robot of {four_digits(masses)} kg by {four_digits(pull)} m/s² at best"
        )
        what = gain if pull > 0.0 else "does not overcome the friction in the joints"
        yield _weak(
            drive, place, f"a torque of {four_digits(torque)} N m at each wheel {what}", 2 * needed
        )


def _weak(drive: Drive, place: Element, what: str, enough: float) -> Find:
    name = drive.torque_name
    is_read = place.name in (name, "plugin")
    follows = "The robot hardly moves, or not at all."
    if not is_read:  # another rule reports that
        what = f"{what}, if it is read"
        follows = f"As it is the robot moves: <{place.name}> is not read, and 5 N m is the default of <{name}>."
    return Find(
        place,
        severity=Severity.WARNING if is_read else Severity.NOTE,
        what=what,
        both=follows,
        remedy=f"Write at least <{name}>{four_digits(enough)}</{name}>.",
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

    Cause: A ball on a fixed joint does not roll, it slides; and every shape has a friction of 1 unless the file
    says otherwise.

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
        what=f"{name} stands on the floor beside the wheels, cannot roll, and has a friction of {four_digits(friction)}: it "
        "drags",
        remedy=f"{remedy}.",
    )
