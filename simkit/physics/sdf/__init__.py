"""SDF: world files and models as Gazebo has them, versions 1.4 to 1.7.

`read_world` gives plain values, and names with its place whatever it does not read; `plan_model` makes
of a model in it what a `World` can add.
"""

from simkit.physics.sdf.description import (
    SdfCollision,
    SdfGeometry,
    SdfJoint,
    SdfLight,
    SdfLink,
    SdfModel,
    SdfVisual,
    SdfWorld,
)
from simkit.physics.sdf.library import ModelLibrary
from simkit.physics.sdf.model_plan import plan_model
from simkit.physics.sdf.world_file import read_model_text, read_world, read_world_file

__all__ = [
    "ModelLibrary",
    "SdfCollision",
    "SdfGeometry",
    "SdfJoint",
    "SdfLight",
    "SdfLink",
    "SdfModel",
    "SdfVisual",
    "SdfWorld",
    "plan_model",
    "read_model_text",
    "read_world",
    "read_world_file",
]
