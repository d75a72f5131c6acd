"""The controller manager: who loads, starts, stops and unloads controllers.

Source: controller_manager `ControllerManager`, texts and order.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from simkit.graph import Node
from simkit.graph.names import is_legal_name
from simkit.plugins.control.advice import missing_type, unknown_type
from simkit.plugins.control.controller import Controller, ControllerState
from simkit.plugins.control.hardware import RobotHardware
from simkit.plugins.control.interfaces import FAMILIES, in_cpp
from simkit.plugins.control.place import ControllerPlace, InitError
from simkit.plugins.control.registry import ControllerEntry, controllers
from simkit.plugins.control.switching import Switch, SwitchRefused, plan_switch


@dataclass(frozen=True, slots=True, kw_only=True)
class Loaded:
    """A controller that is loaded."""

    entry: ControllerEntry
    """Its type."""
    place: ControllerPlace
    """What it was given."""
    controller: Controller
    """Itself."""


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
        self.loaded: dict[str, Loaded] = {}
        self._node = node
        self._root = root

    def update(self, time_ns: int, period_ns: int) -> None:
        """Let all controllers that run command the joints, for the step that ends at a time [ns]."""
        for one in self.loaded.values():
            if one.controller.is_running:
                one.controller.update(time_ns, period_ns)

    def publish(self, time_ns: int) -> None:
        """Let all controllers that run say how things stand, at the end of that step [ns]."""
        running = [one.controller for one in self.loaded.values() if one.controller.is_running]
        due = [one for one in running if one.is_due(time_ns)]
        if due:
            self.hardware.read()
        for one in due:
            one.publish(time_ns)

    def restart(self, time_ns: int) -> None:
        """Stop and start again all that run: the emergency stop was taken off."""
        for one in self.loaded.values():
            if one.controller.is_running:
                one.controller.stopping(time_ns)
                one.controller.starting(time_ns)

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
        entry = self._entry(name)
        return entry is not None and self._make(name, entry)

    def unload(self, name: str) -> bool:
        """Unload a controller that does not run; whether it could be."""
        one = self.loaded.get(name)
        if one is None or one.controller.is_running:
            why = "no controller with this name exists" if one is None else "it is still running"
            self._node.error(f"Could not unload controller with name '{name}' because {why}")
            return False
        one.place.close()
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
            if one.controller.is_running:
                one.controller.stopping(time_ns)
            one.place.close()
        self.loaded.clear()

    def _carry_out(self, switch: Switch, time_ns: int) -> None:
        self.hardware.read()  # a controller begins where the joints are
        for name in switch.stop:
            controller = self.loaded[name].controller
            if controller.is_running:
                controller.stopping(time_ns)
                controller.state = ControllerState.STOPPED
        for name in switch.start:
            controller = self.loaded[name].controller
            controller.starting(time_ns)
            controller.state = ControllerState.RUNNING

    def _entry(self, name: str) -> ControllerEntry | None:
        params, known = self._node.graph.params, controllers()
        kind = params.get(f"{self._root}/{name}/type", None)
        if not isinstance(kind, str):
            self._node.error(
                f"Could not load controller '{name}' because the type was not specified. Did you load "
                "the controller configuration on the parameter server (namespace: "
                f"'{self._root}/{name}')?"
            )
            self._node.warn(f"hint: {missing_type(params, self._root, name)}")
            return None
        if kind not in known:
            self._node.error(
                f"Could not load controller '{name}' because controller type '{kind}' does not exist."
            )
            self._node.error(
                "Use 'rosservice call controller_manager/list_controller_types' to get the available "
                "types"
            )
            self._node.warn(f"hint: {unknown_type(kind, known)}")
            return None
        return known[kind]

    def _make(self, name: str, entry: ControllerEntry) -> bool:
        place = ControllerPlace(
            self._node,
            self.hardware,
            root=self._root,
            name=name,
            type_name=entry.type_name,
            interface=entry.interface,
        )
        try:
            self._require_interface(entry)
            controller = entry.load()(place)
        except InitError as error:
            place.close()
            for text in error.texts:
                self._node.error(text)
            self._node.error(f"Initializing controller '{name}' failed")
            if error.hint:
                self._node.warn(f"hint: {error.hint}")
            return False
        self.loaded[name] = Loaded(entry=entry, place=place, controller=controller)
        return True

    def _require_interface(self, entry: ControllerEntry) -> None:
        if entry.interface not in self.hardware.interfaces:
            kind = entry.type_name.rpartition("/")[2]
            there = ", ".join(f"{family}/{kind}" for family in FAMILIES.values())
            raise InitError(
                f"This controller requires a hardware interface of type '{in_cpp(entry.interface)}'. "
                "Make sure this is registered in the hardware_interface::RobotHW class.",
                hint=f"no joint in Gazebo has a {entry.interface}: take one of {there}, and the "
                "interface of that name in the transmissions",
            )
