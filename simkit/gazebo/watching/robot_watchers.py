"""Watchers of any robot: where it starts, weak joints, joint states, lasers that see their own robot."""

from __future__ import annotations

import math

from simkit.gazebo.watching.ground import Foot, floor_height, foot, is_inside
from simkit.gazebo.watching.watcher import Observation, WatchedModel, Watcher
from simkit.graph.topics import Topic
from simkit.msgs import message_class
from simkit.physics import Mode, ModelJoint
from simkit.plugins.laser import Laser

DEEP, HIGH = 0.002, 0.1
"""So deep in the floor, or so high above it [m], is worth a word."""


class StartHeight(Watcher):
    """Looks once, before anything moves."""

    rule = "GZ-W06"

    @classmethod
    def is_for(cls, scene: WatchedModel) -> bool:
        """Whether it can fall, or be pushed."""
        return scene.model.is_free

    def look(self) -> Observation | None:
        """Where the lowest point is."""
        self.is_over = True
        floor, lowest = floor_height(self.scene.gazebo.world), foot(self.model)
        if floor is None or lowest is None:
            return None
        if lowest.z < floor - DEEP:
            return Observation(text=self._in_the_floor(floor - lowest.z, lowest))
        drop = self._drop(lowest)
        if drop is None or drop <= HIGH:
            return None
        return Observation(
            text=f"{self.model.name} starts {drop:.3g} m above what is below it, and falls; "
            f"with -z {self._height(-drop):.2f} it starts on it",
            is_hint=True,
        )

    def _in_the_floor(self, depth: float, lowest: Foot) -> str:
        return (
            f"{self.model.name} starts {depth:.3g} m in the floor: its link {lowest.link!r} reaches down to "
            f"z = {lowest.z:.3g} m. It is pushed out, and in Gazebo it may jump or tip over. "
            f"Spawn it with -z {self._height(depth):.2f}"
        )

    def _height(self, up: float) -> float:
        """Where to spawn it so that it begins higher [m]: in centimetres, rounded up unless it is 1 mm."""
        return math.ceil((self.model.start.translation[2] + up) * 100.0 - 0.1) / 100.0 + 0.0

    def _drop(self, lowest: Foot) -> float | None:
        """How far it is from its lowest point to the next thing below [m]; None if there is nothing."""
        world = self.scene.gazebo.world
        if world.gravity[2] >= 0.0:
            return None
        point = (lowest.x, lowest.y, lowest.z - DEEP)
        others = [one for one in world.models.values() if one is not self.model]
        if any(is_inside(one, point) for one in others):  # it stands on something
            return None
        (distance,) = world.cast_rays(point, [(0.0, 0.0, -1.0)]).distances
        return float(distance) + DEEP if math.isfinite(distance) else None


PATIENCE = 6
"""So many looks in a row, which is more than half a second."""
STANDING = 0.01
"""What is slower [rad/s or m/s] stands."""


class WeakJoints(Watcher):
    """Looks at the joints that are driven."""

    rule = "GZ-W04"
    is_said_by_rule = True

    def __init__(self, scene: WatchedModel) -> None:
        super().__init__(scene)
        self._looks: dict[str, int] = {}

    @classmethod
    def is_for(cls, scene: WatchedModel) -> bool:
        """Whether it has joints, and plugins that may drive them."""
        return bool(scene.spawned.plugins and scene.model.joints)

    def look(self) -> Observation | None:
        """Whether a motor has been at its bound for too long."""
        for name, joint in self.model.joints.items():
            if joint.mode in (Mode.FREE, Mode.POSITION):
                continue
            looks = self._looks.get(name, 0) + 1 if joint.is_saturated and _is_late(joint) else 0
            self._looks[name] = looks
            if looks >= PATIENCE:
                return Observation(text=self._text(joint))
        return None

    def _text(self, joint: ModelJoint) -> str:
        is_turning = joint.plan.kind.value == "revolute"
        effort, speed = ("N m", "rad/s") if is_turning else ("N", "m/s")
        does = f"moves at {joint.velocity:.2g} {speed}"
        if joint.mode is Mode.VELOCITY:
            does += f" instead of {joint.command:.2g} {speed}"
        drive = self.scene.drive
        is_wheel = drive is not None and joint.name in {one.name for one in drive.joints}
        where = (
            f"<{drive.torque_tag}>" if drive is not None and is_wheel else '<limit effort="...">'
        )
        return (
            f"the joint {joint.name!r} of {self.model.name} has given all it has for half a second, "
            f"{abs(joint.effort):.3g} {effort}, and {does}: it is too weak, or something holds it. Give it more in "
            f"{where}, or look for friction in its <dynamics>, and for what is in its way"
        )


def _is_late(joint: ModelJoint) -> bool:
    """Whether it is far from what it shall do."""
    if joint.mode is Mode.VELOCITY:
        return abs(joint.velocity - joint.command) > max(0.5 * abs(joint.command), STANDING)
    at_stop = min(joint.position - joint.plan.lower, joint.plan.upper - joint.position) < 1e-3
    return abs(joint.velocity) < STANDING and not at_stop


SILENT_LOOKS = 20
"""So many looks a joint may be without a publisher of its state, before it is told."""
MOVED = 0.01
"""From so far on [rad or m] a joint has moved."""
TYPE = "sensor_msgs/JointState"


