"""Watchers of robots on wheels: the wrong way, the wrong size, slipping, creeping, wheels in the air."""

from __future__ import annotations

import math
from collections.abc import Iterator

from simkit.gazebo.watchers.motion import (
    LOOK_S,
    DrivenWheels,
    Means,
    Motion,
    means,
    signed,
    turn_between,
)
from simkit.gazebo.watchers.scene import (
    Looks,
    WatchedModel,
    drive_watcher,
    floor_height,
    foot,
    load_share,
    touching,
)
from simkit.physics import Model

LOOKS = 6
"""It must go the wrong way for so many looks; the first one is for the motors to obey."""
SLOWEST = (0.03, 0.08)
"""Slower commands [m/s, rad/s] say nothing."""
CLEARLY = 0.3
"""It goes the wrong way with at least this share of the speed."""


@drive_watcher("GZ-W02", is_said_by_rule=True)
def wrong_way(scene: WatchedModel, motion: Motion) -> Looks:
    """Compares the commands of the wheels with where the robot goes, for half a second; once for each way that it is to go."""
    judged, name, drive = (0, 0), scene.model.name, motion.drive
    while True:
        way = _way(drive.command())
        moments = [] if way == judged else motion.last(LOOKS)
        if not moments or any(_way(one.command) != way for one in moments):
            yield None
            continue
        judged = way
        found = means(moments[1:])
        yield (
            _backward(name, found) or _swapped(name, drive, found) or _spinning(name, drive, found)
        )


def _backward(name: str, found: Means) -> str | None:
    wanted, moved = found.command[0], found.moved[0]
    if abs(wanted) < SLOWEST[0] or moved * wanted > -CLEARLY * wanted * wanted:
        return None
    return (
        f"{name} is told to drive at {signed(wanted)} m/s, and drives at {signed(moved)} m/s: its wheels "
        "roll backward. A wheel that turns about +y rolls forward along x: turn the axes of its joints round"
    )


def _swapped(name: str, drive: DrivenWheels, found: Means) -> str | None:
    wanted, moved = found.command[1], found.moved[1]
    if abs(wanted) < SLOWEST[1] or moved * wanted > -CLEARLY * wanted * wanted:
        return None
    left, right = drive.left[0].name, drive.right[0].name
    return (
        f"{name} is told to turn at {signed(wanted)} rad/s, and turns at {signed(moved)} rad/s: left and "
        f"right are swapped. Left is where y is greater: the left joint is {left!r} now, the right one {right!r}"
    )


def _spinning(name: str, drive: DrivenWheels, found: Means) -> str | None:
    wanted, moved = found.command, found.moved
    turn = 2.0 * wanted[0] / drive.separation
    if abs(wanted[0]) < SLOWEST[0] or abs(wanted[1]) > 1e-6:
        return None
    if abs(moved[1]) < CLEARLY * abs(turn) or abs(moved[0]) > CLEARLY * abs(wanted[0]):
        return None
    return (
        f"{name} is told to drive straight on at {signed(wanted[0])} m/s, and turns on the spot at "
        f"{signed(moved[1])} rad/s: its wheels turn against each other. Give both joints the same axis"
    )


def _way(command: tuple[float, float]) -> tuple[int, int]:
    """Forward (1) or backward (-1), to the left (1) or to the right (-1)."""
    speed, turn = command
    return (speed > 0.0) - (speed < 0.0), (turn > 0.0) - (turn < 0.0)


STEADY_LOOKS, SETTLING = 12, 4
"""So many looks with the same command, of which the first ones are for speeding up."""
SLOWEST_STEADY = (0.05, 0.15)
"""Slower commands [m/s, rad/s] say nothing."""
STRAIGHT = 0.2
"""What turns slower [rad/s] goes straight on."""
TOLERANCE = 0.1
"""So much may a speed be off, as a share of it."""


