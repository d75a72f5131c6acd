"""TF: where each coordinate frame is, seen from each other, at each moment of the last seconds.

`BufferCore` is the idea, in integers and tuples; `Buffer` takes and gives messages; `TransformListener`
and the broadcasters connect a node. `simkit.tf.transformations` is tf's library of rotations.

One rule: T_ab takes coordinates in b to coordinates in a, and is the pose of b seen from a. So
T_ac = T_ab T_bc, and `lookup_transform("a", "b")` is T_ab.
"""

from simkit.geometry import Transform
from simkit.tf.broadcaster import StaticTransformBroadcaster, TransformBroadcaster
from simkit.tf.buffer import LATEST, Buffer
from simkit.tf.buffer_core import BufferCore
from simkit.tf.echo import echo_text, in_words
from simkit.tf.errors import (
    ConnectivityException,
    DataGap,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TimeoutException,
    TransformException,
)
from simkit.tf.listener import TransformFeed, TransformListener
from simkit.tf.path import StampedTransform

__all__ = [
    "LATEST",
    "Buffer",
    "BufferCore",
    "ConnectivityException",
    "DataGap",
    "ExtrapolationException",
    "InvalidArgumentException",
    "LookupException",
    "StampedTransform",
    "StaticTransformBroadcaster",
    "TimeoutException",
    "Transform",
    "TransformBroadcaster",
    "TransformException",
    "TransformFeed",
    "TransformListener",
    "echo_text",
    "in_words",
]
