"""Models for the world: texts that are read, the model that comes of one, and why one does not come in."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from simkit.errors import SimkitError
from simkit.packages import PackagePath
from simkit.physics import Model
from simkit.physics.sdf import SdfModel
from simkit.plugins import Plugin
from simkit.urdf import Robot
from simkit.xml import Element, parse_xml


class SpawnError(SimkitError):
    """A model that does not come into the world: why, and what would be right.

    Args:
        status: What Gazebo's service says of it.
        more: What else there is to say.
    """

    def __init__(self, status: str, more: str = "") -> None:
        super().__init__(f"{status} {more}".strip())
        self.status = status
        self.more = more


@dataclass(frozen=True, slots=True, kw_only=True)
class Spawned:
    """One model."""

    name: str
    """Its name in the world."""
    model: Model
    """Its bodies and joints."""
    robot: Robot | None = None
    """The URDF that it was spawned from."""
    sdf: SdfModel | None = None
    """The SDF that it was spawned from, if it was no URDF."""
    plugins: tuple[Plugin[Any], ...] = ()
    """What works on it, in the order of the tags."""
    namespace: str | None = None
    """Namespace of the one who spawned it; None for a model of the world file."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ModelText:
    """The text of a model."""

    text: str
    """URDF or SDF."""
    file: str
    """Name to show for it."""
    name: str
    """Name that the text gives the model."""
    is_urdf: bool
    """Whether it is URDF."""


def read_model(path_or_text: str | Path, packages: PackagePath) -> ModelText:
    """A model for the world.

    Args:
        path_or_text: A file, or the text of one: a text has a `<` in it.
        packages: Says which files may be read.

    Raises:
        SimkitError: There is no such file, or it is no model.
    """
    if isinstance(path_or_text, str) and "<" in path_or_text:
        text, file = path_or_text, ""
    else:
        text, file = _read(Path(path_or_text), packages), Path(path_or_text).name
    root = parse_xml(text, file=file).root
    if root is None or root.name not in ("robot", "sdf"):
        found = "nothing" if root is None else f"<{root.name}>"
        raise SimkitError(
            f"{file or 'this text'} is no model: it begins with {found}, not with <robot> (URDF) or <sdf>"
        )
    return ModelText(text=text, file=file, name=_name(root), is_urdf=root.name == "robot")


def _read(path: Path, packages: PackagePath) -> str:
    if not packages.may_read(path):
        raise SimkitError(f"{path} is in no package, and only those may be read here")
    try:
        return path.read_text("utf-8")
    except (OSError, UnicodeDecodeError) as error:
        reason = getattr(error, "strerror", None) or error
        raise SimkitError(f"{path} cannot be read: {reason}") from None


def _name(root: Element) -> str:
    model = root if root.name == "robot" else root.child("model")
    return (model.get("name") if model is not None else None) or "robot"
