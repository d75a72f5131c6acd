"""static_transform_publisher of tf, which repeats one transform on /tf, and of tf2_ros, which latches it on /tf_static.

Source: tf `static_transform_publisher.cpp`: each message is dated one period ahead, so that the
transform is known at every moment. tf2_ros `static_transform_broadcaster_program.cpp`, Noetic.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from simkit.errors import SimkitError
from simkit.geometry import Quaternion, Vector, multiply
from simkit.graph import Node
from simkit.msgs import Duration, MessageError, fill_message, message_class
from simkit.nodes.program import Program, is_number, leading_number
from simkit.tf import StaticTransformBroadcaster, TransformBroadcaster
from simkit.tf.admission import rotation_advice

TF_USAGE = """\
Sends one transform again and again.
Usage: static_transform_publisher x y z yaw pitch roll frame_id child_frame_id period(milliseconds)
OR
Usage: static_transform_publisher x y z qx qy qz qw frame_id child_frame_id period(milliseconds)

It is the pose of child_frame_id in frame_id.
"""
TF2_USAGE = """\
Sends one transform that holds for ever.
Usage: static_transform_publisher x y z qx qy qz qw frame_id child_frame_id
OR
Usage: static_transform_publisher x y z yaw pitch roll frame_id child_frame_id
OR
Usage: static_transform_publisher /param_name