class _JointStates(Watcher):
    """Looks at the topic `joint_states` of a robot."""

    @classmethod
    def is_for(cls, scene: WatchedModel) -> bool:
        """Whether it is a robot with joints."""
        return scene.spawned.robot is not None and bool(scene.model.joints)

    def topic(self) -> Topic | None:
        """The topic in the namespace of the robot, if anybody has to do with it."""
        namespace = (self.scene.spawned.namespace or "").strip("/")
        name = f"/{namespace}/joint_states" if namespace else "/joint_states"
        found = self.scene.gazebo.node.graph.topics.get(name)
        return found if found is not None and found.message_class._type == TYPE else None


class TwoPublishers(_JointStates):
    """The simulation and a node with sliders both say where the joints are."""

    rule = "CTL-W07"

    def look(self) -> Observation | None:
        """Whether another node publishes what the simulation does."""
        topic = self.topic()
        ours = self.scene.gazebo.node.name
        names = sorted({one.node_name for one in topic.publishers}) if topic is not None else []
        others = [name for name in names if name != ours]
        if topic is None or ours not in names or not others:
            return None
        return Observation(
            text=f"{ours} and {', '.join(others)} both publish {topic.name}: in RViz {self.model.name} jumps between two "
            f"poses. The simulation knows where the joints are: do not start {' or '.join(others)} with it"
        )


class NoStates(_JointStates):
    """robot_state_publisher waits for joints that nobody speaks of."""

    rule = "CTL-W06"
    is_said_by_rule = True

    def __init__(self, scene: WatchedModel) -> None:
        super().__init__(scene)
        self._start = {name: joint.position for name, joint in self.model.joints.items()}
        self._silent = list(self._start)
        self._last: bytes | None = None
        self._looks = 0

    def look(self) -> Observation | None:
        """Whether a joint moves, and no message has named it."""
        topic = self.topic()
        if topic is None or not any(
            self._is_state_publisher(one.node_name) for one in topic.subscriptions
        ):
            return None
        self._heed(topic)
        self._looks += 1
        self.is_over = not self._silent
        if self._looks < SILENT_LOOKS:
            return None
        moving = [name for name in self._silent if self._moved(name) > MOVED]
        if not moving:
            return None
        joint, every = self.model.joint(moving[0]), ", ".join(self._start)
        return Observation(
            text=f"the joint {joint.name!r} of {self.model.name} has moved by {self._moved(joint.name):.2g}, and nobody "
            f"publishes it on {topic.name}: there is no transform from {joint.plan.child!r}. Without state: "
            f"{', '.join(moving)}. Add libgazebo_ros_joint_state_publisher.so with <jointName>{every}</jointName>"
        )

    def _heed(self, topic: Topic) -> None:
        """Cross off the joints that the last message names."""
        if topic.last is None or topic.last is self._last:
            return
        self._last = topic.last
        named = set(message_class(TYPE).from_bytes(topic.last).name)
        self._silent = [name for name in self._silent if name not in named]

    def _moved(self, name: str) -> float:
        return abs(self.model.joints[name].position - self._start[name])

    def _is_state_publisher(self, node: str) -> bool:
        """Whether a node listens to joints and tells TF: that is robot_state_publisher, whatever its name."""
        tf = self.scene.gazebo.node.graph.topics.get("/tf")
        return tf is not None and any(one.node_name == node for one in tf.publishers)


MANY = 0.05
"""From this share of the beams on it is worth a warning; less may be a mast."""
SETTLED = 5
"""After so many looks it is looked through the laser, once."""


class BlindLaser(Watcher):
    """Looks through each laser once."""

    rule = "LAS-W01"
    is_said_by_rule = True

    def __init__(self, scene: WatchedModel) -> None:
        super().__init__(scene)
        self._looks = 0

    @classmethod
    def is_for(cls, scene: WatchedModel) -> bool:
        """Whether it has a laser."""
        return any(isinstance(plugin, Laser) for plugin in scene.spawned.plugins)

    def look(self) -> Observation | None:
        """What the lasers see of the robot."""
        self._looks += 1
        if self._looks < SETTLED:
            return None
        self.is_over = True
        lasers = [plugin for plugin in self.scene.spawned.plugins if isinstance(plugin, Laser)]
        texts = [text for laser in lasers if (text := self._seen(laser)) is not None]
        return Observation(text="; ".join(texts)) if texts else None

    def _seen(self, laser: Laser) -> str | None:
        """What is wrong with what a laser sees."""
        sight = laser.scan_points()
        owners = self.scene.gazebo.world.targets
        count = len(sight.ranges)
        own = [
            (float(reach), owners[target].plan.link)
            for reach, target in zip(sight.ranges, sight.targets, strict=True)
            if target >= 0 and owners[target].model == self.model.name
        ]
        if len(own) >= max(1.0, MANY * count):
            nearest, link = min(own)
            return (
                f"the laser {laser.name!r} of {self.model.name} sees the robot itself with {len(own)} of {count} beams: "
                f"{link!r} is {max(nearest, laser.ray.near):.2g} m away. Lift its link out of that shape, give the link no "
                "<collision>, or raise <min> beyond it"
            )
        return None
