"""`simkit urdf_to_graphiz`: the tree of a robot as a drawing.

Source: urdf_to_graphiz of urdfdom (so it is spelt in Melodic and Noetic; urdf_to_graphviz later): NAME.gv and NAME.pdf,
named after the robot, in the folder where it was typed.
"""

from __future__ import annotations

import argparse
from pathlib import Path

from simkit.commands.command import Answer, parsed


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The file."""
    parser.epilog = "Writes ROBOT.gv, for graphviz, and ROBOT.pdf into this folder."
    parser.add_argument("file", metavar="FILE", type=Path, help="a URDF")


def _answer(arguments: argparse.Namespace) -> Answer:
    from simkit.urdf.loader import (
        read_robot_file,
        robot_of,
    )  # slow to load, and not needed for the help
    from simkit.viz.trees.robot import RobotTree

    robot = robot_of(read_robot_file(arguments.file))
    for suffix in (".gv", ".pdf"):
        file = Path(f"{robot.name}{suffix}")
        RobotTree(robot).save(file)
        yield f"Created file {file}\n"
    return 0


run = parsed("urdf_to_graphiz", add_arguments, _answer)
