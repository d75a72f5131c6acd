"""The words of URDF, where each may stand, and what a misspelt one was meant to be."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from itertools import islice

from simkit.xml import Attribute, Element


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


OTHER_NAMES = {
    **{("mass", name): "value" for name in ("mass", "val", "kg")},
    **{("limit", name): "lower" for name in ("min", "low")},
    **{("limit", name): "upper" for name in ("max", "high")},
    **{("limit", name): "effort" for name in ("torque", "force")},
    **{("limit", name): "velocity" for name in ("speed", "vel")},
    **{(role, name): "link" for role in ("parent", "child") for name in ("name", "frame")},
    **{("cylinder", name): "length" for name in ("height", "h", "len")},
    **{("origin", name): "xyz" for name in ("position", "pos")},
    **{("origin", name): "rpy" for name in ("rotation", "orientation", "rot")},
    **{("box", name): "size" for name in ("dimensions", "dim", "dims", "xyz")},
    **{(shape, "r"): "radius" for shape in ("cylinder", "sphere")},
    **{("mesh", name): "filename" for name in ("file", "uri", "url", "path")},
    **{("color", name): "rgba" for name in ("rgb", "value", "color")},
}
"""Attributes that people write, by element, and the one that they mean."""
LINK_TAGS = (
    "material", "mu1", "mu2", "fdir1", "kp", "kd", "maxVel", "minDepth", "maxContacts",
    "selfCollide", "turnGravityOff", "dampingFactor", "laserRetro", "gravity", "self_collide",
    "kinematic", "velocity_decay", "enable_wind", "visual", "collision", "sensor", "plugin",
    "light", "projector", "inertial", "pose", "audio_sink", "audio_source", "battery",
    "particle_emitter",
)  # fmt: skip
"""Tags in a `<gazebo>` of a link: those that are translated, then those of SDF that are copied."""

JOINT_TAGS = (
    "stopCfm", "stopErp", "stopKp", "stopKd", "provideFeedback", "implicitSpringDamper",
    "cfmDamping", "springReference", "springStiffness", "initialJointPosition", "fudgeFactor",
    "preserveFixedJoint", "disableFixedJointLumping", "physics", "sensor", "axis",
)  # fmt: skip
"""Tags in a `<gazebo>` of a joint."""

ROBOT_TAGS = (
    "plugin", "static", "self_collide", "allow_auto_disable", "enable_wind", "pose", "model",
    "frame", "light", "gripper",
)  # fmt: skip
"""Tags in a `<gazebo>` without reference."""

MISNAMED: Mapping[str, str] = {
    "mu": "mu1",
    "friction": "mu1",
    "color": "material",
    "colour": "material",
    "selfCollision": "selfCollide",
    "gravityOff": "turnGravityOff",
    "disableGravity": "turnGravityOff",
    "damping": "dampingFactor",
    "preserveFixedJoints": "preserveFixedJoint",
}
"""Words that are no tags, with the tag that is meant."""

SWITCHES = (
    "selfCollide", "turnGravityOff", "provideFeedback", "implicitSpringDamper",
    "preserveFixedJoint", "disableFixedJointLumping",
)  # fmt: skip
"""Tags that hold true or false."""

NUMBERS = (
    "mu1", "mu2", "kp", "kd", "maxVel", "minDepth", "maxContacts", "dampingFactor",
    "laserRetro", "stopCfm", "stopErp",
)  # fmt: skip
"""Tags that hold a number."""
SENSOR_TYPES = (
    "altimeter", "camera", "contact", "depth", "depth_camera", "force_torque", "gps",
    "gpu_ray", "imu", "logical_camera", "magnetometer", "multicamera",
    "navsat", "ray", "rfid", "rfidtag", "rgbd_camera", "sonar", "thermal_camera",
    "wireless_receiver", "wireless_transmitter",
)  # fmt: skip
"""Types of a `<sensor>`."""

_ALIKE = 0.7
"""From this similarity on, of 1, a word passes for a misspelt one."""
_LONGEST = 40
"""Longer words are no slip of the pen; comparing them would take time [letters]."""
_MOST = 40
"""So many unknown attributes of an element are compared with what may stand there; nobody misspells more of them."""


@lru_cache(maxsize=1024)
def nearest(written: str, words: tuple[str, ...]) -> str | None:
    """The word of `words` that `written` looks like, whatever its capitals; None if it looks like none."""
    if written in words:
        return written
    if len(written) > _LONGEST:
        return None
    import difflib  # only a file with a fault needs it

    folded = {word.lower(): word for word in words}
    found = difflib.get_close_matches(written.lower(), folded, n=1, cutoff=_ALIKE)
    # Of `xzy` and `xyz` too few letters agree, but two that changed places are the commonest slip.
    found = found or [word for word in folded if sorted(word) == sorted(written.lower())]
    return folded[found[0]] if found else None


def meant_word(element: Element, words: tuple[str, ...]) -> str | None:
    """Which of the words that may stand here an element is meant to be.

    Args:
        element: Any element.
        words: Names of the elements that may stand where it stands.

    Returns:
        Its own name if that may stand here, else the one that it looks like. A word that URDF knows from another place counts
        as misspelt only if what it holds fits the other word.
    """
    if element.name in words:
        return element.name
    near = None if ":" in element.name else nearest(element.name, words)
    if near is None or element.name not in WORDS:
        return near
    word = WORDS[near]
    fits = any(element.attribute(name) for name in word.attributes)
    return near if fits or any(element.child(name) for name in word.children) else None


def meant_children(element: Element, context: str) -> dict[str, list[Element]]:
    """The children of an element by the word that each is meant to be, misspelt ones behind the right ones.

    Args:
        element: The element.
        context: The word that the element itself is meant to be.
    """
    words = WORDS[context].children
    found: dict[str, list[Element]] = {word: [] for word in words}
    misspelt: list[tuple[str, Element]] = []
    for child in element.children:
        if child.name in found:
            found[child.name].append(child)
        elif (word := meant_word(child, words)) is not None:
            misspelt.append((word, child))
    for word, child in misspelt:
        found[word].append(child)
    return found


def meant_attribute(element: Element, name: str, context: str) -> Attribute | None:
    """The attribute `name` of an element, or a misspelt one that looks like it; None if there is neither."""
    exact = element.attribute(name)
    if exact is not None:
        return exact
    return next((one for one, word in misspelt_attributes(element, context) if word == name), None)


def misspelt_attributes(element: Element, context: str) -> list[tuple[Attribute, str]]:
    """The unknown attributes of an element that look like ones it lacks, each with the one that it looks like.

    Args:
        element: The element.
        context: The word that the element itself is meant to be.
    """
    known = WORDS[context].attributes
    missing = tuple(one for one in known if element.attribute(one) is None)
    unknown = (one for one in element.attributes if one.name not in known)
    meant: dict[str, Attribute] = {}
    for one in islice(unknown, _MOST):
        word = OTHER_NAMES.get((context, one.name)) or nearest(one.name, missing)
        if word in missing:
            meant.setdefault(word, one)
    return [(one, word) for word, one in meant.items()]


def first(elements: Iterable[Element]) -> Element | None:
    """The first of some elements; None if there are none."""
    return next(iter(elements), None)


def in_context(robot: Element | None) -> Iterator[tuple[Element, str]]:
    """The robot and all elements of URDF below it, each with the word of URDF that it is meant to be.

    Elements that may not stand where they stand are left out with all that is in them, but for links and joints, which the
    sheet lists as well. What is in `<gazebo>` and its kin is not of URDF.

    Args:
        robot: The root; None if there is none.

    Yields:
        Elements in the order of the text.
    """
    waiting = [] if robot is None else [(robot, "robot")]
    while waiting:
        element, word = waiting.pop()
        if word in WORDS:
            yield element, word
        if word not in OTHER_TONGUES:
            waiting.extend(reversed(list(_below(element, word))))


def _below(element: Element, word: str) -> Iterator[tuple[Element, str]]:
    words = WORDS[word].children if word in WORDS else ()
    for child in element.children:
        meaning = meant_word(child, words)
        if meaning is None and child.name in ("link", "joint"):
            meaning = child.name
        if meaning is not None or child.name not in OTHER_TONGUES:
            yield child, meaning or ""


def tag_value(element: Element) -> str:
    """The value of a tag in a `<gazebo>`: its attribute `value`, or its text."""
    return (element.get("value") or element.text).strip()


def is_switch(text: str) -> bool:
    """Whether a text says true or false, as sdformat reads it."""
    return text.strip().lower() in ("true", "false", "1", "0", "yes", "no")
