"""turtlesim: turtles that drive, draw and meet walls, as nodes of the graph and as plain objects.

Read it in this order: `window`, `paper`, `turtle`, `frame` (pure), then `node` (in the graph). How it looks is
`simkit.viz.turtlesim`.
"""

from simkit.nodes.turtlesim.draw_square import DrawSquare
from simkit.nodes.turtlesim.frame import Frame, TurtleExistsError
from simkit.nodes.turtlesim.mimic import TurtleMimic
from simkit.nodes.turtlesim.node import TurtlesimNode
from simkit.nodes.turtlesim.paper import Paper, PaperSheet, Stroke
from simkit.nodes.turtlesim.state import Pen, PoseSample, TurtlePose, TurtleReading, Velocity
from simkit.nodes.turtlesim.teleop import TurtleTeleop
from simkit.nodes.turtlesim.turtle import Turtle

__all__ = [
    "DrawSquare",
    "Frame",
    "Paper",
    "PaperSheet",
    "Pen",
    "PoseSample",
    "Stroke",
    "Turtle",
    "TurtleExistsError",
    "TurtleMimic",
    "TurtlePose",
    "TurtleReading",
    "TurtleTeleop",
    "TurtlesimNode",
    "Velocity",
]
