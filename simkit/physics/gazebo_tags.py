"""The tags in `<gazebo>` blocks of a URDF that change how it moves.

Source: sdformat 6 and 9, `parser_urdf.cc`: blocks of one link are read in the order of the file,
the last word counts, a block that names nothing is dropped.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from simkit.urdf.fixed_joints import KEEP_TAGS, TRUE
from simkit.urdf.model import Robot
from simkit.xml import Element

_RIGID = ("kp", "kd", "maxVel", "minDepth", "stopCfm", "stopErp", "fdir1")
"Tags that soften or turn contacts and stops: those of the engine are rigid, and have no direction."


@dataclass(slots=True, kw_only=True)
class LinkTags:
    """What a `<gazebo>` says of a link; None where it says nothing."""

    friction: float | None = None
    """`mu1`."""
    across: float | None = None
    """`mu2`: friction in the other direction."""
    self_collide: bool | None = None
    """`selfCollide`."""
    gravity: bool | None = None
    """Not `turnGravityOff`."""
    decay: float | None = None
    """`dampingFactor`."""
    retro: float | None = None
    """`laserRetro`."""


@dataclass(slots=True, kw_only=True)
class JointTags:
    """What a `<gazebo>` says of a joint."""

    is_kept: bool = False
    """`preserveFixedJoint` or `disableFixedJointLumping`: the links of a fixed joint stay two."""
    stiffness: float = 0.0
    """`springStiffness` [N m/rad or N/m]."""
    rest: float = 0.0
    """`springReference` [rad or m]."""


@dataclass(slots=True, kw_only=True)
class GazeboTags:
    """What the `<gazebo>` blocks of a robot say."""

    links: dict[str, LinkTags] = field(default_factory=dict)
    """By link."""
    joints: dict[str, JointTags] = field(default_factory=dict)
    """By joint."""
    is_static: bool = False
    """Whether the robot stands still for ever."""
    self_collide: bool = False
    """Whether all its links touch each other."""
    notes: list[str] = field(default_factory=list)
    """What has no effect."""

    def of_link(self, name: str) -> LinkTags:
        """What is said of a link."""
        return self.links.get(name) or LinkTags()

    def of_joint(self, name: str) -> JointTags:
        """What is said of a joint."""
        return self.joints.get(name) or JointTags()


def read_gazebo_tags(robot: Robot) -> GazeboTags:
    """The tags of a robot, in the order of its file."""
    tags = GazeboTags()
    root = robot.document.root
    for block in [] if root is None else root.all("gazebo"):
        name = block.get("reference") or ""
        if not name:
            _read_robot(block, tags)
        if name in robot.links:
            _read_link(block, name, tags)
        if name in robot.joints:
            _read_joint(block, name, tags)
    return tags


def _read_robot(block: Element, tags: GazeboTags) -> None:
    for child in block.children:
        if child.name == "static":
            tags.is_static = _flag(child)
        elif child.name in ("self_collide", "selfCollide"):
            tags.self_collide = _flag(child)


def _read_link(block: Element, name: str, tags: GazeboTags) -> None:
    link = tags.links.setdefault(name, LinkTags())
    for child in block.children:
        match child.name:
            case "selfCollide" | "self_collide":
                link.self_collide = _flag(child)
            case "turnGravityOff":
                link.gravity = not _flag(child)
            case "gravity":
                link.gravity = _flag(child)
            case "mu1":
                link.friction = _number(child, name, tags, least=0.0, otherwise=link.friction)
            case "mu2":
                link.across = _number(child, name, tags, least=0.0, otherwise=link.across)
            case "dampingFactor":
                link.decay = _number(child, name, tags, least=0.0, otherwise=link.decay)
            case "laserRetro":
                link.retro = _number(child, name, tags, least=0.0, otherwise=link.retro)
            case _:
                _note_rigid(child, name, tags)


def _read_joint(block: Element, name: str, tags: GazeboTags) -> None:
    joint = tags.joints.setdefault(name, JointTags())
    for child in block.children:
        match child.name:
            case word if word in KEEP_TAGS:
                joint.is_kept = joint.is_kept or _flag(child)
            case "springStiffness":
                joint.stiffness = _number(child, name, tags, least=0.0) or 0.0
            case "springReference":
                joint.rest = _number(child, name, tags, least=-math.inf) or 0.0
            case _:
                _note_rigid(child, name, tags)


def _note_rigid(child: Element, name: str, tags: GazeboTags) -> None:
    if child.name in _RIGID:
        tags.notes.append(
            f"<{child.name}> of {name} has no effect: contacts and stops are rigid here, friction the same all round"
        )


def _flag(element: Element) -> bool:
    return element.text.strip().lower() in TRUE


def _number(
    element: Element, name: str, tags: GazeboTags, *, least: float, otherwise: float | None = None
) -> float | None:
    """A number from a tag; `otherwise`, with a note, if there is none that makes sense."""
    try:
        value = float(element.text)
    except ValueError:
        value = math.nan
    if math.isfinite(value) and value >= least:
        return value
    tags.notes.append(
        f"<{element.name}> of {name} is left out: it cannot be {element.text.strip()!r}"
    )
    return otherwise
