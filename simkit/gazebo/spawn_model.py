"""spawn_model as a node: brings a model into the world by the services of `/gazebo`, then ends.

Source: gazebo_ros `scripts/spawn_model`: options, texts, exit codes.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from simkit.errors import SimkitError, UnknownNameError
from simkit.gazebo.poses import pose_message
from simkit.gazebo.spawn_arguments import USAGE, SpawnUsageError, read_arguments
from simkit.graph import Node
from simkit.msgs import Duration, service_class
from simkit.nodes.program import Program
from simkit.packages import PackagePath
from simkit.xml import parse_xml

POLL = Duration.from_nsec(100_000_000)
"""How often it looks for what it waits for."""
PATIENCE_NS = 5_000_000_000
"""After so long a wait it says what could be wrong."""
SETTLE = Duration(1)
"""How long after the spawn it sets joints."""


class SpawnModel(Program):
    """The program `spawn_model` of the package gazebo_ros.

    Args:
        node: Its place in the graph; its namespace is that of the plugins that have none.
        argv: As on its command line.
        packages: What it may read.
    """

    def __init__(self, node: Node, argv: list[str], packages: PackagePath) -> None:
        super().__init__(node)
        self._packages = packages
        self._since_ns = node.now().to_nsec()
        self._has_hinted = False
        self._timer: Any = None
        try:
            self._request = read_arguments(argv)
        except SpawnUsageError as error:
            self._print(f"{USAGE}\nspawn_model: error: {error}\n")
            self._exit(2)
            return
        node.graph.executor.call_soon(self._begin)

    def _begin(self) -> None:
        if not self._node.alive:
            return
        try:
            self._text = self._load()
        except SimkitError as error:
            self._node.error(str(error))
            self._exit(1)
            return
        if self._request.wait:
            self._node.info(f"Waiting for model {self._request.wait} before proceeding.")
            self._every(self._look_for_model)
        else:
            self._call_on()

    def _load(self) -> str:
        request = self._request
        if request.file is not None:
            self._node.info(f"Loading model XML from file {request.file}")
            text = self._read_file(request.file)
        else:
            self._node.info(f"Loading model XML from ros parameter {request.param}")
            text = self._read_param(request.param or "")
        document = parse_xml(text, file=request.file or request.param or "")
        if document.faults:
            fault = document.faults[0]
            where = f"line {fault.span.line}, column {fault.span.column}"
            raise SimkitError(f"Invalid XML: {fault.what}: {where}. {fault.remedy}")
        return text

    def _read_file(self, name: str) -> str:
        path = self._folder / name
        if not path.is_file():
            raise SimkitError(f"Error: specified file {name} does not exist")
        if not self._packages.may_read(path):
            raise SimkitError(f"Error: specified file {name} is in no package, so it is not read")
        try:
            text = path.read_text("utf-8")
        except (OSError, UnicodeDecodeError) as error:
            raise SimkitError(f"Error: specified file {name} cannot be read: {error}") from None
        if not text:
            raise SimkitError(f"Error: file {name} is empty")
        return text

    def _read_param(self, name: str) -> str:
        try:
            value = self._node.get_param(name)
        except UnknownNameError as error:
            raise SimkitError(
                f"the parameter {self._node.resolve(name)} is not set: load the robot first, e.g. by "
                f'<param name="{name}" textfile="..."/> in the launch file. {error}'
            ) from None
        if not isinstance(value, str) or not value.strip():
            raise SimkitError(f"the parameter {self._node.resolve(name)} holds no model")
        return value

    # -- steps, each by an event of its own

    def _every(self, look: Callable[[], bool]) -> None:
        """Look again and again until it is there."""
        if look():
            return

        def again() -> None:
            if look():
                self._timer.cancel()

        self._timer = self._node.create_timer(POLL, again)

    def _look_for_model(self) -> bool:
        topic = self._node.graph.topics.get(f"{self._request.gazebo}/model_states")
        if topic is None or not topic.publishers:
            self._hint()
            return False
        if self._request.wait not in self._models():
            return False
        self._call_on()
        return True

    def _models(self) -> list[str]:
        """Names of the models in the world, as `get_world_properties` would say them at once."""
        found: list[str] = []
        service = f"{self._request.gazebo}/get_world_properties"
        server = self._node.graph.services.get(service)
        if server is None:
            return found
        kind = service_class("gazebo_msgs/GetWorldProperties")

        def take(success: bool, data: bytes) -> None:
            if success:
                response: Any = kind._response_class.from_bytes(data)
                found.extend(response.model_names)

        server.respond(kind._request_class().to_bytes(), self._node.name, take)
        return found

    def _call_on(self) -> None:
        kind = "urdf" if self._request.is_urdf else "sdf"
        service = f"{self._request.gazebo}/spawn_{kind}_model"
        self._node.info(f"Waiting for service {service}")
        self._every(lambda: self._spawn_if_there(service))

    def _spawn_if_there(self, service: str) -> bool:
        if service not in self._node.graph.services:
            self._hint()
            return False
        self._node.info(f"Calling service {service}")
        request: Any = service_class("gazebo_msgs/SpawnModel")._request_class()
        request.model_name = self._request.model
        request.model_xml = self._text
        request.robot_namespace = self._namespace()
        request.initial_pose = pose_message(self._request.pose.transform)
        request.reference_frame = self._request.reference_frame
        self._call(service, "gazebo_msgs/SpawnModel", request, self._spawned)
        return True

    def _namespace(self) -> str:
        if self._request.robot_namespace is not None:
            return self._request.robot_namespace
        return self._node.name.rpartition("/")[0] or "/"

    def _spawned(self, response: Any) -> None:
        self._node.info(f"Spawn status: {response.status_message}")
        if not response.success:
            self._node.error("Spawn service failed. Exiting.")
            self._exit(1)
        elif self._request.joints:
            self._timer = self._node.create_timer(SETTLE, self._set_joints)
        else:
            self._unpause()

    def _set_joints(self) -> None:
        self._timer.cancel()
        name = "gazebo_msgs/SetModelConfiguration"
        request: Any = service_class(name)._request_class()
        request.model_name = self._request.model
        request.joint_names = [joint for joint, _ in self._request.joints]
        request.joint_positions = [position for _, position in self._request.joints]

        def done(response: Any) -> None:
            self._node.info(f"Set model configuration status: {response.status_message}")
            self._unpause()

        self._call(f"{self._request.gazebo}/set_model_configuration", name, request, done)

    def _unpause(self) -> None:
        if not self._request.unpause:
            self._end()
            return
        request = service_class("std_srvs/Empty")._request_class()
        self._call(
            f"{self._request.gazebo}/unpause_physics",
            "std_srvs/Empty",
            request,
            lambda _: self._end(),
        )

    def _end(self) -> None:
        if not self._request.is_bound:
            self._exit(0)
            return
        self._node.info("Waiting for shutdown to delete model")
        self._node.on_shutdown(self._delete)

    def _delete(self) -> None:
        request: Any = service_class("gazebo_msgs/DeleteModel")._request_class()
        request.model_name = self._request.model
        service = f"{self._request.gazebo}/delete_model"
        server = self._node.graph.services.get(service)
        if server is not None:
            server.respond(request.to_bytes(), self._node.name, lambda _success, _data: None)

    def _call(
        self, service: str, type_name: str, request: Any, done: Callable[[Any], None]
    ) -> None:
        kind = service_class(type_name)

        def take(success: bool, data: bytes) -> None:
            if not self._node.alive:
                return
            if success:
                done(kind._response_class.from_bytes(data))
                return
            self._node.error(f"{service}: {data.decode(errors='replace')}")
            self._exit(1)

        try:
            self._node.graph.call_service(service, request.to_bytes(), self._node.name, take)
        except UnknownNameError as error:
            self._node.error(str(error))
            self._exit(1)

    def _hint(self) -> None:
        waited = self._node.now().to_nsec() - self._since_ns
        if waited >= PATIENCE_NS and not self._has_hinted:
            self._has_hinted = True
            self._node.warn(
                "no world runs, so nothing can be spawned: start one with "
                "roslaunch gazebo_ros empty_world.launch (in Python: sim.gazebo), or include that file"
            )
