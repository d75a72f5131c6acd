"""Seeing: the RViz of this kit, its view_frames, time series, and a window of turtles.

Every picture is made once and does not change afterwards, but for those that are called live; it
shows itself in a notebook and is saved by `save("name.svg")`, or `.png`, or `.html`. What a picture
shows (`scene`, `forest`, `transform_series`, `turtle_tape`) lies apart from how it is drawn:
`drawing` is what both SVG and PNG are made of, and a `scene` is drawn by three.js in a browser
(`rviz_page`) and by `scene_raster` without one.
"""

from simkit.viz.frames_picture import FramesPicture
from simkit.viz.joint_sliders import JointSliders
from simkit.viz.live_rviz import LiveRviz
from simkit.viz.live_view import LiveView
from simkit.viz.robot_tree import RobotTree
from simkit.viz.rviz_program import RvizProgram
from simkit.viz.rviz_replay import RvizReplay
from simkit.viz.rviz_settings import RvizSettings
from simkit.viz.rviz_view import RvizView
from simkit.viz.scene_source import SceneSource
from simkit.viz.transform_plot import TransformPlot
from simkit.viz.transform_series import TransformSeries, transform_series
from simkit.viz.turtle_replay import TurtleReplay
from simkit.viz.turtlesim_view import TurtlesimView

__all__ = [
    "FramesPicture",
    "JointSliders",
    "LiveRviz",
    "LiveView",
    "RobotTree",
    "RvizProgram",
    "RvizReplay",
    "RvizSettings",
    "RvizView",
    "SceneSource",
    "TransformPlot",
    "TransformSeries",
    "TurtleReplay",
    "TurtlesimView",
    "transform_series",
]
