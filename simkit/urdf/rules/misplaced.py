"""Words that people write into URDF where it has none, and what they should write instead.

Most come from SDF, Gazebo's own language, or from another place of URDF.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from simkit.urdf.rules.vocabulary import WORDS
from simkit.urdf.rules.wording import numbers_text, owner, read_numbers, shown
from simkit.xml import Element

_BOTH = 'damping="..." friction="..."'

Advice = Callable[[Element], str]
"""What to write instead of an element, for a person."""

GAZEBO_WORDS = {
    **{"gravity": "turnGravityOff", "kinematic": "kinematic", "self_collide": "selfCollide"},
    **{"mu": "mu1", "mu1": "mu1", "mu2": "mu2", "kp": "kp", "kd": "kd"},
    **{"selfCollide": "selfCollide", "turnGravityOff": "turnGravityOff", "maxVel": "maxVel"},
    **{"velocity_decay": "dampingFactor", "laser_retro": "laserRetro", "minDepth": "minDepth"},
}
"""Properties of a link that stand in its `<gazebo>`, by what people write."""


def advice(element: Element, context: str) -> str:
    """What to write instead of an element that may not stand where it stands; empty if there is no special advice.

    Args:
        element: The element.
        context: What the element that it stands in is meant to be.
    """
    special = _ADVICE.get((context, element.name)) or _ADVICE.get(("", element.name))
    if special is not None:
        return special(element)
    if context in ("link", "visual", "collision") and element.name in GAZEBO_WORDS:
        return _gazebo_word(element)
    homes = [word for word, entry in WORDS.items() if element.name in entry.children]
    if homes and context not in homes:
        return f"Move it into <{'> or <'.join(homes)}>."
    return ""


def _gazebo_word(element: Element) -> str:
    word = GAZEBO_WORDS[element.name]
    value = shown(element.text.strip()) or "..."
    if element.name == "gravity":
        value = "true" if value in ("0", "false") else "false"
    return f"It belongs to Gazebo: write {_block(element, f'<{word}>{value}</{word}>')}."


def _block(element: Element, inner: str) -> str:
    link = owner(element).get("name") or "..."
    return f'<gazebo reference="{shown(link)}">{inner}</gazebo> into the robot'


def _pose_of_a_part(element: Element) -> str:
    return f"<pose> is SDF; URDF writes {_origin(element)}."


def _pose_of_a_link(element: Element) -> str:
    numbers = read_numbers(element.text.strip(), 6)
    height = f"-z {numbers_text(numbers[2:3])}" if numbers and numbers[2] else "-z 0.1"
    return (
        "<pose> is SDF, and a link of URDF has no pose: its joint says where it is, and <origin> in a visual, collision or "
        f"inertial where that is. Where the robot starts, spawn_model says: {height}."
    )


def _origin(element: Element) -> str:
    numbers = read_numbers(" ".join(element.text.split()), 6)
    if numbers is None:
        return '<origin xyz="..." rpy="..."/>'
    return f'<origin xyz="{numbers_text(numbers[:3])}" rpy="{numbers_text(numbers[3:])}"/>'


def _surface(element: Element) -> str:
    found = {one.name: shown(one.text.strip()) for one in element.walk()}
    inner = "".join(
        f"<{name}>{value}</{name}>"
        for name, value in (("mu1", found.get("mu")), ("mu2", found.get("mu2")))
        if value
    )
    inner = inner or "<mu1>...</mu1><mu2>...</mu2>"
    return (
        f"<surface> is SDF; friction of a URDF stands in a <gazebo>: write {_block(element, inner)}; it holds for all "
        "collisions of the link."
    )


def _contact(element: Element) -> str:
    friction = element.child("lateral_friction")
    value = "..." if friction is None else shown(friction.get("value") or "...")
    words = f"<mu1>{value}</mu1><mu2>{value}</mu2>"
    return f"Only Bullet reads it. For friction in Gazebo write {_block(element, words)}."


def _dynamics(element: Element) -> str:
    given = " ".join(f'{one.name}="{shown(one.value)}"' for one in element.attributes)
    return f"URDF calls it <dynamics {given or _BOTH}/>."


def _as_dynamics(element: Element) -> str:
    value = shown(element.text.strip() or element.get("value") or "...")
    return f'Write <dynamics {element.name}="{value}"/>.'


def _as_limit(element: Element) -> str:
    value = shown(element.text.strip() or element.get("value") or "...")
    return f'It is an attribute of <limit>: <limit {element.name}="{value}" .../>.'


def _sensor(element: Element) -> str:
    return f"A sensor stands in a <gazebo>: write {_block(element, '<sensor ...>...</sensor>')}."


def _colour_of(element: Element) -> str:
    rgba = shown(element.get("rgba") or element.text.strip() or "0.75 0.75 0.75 1")
    return f'A colour stands in a <material> of a <visual>: <material name="..."><color rgba="{rgba}"/></material>.'


def _says(text: str) -> Advice:
    return lambda _: text


_LINKS_ORIGIN = (
    "A link has no origin of its own: its joint says where it is. Move it into the <visual>, <collision> or <inertial>, or into "
    "the joint above the link."
)
_COLOURS_OF_GAZEBO = (
    "URDF knows only <color>; Gazebo takes a <material> of its own, e.g. Gazebo/Orange, from the "
    "<gazebo> of the link."
)
_ADVICE: Mapping[tuple[str, str], Advice] = {
    ("link", "pose"): _pose_of_a_link,
    ("", "pose"): _pose_of_a_part,
    ("", "surface"): _surface,
    ("joint", "joint_properties"): _dynamics,
    ("joint", "damping"): _as_dynamics,
    ("joint", "friction"): _as_dynamics,
    **{("joint", name): _as_limit for name in ("lower", "upper", "effort", "velocity")},
    ("link", "contact"): _contact,
    ("link", "sensor"): _sensor,
    ("link", "origin"): _says(_LINKS_ORIGIN),
    ("link", "color"): _colour_of,
    ("visual", "color"): _colour_of,
    ("robot", "color"): _colour_of,
    ("collision", "material"): _says(
        "A collision is not seen, and has no colour: take it out, or move it into the <visual>."
    ),
    ("link", "material"): _says("Move it into the <visual>."),
    ("geometry", "material"): _says("Move it out of the <geometry>, into the <visual>."),
    ("robot", "plugin"): _says(
        "A plugin stands in a <gazebo>: <gazebo><plugin ...>...</plugin></gazebo>."
    ),
    ("link", "plugin"): _says(
        "A plugin stands in a <gazebo> of the robot: <gazebo><plugin ...>...</plugin></gazebo>."
    ),
    ("joint", "hardwareInterface"): _says("It belongs into a <transmission>."),
    ("robot", "static"): _says("It belongs to Gazebo: <gazebo><static>true</static></gazebo>."),
    ("robot", "include"): _says('URDF has no include; xacro has: <xacro:include filename="..."/>.'),
    ("robot", "model"): _says("<model> is SDF; the robot itself is the model: take it out."),
    **{
        ("material", name): _says(_COLOURS_OF_GAZEBO)
        for name in ("ambient", "diffuse", "specular", "emissive", "script")
    },
    ("collision", "verbose"): _says("It has no effect any more: take it out."),
    **{
        ("link", name): _says("Nothing of ROS 1 reads it: take it out.")
        for name in ("self_filter", "collision_checking", "self_collision_checking")
    },
}
