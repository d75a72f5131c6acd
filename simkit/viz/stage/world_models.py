"""The models of a world: their shapes, in the colours of Gazebo's window."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any, Final, Protocol

from simkit.geometry import (
    Quaternion,
    Transform,
    Vector,
    multiply,
    quaternion_from_z,
)
from simkit.physics import Model, Plane, World
from simkit.physics.sdf import SdfModel
from simkit.urdf import Collision, Robot, Visual
from simkit.urdf.rules.colours import COLOURS
from simkit.viz.stage.parts import Color, Role, Solid
from simkit.viz.stage.robot import painted, part_solid


class Thing(Protocol):
    """A model in the world, with the file that it comes from: `simkit.gazebo.Spawned` is one."""

    @property
    def model(self) -> Model:
        """Its bodies and joints."""

    @property
    def robot(self) -> Robot | None:
        """The URDF that it was made from."""

    @property
    def sdf(self) -> SdfModel | None:
        """The SDF that it was made from."""

    @property
    def plugins(self) -> tuple[Any, ...]:
        """What works on it."""


class WorldOfThings(Protocol):
    """A world with its models: `simkit.gazebo.Gazebo` is one."""

    @property
    def world(self) -> World:
        """The physics."""

    @property
    def spawned(self) -> Mapping[str, Thing]:
        """The models by name, the oldest first."""


def link_frame(model: str, link: str) -> str:
    """The name of a link among all of the world, as Gazebo writes it."""
    return f"{model}::{link}"


GREY: Final[Color] = (0.7, 0.7, 0.7)
"""Of a link without a material, and of `Gazebo/Grey`."""
_PREFIX: Final = "Gazebo/"
_CLEAR: Final = "Transparent"
_CLEAR_ALPHA: Final = 0.5
_ENDINGS: Final = ("Overlay", _CLEAR, "GlowOutline", "Glow", "Laser", "Bright")
_MORE: Final[dict[str, Color]] = {
    "Grey": GREY,
    "Gray": GREY,
    "DarkGray": COLOURS["DarkGrey"],
    "FlatBlack": (0.1, 0.1, 0.1),
    "RedBright": (0.87, 0.26, 0.07),
    "Wood": (0.62, 0.44, 0.26),
    "Bricks": (0.6, 0.33, 0.26),
}
"Lit colours of materials that are pictures, or darker in the shade than in the light."


def gazebo_color(name: str) -> tuple[Color, float] | None:
    """Colour and opacity of a material of Gazebo; None if it is unknown here.

    Args:
        name: As in `<material>Gazebo/Orange</material>`.

    Source:
        gazebo.material of Gazebo 9, the diffuse colours; what is a picture there is one colour here.
    """
    short = name.strip().removeprefix(_PREFIX)
    alpha = _CLEAR_ALPHA if _CLEAR in short else 1.0
    while short:
        color = _MORE.get(short) or COLOURS.get(short)
        if color is not None:
            return color, alpha
        ending = next((one for one in _ENDINGS if short.endswith(one)), "")
        if not ending:
            return None
        short = short.removesuffix(ending)
    return None


TOUCHED: Final[Color] = (1.0, 0.44, 0.0)
"""Collision shapes are orange in Gazebo."""
TOUCHED_ALPHA: Final = 0.5
"""Their opacity."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Ground:
    """A plane without end, which is drawn as large as the picture needs it."""

    link: str
    """The link that it belongs to."""
    translation: Vector
    """A point of it in the frame of the link [m]."""
    rotation: Quaternion
    """Turns z to its normal."""
    color: Color
    """Its colour."""


@dataclass(frozen=True, slots=True, kw_only=True)
class ModelShapes:
    """What there is to draw of a model."""

    solids: tuple[Solid, ...] = ()
    """Its shapes; their links are named `model::link`."""
    grounds: tuple[Ground, ...] = ()
    """Its planes."""
    notes: tuple[str, ...] = ()
    """A sentence for each shape that is not drawn as it is written."""