@drive_watcher("GZ-W03", is_said_by_rule=True)
def wrong_size(scene: WatchedModel, motion: Motion) -> Looks:
    """A plugin that takes the wheels for larger, smaller, or farther apart than they are: its numbers explain the speed."""
    for found in _steady(motion):
        yield None if found is None else _wrong_size(scene.model.name, motion.drive, found)


@drive_watcher("GZ-W05")
def slipping(scene: WatchedModel, motion: Motion) -> Looks:
    """Wheels that turn as commanded, and a robot that is slower than they roll."""
    for found in _steady(motion):
        speeds = None if found is None else _slow(motion.drive, found)
        bears = (
            load_share(scene, [one.plan.child for one in motion.drive.joints]) if speeds else None
        )
        if not bears:  # its wheels are in the air, which another one says
            yield None
            continue
        yield (
            f"{scene.model.name} is told to {speeds}, though its wheels turn as told: they slip. They bear "
            f"{bears:.0%} of its weight. Give them <mu1>1</mu1>, what drags on the floor <mu1>0</mu1>, and put "
            "the weight over them; or something is in the way"
        )


def _steady(motion: Motion) -> Iterator[Means | None]:
    """How a robot moved that had the same command for a second, and whose wheels obeyed; once for each command."""
    judged = (0.0, 0.0)
    while True:
        moments = [] if motion.drive.command() == judged else motion.last(STEADY_LOOKS)
        if not moments or any(one.command != moments[0].command for one in moments):
            yield None
            continue
        found = means(moments[SETTLING:])
        pairs = zip(found.rolled, found.command, strict=True)
        if any(abs(did - wanted) > 0.05 * abs(wanted) + 0.005 for did, wanted in pairs):
            yield None
            continue
        judged = moments[0].command
        yield found


def _wrong_size(name: str, drive: DrivenWheels, found: Means) -> str | None:
    real, apart = drive.real_diameter(), drive.real_separation()
    grown, wide = _errors(drive)
    forward, turning = _share(found, 0), _share(found, 1)
    if real is not None and _is_off(grown) and _explains(forward, grown):
        speeds = _speeds(found, 0, "drive", "m/s")
        return (
            f"{name} is told to {speeds}: <wheelDiameter> is {drive.diameter:.3g} m, and its "
            f"wheels have {real:.3g} m. Write <wheelDiameter>{real:.3g}</wheelDiameter>"
        )
    if _is_off(wide) and _explains(turning, grown * wide):
        speeds = _speeds(found, 1, "turn", "rad/s")
        return (
            f"{name} is told to {speeds}: <wheelSeparation> is {drive.separation:.3g} m, and "
            f"its wheels are {apart:.3g} m apart. Write <wheelSeparation>{apart:.3g}</wheelSeparation>"
        )
    return None


def _slow(drive: DrivenWheels, found: Means) -> str | None:
    """How a robot is slower than its wheels roll, if it is."""
    grown, wide = _errors(drive)
    forward, turning = _share(found, 0), _share(found, 1)
    if abs(found.command[1]) < 1e-6 and abs(found.moved[1]) > STRAIGHT:
        return None  # it goes another way, which is another fault
    if forward is not None and -TOLERANCE <= forward < grown * (1.0 - 2 * TOLERANCE):
        return (
            f"drive at {signed(found.command[0])} m/s, and drives at {signed(found.moved[0])} m/s"
        )
    has_two = len(drive.joints) == 2  # four wheels cannot turn without slipping
    most = grown * wide * (1.0 - 2 * TOLERANCE)
    if turning is not None and has_two and -TOLERANCE <= turning < most:
        return (
            f"turn at {signed(found.command[1])} rad/s, and turns at {signed(found.moved[1])} rad/s"
        )
    return None


def _errors(drive: DrivenWheels) -> tuple[float, float]:
    """By which factors diameter and separation make it drive, and turn, faster than commanded."""
    real = drive.real_diameter()
    grown = 1.0 if real is None else real / drive.diameter
    return grown, drive.separation / max(drive.real_separation(), 1e-6)


