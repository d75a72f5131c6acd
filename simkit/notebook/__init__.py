"""The command lines of ROS in a notebook: `%load_ext simkit`, then `%rosrun turtlesim turtlesim_node`.

They act on the newest open `Simulation` of the notebook; the first one makes one if there is none.
`lines` is what each does, and how IPython comes to know them.
"""

from simkit.notebook.lines import LINES, LineError, register

__all__ = ["LINES", "LineError", "register"]
