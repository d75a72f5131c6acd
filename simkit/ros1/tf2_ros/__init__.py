"""tf2_ros for scripts of this kit: the names and texts of ROS 1's tf2_ros, over simkit's buffer.

`buffer.lookup_transform("a", "b", time)` gives the pose of b seen from a. Frame names have no
leading slash here: tf2 refuses the one that tf allowed.

Source: tf2_ros of ROS Noetic, behaviour and texts. `BufferClient` is left out.
"""

from typing import TYPE_CHECKING

from simkit.graph.process import client as _client

_client.require_node_process()

if TYPE_CHECKING:
    from simkit.ros1.tf2_py import (
        BufferCore,
        ConnectivityException,
        ExtrapolationException,
        InvalidArgumentException,
        LookupException,
        TimeoutException,
        TransformException,
    )
else:
    from tf2_py import (
        BufferCore,
        ConnectivityException,
        ExtrapolationException,
        InvalidArgumentException,
        LookupException,
        TimeoutException,
        TransformException,
    )

from .buffer import Buffer  # noqa: E402 - after the refusal outside nodes
from .buffer_interface import BufferInterface, NotImplementedException, Stamped  # noqa: E402
from .registration import (  # noqa: E402
    ConvertRegistration,
    TransformRegistration,
    TypeException,
    convert,
)
from .static_transform_broadcaster import StaticTransformBroadcaster  # noqa: E402
from .transform_broadcaster import TransformBroadcaster  # noqa: E402
from .transform_listener import TransformListener  # noqa: E402

__all__ = [
    "Buffer",
    "BufferCore",
    "BufferInterface",
    "ConnectivityException",
    "ConvertRegistration",
    "ExtrapolationException",
    "InvalidArgumentException",
    "LookupException",
    "NotImplementedException",
    "Stamped",
    "StaticTransformBroadcaster",
    "TimeoutException",
    "TransformBroadcaster",
    "TransformException",
    "TransformListener",
    "TransformRegistration",
    "TypeException",
    "convert",
]