def _speeds(found: Means, which: int, verb: str, unit: str) -> str:
    wanted, moved = signed(found.command[which]), signed(found.moved[which])
    return f"{verb} at {wanted} {unit}, and does so at {moved} {unit}"


def _share(found: Means, which: int) -> float | None:
    """The speed as a share of the command; None if that is too slow to say."""
    wanted = found.command[which]
    return None if abs(wanted) < SLOWEST_STEADY[which] else found.moved[which] / wanted


def _is_off(share: float) -> bool:
    return abs(share - 1.0) > TOLERANCE


def _explains(measured: float | None, expected: float) -> bool:
    return measured is not None and abs(measured / expected - 1.0) < TOLERANCE


STANDING_LOOKS, REST_LOOKS = 60, 10
"""It stands for so many looks, of which the first ones are for coming to rest; the rest are 5 s."""
FAR, ROUND = 0.01, 0.02
"""How far it may creep [m], and how far it may turn [rad], in that time."""


@drive_watcher("GZ-W05")
def drifting(scene: WatchedModel, motion: Motion) -> Looks:
    """Looks at a robot on wheels that is to stand: whether it creeps, once in 6 s of standing."""
    looks = 0
    while True:
        looks = 0 if any(motion.drive.command()) else looks + 1
        is_time = looks > 0 and looks % STANDING_LOOKS == 0
        moments = motion.last(STANDING_LOOKS) if is_time else []
        if not moments or any(any(one.command) for one in moments):
            yield None
            continue
        first, last = moments[REST_LOOKS], moments[-1]
        way = math.dist(first.place[:2], last.place[:2])
        turn = abs(turn_between(first.yaw, last.yaw))
        if way < FAR and turn < ROUND:
            yield None
            continue
        yield (
            f"{scene.model.name} moves though nothing is commanded: {way:.2g} m and {math.degrees(turn):.2g} degrees "
            f"in {(STANDING_LOOKS - REST_LOOKS) * LOOK_S:g} s. Check the friction of its wheels (<mu1>1</mu1>), that all "
            "wheels and casters stand at one height, and that its inertias fit its shapes"
        )


PATIENCE = 5
"""So many looks in a row the wheels touch nothing."""
ENOUGH = 20
"""After so many looks at wheels that all touch something, they will do so."""
CALM = 0.05
"""What is slower up and down [m/s] does not fall."""


@drive_watcher("GZ-W04")
def wheels_in_air(scene: WatchedModel, motion: Motion) -> Looks:
    """Looks at wheels that are to turn: whether those of a robot that stands touch nothing."""
    looks = good_looks = 0
    model, wheels = scene.model, motion.drive.joints
    while good_looks < ENOUGH:
        if not any(joint.command for joint in wheels) or abs(model.twist[0][2]) > CALM:
            looks = 0
            yield None
            continue
        down = touching(scene)
        hanging = [joint.plan.child for joint in wheels if joint.plan.child not in down]
        looks = looks + 1 if hanging and down else 0
        good_looks = 0 if hanging else good_looks + 1
        yield (
            None
            if looks < PATIENCE
            else (
                f"{model.name} is told to drive, and {', '.join(map(repr, hanging))} "
                f"{'touches' if len(hanging) == 1 else 'touch'} nothing{_gap(scene, model, hanging[0])}: it stands on "
                f"{', '.join(map(repr, sorted(down)))}. Move the wheels down, or what it stands on up"
            )
        )


def _gap(scene: WatchedModel, model: Model, body: str) -> str:
    lowest, floor = foot(model, body=body), floor_height(scene.gazebo.world)
    if lowest is None:
        return ", as it has no <collision>"
    return "" if floor is None else f", {max(0.0, lowest.z - floor):.2g} m above the floor"
