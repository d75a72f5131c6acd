"""Seeing: the RViz of this kit, its view_frames, time series, and a window of turtles.

Every picture is made once and does not change afterwards, but for those that are called live; it
shows itself in a notebook and is saved by `save("name.svg")`, or `.png`, or `.html`. What a picture
shows (`scene`, `forest`, `transform_series`, `turtle_tape`) lies apart from how it is drawn:
`drawing` is what both SVG and PNG are made of, and a `scene` is drawn by three.js in a browser
(`rviz_page`) and by `scene_raster` without one. Below it lie `topics` (displays of messages), `plots` (figures of
recordings), `by_hand` (widgets that move robots).
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from simkit.viz.by_hand.controlled_joints import controlled_joints
    from simkit.viz.by_hand.teleop_pad import TeleopPad
    from simkit.viz.by_hand.trajectory_sliders import TrajectorySliders
    from simkit.viz.frames_picture import FramesPicture
    from simkit.viz.joint_sliders import JointSliders
    from simkit.viz.live_rviz import LiveRviz
    from simkit.viz.live_view import LiveView
    from simkit.viz.plots.joint_plot import JointPlot
    from simkit.viz.plots.model_recording import ModelRecording
    from simkit.viz.plots.path_plot import PathPlot
    from simkit.viz.plots.tracking_plot import TrackingPlot
    from simkit.viz.robot_description import robot_displays
    from simkit.viz.robot_tree import RobotTree
    from simkit.viz.rviz_replay import RvizReplay
    from simkit.viz.rviz_settings import RvizSettings
    from simkit.viz.rviz_view import RvizView
    from simkit.viz.scene_source import SceneSource
    from simkit.viz.topics.displays import display_of, displays_of
    from simkit.viz.topics.ears import RvizEars
    from simkit.viz.transform_plot import TransformPlot
    from simkit.viz.transform_series import TransformSeries, transform_series
    from simkit.viz.turtlesim.replay import TurtleReplay
    from simkit.viz.turtlesim.view import TurtlesimView

__all__ = [
    "FramesPicture",
    "JointPlot",
    "JointSliders",
    "LiveRviz",
    "LiveView",
    "ModelRecording",
    "PathPlot",
    "RobotTree",
    "RvizEars",
    "RvizReplay",
    "RvizSettings",
    "RvizView",
    "SceneSource",
    "TeleopPad",
    "TrackingPlot",
    "TrajectorySliders",
    "TransformPlot",
    "TransformSeries",
    "TurtleReplay",
    "TurtlesimView",
    "controlled_joints",
    "display_of",
    "displays_of",
    "robot_displays",
    "transform_series",
]

_HOMES = {
    "FramesPicture": "frames_picture",
    "JointPlot": "plots.joint_plot",
    "JointSliders": "joint_sliders",
    "LiveRviz": "live_rviz",
    "LiveView": "live_view",
    "ModelRecording": "plots.model_recording",
    "PathPlot": "plots.path_plot",
    "RobotTree": "robot_tree",
    "RvizEars": "topics.ears",
    "RvizReplay": "rviz_replay",
    "RvizSettings": "rviz_settings",
    "RvizView": "rviz_view",
    "SceneSource": "scene_source",
    "TeleopPad": "by_hand.teleop_pad",
    "TrackingPlot": "plots.tracking_plot",
    "TrajectorySliders": "by_hand.trajectory_sliders",
    "TransformPlot": "transform_plot",
    "TransformSeries": "transform_series",
    "TurtleReplay": "turtlesim.replay",
    "TurtlesimView": "turtlesim.view",
    "controlled_joints": "by_hand.controlled_joints",
    "display_of": "topics.displays",
    "displays_of": "topics.displays",
    "robot_displays": "robot_description",
    "transform_series": "transform_series",
}


def __getattr__(name: str) -> Any:
    # Loaded when first used: who draws nothing loads nothing.
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(f"{__name__}.{_HOMES[name]}"), name)
