"""The services of a controller manager.

Source: controller_manager, `...Srv`.
"""

from __future__ import annotations

from typing import Any

from simkit.graph import Node, ServiceServer
from simkit.msgs import message_class, service_class
from simkit.plugins.control.controller import Controller
from simkit.plugins.control.manager import ControllerManager
from simkit.plugins.control.registry import CONTROLLER_TYPES, in_cpp
from simkit.plugins.control.switch import BEST_EFFORT

_BASE = "controller_interface"
_MSGS = "controller_manager_msgs"


class ManagerServices:
    """Answers for a controller manager.

    Args:
        node: Who answers.
        manager: The manager.
        root: Its namespace, without a slash at its end; empty at the root.
    """

    def __init__(self, node: Node, manager: ControllerManager, root: str) -> None:
        self._node = node
        self._manager = manager
        self._servers: list[ServiceServer] = []
        for name, kind, handler in (
            ("list_controllers", "ListControllers", self._list),
            ("list_controller_types", "ListControllerTypes", self._list_types),
            ("load_controller", "LoadController", self._load),
            ("unload_controller", "UnloadController", self._unload),
            ("switch_controller", "SwitchController", self._switch),
            ("reload_controller_libraries", "ReloadControllerLibraries", self._reload),
        ):
            found = service_class(f"{_MSGS}/{kind}")
            server = node.advertise_service(
                f"{root}/controller_manager/{name}", found, _bound(found, handler)
            )
            self._servers.append(server)

    def close(self) -> None:
        """Answer no more."""
        for server in self._servers:
            server.unregister()

    @property
    def _now_ns(self) -> int:
        return self._node.graph.executor.now_ns

    def _list(self, _request: Any, response: Any) -> None:
        response.controller = [_state(one) for one in self._manager.loaded.values()]

    def _list_types(self, _request: Any, response: Any) -> None:
        response.types = list(CONTROLLER_TYPES)
        response.base_classes = [_BASE] * len(response.types)

    def _load(self, request: Any, response: Any) -> None:
        response.ok = self._manager.load(request.name)

    def _unload(self, request: Any, response: Any) -> None:
        response.ok = self._manager.unload(request.name)

    def _switch(self, request: Any, response: Any) -> None:
        response.ok = self._manager.switch(
            request.start_controllers,
            request.stop_controllers,
            strictness=request.strictness,
            time_ns=self._now_ns,
        )

    def _reload(self, request: Any, response: Any) -> None:
        names = list(self._manager.loaded)
        if names and not request.force_kill:
            self._node.error(
                "Controller manager: Cannot reload controller libraries because there are still "
                f"{len(names)} controllers running"
            )
            response.ok = False
            return
        if names:
            self._node.info("Controller manager: Killing all running controllers")
            self._manager.switch((), names, strictness=BEST_EFFORT, time_ns=self._now_ns)
            for name in names:
                self._manager.unload(name)
        self._node.info(f"Controller manager: reloaded controller libraries for '{_BASE}'")
        response.ok = True


def _bound(found: Any, handler: Any) -> Any:
    """A handler that fills a new response."""

    def answer(request: Any) -> Any:
        response = found._response_class()
        handler(request, response)
        return response

    return answer


def _state(controller: Controller) -> Any:
    state: Any = message_class(f"{_MSGS}/ControllerState")()
    state.name, state.type = controller.name, controller.type.name
    state.state = controller.state.value
    resources: Any = message_class(f"{_MSGS}/HardwareInterfaceResources")()
    resources.hardware_interface = in_cpp(controller.type.interface)
    resources.resources = sorted(controller.claims)
    state.claimed_resources = [resources]
    return state
