"""Robots that drive or turn at another speed than they are told, though their wheels obey."""

from __future__ import annotations

from simkit.gazebo.watching.load import load_share
from simkit.gazebo.watching.motion import Means, means, signed
from simkit.gazebo.watching.watcher import DriveWatcher, Finding, Scene

LOOKS, SETTLING = 12, 4
"""So many looks with the same command, of which the first ones are for speeding up."""
SLOWEST = (0.05, 0.15)
"""Slower commands [m/s, rad/s] say nothing."""
STRAIGHT = 0.2
"""What turns slower [rad/s] goes straight on."""
TOLERANCE = 0.1
"""So much may a speed be off, as a share of it."""


class _SteadyDrive(DriveWatcher):
    """Looks at a robot that is told the same for a second, and whose wheels do it; once for each command."""

    def __init__(self, scene: Scene) -> None:
        super().__init__(scene)
        self._judged = (0.0, 0.0)

    def look(self) -> Finding | None:
        """What is wrong with the speed."""
        if self.drive.command() == self._judged:
            return None
        moments = self.motion.last(LOOKS)
        if not moments or any(one.command != moments[0].command for one in moments):
            return None
        found = means(moments[SETTLING:])
        pairs = zip(found.rolled, found.command, strict=True)
        if any(abs(did - told) > 0.05 * abs(told) + 0.005 for did, told in pairs):
            return None
        self._judged = moments[0].command
        return self.judge(found)

    def judge(self, found: Means) -> Finding | None:
        """What is wrong with a speed, if the wheels do what they are told."""
        raise NotImplementedError


class WrongSize(_SteadyDrive):
    """A plugin that believes in wheels that are larger, smaller, or farther apart than they are."""

    rule = "GZ-W03"
    is_said_by_rule = True

    def judge(self, found: Means) -> Finding | None:
        """Whether the numbers of the tag explain the speed."""
        real = self.drive.real_diameter()
        grown = 1.0 if real is None else real / self.drive.diameter
        wide = self.drive.separation / max(self.drive.real_separation(), 1e-6)
        forward, turning = _share(found, 0), _share(found, 1)
        if real is not None and _is_off(grown) and _explains(forward, grown):
            return Finding(
                text=f"{self._told(found, 0, 'drive', 'm/s')}: <wheelDiameter> is {self.drive.diameter:.3g} m, and its "
                f"wheels have {real:.3g} m. Write <wheelDiameter>{real:.3g}</wheelDiameter>"
            )
        if _is_off(wide) and _explains(turning, grown * wide):
            apart = self.drive.real_separation()
            return Finding(
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

    def judge(self, found: Means) -> Finding | None:
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
        return Finding(
            text=f"{self.model.name} is told to {speeds}, though its wheels turn as told: they slip. They bear "
            f"{bears:.0%} of its weight. Give them <mu1>1</mu1>, what drags on the floor <mu1>0</mu1>, and put "
            "the weight over them; or something is in the way"
        )


def _share(found: Means, which: int) -> float | None:
    """The speed as a share of what was told; None if that is too slow to say."""
    told = found.command[which]
    return None if abs(told) < SLOWEST[which] else found.moved[which] / told


def _is_off(share: float) -> bool:
    return abs(share - 1.0) > TOLERANCE


def _explains(measured: float | None, expected: float) -> bool:
    return measured is not None and abs(measured / expected - 1.0) < TOLERANCE