def model_shapes(thing: Thing, *, name: str) -> ModelShapes:
    """What there is to draw of a model, of the links that are simulated.

    A link has the colour of its `<gazebo>` material, else that of its URDF, else it is grey.

    Args:
        thing: The model.
        name: What it is called in the view.

    Source:
        Gazebo 9 for the shapes; it shows a link without a `<gazebo>` material grey, whatever its URDF says.
    """
    notes: list[str] = []
    grounds: list[Ground] = []
    if thing.robot is not None:
        solids = list(_of_robot(thing.robot, notes))
    elif thing.sdf is not None:
        solids = list(_of_sdf(thing.sdf, grounds, notes))
    else:
        solids = list(_of_plan(thing, grounds))
    known = set(thing.model.links)
    return ModelShapes(
        solids=tuple(
            _touched(replace(solid, link=link_frame(name, solid.link)))
            for solid in solids
            if solid.link in known
        ),
        grounds=tuple(grounds),
        notes=tuple(dict.fromkeys(notes)),
    )


def _touched(solid: Solid) -> Solid:
    if solid.role is not Role.COLLISION:
        return solid
    return replace(solid, color=TOUCHED, alpha=TOUCHED_ALPHA)


def _of_robot(robot: Robot, notes: list[str]) -> Iterator[Solid]:
    materials = gazebo_materials(robot)
    for link in robot.links.values():
        for visual in link.visuals:
            named = gazebo_color(materials.get(link.name, ""))
            color, alpha = named or painted(visual.material) or (GREY, 1.0)
            yield from part_solid(link.name, visual, color, alpha, notes)
        for collision in link.collisions:
            yield from part_solid(link.name, collision, TOUCHED, TOUCHED_ALPHA, notes)


def gazebo_materials(robot: Robot) -> Mapping[str, str]:
    """Names of the materials in the `<gazebo>` blocks of a robot, by link; the last one of a link counts."""
    root = robot.document.root
    found: dict[str, str] = {}
    for block in [] if root is None else root.all("gazebo"):
        element = block.child("material")
        if element is not None:
            found[block.get("reference") or ""] = (element.get("value") or element.text).strip()
    return found


def _of_sdf(model: SdfModel, grounds: list[Ground], notes: list[str]) -> Iterator[Solid]:
    for link in model.links:
        for visual in link.visuals:
            color, alpha = gazebo_color(visual.material) or (GREY, 1.0)
            if visual.rgba is not None:
                red, green, blue, alpha = (min(max(value, 0.0), 1.0) for value in visual.rgba)
                color = (red, green, blue)
            if isinstance(visual.geometry, Plane):
                translation, rotation = visual.pose.transform @ _upright(visual.geometry)
                grounds.append(
                    Ground(link=link.name, translation=translation, rotation=rotation, color=color)
                )
                continue
            part = Visual(geometry=visual.geometry, origin=visual.pose)
            yield from part_solid(link.name, part, color, alpha, notes)
        for collision in link.collisions:
            if not isinstance(collision.geometry, Plane):
                touched = Collision(geometry=collision.geometry, origin=collision.pose)
                yield from part_solid(link.name, touched, TOUCHED, TOUCHED_ALPHA, notes)


def _upright(plane: Plane) -> Transform:
    return Transform((0.0, 0.0, 0.0), quaternion_from_z(plane.normal))


def _of_plan(thing: Thing, grounds: list[Ground]) -> Iterator[Solid]:
    """Of a model without a file, what others touch."""
    for body in thing.model.plan.bodies.values():
        for shape in body.shapes:
            translation, rotation = shape.frame
            if isinstance(shape.solid, Plane):
                rotation = multiply(rotation, quaternion_from_z(shape.solid.normal))
                grounds.append(
                    Ground(link=body.name, translation=translation, rotation=rotation, color=GREY)
                )
                continue
            yield Solid(
                link=body.name,
                role=Role.VISUAL,
                shape=shape.solid,
                translation=translation,
                rotation=rotation,
                color=GREY,
            )
