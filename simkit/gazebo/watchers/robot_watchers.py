"""Watchers of any robot: where it starts, weak joints, joint states, lasers that see their own robot."""

from __future__ import annotations

import math

from simkit.gazebo.watchers.scene import (
    Foot,
    Hint,
    Looks,
    WatchedModel,
    floor_height,
    foot,
    is_inside,
    watcher,
)
from simkit.graph.topics import Topic
from simkit.msgs import message_class
from simkit.physics import Mode, ModelJoint
from simkit.plugins.laser import Laser

DEEP, HIGH = 0.002, 0.1
"""So deep in the floor, or so high above it [m], is worth a word."""


@watcher("GZ-W06")
def start_height(scene: WatchedModel) -> Looks:
    """Looks once, before anything moves, at what can fall or be pushed: where its lowest point is."""
    model = scene.model
    floor, lowest = floor_height(scene.gazebo.world), foot(model)
    if not model.is_free or floor is None or lowest is None:
        return
    depth = floor - lowest.z
    if depth > DEEP:
        yield (
            f"{model.name} starts {depth:.3g} m in the floor: its link {lowest.link!r} reaches down to "
            f"z = {lowest.z:.3g} m. It is pushed out, and in Gazebo it may jump or tip over. "
            f"Spawn it with -z {_height(scene, depth):.2f}"
        )
        return
    drop = _drop(scene, lowest)
    if drop is not None and drop > HIGH:
        yield Hint(
            f"{model.name} starts {drop:.3g} m above what is below it, and falls; "
            f"with -z {_height(scene, -drop):.2f} it starts on it"
        )


def _height(scene: WatchedModel, up: float) -> float:
    """Where to spawn it so that it begins higher [m]: in centimetres, rounded up unless it is 1 mm."""
    return math.ceil((scene.model.start.translation[2] + up) * 100.0 - 0.1) / 100.0 + 0.0


def _drop(scene: WatchedModel, lowest: Foot) -> float | None:
    """How far it is from its lowest point to the next thing below [m]; None if there is nothing."""
    world = scene.gazebo.world
    if world.gravity[2] >= 0.0:
        return None
    point = (lowest.x, lowest.y, lowest.z - DEEP)
    others = [one for one in world.models.values() if one is not scene.model]
    if any(is_inside(one, point) for one in others):  # it stands on something
        return None
    (distance,) = world.cast_rays(point, [(0.0, 0.0, -1.0)]).distances
    return float(distance) + DEEP if math.isfinite(distance) else None


PATIENCE = 6
"""So many looks in a row, which is more than half a second."""
STANDING = 0.01
"""What is slower [rad/s or m/s] stands."""


@watcher("GZ-W04", is_said_by_rule=True)
def weak_joints(scene: WatchedModel) -> Looks:
    """Looks at the joints that plugins may drive: whether a motor has been at its bound for too long."""
    looks = dict.fromkeys(scene.model.joints, 0)
    while scene.spawned.plugins and looks:
        weak = None
        for name, joint in scene.model.joints.items():
            if joint.mode in (Mode.FREE, Mode.POSITION):
                continue
            looks[name] = looks[name] + 1 if joint.is_saturated and _is_late(joint) else 0
            weak = weak or (joint if looks[name] >= PATIENCE else None)
        yield None if weak is None else _weak_text(scene, weak)