It is the pose of child_frame_id in frame_id.
"""
"""What the programs print when their arguments are wrong."""

YPR = ("x", "y", "z", "yaw", "pitch", "roll")
"""Numbers of a transform whose rotation is given as angles."""
XYZW = ("x", "y", "z", "qx", "qy", "qz", "qw")
"""Numbers of a transform whose rotation is given as a quaternion."""


class WrongNumberError(SimkitError):
    """The command line has too few or too many words."""


class BadTransformError(SimkitError):
    """The command line has the right number of words, but they make no transform."""


@dataclass(frozen=True, slots=True, kw_only=True)
class FixedTransform:
    """Where a frame is, for ever."""

    parent: str
    "Frame that the transform is expressed in."
    child: str
    "Frame that is placed."
    translation: Vector
    "Origin of the child in the parent [m]."
    rotation: Quaternion
    "Orientation of the child in the parent, xyzw."
    angles: Vector | None
    "Yaw, pitch and roll [rad] if they were given."

    def message(self) -> Any:
        """The geometry_msgs/TransformStamped, without a stamp."""
        message: Any = message_class("geometry_msgs/TransformStamped")()
        message.header.frame_id, message.child_frame_id = self.parent, self.child
        t, q = message.transform.translation, message.transform.rotation
        t.x, t.y, t.z = self.translation
        q.x, q.y, q.z, q.w = self.rotation
        return message


def parse_transform(words: Sequence[str]) -> FixedTransform:
    """Read `x y z yaw pitch roll parent child` or `x y z qx qy qz qw parent child`.

    Raises:
        WrongNumberError: There are neither 8 nor 9 words.
        BadTransformError: A number is none, or the two frames are the same.
    """
    names = {8: YPR, 9: XYZW}.get(len(words))
    if names is None:
        raise WrongNumberError
    *numbers, parent, child = words
    for name, number in zip(names, numbers, strict=True):
        if not is_number(number):
            raise BadTransformError(
                f"{name} must be a number, not {number!r}; "
                f"the order is {' '.join(names)} parent child"
            )
    if parent == child:
        raise BadTransformError(
            f"target_frame and source frame are the same ({parent}, {child}) this cannot work"
        )
    x, y, z, *rest = map(float, numbers)
    angles = (rest[0], rest[1], rest[2]) if names is YPR else None
    return FixedTransform(
        parent=parent,
        child=child,
        translation=(x, y, z),
        rotation=_from_angles(*angles) if angles else (rest[0], rest[1], rest[2], rest[3]),
        angles=angles,
    )


def _from_angles(yaw: float, pitch: float, roll: float) -> Quaternion:
    """Roll about x, then pitch about y, then yaw about z, all about fixed axes."""
    about_z = (0.0, 0.0, math.sin(yaw / 2.0), math.cos(yaw / 2.0))
    about_y = (0.0, math.sin(pitch / 2.0), 0.0, math.cos(pitch / 2.0))
    about_x = (math.sin(roll / 2.0), 0.0, 0.0, math.cos(roll / 2.0))
    return multiply(about_z, multiply(about_y, about_x))


class _StaticTransformPublisher(Program):
    """What both programs do with their command line.

    Args:
        node: Its place in the graph.
        argv: Numbers and frames.
    """

    usage: str

    def __init__(self, node: Node, argv: list[str]) -> None:
        super().__init__(node)
        try:
            self._begin(argv)
        except WrongNumberError as error:
            self._print(self.usage)
            node.error(
                f"static_transform_publisher exited due to not having the right number of arguments{error}"
            )
            self._exit(255)
        except BadTransformError as error:
            node.fatal(str(error))
            self._exit(1)

    def _begin(self, words: list[str]) -> None:
        raise NotImplementedError

    def _log_angles(self, transform: FixedTransform) -> None:
        """Log how three angles were read, where the order of a URDF would give another rotation."""
        if transform.angles is None or transform.angles == transform.angles[::-1]:
            return
        yaw, pitch, roll = transform.angles
        self._node.info(
            f"{transform.child}: read as yaw {yaw:g}, pitch {pitch:g}, roll {roll:g} [rad]; "
            f"the rpy of a URDF counts the other way round and would mean "
            f"yaw {roll:g}, pitch {pitch:g}, roll {yaw:g}"
        )


class TfStaticTransformPublisher(_StaticTransformPublisher):
    """The program `static_transform_publisher` of the package tf: six or seven numbers, parent, child, period [ms]."""

    usage = TF_USAGE

    def _begin(self, words: list[str]) -> None:
        transform = parse_transform(words[:-1])
        self._period = _period(words[-1])
        self._log_angles(transform)
        advice = rotation_advice(transform.child, transform.rotation)
        if advice:
            self._node.warn(advice)
        self._transform = transform
        self._broadcaster = TransformBroadcaster(self._node)
        self._send()
        self._node.create_timer(self._period, self._send)

    def _send(self) -> None:
        message = self._transform.message()
        message.header.stamp = self._node.now() + self._period
        self._broadcaster.send_transform(message)


class Tf2StaticTransformPublisher(_StaticTransformPublisher):
    """The program `static_transform_publisher` of the package tf2_ros.

    It takes six or seven numbers, parent and child; or the name of a parameter that holds a
    geometry_msgs/TransformStamped.
    """

    usage = TF2_USAGE

    def _begin(self, words: list[str]) -> None:
        node = self._node
        message = self._from_parameter(words[0]) if len(words) == 1 else self._from_words(words)
        message.header.stamp = node.now()
        StaticTransformBroadcaster(node).send_transform(message)
        node.info(
            f"Spinning until killed publishing {message.header.frame_id} "
            f"to {message.child_frame_id}"
        )

    def _from_words(self, words: list[str]) -> Any:
        has_period = len(words) in (9, 10) and is_number(words[-1])
        # One word more than with angles may be the period that the program of tf takes.
        if len(words) not in (8, 9) or (has_period and not is_number(words[6])):
            advice = "; the last number looks like a period, which tf takes and tf2_ros does not"
            raise WrongNumberError(advice if has_period else "")
        transform = parse_transform(words)
        self._log_angles(transform)
        return transform.message()

    def _from_parameter(self, name: str) -> Any:
        self._node.info(f"Looking for TF in parameter: {name}")
        value = self._node.get_param(name, None)
        if value is None:
            raise BadTransformError(f"Could not read TF from parameter server: {name}")
        try:
            return fill_message(message_class("geometry_msgs/TransformStamped"), value)
        except MessageError as error:
            raise BadTransformError(f"Could not validate XmlRpcC TF: {error}") from error


def _period(word: str) -> Duration:
    milliseconds = leading_number(word)
    if milliseconds <= 0.0:
        raise BadTransformError(
            f"the period must be a positive number of milliseconds, not {word!r}"
        )
    return Duration.from_nsec(round(milliseconds * 1e6))
