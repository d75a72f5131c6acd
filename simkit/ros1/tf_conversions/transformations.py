"""`tf.transformations`: rotations and homogeneous matrices; see `simkit.tf.transformations`."""

from simkit.tf.transformations import *  # noqa: F403 - the same names, all of them
from simkit.tf.transformations import __all__ as __all__
