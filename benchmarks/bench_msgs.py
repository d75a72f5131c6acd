"""Messages to bytes and back, against rosbags in the same run."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

from figures import Figure, median_of, show
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

from simkit.msgs import message_class

ROUNDS, CALLS = 15, 400
TRANSFORMS = 5


def per_call(work: Callable[[], object]) -> float:
    """Median time of one call over several rounds [us]."""
    durations = []
    for _ in range(ROUNDS):
        start = time.perf_counter()
        for _ in range(CALLS):
            work()
        durations.append((time.perf_counter() - start) / CALLS * 1e6)
    return median_of(durations)


def samples() -> dict[str, Any]:
    """Messages that a turtle and tf send all day."""
    twist = message_class("geometry_msgs/Twist")()
    twist.linear.x, twist.angular.z = 1.5, -0.5
    frames = message_class("tf2_msgs/TFMessage")()
    for number in range(TRANSFORMS):
        transform = message_class("geometry_msgs/TransformStamped")()
        transform.header.frame_id, transform.child_frame_id = "world", f"turtle{number}"
        transform.transform.rotation.w = 1.0
        frames.transforms.append(transform)
    return {"Twist": twist, f"TFMessage of {TRANSFORMS}": frames}


def main() -> None:
    """Print the figures."""
    store = get_typestore(Stores.ROS1_NOETIC)
    for name, message in samples().items():
        data = message.to_bytes()
        package, _, short = message._type.partition("/")
        peer_type = f"{package}/msg/{short}"
        if peer_type not in store.fielddefs:
            store.register(get_types_from_msg(message._definition.text, peer_type))
        peer = store.deserialize_ros1(data, peer_type)
        assert bytes(store.serialize_ros1(peer, peer_type)) == data

        def ours(message: Any = message, data: bytes = data) -> None:
            message.to_bytes()
            type(message).from_bytes(data)

        def theirs(peer: Any = peer, data: bytes = data, kind: str = peer_type) -> None:
            store.serialize_ros1(peer, kind)
            store.deserialize_ros1(data, kind)

        mine, rosbags = per_call(ours), per_call(theirs)
        show(
            Figure(f"{name}: encode and decode", mine, "us"),
            Figure(f"{name}: rosbags, the same", rosbags, "us"),
            Figure(f"{name}: simkit over rosbags", mine / rosbags, "x"),
        )


if __name__ == "__main__":
    main()
