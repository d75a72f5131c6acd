"""Rules on sensors: numbers that make no sense, and lasers that see the robot itself."""

from __future__ import annotations

import math
from collections.abc import Iterator

from simkit.diagnostics import Find, Severity, rule
from simkit.geometry import Transform
from simkit.plugins.registry import plugins
from simkit.urdf.model import Pose
from simkit.urdf.placed_shape import PlacedShape
from simkit.urdf.rules.bodies import Standing, standing_shapes, zero_pose
from simkit.urdf.rules.entries import GazeboEntry
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.vocabulary import SENSOR_TYPES
from simkit.urdf.rules.wording import four_digits, meant, quoted, read_number, read_numbers
from simkit.xml import Element

_TURN = 2.0 * math.pi * 1.05
_RAYS = ("ray", "gpu_ray")
_MOST_SHAPES = 2000


@rule("GZ-W14", "a sensor with a value that makes no sense", Severity.ERROR)
def sensor_values(sheet: Sheet) -> Iterator[Find]:
    """A sensor with a value that makes no sense.

    Symptom: No scan, a scan of one beam, or one that looks in the wrong direction.

    Cause: Degrees where radians are meant, minimum and maximum swapped, no samples, a misspelt `type`.

    Remedy: Angles in radians (90° = 1.5708), `min` below `max`, at least one sample.

    Right:

        <horizontal>
          <samples>720</samples>
          <min_angle>-1.5708</min_angle>
          <max_angle>1.5708</max_angle>
        </horizontal>
    """
    simulated = {one.sensor: one.filename for one in plugins().values() if one.sensor}
    for block, sensor in _sensors(sheet):
        for element, what, remedy in _value_faults(sheet, sensor):
            yield _find(Severity.WARNING, element, what, remedy)
        if not block.reference:
            what = f"the sensor {quoted(sensor.get('name'))} belongs to no link"
            remedy = 'Put it into a <gazebo reference="..."> that names its link.'
            yield _find(Severity.ERROR, sensor, what, remedy)
        kind = sensor.get("type")
        if kind in SENSOR_TYPES and kind not in simulated and kind != "gpu_ray":
            what = f"simkit does not simulate sensors of type {quoted(kind)}"
            yield _find(Severity.NOTE, sensor, what, "simkit has ray, imu and contact.")
        elif sensor.child("plugin") is None and kind in SENSOR_TYPES:
            what = (
                f"the sensor {quoted(sensor.get('name'))} has no plugin, so ROS hears nothing of it"
            )
            near = simulated.get(kind, "...")
            remedy = f'Add <plugin name="..." filename="{near}"> to the sensor.'
            yield _find(Severity.NOTE, sensor, what, remedy)


@rule(
    "LAS-W01",
    "a laser inside of the robot's own shape",
    Severity.WARNING,
    both="Its beams hit the robot itself.",
)
def laser_inside(sheet: Sheet) -> Iterator[Find]:
    """A laser that sits inside the robot's own collision shape.

    Symptom: The scan shows the shortest distance, or -inf, all around.

    Cause: Beams hit collision shapes, also those of the robot that carries the laser. They start at `<range><min>` from the
    sensor, and there they are still inside of the shape.

    Remedy: Lift the link of the sensor out of the body, or give it no `<collision>`, or raise `<min>` beyond the shape.

    Right:

        <joint name="joint_laser" type="fixed">
          <parent link="link_chassis"/>
          <child link="sensor_laser"/>
          <origin xyz="0.15 0 0.08"/>
        </joint>
    """
    rays = [(block, sensor) for block, sensor in _sensors(sheet) if sensor.get("type") in _RAYS]
    standing = zero_pose(sheet) if rays else {}
    shapes = list(_shapes(sheet, standing)) if rays else []
    for block, sensor in rays[:50]:
        where = standing.get(block.reference or "")
        pose = _pose(sensor)
        if where is None or pose is None:
            continue
        eye = where.frame @ pose.transform
        near = _number(sensor, "ray", "range", "min") or 0.0
        for name, shape in shapes:
            if shape.depth(eye.translation) > 0.0 and _reaches_beyond(shape, eye, near):
                yield Find(
                    sensor,
                    what=f"the laser {quoted(sensor.get('name'))} sits inside of the collision shape of {quoted(name)}, "
                    f"{four_digits(shape.depth(eye.translation))} m deep",
                    remedy=f"Move {quoted(block.reference)} out of {quoted(name)}, or raise <min> beyond its shape.",
                )
                break


def _sensors(sheet: Sheet) -> Iterator[tuple[GazeboEntry, Element]]:
    for block in sheet.gazebo:
        for element in block.element.walk():
            if element.name == "sensor":
                yield block, element


