"""The command line of spawn_model.

Source: gazebo_ros `scripts/spawn_model`: options and their defaults.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from typing import Final, NoReturn

from simkit.errors import SimkitError
from simkit.urdf import Pose

USAGE: Final = (
    "usage: spawn_model (-urdf | -sdf) (-file FILE | -param PARAMETER) -model NAME\n"
    "                   [-x X] [-y Y] [-z Z] [-R ROLL] [-P PITCH] [-Y YAW] [-J JOINT POSITION]...\n"
    "                   [-reference_frame FRAME] [-robot_namespace NS] [-gazebo_namespace NS]\n"
    "                   [-unpause] [-wait MODEL] [-b]"
)


@dataclass(frozen=True, slots=True, kw_only=True)
class SpawnRequest:
    """What the command line asks for."""

    is_urdf: bool
    """Whether the model is URDF; otherwise it is SDF."""
    file: str | None
    """File that holds it."""
    param: str | None
    """Parameter that holds it, if no file does."""
    model: str
    """Name that it shall have."""
    pose: Pose
    """Where it shall be in the reference frame."""
    joints: tuple[tuple[str, float], ...]
    """Positions that joints shall have afterwards [rad or m]."""
    reference_frame: str
    """Model or link that the pose is relative to; the world if empty."""
    robot_namespace: str | None
    """Namespace of its plugins; that of the node if None."""
    gazebo: str
    """Where the services of the world are."""
    unpause: bool
    """Whether the world shall go on afterwards."""
    wait: str | None
    """Model that it waits for."""
    is_bound: bool
    """Whether the model goes when the node does."""


class SpawnUsageError(SimkitError):
    """A command line that cannot be."""


class _Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        raise SpawnUsageError(message)


def read_arguments(argv: list[str]) -> SpawnRequest:
    """What a command line asks for.

    Raises:
        SpawnUsageError: It cannot be.
    """
    parser = _Parser(add_help=False, allow_abbrev=False)
    kind = parser.add_mutually_exclusive_group(required=True)
    kind.add_argument("-urdf", action="store_true")
    kind.add_argument("-sdf", action="store_true")
    source = parser.add_mutually_exclusive_group(required=True)
    source.add_argument("-file")
    source.add_argument("-param")
    source.add_argument("-database")
    source.add_argument("-stdin", action="store_true")
    parser.add_argument("-model", required=True)
    for name in ("x", "y", "z", "R", "P", "Y"):
        parser.add_argument(f"-{name}", type=float, default=0.0)
    parser.add_argument("-J", dest="joints", nargs=2, action="append", default=[])
    parser.add_argument("-reference_frame", default="")
    parser.add_argument("-gazebo_namespace", default="/gazebo")
    parser.add_argument("-robot_namespace")
    parser.add_argument("-wait")
    parser.add_argument("-unpause", action="store_true")
    parser.add_argument("-package_to_model", action="store_true")
    parser.add_argument("-b", action="store_true")
    found = parser.parse_args(argv)
    if found.database is not None or found.stdin:
        raise SpawnUsageError(
            "models come from -file or -param here; there is no database and no standard input"
        )
    return SpawnRequest(
        is_urdf=found.urdf,
        file=found.file,
        param=found.param,
        model=found.model,
        pose=Pose(xyz=(found.x, found.y, found.z), rpy=(found.R, found.P, found.Y)),
        joints=tuple(_joint(*pair) for pair in found.joints),
        reference_frame=found.reference_frame,
        robot_namespace=found.robot_namespace,
        gazebo="/" + found.gazebo_namespace.strip("/"),
        unpause=found.unpause,
        wait=found.wait,
        is_bound=found.b,
    )


def _joint(name: str, text: str) -> tuple[str, float]:
    try:
        return name, float(text)
    except ValueError:
        raise SpawnUsageError(
            f"argument -J: {text!r} is no position of {name}: a number is needed"
        ) from None
