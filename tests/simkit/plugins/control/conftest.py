"""An arm with motors on a stage, and someone who talks with its controllers."""

from __future__ import annotations

from typing import Any

import pytest

from simkit.graph import LogLevel, ServiceFailed
from simkit.msgs import message_class, service_class

LINK = """<link name="{name}"><inertial><origin xyz="0.2 0 0"/><mass value="1"/>
<inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>"""
PLUGIN = (
    '<gazebo><plugin name="control" filename="libgazebo_ros_control.so">{tags}</plugin></gazebo>'
)


def transmission(joint: str, interface: str) -> str:
    return f"""<transmission name="of_{joint}"><type>transmission_interface/SimpleTransmission</type>
<joint name="{joint}"><hardwareInterface>hardware_interface/{interface}</hardwareInterface></joint>
<actuator name="motor_{joint}"/></transmission>"""


def arm(
    interface: str = "PositionJointInterface",
    *,
    kind: str = "continuous",
    limit: str = "",
    tags: str = "",
    axis: str = "0 1 0",
) -> str:
    """What stands in the `<robot>` of an arm with the joints hip and shoulder, which hang on the world."""
    parts = ['<link name="world"/>']
    for parent, joint, child, height in (
        ("world", "hip", "upper", 1.0),
        ("upper", "shoulder", "lower", 0.0),
    ):
        reach = 0.0 if joint == "hip" else 0.4
        parts += [
            LINK.format(name=child),
            f'<joint name="{joint}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
            f'<origin xyz="{reach} 0 {height}"/><axis xyz="{axis}"/>{limit}</joint>',
            transmission(joint, interface),
        ]
    return "\n".join([*parts, PLUGIN.format(tags=tags)])


class Bench:
    """An arm on a stage."""

    def __init__(self, stage: Any) -> None:
        self.stage = stage
        self.graph = stage.graph

    def put(self, robot: str, **parameters: Any) -> Any:
        """Spawn a robot, whose URDF is on the parameter server too; parameters by name, `__` for a slash."""
        self.graph.params.set("/robot_description", f'<robot name="r">{robot}</robot>')
        for name, value in parameters.items():
            self.graph.params.set(f"/{name.replace('__', '/')}", value)
        self.spawned = self.stage.spawn(robot, namespace="/")
        return self.spawned

    @property
    def plugin(self) -> Any:
        return self.spawned.plugins[0]

    def joint(self, name: str) -> Any:
        return self.spawned.model.joint(name)

    def positions(self) -> list[float]:
        return [self.joint(name).position for name in ("hip", "shoulder")]

    def call(self, service: str, type_name: str, **fields: Any) -> Any:
        """The response of a service call; raises ServiceFailed with the server's text."""
        kind: Any = service_class(type_name)
        answers: list[tuple[bool, bytes]] = []
        self.graph.call_service(
            service,
            kind._request_class(**fields).to_bytes(),
            "/listener",
            lambda ok, data: answers.append((ok, data)),
        )
        self.stage.run(0.0)
        ((ok, data),) = answers
        if not ok:
            raise ServiceFailed(data.decode())
        return kind._response_class.from_bytes(data)

    def load(self, name: str) -> bool:
        kind = "controller_manager_msgs/LoadController"
        return self.call("/controller_manager/load_controller", kind, name=name).ok

    def unload(self, name: str) -> bool:
        kind = "controller_manager_msgs/UnloadController"
        return self.call("/controller_manager/unload_controller", kind, name=name).ok

    def switch(self, start: Any = (), stop: Any = (), strictness: int = 2) -> bool:
        return self.call(
            "/controller_manager/switch_controller",
            "controller_manager_msgs/SwitchController",
            start_controllers=list(start),
            stop_controllers=list(stop),
            strictness=strictness,
        ).ok

    def start(self, name: str, type_name: str, **parameters: Any) -> bool:
        """Set the parameters of a controller, load it and start it."""
        self.graph.params.set(f"/{name}", {"type": type_name, **parameters})
        return self.load(name) and self.switch([name])

    def states(self) -> dict[str, str]:
        kind = "controller_manager_msgs/ListControllers"
        listed = self.call("/controller_manager/list_controllers", kind).controller
        return {one.name: one.state for one in listed}

    def tell(self, topic: str, type_name: str, **fields: Any) -> None:
        """Publish one message."""
        kind = message_class(type_name)
        publisher = self.stage.listener.advertise(topic, kind)
        publisher.publish(kind(**fields))
        self.stage.run(0.0)
        publisher.unregister()

    def said(self, level: LogLevel = LogLevel.WARN) -> list[str]:
        return self.stage.said(level)


@pytest.fixture
def new_bench(new_stage):
    """Makes a bench; skips where dartpy is not."""

    def make() -> Bench:
        return Bench(new_stage())

    return make


@pytest.fixture
def bench(new_bench) -> Bench:
    """A bench without a robot."""
    return new_bench()
