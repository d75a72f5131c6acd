"""The words that a course on ROS types in a terminal: the commands, two shorthands, and what is not here."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from simkit.commands.table import COMMANDS, THIS_INSTALLATION

_GRAPH = "simkit rosnode list and simkit rosnode info NODE say who talks to whom"
_PICTURES = "in a notebook, sim.plot() draws topics over time"

SHORTHANDS: Mapping[str, Callable[[Sequence[str]], list[str]]] = {
    "rviz": lambda words: ["rosrun", "rviz", "rviz", *words],
    "gazebo": lambda words: [
        "roslaunch",
        "gazebo_ros",
        "empty_world.launch",
        *(f"world_name:={word}" if ":=" not in word else word for word in words[:1]),
        *words[1:],
    ],
    "urdf_to_graphviz": lambda words: ["urdf_to_graphiz", *words],
}
"""Programs of ROS that are another command here, and its words."""

ABSENT: Mapping[str, str] = {
    "catkin_make": "nothing has to be built here: a package runs as it lies, and simkit rospack find PACKAGE says whether"
    " it is found",
    "rosbag": "in a notebook, sim.record() keeps what a topic carries",
    "rosdep": "nothing has to be installed for a package here",
    "roswtf": "simkit doctor looks at this installation, simkit check_urdf at a robot",
    "rqt": _GRAPH,
    "rqt_console": "each node's log is printed where the node was started",
    "rqt_graph": _GRAPH,
    "rqt_image_view": "no camera is simulated here, so there is no image to look at",
    "rqt_plot": _PICTURES,
    "rqt_tf_tree": "simkit rosrun tf view_frames draws the tree of frames",
}
"""Programs of ROS that simkit lacks, and what to use."""


def all_words() -> list[str]:
    """Every word that a terminal learns, sorted: `env` and `shell` of simkit have the names of other programs."""
    of_ros = (name for name, entry in COMMANDS.items() if entry.group != THIS_INSTALLATION)
    return sorted({"grader", "simkit", *of_ros, *SHORTHANDS, *ABSENT})
