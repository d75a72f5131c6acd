"""Who says where joints are: two at once, or nobody."""

from __future__ import annotations

from simkit.gazebo.watching.watcher import Finding, Scene, Watcher
from simkit.graph.topics import Topic
from simkit.msgs import message_class

PATIENCE = 20
"""So many looks a joint may be without a publisher of its state, before it is told."""
MOVED = 0.01
"""From so far on [rad or m] a joint has moved."""
TYPE = "sensor_msgs/JointState"


class _JointStates(Watcher):
    """Looks at the topic `joint_states` of a robot."""

    @classmethod
    def is_for(cls, scene: Scene) -> bool:
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

    def look(self) -> Finding | None:
        """Whether another node publishes what the simulation does."""
        topic = self.topic()
        ours = self.scene.gazebo.node.name
        names = sorted({one.node_name for one in topic.publishers}) if topic is not None else []
        others = [name for name in names if name != ours]
        if topic is None or ours not in names or not others:
            return None
        return Finding(
            text=f"{ours} and {', '.join(others)} both publish {topic.name}: in RViz {self.model.name} jumps between two "
            f"poses. The simulation knows where the joints are: do not start {' or '.join(others)} with it"
        )


class NoStates(_JointStates):
    """robot_state_publisher waits for joints that nobody speaks of."""

    rule = "CTL-W06"
    is_said_by_rule = True

    def __init__(self, scene: Scene) -> None:
        super().__init__(scene)
        self._start = {name: joint.position for name, joint in self.model.joints.items()}
        self._silent = list(self._start)
        self._last: bytes | None = None
        self._looks = 0

    def look(self) -> Finding | None:
        """Whether a joint moves, and no message has named it."""
        topic = self.topic()
        if topic is None or not any(
            self._is_state_publisher(one.node_name) for one in topic.subscriptions
        ):
            return None
        self._heed(topic)
        self._looks += 1
        self.is_over = not self._silent
        if self._looks < PATIENCE:
            return None
        moving = [name for name in self._silent if self._moved(name) > MOVED]
        if not moving:
            return None
        joint, every = self.model.joint(moving[0]), ", ".join(self._start)
        return Finding(
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