def _weak_text(scene: WatchedModel, joint: ModelJoint) -> str:
    is_turning = joint.plan.kind.value == "revolute"
    effort, speed = ("N m", "rad/s") if is_turning else ("N", "m/s")
    does = f"moves at {joint.velocity:.2g} {speed}"
    if joint.mode is Mode.VELOCITY:
        does += f" instead of {joint.command:.2g} {speed}"
    drive = None if scene.motion is None else scene.motion.drive
    is_wheel = drive is not None and joint.name in {one.name for one in drive.joints}
    where = f"<{drive.torque_tag}>" if drive is not None and is_wheel else '<limit effort="...">'
    return (
        f"the joint {joint.name!r} of {scene.model.name} has given all it has for half a second, "
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
"""So many looks a joint may be without a publisher of its state, before it is reported."""
MOVED = 0.01
"""From so far on [rad or m] a joint has moved."""
TYPE = "sensor_msgs/JointState"


def _has_states(scene: WatchedModel) -> bool:
    """Whether it is a robot with joints."""
    return scene.spawned.robot is not None and bool(scene.model.joints)


def _states_topic(scene: WatchedModel) -> Topic | None:
    """The topic `joint_states` in the namespace of the robot, if anybody has to do with it."""
    namespace = (scene.spawned.namespace or "").strip("/")
    name = f"/{namespace}/joint_states" if namespace else "/joint_states"
    found = scene.gazebo.node.graph.topics.get(name)
    return found if found is not None and found.message_class._type == TYPE else None


@watcher("CTL-W07")
def two_publishers(scene: WatchedModel) -> Looks:
    """The simulation and a node with sliders both say where the joints are."""
    ours = scene.gazebo.node.name
    while _has_states(scene):
        topic = _states_topic(scene)
        names = sorted({one.node_name for one in topic.publishers}) if topic is not None else []
        others = [name for name in names if name != ours]
        if topic is None or ours not in names or not others:
            yield None
            continue
        yield (
            f"{ours} and {', '.join(others)} both publish {topic.name}: in RViz {scene.model.name} jumps between two "
            f"poses. The simulation knows where the joints are: do not start {' or '.join(others)} with it"
        )


@watcher("CTL-W06", is_said_by_rule=True)
def no_states(scene: WatchedModel) -> Looks:
    """robot_state_publisher waits for joints: whether one moves, and no message has named it."""
    joints = scene.model.joints
    start = {name: joint.position for name, joint in joints.items()}
    silent, looks = list(start), 0
    while silent and _has_states(scene):
        topic = _states_topic(scene)
        if topic is None or not _feeds_tf(scene, topic):
            yield None
            continue
        if topic.last is not None:
            named = set(message_class(TYPE).from_bytes(topic.last).name)
            silent = [name for name in silent if name not in named]
        looks += 1
        moved = {name: abs(joints[name].position - start[name]) for name in silent}
        moving = [name for name in silent if moved[name] > MOVED]
        if looks < SILENT_LOOKS or not moving:
            yield None
            continue
        first = joints[moving[0]]
        yield (
            f"the joint {first.name!r} of {scene.model.name} has moved by {moved[first.name]:.2g}, and nobody "
            f"publishes it on {topic.name}: there is no transform from {first.plan.child!r}. Without state: "
            f"{', '.join(moving)}. Add libgazebo_ros_joint_state_publisher.so with <jointName>{', '.join(start)}</jointName>"
        )


def _feeds_tf(scene: WatchedModel, topic: Topic) -> bool:
    """Whether a node listens to joints and publishes on /tf: that is robot_state_publisher, whatever its name."""
    tf = scene.gazebo.node.graph.topics.get("/tf")
    publishers = set() if tf is None else {one.node_name for one in tf.publishers}
    return any(one.node_name in publishers for one in topic.subscriptions)


MANY = 0.05
"""From this share of the beams on it is worth a warning; less may be a mast."""
SETTLED = 5
"""After so many looks it is looked through the laser, once."""


@watcher("LAS-W01", is_said_by_rule=True)
def blind_laser(scene: WatchedModel) -> Looks:
    """Looks through each laser once: what it sees of the robot."""
    lasers = [plugin for plugin in scene.spawned.plugins if isinstance(plugin, Laser)]
    if not lasers:
        return
    for _ in range(SETTLED - 1):
        yield None
    yield "; ".join(text for laser in lasers if (text := _own_beams(scene, laser)))


def _own_beams(scene: WatchedModel, laser: Laser) -> str:
    """How much of its own robot a laser sees, if it is too much."""
    name, sight, owners = scene.model.name, laser.scan_points(), scene.gazebo.world.targets
    count = len(sight.ranges)
    own = [
        (float(reach), owners[target].plan.link)
        for reach, target in zip(sight.ranges, sight.targets, strict=True)
        if target >= 0 and owners[target].model == name
    ]
    if len(own) < max(1.0, MANY * count):
        return ""
    nearest, link = min(own)
    return (
        f"the laser {laser.name!r} of {name} sees the robot itself with {len(own)} of {count} beams: "
        f"{link!r} is {max(nearest, laser.ray.near):.2g} m away. Lift its link out of that shape, give the link no "
        "<collision>, or raise <min> beyond it"
    )
