"""Launch files: `evaluate` says what one comes to, without doing it.

One file a subject: `substitution` replaces `$(...)`, each kind of tag has its handler, `walk` goes through them,
and `state` gathers what they find. What cannot be used is a `LaunchError`, in the words of roslaunch and in ours.
"""

from simkit.launch.errors import LaunchError
from simkit.launch.evaluate import evaluate
from simkit.launch.file_search import find_launch_file, given_arguments
from simkit.launch.launch import Launch
from simkit.launch.parameters import robot_lines
from simkit.launch.plan import LaunchPlan, PlannedNode
from simkit.launch.summary import summary_of

__all__ = [
    "Launch",
    "LaunchError",
    "LaunchPlan",
    "PlannedNode",
    "evaluate",
    "find_launch_file",
    "given_arguments",
    "robot_lines",
    "summary_of",
]
