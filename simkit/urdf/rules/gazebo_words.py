"""What may stand in a `<gazebo>`: tags for links and joints, and the colours that Gazebo knows.

Source: the conversion from URDF to SDF in sdformat 6 and 9; the materials of Gazebo 9.
"""

from __future__ import annotations

from collections.abc import Mapping

from simkit.xml import Element

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

COLOURS: Mapping[str, tuple[float, float, float]] = {
    "Black": (0.0, 0.0, 0.0),
    "Blue": (0.0, 0.0, 1.0),
    "DarkGrey": (0.175, 0.175, 0.175),
    "Gold": (0.8, 0.65, 0.19),
    "Green": (0.0, 1.0, 0.0),
    "Grey": (0.3, 0.3, 0.3),
    "Gray": (0.3, 0.3, 0.3),
    "Indigo": (0.33, 0.0, 0.5),
    "Orange": (1.0, 0.51, 0.05),
    "Purple": (1.0, 0.0, 1.0),
    "Red": (1.0, 0.0, 0.0),
    "SkyBlue": (0.13, 0.44, 0.7),
    "Turquoise": (0.0, 1.0, 1.0),
    "White": (1.0, 1.0, 1.0),
    "Yellow": (1.0, 1.0, 0.0),
    "ZincYellow": (0.97, 0.95, 0.2),
}
"""Materials of Gazebo that are one colour: red, green, blue from 0 to 1, as seen in plain light."""

PATTERNS = (
    "BlueGlow", "BlueLaser", "BlueTransparent", "BuildingFrame", "Bricks", "CeilingTiled",
    "CloudySky", "Chrome", "DarkGray", "DarkMagentaTransparent", "DarkOrangeTransparent",
    "DarkYellow", "DepthMap", "Editor", "FlatBlack", "Fish", "Footway", "Grass", "GrayGrid",
    "GreenGlow", "GreenTransparent", "GreyGradientSky", "GreyTransparent", "JointAnchor",
    "LaserGlow", "LightBlueLaser", "LightOff", "LightOn", "LtGreenTransparent", "Mud",
    "Orange", "OrangeTransparent", "PaintedWall", "PioneerBody", "Pedestrian", "PurpleGlow",
    "RedBright", "RedGlow", "RedTransparent", "RedTransparentOverlay", "Residential", "Road",
    "RustySteel", "RustyBarrel", "Runway", "Shell", "SkyBlue", "Smoke", "Spherical",
    "TrunkTexture", "TurquoiseGlow", "TurquoiseGlowOutline", "WaveDisplay", "WhiteGlow",
    "WireBox", "Wood", "WoodFloor", "WoodPallet", "WoodTile", "YellowGlow",
    "YellowTransparent", "Motorway", "Steep",
)  # fmt: skip
"""More materials of Gazebo, which are pictures, glow, or let light through."""


def tag_value(element: Element) -> str:
    """The value of a tag in a `<gazebo>`: its attribute `value`, or its text."""
    return (element.get("value") or element.text).strip()


def is_switch(text: str) -> bool:
    """Whether a text says true or false, as sdformat reads it."""
    return text.strip().lower() in ("true", "false", "1", "0", "yes", "no")
