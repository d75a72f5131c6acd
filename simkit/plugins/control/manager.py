"""The controller manager: who loads, starts, stops and unloads controllers.

Source: controller_manager `ControllerManager`, texts and order.
"""

from __future__ import annotations

from collections.abc import Sequence

from simkit.errors import near_names
from simkit.graph import Node
from simkit.graph.names import is_legal_name
from simkit.plugins.control.controller import Controller, ControllerState, InitError
from simkit.plugins.control.hardware import RobotHardware
from simkit.plugins.control.registry import (
    CONTROLLER_TYPES,
    FAMILIES,
    INTERFACES,
    STATE,
    ControllerType,
    in_cpp,
)
from simkit.plugins.control.switch import Switch, SwitchRefused, plan_switch


class ControllerManager:
    """Controllers of one robot, by name in the order in which they were loaded.

    A switch happens at once, between two steps; the original waits for the next step.

    Args:
        node: The node in which they work.
        hardware: The joints.
        root: The namespace, without a slash at its end; empty at the root.
    """

    def __init__(self, node: Node, hardware: RobotHardware, root: str) -> None:
        self.hardware = hardware
        self.loaded: dict[str, Controller] = {}
        self._node = node
        self._root = root

    def update(self, time_ns: int, period_ns: int) -> None:
        """Let all controllers that run command the joints, for the step that ends at a time [ns]."""
        for one in self.loaded.values():
            if one.is_running:
                one.update(time_ns, period_ns)

    def publish(self, time_ns: int) -> None:
        """Let all controllers that run publish their state, at the end of that step [ns]."""
        due = [one for one in self.loaded.values() if one.is_running and one.is_due(time_ns)]
        if due:
            self.hardware.read()
        for one in due:
            one.publish(time_ns)

    def restart(self, time_ns: int) -> None:
        """Stop and start again all that run: the emergency stop was taken off."""
        for one in self.loaded.values():
            if one.is_running:
                one.stopping(time_ns)
                one.starting(time_ns)

    def load(self, name: str) -> bool:
        """Load a controller, and say what is wrong if it cannot be; whether it could."""
        if name in self.loaded:
            self._node.error(
                f"A controller named '{name}' was already loaded inside the controller manager"
            )
            return False
        if not name or not is_legal_name(f"/{name}"):
            self._node.error(
                f"Exception thrown while constructing nodehandle for controller with name '{name}':\n"
                "a name has letters, digits, _ and /, and begins with a letter"
            )
            return False
        kind = self._type_of(name)
        return kind is not None and self._init(name, kind)

    def unload(self, name: str) -> bool:
        """Unload a controller that does not run; whether it could be."""
        one = self.loaded.get(name)
        if one is None or one.is_running:
            why = "no controller with this name exists" if one is None else "it is still running"
            self._node.error(f"Could not unload controller with name '{name}' because {why}")
            return False
        one.close()
        del self.loaded[name]
        return True

    def switch(
        self, start: Sequence[str], stop: Sequence[str], *, strictness: int, time_ns: int
    ) -> bool:
        """Stop controllers and start others, all of it or nothing; whether it was done.

        Args:
            start: Names of those to be started.
            stop: Names of those to be stopped.
            strictness: STRICT or BEST_EFFORT of SwitchController.
            time_ns: Now [ns].
        """
        try:
            switch = plan_switch(self.loaded, start, stop, strictness, self._node.warn)
        except SwitchRefused as refusal:
            self._node.error(str(refusal))
            if refusal.hint:
                self._node.warn(f"hint: {refusal.hint}")
            return False
        self._carry_out(switch, time_ns)
        return True

    def close(self, time_ns: int) -> None:
        """Stop and unload all."""
        for one in self.loaded.values():
            if one.is_running:
                one.stopping(time_ns)
            one.close()
        self.loaded.clear()

    def _carry_out(self, switch: Switch, time_ns: int) -> None:
        self.hardware.read()  # a controller begins where the joints are
        for name in switch.stop:
            controller = self.loaded[name]
            if controller.is_running:
                controller.stopping(time_ns)
                controller.state = ControllerState.STOPPED
        for name in switch.start:
            controller = self.loaded[name]
            controller.starting(time_ns)
            controller.state = ControllerState.RUNNING

    def _type_of(self, name: str) -> ControllerType | None:
        kind = self._node.graph.params.get(f"{self._root}/{name}/type", None)
        if not isinstance(kind, str):
            self._node.error(
                f"Could not load controller '{name}' because the type was not specified. Did you load "
                "the controller configuration on the parameter server (namespace: "
                f"'{self._root}/{name}')?"
            )
            self._node.warn(f"hint: {self._why_no_type(name)}")
            return None
        if kind not in CONTROLLER_TYPES:
            self._node.error(
                f"Could not load controller '{name}' because controller type '{kind}' does not exist."
            )
            self._node.error(
                "Use 'rosservice call controller_manager/list_controller_types' to get the available "
                "types"
            )
            near = near_names(kind, CONTROLLER_TYPES)
            there = f"there are: {', '.join(sorted(CONTROLLER_TYPES))}"
            self._node.warn(f"hint: {f'did you mean {near[0]}?' if near else there}")
            return None
        return CONTROLLER_TYPES[kind]

    def _why_no_type(self, name: str) -> str:
        """Why there is no type for a controller on the parameter server."""
        root = self._root
        here = self._node.graph.params.get(root or "/", {})
        tree = here if isinstance(here, dict) else {}
        known = sorted(
            name for name, value in tree.items() if isinstance(value, dict) and "type" in value
        )
        near = near_names(name, known)
        if near:
            return (
                f"there are parameters for {near[0]}, and none for {name}: the name in the YAML file and "
                "the one given to the spawner must be the same"
            )
        there = f"; there are parameters for: {', '.join(known)}" if known else ""
        return (
            f"nobody has set {root}/{name}/type: load the YAML file before, with "
            f'<rosparam file="..." command="load"/> in the launch file{there}'
        )

    def _init(self, name: str, kind: ControllerType) -> bool:
        controller = kind.load()(self._node, self.hardware, root=self._root, name=name, type_=kind)
        try:
            self._require_interface(kind)
            controller.init()
        except InitError as error:
            controller.close()
            for text in error.texts:
                self._node.error(text)
            self._node.error(f"Initializing controller '{name}' failed")
            if error.hint:
                self._node.warn(f"hint: {error.hint}")
            return False
        self.loaded[name] = controller
        return True

    def _require_interface(self, kind: ControllerType) -> None:
        if kind.interface not in (*INTERFACES, STATE):
            there = ", ".join(f"{family}/{kind.bare_name}" for family in FAMILIES.values())
            raise InitError(
                f"This controller requires a hardware interface of type '{in_cpp(kind.interface)}'. "
                "Make sure this is registered in the hardware_interface::RobotHW class.",
                hint=f"no joint in Gazebo has a {kind.interface}: take one of {there}, and the "
                "interface of that name in the transmissions",
            )
