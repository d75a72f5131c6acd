"""Seeing: the RViz of this kit, the window of Gazebo, view_frames, time series, and a window of turtles.

Every picture is made once and does not change afterwards, but for those that are called live; it
shows itself in a notebook and is saved by `save("name.svg")`, or `.png`, or `.html`. In 2D, `draw` has what both
SVG and PNG are made of; `trees`, `plots` and `turtlesim` are drawn with it. In 3D, `stage` has the scene, `page`
shows it in a browser and `still` without one; `view` hands it to people. A scene over time is a `tape`,
which a `replay` plays. `widgets` move robots by hand.
"""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from simkit.viz.plots.joints import JointPlot, TrackingPlot
    from simkit.viz.plots.model_recording import ModelRecording
    from simkit.viz.plots.paths import PathPlot
    from simkit.viz.plots.transforms import TransformPlot, TransformSeries, transform_series
    from simkit.viz.rviz_tape import RvizReplay
    from simkit.viz.stage.rviz_settings import RvizSettings, display_of, displays_of, robot_displays
    from simkit.viz.stage.rviz_source import SceneSource
    from simkit.viz.stage.topic_listener import TopicListeners
    from simkit.viz.stage.world_scene import WorldSettings
    from simkit.viz.stage.world_source import WorldSource
    from simkit.viz.trees.frames import FramesPicture
    from simkit.viz.trees.robot import RobotTree
    from simkit.viz.turtlesim.replay import TurtleReplay
    from simkit.viz.turtlesim.view import LiveView, TurtlesimView
    from simkit.viz.view import LiveRviz, LiveWorld, RvizView, WorldView
    from simkit.viz.widgets.joint_sliders import JointSliders
    from simkit.viz.widgets.teleop_pad import TeleopPad
    from simkit.viz.widgets.trajectory_sliders import TrajectorySliders, controlled_joints
    from simkit.viz.world_recording import WorldTape
    from simkit.viz.world_tape import WorldReplay

__all__ = [
    "FramesPicture",
    "JointPlot",
    "JointSliders",
    "LiveRviz",
    "LiveView",
    "LiveWorld",
    "ModelRecording",
    "PathPlot",
    "RobotTree",
    "RvizReplay",
    "RvizSettings",
    "RvizView",
    "SceneSource",
    "TeleopPad",
    "TopicListeners",
    "TrackingPlot",
    "TrajectorySliders",
    "TransformPlot",
    "TransformSeries",
    "TurtleReplay",
    "TurtlesimView",
    "WorldReplay",
    "WorldSettings",
    "WorldSource",
    "WorldTape",
    "WorldView",
    "controlled_joints",
    "display_of",
    "displays_of",
    "robot_displays",
    "transform_series",
]

_HOMES = {
    "FramesPicture": "trees.frames",
    "JointPlot": "plots.joints",
    "JointSliders": "widgets.joint_sliders",
    "LiveRviz": "view",
    "LiveView": "turtlesim.view",
    "LiveWorld": "view",
    "ModelRecording": "plots.model_recording",
    "PathPlot": "plots.paths",
    "RobotTree": "trees.robot",
    "TopicListeners": "stage.topic_listener",
    "RvizReplay": "rviz_tape",
    "RvizSettings": "stage.rviz_settings",
    "RvizView": "view",
    "SceneSource": "stage.rviz_source",
    "TeleopPad": "widgets.teleop_pad",
    "TrackingPlot": "plots.joints",
    "TrajectorySliders": "widgets.trajectory_sliders",
    "TransformPlot": "plots.transforms",
    "TransformSeries": "plots.transforms",
    "TurtleReplay": "turtlesim.replay",
    "TurtlesimView": "turtlesim.view",
    "WorldReplay": "world_tape",
    "WorldSettings": "stage.world_scene",
    "WorldSource": "stage.world_source",
    "WorldTape": "world_recording",
    "WorldView": "view",
    "controlled_joints": "widgets.trajectory_sliders",
    "display_of": "stage.rviz_settings",
    "displays_of": "stage.rviz_settings",
    "robot_displays": "stage.rviz_settings",
    "transform_series": "plots.transforms",
}


def __getattr__(name: str) -> Any:
    # Loaded when first used: who draws nothing loads nothing.
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(f"{__name__}.{_HOMES[name]}"), name)
