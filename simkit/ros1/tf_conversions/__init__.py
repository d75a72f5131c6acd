"""tf_conversions for scripts of this kit: `tf_conversions.transformations`, which is tf's library.

Tutorials of tf2 take it from here. What needs PyKDL (`posemath`) is left out.
"""

from simkit.graph.process import client as _client

_client.require_node_process()

from . import transformations  # noqa: E402 - after the refusal outside nodes

__all__ = ["transformations"]
