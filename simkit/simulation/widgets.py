"""Widgets of a notebook that move a robot by hand: a teleop pad, and sliders for a trajectory controller."""

from __future__ import annotations

import weakref
from collections.abc import Callable
from typing import TYPE_CHECKING

from simkit.errors import SimkitError
from simkit.graph.names import free_name

if TYPE_CHECKING:
    from simkit.nodes.joint_state_publisher import JointStatePublisherGui
    from simkit.simulation.simulation import Simulation
    from simkit.viz import JointSliders, LiveRviz, TeleopPad, TrajectorySliders, TurtlesimView


class Widgets:
    """The part of a `Simulation` that is moved by hand.

    Args:
        sim: The simulation.
    """

    def __init__(self, sim: Simulation) -> None:
        self._sim: Simulation = weakref.proxy(sim)
        self._sliders: list[JointSliders] = []

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

        node = self._sim.graph.create_node(free_name("/teleop", self._sim.graph.nodes))
        pad = TeleopPad(
            node,
            self._sim.node.resolve(topic),
            linear=linear,
            angular=angular,
            step=step,
            run=while_it_lives(self._sim),
            view=view,
        )
        self._sim.view.add(pad.refresh)
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

        name = self._sim.node.resolve(controller)
        joints = controlled_joints(self._sim.graph, name, description=description)
        sliders = TrajectorySliders(
            self._sim.graph.create_node(free_name("/trajectory_sliders", self._sim.graph.nodes)),
            name,
            joints,
            duration=duration,
            run=while_it_lives(self._sim),
            picture=self._robot_picture(),
            view=self._robot_view(),
        )
        self._sim.view.add(sliders.refresh)
        return sliders

    def joint_sliders(self, node: str | None = None) -> JointSliders:
        """The sliders of a joint_state_publisher_gui that runs here; moving one moves the simulation.

        Args:
            node: Resolved name of its node; the newest one if None.

        Raises:
            SimkitError: None runs, or none of that name.
        """
        from simkit.viz import JointSliders

        gui = self._newest_gui(node)
        for known in self._sliders:
            if known.gui is gui:
                return known
        sliders = JointSliders(
            gui,
            run=while_it_lives(self._sim),
            picture=self._robot_picture(),
            view=self._robot_view(),
        )
        self._sliders.append(sliders)
        self._sim.view.add(sliders.refresh)
        return sliders

    def _robot_picture(self) -> Callable[[], bytes]:
        """What makes a small picture of the robots as they stand."""
        from simkit.viz import RvizSettings, RvizView

        source = self._sim.view.scene_source(RvizSettings(fixed_frame=""))
        return lambda: RvizView(source.scene()).thumbnail()

    def _robot_view(self) -> LiveRviz:
        """A live view of the robots."""
        from simkit.viz import RvizSettings

        return self._sim.view.live_rviz(RvizSettings(fixed_frame="", show_tf=False))

    def _newest_gui(self, node: str | None) -> JointStatePublisherGui:
        from simkit.nodes.joint_state_publisher import JointStatePublisherGui

        for builtin in reversed(self._sim.builtins):
            program = builtin.program
            if not (isinstance(program, JointStatePublisherGui) and builtin.alive):
                continue
            if node in (None, builtin.name):
                return program
        raise SimkitError(
            f"no joint_state_publisher_gui runs{f' as {node}' if node else ''}: "
            "sim.rosrun('joint_state_publisher_gui', 'joint_state_publisher_gui')"
        )


def while_it_lives(sim: Simulation) -> Callable[[float], None]:
    """The `run` of a simulation. Widgets are never forgotten by their notebook, but a simulation must be.

    Args:
        sim: A weak proxy of it.
    """

    def run(seconds: float) -> None:
        try:
            sim.run(seconds)
        except ReferenceError:
            raise SimkitError(
                "this simulation is gone; the widgets of the newest one move it"
            ) from None

    return run
