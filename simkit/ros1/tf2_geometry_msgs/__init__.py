"""tf2_geometry_msgs for scripts of this kit: stamped messages from one frame into another.

Importing it teaches `tf2_ros.Buffer.transform` the stamped messages of geometry_msgs.

Source: tf2_geometry_msgs of ROS Noetic; PyKDL is not needed here, and `transform_to_kdl` is left out.
"""

from simkit.graph.process import client as _client

_client.require_node_process()

from .tf2_geometry_msgs import (  # noqa: E402 - after the refusal outside nodes
    do_transform_point,
    do_transform_pose,
    do_transform_vector3,
    do_transform_wrench,
    from_msg_msg,
    to_msg_msg,
)

__all__ = [
    "do_transform_point",
    "do_transform_pose",
    "do_transform_vector3",
    "do_transform_wrench",
    "from_msg_msg",
    "to_msg_msg",
]
