"""`libgazebo_ros_bumper.so`: what a link touches, and how hard.

Source: gazebo_ros_bumper of Noetic; Gazebo's `ContactSensor` and `ContactManager`.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable
from typing import Any

from simkit.errors import near_names
from simkit.geometry import Vector
from simkit.msgs import Time, message_class
from simkit.physics import Contact, Side
from simkit.plugins.parameters import resolve_frame, tf_prefix, topic_at_root
from simkit.plugins.plugin import NEVER, Plugin
from simkit.plugins.rate import SensorRate
from simkit.plugins.sensor_tag import SensorTag, read_sensor, warn_of_strangers
from simkit.plugins.site import Site
from simkit.plugins.tags import BumperParameters

MOST_STEPS = 100
"""Contacts of so many steps are kept until the sensor is due; older ones are dropped."""


class Bumper(Plugin[BumperParameters]):
    """A contact sensor; it looks while someone listens.

    Each message has the contacts of all steps since the last one. Two shapes that touch are one state,
    with a point, a force on the first one, a normal and a depth for each point at which they touch,
    everything in the frame of the world.
    """

    Parameters = BumperParameters

    def __init__(self, site: Site, parameters: BumperParameters) -> None:
        super().__init__(site, parameters)
        self.sensor = read_sensor(site, "contact")
        self._frame = resolve_frame(parameters.frame, tf_prefix(site))
        self._body = site.model.plan.mounts[self.sensor.link].body
        self._shapes = _shapes(site, self.sensor, self._body)
        self._rate = SensorRate(self.sensor.update_rate, site.now_ns)
        self._waiting: deque[tuple[int, list[Contact]]] = deque(maxlen=MOST_STEPS)
        self._publisher: Any = None

    def on_attach(self) -> None:
        """Offer the topic."""
        topic = topic_at_root(self.site, "bumperTopicName", self.parameters.topic)
        self._publisher = self.site.node.advertise(
            topic, message_class("gazebo_msgs/ContactsState"), queue_size=1
        )

    @property
    def due_ns(self) -> int:
        """Each step while someone listens: it collects what touches."""
        return 0 if self._publisher.num_connections or self._waiting else NEVER

    def after_step(self) -> None:
        """Look what touches, and publish if it is time, while someone listens."""
        if not self._publisher.num_connections:
            self._waiting.clear()
            return
        now_ns = self.site.now_ns
        mine = [one for one in self.site.world.contacts() if self._is_mine(one)]
        self._waiting.append((now_ns, mine))
        if self._rate.is_due(now_ns):
            self._publisher.publish(self._message(now_ns))
            self._waiting.clear()

    def on_reset(self) -> None:
        """Forget what was touched."""
        self._rate.restart(self.site.now_ns)
        self._waiting.clear()

    def on_detach(self) -> None:
        """Withdraw the topic."""
        self._publisher.unregister()

    def _is_mine(self, contact: Contact) -> bool:
        return any(self._has(side) for side in (contact.first, contact.second))

    def _has(self, side: Side) -> bool:
        return (
            side.model == self.site.model.name
            and side.body == self._body
            and side.shape in self._shapes
        )

    def _message(self, now_ns: int) -> Any:
        message: Any = message_class("gazebo_msgs/ContactsState")()
        message.header.stamp = Time.from_nsec(now_ns)
        message.header.frame_id = self._frame
        for time_ns, contacts in self._waiting:
            pairs: dict[tuple[str, str], list[Contact]] = {}
            for one in contacts:
                pairs.setdefault((_scoped(one.first), _scoped(one.second)), []).append(one)
            for (first, second), points in pairs.items():
                message.states.append(_state(first, second, points, time_ns))
        return message


def _state(first: str, second: str, points: Iterable[Contact], time_ns: int) -> Any:
    """What two shapes do to each other."""
    state: Any = message_class("gazebo_msgs/ContactState")()
    state.collision1_name, state.collision2_name = first, second
    state.info = (
        f"my geom: {first}  other geom: {second}  time: {Time.from_nsec(time_ns).to_sec():.9f}"
    )
    total = state.total_wrench.force
    for one in points:
        wrench: Any = message_class("geometry_msgs/Wrench")()
        wrench.force = _vector(one.force)
        total.x, total.y, total.z = (
            total.x + one.force[0],
            total.y + one.force[1],
            total.z + one.force[2],
        )
        state.wrenches.append(wrench)
        state.contact_positions.append(_vector(one.point))
        state.contact_normals.append(_vector(one.normal))
        state.depths.append(one.depth)
    return state


def _vector(vector: Vector) -> Any:
    message: Any = message_class("geometry_msgs/Vector3")()
    message.x, message.y, message.z = vector
    return message


def _scoped(side: Side) -> str:
    """Name of a shape as Gazebo says it."""
    return f"{side.model}::{side.body}::{side.shape}"


def _shapes(site: Site, sensor: SensorTag, body: str) -> tuple[str, ...]:
    """Names of the shapes that the sensor is for; a warning names one that is not there."""
    known = [shape.name for shape in site.model.plan.bodies[body].shapes]
    contact = sensor.element.child("contact")
    named = [] if contact is None else contact.all("collision")
    if contact is not None:
        warn_of_strangers(site, contact, ("collision", "topic"))
    if not named:
        site.node.warn(
            f"{site.place(contact or sensor.element)}: the sensor {sensor.name!r} feels nothing: it needs "
            f"<contact><collision>NAME</collision></contact>; shapes here: {', '.join(known) or 'none'}"
        )
    for element in named:
        name = element.text.strip()
        if name not in known:
            near = near_names(name, known)
            hint = f"did you mean {near[0]}? " if near else ""
            site.node.warn(
                f"{site.place(element)}: the sensor {sensor.name!r} is for a shape {name!r}, and {body} has none of "
                f"that name, as Gazebo calls it; {hint}shapes here: {', '.join(known) or 'none'}"
            )
    return tuple(element.text.strip() for element in named)
