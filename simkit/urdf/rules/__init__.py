"""The rules of `simkit check_urdf`: what a teacher would say about a URDF file.

`read_robot` says what urdfdom makes of a file; the rules say what is wrong with it, where, what follows in this
kit and in Gazebo, and what would be right. `check` runs them; each is a generator whose docstring explains it.
"""

from simkit.urdf.rules.check import all_rules, check_robot
from simkit.urdf.rules.sheet import Companion, CompanionKind

__all__ = ["Companion", "CompanionKind", "all_rules", "check_robot"]
