"""Seeing: the RViz of this kit, its view_frames, time series, and a window of turtles.

Every picture is made once and does not change afterwards, but for those that are called live; it
shows itself in a notebook and is saved by `save("name.svg")`, or `.png`, or `.html`. What a picture
shows (a `scene`, a forest of `trees`) lies apart from how it is drawn: `draw` has what both SVG and PNG
are made of, and a `scene` is drawn by three.js in a browser
(`rviz_page`) and by `scene_raster` without one. Below it lie `topics` (displays of messages), `plots` (figures of
recordings), `trees`, `turtlesim`, `by_hand` (widgets that move robots).
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from simkit.viz.by_hand.controlled_joints import controlled_joints
    from simkit.viz.by_hand.teleop_pad import TeleopPad
    from simkit.viz.by_hand.trajectory_sliders import TrajectorySliders
    from simkit.viz.joint_sliders import JointSliders
    from simkit.viz.live_rviz import LiveRviz
    from simkit.viz.live_view import LiveView
    from simkit.viz.plots.joints import JointPlot, TrackingPlot
    from simkit.viz.plots.model_recording import ModelRecording
    from simkit.viz.plots.paths import PathPlot
    from simkit.viz.plots.transforms import TransformPlot, TransformSeries, transform_series
    from simkit.viz.robot_description import robot_displays
    from simkit.viz.rviz_replay import RvizReplay
    from simkit.viz.rviz_settings import RvizSettings
    from simkit.viz.rviz_view import RvizView
    from simkit.viz.scene_source import SceneSource
    from simkit.viz.topics.displays import display_of, displays_of
    from simkit.viz.topics.ears import RvizEars
    from simkit.viz.trees.frames import FramesPicture
    from simkit.viz.trees.robot import RobotTree
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
    "FramesPicture": "trees.frames",
    "JointPlot": "plots.joints",
    "JointSliders": "joint_sliders",
    "LiveRviz": "live_rviz",
    "LiveView": "live_view",
    "ModelRecording": "plots.model_recording",
    "PathPlot": "plots.paths",
    "RobotTree": "trees.robot",
    "RvizEars": "topics.ears",
    "RvizReplay": "rviz_replay",
    "RvizSettings": "rviz_settings",
    "RvizView": "rviz_view",
    "SceneSource": "scene_source",
    "TeleopPad": "by_hand.teleop_pad",
    "TrackingPlot": "plots.joints",
    "TrajectorySliders": "by_hand.trajectory_sliders",
    "TransformPlot": "plots.transforms",
    "TransformSeries": "plots.transforms",
    "TurtleReplay": "turtlesim.replay",
    "TurtlesimView": "turtlesim.view",
    "controlled_joints": "by_hand.controlled_joints",
    "display_of": "topics.displays",
    "displays_of": "topics.displays",
    "robot_displays": "robot_description",
    "transform_series": "plots.transforms",
}


def __getattr__(name: str) -> Any:
    # Loaded when first used: who draws nothing loads nothing.
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(f"{__name__}.{_HOMES[name]}"), name)