def _value_faults(sheet: Sheet, sensor: Element) -> Iterator[tuple[Element, str, str]]:
    """What is wrong in a sensor: where, what, remedy."""
    kind = sensor.get("type")
    if kind is None:
        yield sensor, "the sensor has no type", 'Add type="ray" for a laser.'
    elif kind not in SENSOR_TYPES:
        is_laser = any(word in kind.lower() for word in ("laser", "lidar", "scan", "hokuyo"))
        near = [] if is_laser else sheet.near(kind, SENSOR_TYPES)
        remedy = meant(near).strip() or 'Write "ray" for a laser.'
        yield sensor, f"there is no sensor of type {quoted(kind)}", remedy
    if kind in _RAYS:
        yield from _ray_faults(sensor)
    rate = _part(sensor, "update_rate")
    if rate is not None and (read_number(rate.text) is None or (read_number(rate.text) or 0) < 0):
        yield (
            rate,
            f"<update_rate> is {quoted(rate.text.strip())}",
            "Write how often it measures [Hz], as in 20.",
        )


def _ray_faults(sensor: Element) -> Iterator[tuple[Element, str, str]]:
    flat = _part(sensor, "ray", "scan", "horizontal")
    if flat is None:
        yield (
            sensor,
            "the laser has no <ray><scan><horizontal>: one beam, straight ahead",
            "Add <samples>, <min_angle> and <max_angle>.",
        )
        return
    samples = _part(flat, "samples")
    count = None if samples is None else read_number(samples.text)
    if samples is not None and (count is None or count < 1 or count != int(count)):
        yield (
            samples,
            f"<samples> is {quoted(samples.text.strip())}",
            "Write how many beams there are, at least 1.",
        )
    yield from _swapped(flat, "min_angle", "max_angle")
    for name in ("min_angle", "max_angle"):
        element, angle = _part(flat, name), _number(flat, name)
        if element is not None and angle is not None and abs(angle) > _TURN:
            what = f"<{name}> is {four_digits(angle)}, which is {four_digits(angle / (2 * math.pi))} turns"
            yield (
                element,
                what,
                f"Angles are radians: {four_digits(angle)}° = {four_digits(math.radians(angle))}.",
            )
    reach = _part(sensor, "ray", "range")
    if reach is not None:
        yield from _swapped(reach, "min", "max")
    yield from _noise_faults(sensor)


def _noise_faults(sensor: Element) -> Iterator[tuple[Element, str, str]]:
    kind = _part(sensor, "ray", "noise", "type")
    if kind is not None and kind.text.strip() not in ("gaussian", "none"):
        yield kind, f"there is no noise of type {quoted(kind.text.strip())}", "Write gaussian."
    spread = _part(sensor, "ray", "noise", "stddev")
    if spread is not None and (
        read_number(spread.text) is None or (read_number(spread.text) or 0) < 0
    ):
        yield (
            spread,
            f"<stddev> is {quoted(spread.text.strip())}",
            "Write a number of metres, 0 or more.",
        )


def _swapped(element: Element, low: str, high: str) -> Iterator[tuple[Element, str, str]]:
    below, above = _number(element, low), _number(element, high)
    place = _part(element, low)
    for name in (low, high):
        part = _part(element, name)
        if part is not None and read_number(part.text) is None:
            yield part, f"<{name}> is not a number: {quoted(part.text.strip())}", "Write a number."
    if place is None or below is None or above is None or below < above or (below == above == 0.0):
        return
    what = f"<{low}> is {four_digits(below)}, and <{high}> is {four_digits(above)}"
    yield place, what, f"Write the smaller one in <{low}>."


def _find(severity: Severity, at: Element, what: str, remedy: str) -> Find:
    return Find(
        at,
        severity=severity,
        what=what,
        here="Nothing is published."
        if severity is Severity.NOTE
        else "simkit leaves out the sensor.",
        gazebo="Gazebo simulates the sensor; what it senses reaches ROS by a plugin only."
        if severity is Severity.NOTE
        else "Gazebo takes a default, or drops the sensor.",
        remedy=remedy,
    )


def _part(element: Element, *names: str) -> Element | None:
    found: Element | None = element
    for name in names:
        found = None if found is None else found.child(name)
    return found


def _number(element: Element, *names: str) -> float | None:
    found = _part(element, *names)
    return None if found is None else read_number(found.text)


def _pose(sensor: Element) -> Pose | None:
    """Where a sensor stands in its link; None if that cannot be read."""
    element = sensor.child("pose")
    if element is None:
        return Pose()
    numbers = read_numbers(element.text, 6)
    if numbers is None or max(map(abs, numbers)) > 1e6:
        return None
    x, y, z, roll, pitch, yaw = numbers
    return Pose((x, y, z), (roll, pitch, yaw))


def _shapes(sheet: Sheet, standing: dict[str, Standing]) -> Iterator[tuple[str, PlacedShape]]:
    for link in sheet.links[:_MOST_SHAPES]:
        for shape in standing_shapes(link.collisions, standing.get(link.name or "")):
            yield link.name or "", shape


def _reaches_beyond(shape: PlacedShape, eye: Transform, near: float) -> bool:
    """Whether a beam that starts `near` [m] from the eye, in its plane, still starts inside of a shape."""
    ways = [(math.cos(turn), math.sin(turn), 0.0) for turn in (math.pi / 8 * i for i in range(16))]
    starts = [eye.apply((near * x, near * y, 0.0)) for x, y, _ in ways]
    return any(shape.depth(start) > 0.0 for start in starts)
