"""The words of URDF: which elements and attributes may stand where, and which must.

Source: the URDF specification, and what urdfdom reads.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True, kw_only=True)
class Word:
    """What may stand in an element."""

    children: tuple[str, ...] = ()
    """Elements in it."""
    many: tuple[str, ...] = ()
    """Those of them that may stand there more than once."""
    required: tuple[str, ...] = ()
    """Attributes that must be there."""
    optional: tuple[str, ...] = ()
    """Attributes that may be there."""

    @property
    def attributes(self) -> tuple[str, ...]:
        """All its attributes."""
        return (*self.required, *self.optional)


SHAPES = ("box", "cylinder", "sphere", "mesh")
_TENSOR = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
_ORIGIN = ("xyz", "rpy")
_PARTS_OF_A_ROBOT = (
    *("link", "joint", "material"),
    *("gazebo", "transmission", "ros2_control", "sensor"),
)
_PARTS_OF_A_JOINT = (
    *("origin", "parent", "child", "axis", "limit"),
    *("dynamics", "mimic", "calibration", "safety_controller"),
)

WORDS: Mapping[str, Word] = {
    "robot": Word(
        children=_PARTS_OF_A_ROBOT,
        many=_PARTS_OF_A_ROBOT,
        required=("name",),
        optional=("version",),
    ),
    "link": Word(
        children=("inertial", "visual", "collision"),
        many=("visual", "collision"),
        required=("name",),
        optional=("type",),
    ),
    "inertial": Word(children=("origin", "mass", "inertia")),
    "origin": Word(optional=_ORIGIN),
    "mass": Word(required=("value",)),
    "inertia": Word(required=_TENSOR),
    "visual": Word(children=("origin", "geometry", "material"), optional=("name",)),
    "collision": Word(children=("origin", "geometry"), optional=("name", "group")),
    "geometry": Word(children=SHAPES),
    "box": Word(required=("size",)),
    "cylinder": Word(required=("radius", "length")),
    "sphere": Word(required=("radius",)),
    "mesh": Word(required=("filename",), optional=("scale",)),
    "material": Word(children=("color", "texture"), required=("name",)),
    "color": Word(required=("rgba",)),
    "texture": Word(required=("filename",)),
    "joint": Word(children=_PARTS_OF_A_JOINT, required=("name", "type")),
    "parent": Word(required=("link",)),
    "child": Word(required=("link",)),
    "axis": Word(required=("xyz",)),
    "limit": Word(required=("effort", "velocity"), optional=("lower", "upper")),
    "dynamics": Word(optional=("damping", "friction")),
    "mimic": Word(required=("joint",), optional=("multiplier", "offset")),
    "calibration": Word(optional=("rising", "falling", "reference_position")),
    "safety_controller": Word(
        required=("k_velocity",), optional=("soft_lower_limit", "soft_upper_limit", "k_position")
    ),
}
"""By the name of the element. A joint in a `<transmission>`, and what is in `OTHER_TONGUES`, is not of URDF."""

OTHER_TONGUES = ("gazebo", "transmission", "ros2_control", "sensor")
"""Elements of a robot whose inside has rules of its own."""
JOINT_TYPES = ("fixed", "revolute", "continuous", "prismatic", "floating", "planar")
