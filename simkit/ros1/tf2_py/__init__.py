"""tf2_py for scripts of this kit: the buffer of transforms under tf2's own names, and what it raises.

Source: tf2_py of ROS Noetic, behaviour and texts.
"""

from simkit.graph.process import client as _client

_client.require_node_process()

from simkit.tf.errors import (  # noqa: E402 - after the refusal outside nodes
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TimeoutException,
    TransformException,
)

from .buffer_core import BufferCore  # noqa: E402

__all__ = [
    "BufferCore",
    "ConnectivityException",
    "ExtrapolationException",
    "InvalidArgumentException",
    "LookupException",
    "TimeoutException",
    "TransformException",
]
