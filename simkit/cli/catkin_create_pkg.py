"""`simkit catkin_create_pkg`: a folder that is a ROS package."""

from __future__ import annotations

import argparse


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Name and dependencies, as the original takes them."""
    parser.add_argument("name", metavar="NAME", help="of the package, e.g. hello_ros")
    parser.add_argument("dependencies", metavar="DEPENDENCY", nargs="*", help="e.g. rospy tf")


def run(arguments: argparse.Namespace) -> int:
    """Make the package in the working folder, and say what was made."""
    from simkit.new_package import create_package

    print(create_package(arguments.name, arguments.dependencies))
    return 0
