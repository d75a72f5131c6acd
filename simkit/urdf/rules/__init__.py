"""The rules of `simkit check_urdf`: what a teacher would say about a URDF file.

`read_robot` says what urdfdom makes of a file; the rules say what is wrong with it, where, what follows in this
kit and in Gazebo, and what would be right. `registry` lists them; each is a function whose docstring explains it.
"""

from simkit.urdf.rules.check import check_robot
from simkit.urdf.rules.companion import Companion, CompanionKind
from simkit.urdf.rules.registry import all_rules

__all__ = ["Companion", "CompanionKind", "all_rules", "check_robot"]
