"""static_transform_publisher of the package tf: repeats one transform on /tf.

Source: tf `static_transform_publisher.cpp`: each message is dated one period ahead, so that the
transform is known at every moment.
"""

from __future__ import annotations

from simkit.graph import Node
from simkit.msgs import Duration
from simkit.nodes.program import Program
from simkit.nodes.tf_tools.fixed_transform import (
    BadTransformError,
    WrongNumberError,
    parse_transform,
    tell_reading,
)
from simkit.nodes.tf_tools.numbers import leading_number
from simkit.tf import TransformBroadcaster
from simkit.tf.admission import rotation_advice

USAGE = """\
Sends one transform again and again.
Usage: static_transform_publisher x y z yaw pitch roll frame_id child_frame_id period(milliseconds)
OR
Usage: static_transform_publisher x y z qx qy qz qw frame_id child_frame_id period(milliseconds)

It is the pose of child_frame_id in frame_id.
"""
"""What the program prints when its arguments are wrong."""


class TfStaticTransformPublisher(Program):
    """The program `static_transform_publisher` of the package tf.

    Args:
        node: Its place in the graph.
        argv: Six or seven numbers, parent, child, period [ms].
    """

    def __init__(self, node: Node, argv: list[str]) -> None:
        super().__init__(node)
        try:
            self._transform = parse_transform(argv[:-1])
            self._period = _period(argv[-1])
        except (WrongNumberError, IndexError):
            self._print(USAGE)
            node.error(
                "static_transform_publisher exited due to not having the right number of arguments"
            )
            self._exit(255)
            return
        except BadTransformError as error:
            node.fatal(str(error))
            self._exit(1)
            return
        tell_reading(node, self._transform)
        advice = rotation_advice(self._transform.child, self._transform.rotation)
        if advice:
            node.warn(advice)
        self._broadcaster = TransformBroadcaster(node)
        self._send()
        node.create_timer(self._period, self._send)

    def _send(self) -> None:
        message = self._transform.message()
        message.header.stamp = self._node.now() + self._period
        self._broadcaster.send_transform(message)


def _period(word: str) -> Duration:
    milliseconds = leading_number(word)
    if milliseconds <= 0.0:
        raise BadTransformError(
            f"the period must be a positive number of milliseconds, not {word!r}"
        )
    return Duration.from_nsec(round(milliseconds * 1e6))
