"""Gazebo: a world of physics on the clock of a simulation, with the plugins, services and topics of gazebo_ros.

Read it in this order: `server` (the world and what is in it), `models` and `plugin_loader` (how a robot
comes into it), `services` and `topics` (what ROS sees of it); then the programs, `gzserver` and `spawn_model`.
"""

from simkit.gazebo.models import Spawned, SpawnError
from simkit.gazebo.server import Gazebo

__all__ = ["Gazebo", "SpawnError", "Spawned"]
