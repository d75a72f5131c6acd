"""A transformer that fills itself from the topics /tf and /tf_static."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .transformer_ros import TransformerROS

if TYPE_CHECKING:
    from simkit.ros1 import tf2_ros
else:
    import tf2_ros


class TransformListener(TransformerROS):
    """Hears all transforms from now on; right after its creation it knows none.

    Args:
        *args: As `Transformer`.
        **kwargs: As `Transformer`.
    """

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self._listener = tf2_ros.TransformListener(self._buffer)
        self.setUsingDedicatedThread(True)
