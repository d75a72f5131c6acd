"""The topics of the world: the clock, and where models and links are.

Each is published after every step while somebody listens, and costs nothing otherwise.

Source: gazebo_ros_api_plugin: `/clock`, `/gazebo/model_states`, `/gazebo/link_states` in the frame of
the world, and `/gazebo/set_model_state`, which is listened to.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from simkit.errors import SimkitError
from simkit.gazebo.poses import pose_message, twist_message
from simkit.gazebo.server import Gazebo
from simkit.gazebo.services.models import set_model_state
from simkit.graph.topics import Publisher
from simkit.msgs import Message, message_class


def publish_states(gazebo: Gazebo) -> None:
    """Publish what the world does, and listen to what it shall do."""
    node = gazebo.node
    for topic, type_name, message in (
        ("/clock", "rosgraph_msgs/Clock", _clock),
        ("/gazebo/model_states", "gazebo_msgs/ModelStates", _models),
        ("/gazebo/link_states", "gazebo_msgs/LinkStates", _links),
    ):
        _EachStep(gazebo, node.advertise(topic, message_class(type_name)), message)

    def on_state(state: Any) -> None:
        try:
            set_model_state(gazebo, state)
        except SimkitError as error:
            node.error(str(error))

    kind: Any = message_class("gazebo_msgs/ModelState")
    node.subscribe("/gazebo/set_model_state", kind, on_state)


class _EachStep:
    """Publishes after each step while somebody listens."""

    def __init__(
        self, gazebo: Gazebo, publisher: Publisher, message: Callable[[Gazebo], Message]
    ) -> None:
        self._gazebo = gazebo
        self._publisher = publisher
        self._message = message
        self._is_on = False
        gazebo.before_run.append(self._look)

    def _look(self) -> None:
        is_wanted = self._publisher.num_connections > 0
        if is_wanted is self._is_on:
            return
        self._is_on = is_wanted
        calls = self._gazebo.world.after_step
        (calls.append if is_wanted else calls.remove)(self._publish)

    def _publish(self) -> None:
        self._publisher.publish(self._message(self._gazebo))


def _clock(gazebo: Gazebo) -> Message:
    message: Any = message_class("rosgraph_msgs/Clock")()
    message.clock = gazebo.node.now()
    found: Message = message
    return found


def _models(gazebo: Gazebo) -> Message:
    message: Any = message_class("gazebo_msgs/ModelStates")()
    for name, model in gazebo.world.models.items():
        message.name.append(name)
        message.pose.append(pose_message(model.pose))
        message.twist.append(twist_message(model.twist))
    found: Message = message
    return found


def _links(gazebo: Gazebo) -> Message:
    message: Any = message_class("gazebo_msgs/LinkStates")()
    for name, model in gazebo.world.models.items():
        for link in model.plan.bodies:
            message.name.append(f"{name}::{link}")
            message.pose.append(pose_message(model.link_pose(link)))
            message.twist.append(twist_message(model.link_twist(link)))
    found: Message = message
    return found
