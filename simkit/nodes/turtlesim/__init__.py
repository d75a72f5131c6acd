"""turtlesim: turtles that drive, draw and meet walls, as nodes of the graph and as plain objects.

Read it in this order: `window`, `turtle`, `frame` (pure); `endpoints`, `node` (in the graph); then
`picture`.
"""

from simkit.nodes.turtlesim.draw_square import DrawSquare
from simkit.nodes.turtlesim.frame import Frame, TurtleExistsError
from simkit.nodes.turtlesim.mimic import Mimic
from simkit.nodes.turtlesim.node import TurtlesimNode
from simkit.nodes.turtlesim.paper import Paper, Sheet, Stroke
from simkit.nodes.turtlesim.pen import Pen
from simkit.nodes.turtlesim.picture import Picture
from simkit.nodes.turtlesim.state import PoseSample, Reading, TurtlePose, Velocity
from simkit.nodes.turtlesim.teleop import TurtleTeleop
from simkit.nodes.turtlesim.turtle import Turtle

__all__ = [
    "DrawSquare",
    "Frame",
    "Mimic",
    "Paper",
    "Pen",
    "Picture",
    "PoseSample",
    "Reading",
    "Sheet",
    "Stroke",
    "Turtle",
    "TurtleExistsError",
    "TurtlePose",
    "TurtleTeleop",
    "TurtlesimNode",
    "Velocity",
]
