"""tf for scripts of this kit: the names and texts of ROS 1's tf, over simkit's buffer.

`lookupTransform("a", "b", time)` gives the pose of b seen from a. Frame names may carry the
leading slash of old books here; tf2 refuses it.

Source: tf 1.13 of ROS Noetic, behaviour and texts.
"""

from simkit.graph.process import client as _client

_client.require_node_process()

from simkit.tf.errors import (  # noqa: E402 - after the refusal outside nodes
    ConnectivityException,
    ExtrapolationException,
    LookupException,
)
from simkit.tf.errors import TransformException as Exception  # noqa: A004, E402 - tf's name

from . import transformations  # noqa: E402
from .broadcaster import TransformBroadcaster  # noqa: E402
from .listener import TransformListener  # noqa: E402
from .transformer import Transformer  # noqa: E402
from .transformer_ros import TransformerROS  # noqa: E402

__all__ = [
    "ConnectivityException",
    "Exception",
    "ExtrapolationException",
    "LookupException",
    "TransformBroadcaster",
    "TransformListener",
    "Transformer",
    "TransformerROS",
    "transformations",
]
