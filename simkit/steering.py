"""Widgets of a notebook that move a robot by hand: a teleop pad, and sliders for a trajectory controller."""

from __future__ import annotations

import weakref
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from simkit.errors import SimkitError
from simkit.graph import Graph, Node

if TYPE_CHECKING:
    from simkit.viz import LiveRviz, TeleopPad, TrajectorySliders, TurtlesimView


class Steering:
    """The part of `Simulation` that is moved by hand."""

    graph: Graph
    _node: Node
    _views: list[Callable[[], None]]

    def run(self, seconds: float) -> None:
        """Let virtual time pass [s]."""
        raise NotImplementedError

    def _free_name(self, base: str) -> str:
        raise NotImplementedError

    def teleop(
        self,
        topic: str = "/cmd_vel",
        linear: float = 0.5,
        *,
        angular: float = 1.0,
        step: float = 0.2,
        view: LiveRviz | TurtlesimView | None = None,
    ) -> TeleopPad:
        """Arrows that drive a robot or a turtle, by mouse or by the arrow keys.

        Args:
            topic: Topic of geometry_msgs/Twist, e.g. `/turtle1/cmd_vel`.
            linear: Speed of the arrows up and down [m/s].
            angular: Speed of the arrows to the left and right [rad/s].
            step: Virtual time that a press takes [s].
            view: Shown beside the arrows: `sim.rviz(live=True)` or `sim.turtlesim`.

        Raises:
            SimkitError: A speed or the step is no number from 0 on.
        """
        from simkit.viz import TeleopPad

        node = self.graph.create_node(self._free_name("/teleop"))
        pad = TeleopPad(
            node,
            self._node.resolve(topic),
            linear=linear,
            angular=angular,
            step=step,
            run=while_it_lives(self),
            view=view,
        )
        self._views.append(pad.refresh)
        return pad

    def trajectory_sliders(
        self,
        controller: str = "/arm_controller",
        *,
        duration: float = 1.0,
        description: str = "/robot_description",
    ) -> TrajectorySliders:
        """A slider for each joint of a trajectory controller, as rqt_joint_trajectory_controller has them.

        Args:
            controller: Name of the controller.
            duration: Virtual time that a motion takes [s].
            description: Parameter with the URDF of the robot, which has the limits.

        Raises:
            SimkitError: The controller has no parameter `joints`, there is no robot, or the duration is out of range.
            UnknownNameError: A joint of the controller is none of the robot.
        """
        from simkit.viz import TrajectorySliders, controlled_joints

        name = self._node.resolve(controller)
        joints = controlled_joints(self.graph, name, description=description)
        sliders = TrajectorySliders(
            self.graph.create_node(self._free_name("/trajectory_sliders")),
            name,
            joints,
            duration=duration,
            run=while_it_lives(self),
        )
        self._views.append(sliders.refresh)
        return sliders


def while_it_lives(sim: Any) -> Callable[[float], None]:
    """The `run` of a simulation. Widgets are never forgotten by their notebook, but a simulation must be."""
    living = weakref.ref(sim)

    def run(seconds: float) -> None:
        found = living()
        if found is None:
            raise SimkitError("this simulation is gone; the widgets of the newest one move it")
        found.run(seconds)

    return run
