"""How much room a robot takes, however its joints are moved: so that a camera need not follow it."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from typing import Final

import numpy as np

from simkit.errors import SimkitError
from simkit.geometry import Vector
from simkit.urdf import Joint, JointType
from simkit.urdf.kinematics import forward_kinematics
from simkit.viz.stage.frames import FramePose
from simkit.viz.stage.robot import RobotInTf
from simkit.viz.stage.scene import corners
from simkit.viz.stage.solid import Solid

_TRIALS: Final = 60
"So many positions of all joints are tried."
_MOST_SOLIDS: Final = 60
"Of a robot with more shapes, every second one is looked at, or every third, and so on."
_PRIMES: Final = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37)
_SIDES: Final = tuple(side for side in itertools.product((-1, 0, 1), repeat=3) if any(side))


def robot_room(model: RobotInTf, solids: Sequence[Solid]) -> tuple[Vector, ...]:
    """Points on the outside of everywhere that a robot gets to, in the frame of its root [m].

    Args:
        model: The robot.
        solids: Its shapes, and perhaps those of others.
    """
    points = list(_points(model, solids[:: 1 + len(solids) // _MOST_SOLIDS]))
    if not points:
        return ()
    x, y, z = np.array(points).T
    # Sums in a fixed order, and the first of equals: the same points on every machine.
    farthest = [int(np.argmax(a * x + b * y + c * z)) for a, b, c in _SIDES]
    return tuple(dict.fromkeys(points[number] for number in farthest))


def _points(model: RobotInTf, solids: Sequence[Solid]) -> Iterator[Vector]:
    """The corners of the boxes around all shapes, for many positions of the joints."""
    robot = model.robot
    moving = [joint for joint in robot.joints.values() if joint.moves and joint.mimic is None]
    for trial in range(_TRIALS if moving else 1):
        positions = {joint.name: _position(joint, n, trial) for n, joint in enumerate(moving)}
        try:
            found = forward_kinematics(robot, positions)
        except SimkitError:
            return  # joints that mimic each other in a circle
        links = {model.frame(link): pose for link, pose in found.items()}
        for solid in solids:
            if solid.link in links:
                origin, rotation = links[solid.link]
                frame = FramePose(name="", parent=None, origin=origin, rotation=rotation)
                yield from corners(solid, frame)


def _position(joint: Joint, number: int, trial: int) -> float:
    """Where a joint stands [rad or m]; over all trials the joints are spread evenly, each in its own rhythm."""
    share = math.modf(trial * math.sqrt(_PRIMES[number % len(_PRIMES)]))[0]
    if joint.type is JointType.CONTINUOUS or joint.limit is None:
        return math.pi * (2.0 * share - 1.0)
    return joint.limit.lower + share * (joint.limit.upper - joint.limit.lower)
