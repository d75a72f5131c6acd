"""Watchers of robots on wheels: the wrong way, the wrong size, slipping, creeping, wheels in the air."""

from __future__ import annotations

import math

from simkit.gazebo.watching.ground import floor_height, foot, load_share, touching
from simkit.gazebo.watching.motion import LOOK_S, Means, means, signed, turn_between
from simkit.gazebo.watching.watcher import DriveWatcher, Observation, WatchedModel

LOOKS = 6
"""It must go the wrong way for so many looks; the first one is for the motors to obey."""
SLOWEST = (0.03, 0.08)
"""Slower commands [m/s, rad/s] say nothing."""
CLEARLY = 0.3
"""It goes the wrong way with at least this share of the speed."""


class WrongWay(DriveWatcher):
    """Compares what the wheels are told with where the robot goes, for half a second."""

    rule = "GZ-W02"
    is_said_by_rule = True

    def __init__(self, scene: WatchedModel) -> None:
        super().__init__(scene)
        self._judged = (0, 0)

    def look(self) -> Observation | None:
        """Whether it goes the wrong way; once for each way that it is told to go."""
        way = _way(self.drive.command())
        moments = [] if way == self._judged else self.motion.last(LOOKS)
        if not moments or any(_way(one.command) != way for one in moments):
            return None
        self._judged = way
        found = means(moments[1:])
        text = self._backward(found) or self._turned(found) or self._spinning(found)
        return None if text is None else Observation(text=text)

    def _backward(self, found: Means) -> str | None:
        told, moved = found.command[0], found.moved[0]
        if abs(told) < SLOWEST[0] or moved * told > -CLEARLY * told * told:
            return None
        return (
            f"{self.model.name} is told to drive at {signed(told)} m/s, and drives at {signed(moved)} m/s: its wheels "
            "roll backward. A wheel that turns about +y rolls forward along x: turn the axes of its joints round"
        )

    def _turned(self, found: Means) -> str | None:
        told, moved = found.command[1], found.moved[1]
        if abs(told) < SLOWEST[1] or moved * told > -CLEARLY * told * told:
            return None
        left, right = self.drive.left[0].name, self.drive.right[0].name
        return (
            f"{self.model.name} is told to turn at {signed(told)} rad/s, and turns at {signed(moved)} rad/s: left and "
            f"right are swapped. Left is where y is greater: the left joint is {left!r} now, the right one {right!r}"
        )

    def _spinning(self, found: Means) -> str | None:
        told, moved = found.command, found.moved
        turn = 2.0 * told[0] / self.drive.separation
        if abs(told[0]) < SLOWEST[0] or abs(told[1]) > 1e-6:
            return None
        if abs(moved[1]) < CLEARLY * abs(turn) or abs(moved[0]) > CLEARLY * abs(told[0]):
            return None
        return (
            f"{self.model.name} is told to drive straight on at {signed(told[0])} m/s, and turns on the spot at "
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


class _SteadyDrive(DriveWatcher):
    """Looks at a robot that is told the same for a second, and whose wheels do it; once for each command."""

    def __init__(self, scene: WatchedModel) -> None:
        super().__init__(scene)
        self._judged = (0.0, 0.0)

    def look(self) -> Observation | None:
        """What is wrong with the speed."""
        if self.drive.command() == self._judged:
            return None
        moments = self.motion.last(STEADY_LOOKS)
        if not moments or any(one.command != moments[0].command for one in moments):
            return None
        found = means(moments[SETTLING:])
        pairs = zip(found.rolled, found.command, strict=True)
        if any(abs(did - told) > 0.05 * abs(told) + 0.005 for did, told in pairs):
            return None
        self._judged = moments[0].command
        return self.judge(found)

    def judge(self, found: Means) -> Observation | None:
        """What is wrong with a speed, if the wheels do what they are told."""
        raise NotImplementedError


class WrongSize(_SteadyDrive):
    """A plugin that believes in wheels that are larger, smaller, or farther apart than they are."""

    rule = "GZ-W03"
    is_said_by_rule = True

    def judge(self, found: Means) -> Observation | None:
        """Whether the numbers of the tag explain the speed."""
        real = self.drive.real_diameter()
        grown = 1.0 if real is None else real / self.drive.diameter
        wide = self.drive.separation / max(self.drive.real_separation(), 1e-6)
        forward, turning = _share(found, 0), _share(found, 1)
        if real is not None and _is_off(grown) and _explains(forward, grown):
            return Observation(
                text=f"{self._told(found, 0, 'drive', 'm/s')}: <wheelDiameter> is {self.drive.diameter:.3g} m, and its "
                f"wheels have {real:.3g} m. Write <wheelDiameter>{real:.3g}</wheelDiameter>"
            )
        if _is_off(wide) and _explains(turning, grown * wide):
            apart = self.drive.real_separation()
            return Observation(
                text=f"{self._told(found, 1, 'turn', 'rad/s')}: <wheelSeparation> is {self.drive.separation:.3g} m, and "
                f"its wheels are {apart:.3g} m apart. Write <wheelSeparation>{apart:.3g}</wheelSeparation>"
            )
        return None

    def _told(self, found: Means, which: int, verb: str, unit: str) -> str:
        return (
            f"{self.model.name} is told to {verb} at {signed(found.command[which])} {unit}, and does so at "
            f"{signed(found.moved[which])} {unit}"
        )


class Slipping(_SteadyDrive):
    """Wheels that turn as told, and a robot that stays behind."""

    rule = "GZ-W05"

    def judge(self, found: Means) -> Observation | None:
        """Whether it is slower than its wheels roll."""
        real = self.drive.real_diameter()
        grown = 1.0 if real is None else real / self.drive.diameter
        wide = self.drive.separation / max(self.drive.real_separation(), 1e-6)
        forward, turning = _share(found, 0), _share(found, 1)
        if abs(found.command[1]) < 1e-6 and abs(found.moved[1]) > STRAIGHT:
            return None  # it goes another way, which is another fault
        if forward is not None and -TOLERANCE <= forward < grown * (1.0 - 2 * TOLERANCE):
            speeds = f"drive at {signed(found.command[0])} m/s, and drives at {signed(found.moved[0])} m/s"
        elif (
            turning is not None
            and len(self.drive.joints) == 2  # four wheels cannot turn without slipping
            and -TOLERANCE <= turning < grown * wide * (1.0 - 2 * TOLERANCE)
        ):
            speeds = f"turn at {signed(found.command[1])} rad/s, and turns at {signed(found.moved[1])} rad/s"
        else:
            return None
        bears = load_share(self.scene, [joint.plan.child for joint in self.drive.joints])
        if bears is None or bears == 0.0:  # its wheels are in the air, which another one says
            return None
        return Observation(
            text=f"{self.model.name} is told to {speeds}, though its wheels turn as told: they slip. They bear "
            f"{bears:.0%} of its weight. Give them <mu1>1</mu1>, what drags on the floor <mu1>0</mu1>, and put "
            "the weight over them; or something is in the way"
        )


def _share(found: Means, which: int) -> float | None:
    """The speed as a share of what was told; None if that is too slow to say."""
    told = found.command[which]
    return None if abs(told) < SLOWEST_STEADY[which] else found.moved[which] / told


def _is_off(share: float) -> bool:
    return abs(share - 1.0) > TOLERANCE


def _explains(measured: float | None, expected: float) -> bool:
    return measured is not None and abs(measured / expected - 1.0) < TOLERANCE


STANDING_LOOKS, REST_LOOKS = 60, 10
"""It stands for so many looks, of which the first ones are for coming to rest; the rest are 5 s."""
FAR, ROUND = 0.01, 0.02
"""How far it may creep [m], and how far it may turn [rad], in that time."""


class Drifting(DriveWatcher):
    """Looks at a robot on wheels that is told to stand."""

    rule = "GZ-W05"

    def __init__(self, scene: WatchedModel) -> None:
        super().__init__(scene)
        self._looks = 0

    def look(self) -> Observation | None:
        """Whether it creeps; asked once in 6 s of standing."""
        self._looks = 0 if any(self.drive.command()) else self._looks + 1
        if self._looks % STANDING_LOOKS or not self._looks:
            return None
        moments = self.motion.last(STANDING_LOOKS)
        if not moments or any(any(one.command) for one in moments):
            return None
        first, last = moments[REST_LOOKS], moments[-1]
        way = math.dist(first.place[:2], last.place[:2])
        turn = abs(turn_between(first.yaw, last.yaw))
        if way < FAR and turn < ROUND:
            return None
        return Observation(
            text=f"{self.model.name} moves though nothing is commanded: {way:.2g} m and {math.degrees(turn):.2g} degrees "
            f"in {(STANDING_LOOKS - REST_LOOKS) * LOOK_S:g} s. Check the friction of its wheels (<mu1>1</mu1>), that all wheels "
            "and casters stand at one height, and that its inertias fit its shapes"
        )


PATIENCE = 5
"""So many looks in a row the wheels touch nothing."""
ENOUGH = 20
"""After so many looks at wheels that all touch something, they will do so."""
CALM = 0.05
"""What is slower up and down [m/s] does not fall."""


class WheelsInAir(DriveWatcher):
    """Looks at wheels that are told to turn."""

    rule = "GZ-W04"

    def __init__(self, scene: WatchedModel) -> None:
        super().__init__(scene)
        self._looks = 0
        self._good_looks = 0

    def look(self) -> Observation | None:
        """Whether wheels of a robot that stands touch nothing."""
        is_told = any(joint.command for joint in self.drive.joints)
        if not is_told or abs(self.model.twist[0][2]) > CALM:
            self._looks = 0
            return None
        down = touching(self.scene)
        hanging = [joint for joint in self.drive.joints if joint.plan.child not in down]
        self._looks = self._looks + 1 if hanging and down else 0
        self._good_looks = 0 if hanging else self._good_looks + 1
        self.is_over = self._good_looks >= ENOUGH
        if self._looks < PATIENCE:
            return None
        links = ", ".join(repr(joint.plan.child) for joint in hanging)
        return Observation(
            text=f"{self.model.name} is told to drive, and {links} {'touches' if len(hanging) == 1 else 'touch'} "
            f"nothing{self._gap(hanging[0].plan.child)}: it stands on {', '.join(map(repr, sorted(down)))}. Move the "
            "wheels down, or what it stands on up"
        )

    def _gap(self, body: str) -> str:
        lowest, floor = foot(self.model, body=body), floor_height(self.scene.gazebo.world)
        if lowest is None:
            return ", as it has no <collision>"
        return "" if floor is None else f", {max(0.0, lowest.z - floor):.2g} m above the floor"
