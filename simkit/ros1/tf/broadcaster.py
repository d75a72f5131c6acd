"""Sends transforms to the topic /tf."""

# ruff: noqa: N802 - the names are tf's

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from simkit.msgs import Time, message_class

if TYPE_CHECKING:
    from simkit.ros1 import rospy
else:
    import rospy

_ORDER = "the order is sendTransform(translation, rotation, time, child, parent)"


class TransformBroadcaster:
    """Broadcasts where a frame is.

    What is sent is what was given: an invalid transform is refused by each listener,
    with a warning that names this node.

    Args:
        queue_size: Length of the publisher's queue.
    """

    def __init__(self, queue_size: int = 100) -> None:
        self.pub_tf = rospy.Publisher(
            "/tf", message_class("tf2_msgs/TFMessage"), queue_size=queue_size
        )

    def sendTransform(
        self,
        translation: Sequence[float],
        rotation: Sequence[float],
        time: Time,
        child: str,
        parent: str,
    ) -> None:
        """Send the pose of `child` in `parent`.

        Args:
            translation: x, y, z [m].
            rotation: Quaternion x, y, z, w.
            time: Time the pose holds for, mostly `rospy.Time.now()`.
            child: Frame that is placed.
            parent: Frame it is placed in.

        Raises:
            IndexError: The translation has less than 3 numbers, or the rotation less than 4.
            AttributeError: `time` is no rospy.Time.
            TypeError: A frame name is no text.
            ROSSerializationException: A value is not a number.
        """
        _check(translation, rotation, time, frames=(child, parent))
        transform: Any = message_class("geometry_msgs/TransformStamped")()
        transform.header.frame_id = parent
        transform.header.stamp = time
        transform.child_frame_id = child
        p, q = transform.transform.translation, transform.transform.rotation
        p.x, p.y, p.z = (translation[i] for i in range(3))
        q.x, q.y, q.z, q.w = (rotation[i] for i in range(4))
        self.sendTransformMessage(transform)

    def sendTransformMessage(self, transform: Any) -> None:
        """Send a geometry_msgs/TransformStamped."""
        self.pub_tf.publish(message_class("tf2_msgs/TFMessage")([transform]))


def _check(
    translation: Sequence[float],
    rotation: Sequence[float],
    time: object,
    *,
    frames: tuple[object, object],
) -> None:
    """Refuse what ROS would choke on, with the error it raises there, in clearer words."""
    if _length(translation) < 3:
        raise IndexError(f"translation must be (x, y, z), not {translation!r}; {_ORDER}")
    if _length(rotation) < 4:
        raise IndexError(
            f"rotation must be a quaternion (x, y, z, w), not {rotation!r}; "
            f"quaternion_from_euler(roll, pitch, yaw) makes one; {_ORDER}"
        )
    if not (hasattr(time, "secs") and hasattr(time, "nsecs")):
        raise AttributeError(
            f"{type(time).__name__!r} object has no attribute 'secs': time must be a rospy.Time, "
            f"not {time!r}; {_ORDER}"
        )
    for role, frame in zip(("child", "parent"), frames, strict=True):
        if not isinstance(frame, str):
            raise TypeError(
                f"{role} must be the name of a frame, not {frame!r} "
                f"({type(frame).__name__}); {_ORDER}"
            )


def _length(numbers: object) -> int:
    """How many numbers there are; a single one is none."""
    return len(numbers) if hasattr(numbers, "__len__") else 0
