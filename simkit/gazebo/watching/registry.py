"""All kinds of watchers; a new one is a file and a line here."""

from __future__ import annotations

from simkit.gazebo.watching.blind_laser import BlindLaser
from simkit.gazebo.watching.drifting import Drifting
from simkit.gazebo.watching.joint_states import NoStates, TwoPublishers
from simkit.gazebo.watching.off_speed import Slipping, WrongSize
from simkit.gazebo.watching.start_height import StartHeight
from simkit.gazebo.watching.watcher import Watcher
from simkit.gazebo.watching.weak_joints import WeakJoints
from simkit.gazebo.watching.wheels_in_air import WheelsInAir
from simkit.gazebo.watching.wrong_way import WrongWay

WATCHERS: tuple[type[Watcher], ...] = (
    StartHeight,
    WheelsInAir,
    WrongWay,
    WrongSize,
    WeakJoints,
    Slipping,
    Drifting,
    TwoPublishers,
    NoStates,
    BlindLaser,
)
"""In the order in which they speak."""
