"""libgazebo_ros_control.so: controllers of ros_control move the joints of a model.

Source: gazebo_ros_control `GazeboRosControlPlugin`, texts and order.
"""

from __future__ import annotations

from typing import Any

from simkit.graph import Subscription, Timer
from simkit.msgs import Duration, message_class
from simkit.plugins.control.hardware import make_hardware
from simkit.plugins.control.manager import ControllerManager
from simkit.plugins.control.services import ManagerServices
from simkit.plugins.control.transmission import read_transmissions
from simkit.plugins.plugin import Plugin
from simkit.plugins.site import Site
from simkit.plugins.tags import ControlParameters
from simkit.urdf import read_robot

POLL = Duration.from_nsec(100_000_000)
"""How often it looks for a robot that nobody has loaded yet."""
PATIENCE = 50
"""After so many looks it logs what could be wrong."""


class GazeboRosControl(Plugin[ControlParameters]):
    """The plugin: before a step controllers command the joints, after it they publish their state.

    The controllers see the time at which the step ends, as in Gazebo, so that a joint stands at the end
    of a step where the controller wants it at that time. It waits for the parameter with the URDF
    while the world goes on; Gazebo stands still meanwhile.
    """

    Parameters = ControlParameters

    def __init__(self, site: Site, parameters: ControlParameters) -> None:
        super().__init__(site, parameters)
        self.manager: ControllerManager | None = None
        """The controller manager; None while there is no robot description."""
        self._services: ManagerServices | None = None
        self._waiting: Timer | None = None
        self._looks = 0
        self._stop_subscription: Subscription | None = None
        self._is_stopped = self._was_stopped = self._has_updated = False
        self._step_ns = site.world.step_ns
        self._period_ns = self._step_ns
        self._next_ns = 0

    def on_attach(self) -> None:
        """Look for the robot description, and begin."""
        node, site = self.site.node, self.site
        node.info("Loading gazebo_ros_control plugin")
        self._choose_period()
        if self.parameters.e_stop_topic:
            topic = site.resolve(self.parameters.e_stop_topic)
            kind = message_class("std_msgs/Bool")
            self._stop_subscription = node.subscribe(topic, kind, self._on_stop, queue_size=1)
        space = site.robot_namespace or "/"
        node.info(f"Starting gazebo_ros_control plugin in namespace: {space}")
        node.info(
            "gazebo_ros_control plugin is waiting for model URDF in parameter "
            f"[{self._description_name()}] on the ROS param server."
        )
        self._waiting = node.create_timer(POLL, self._look)
        self._look()

    def before_step(self) -> None:
        """Read the joints, let controllers command them, and carry the commands out."""
        manager = self.manager
        if manager is None:
            return
        time_ns = self.site.now_ns + self._step_ns
        manager.hardware.is_stopped = self._is_stopped
        self._has_updated = time_ns >= self._next_ns
        if self._has_updated:
            self._next_ns = time_ns + self._period_ns
            manager.hardware.read()
            if self._was_stopped and not self._is_stopped:
                manager.restart(time_ns)
            self._was_stopped = self._is_stopped
            manager.update(time_ns, self._period_ns)
        manager.hardware.write(self._step_ns * 1e-9)

    def after_step(self) -> None:
        """Let controllers publish their state."""
        if self.manager is not None and self._has_updated:
            self.manager.publish(self.site.now_ns)

    def on_reset(self) -> None:
        """Update in the next step; the controllers go on."""
        self._next_ns = 0

    def on_detach(self) -> None:
        """End the controllers, and let the joints go."""
        if self._waiting is not None:
            self._waiting.cancel()
        if self._stop_subscription is not None:
            self._stop_subscription.unregister()
        if self._services is not None:
            self._services.close()
        if self.manager is not None:
            self.manager.close(self.site.now_ns)
            self.manager.hardware.release()
            self.manager = None

    def _choose_period(self) -> None:
        period_ns = round(self.parameters.control_period * 1e9)
        if not period_ns:
            return
        warning = (
            f"Desired controller update period ({period_ns / 1e9:.9f} s) is {{}} than the gazebo "
            f"simulation period ({self._step_ns / 1e9:.9f} s)."
        )
        if period_ns < self._step_ns:
            self.site.node.error(warning.format("faster"))
        elif period_ns > self._step_ns:
            self.site.node.warn(warning.format("slower"))
            self._period_ns = -(-period_ns // self._step_ns) * self._step_ns

    def _description_name(self) -> str:
        params, name = self.site.node.graph.params, self.parameters.robot_param
        return params.search(self.site.resolve(""), name) or name

    def _look(self) -> None:
        """Begin if there is a robot description."""
        name = self._description_name()
        text = self.site.node.graph.params.get(self.site.resolve(name), None)
        self._looks += 1
        if not isinstance(text, str) or not text:
            if self._looks == PATIENCE:
                self.site.node.warn(
                    f"hint: nothing is controlled, since nobody has set the parameter {name}: in the launch "
                    f'file, <param name="{name}" textfile="$(find my_package)/urdf/my_robot.urdf"/> must '
                    "stand outside of any <node>"
                )
            return
        if self._waiting is not None:
            self._waiting.cancel()
        self._begin(text, name)

    def _begin(self, text: str, name: str) -> None:
        node, site = self.site.node, self.site
        reading = read_robot(text, file=name)
        root = "" if site.robot_namespace == "" else f"/{site.robot_namespace}"
        if reading.document.root is None:
            node.error("Can't parse transmissions. Invalid robot description.")
            return
        transmissions = read_transmissions(reading.document.root, node.log)
        is_legacy = (
            site.element.child("robotSimType") is not None and self.parameters.legacy_mode_ns
        )
        hardware = make_hardware(
            node,
            site.model,
            reading.robot,
            transmissions,
            namespace=root,
            gains_namespace="" if is_legacy else root,
        )
        hardware.read()
        self.manager = ControllerManager(node, hardware, root)
        self._services = ManagerServices(node, self.manager, root)
        node.info("Loaded gazebo_ros_control.")

    def _on_stop(self, message: Any) -> None:
        self._is_stopped = message.data
