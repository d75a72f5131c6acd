"""World files: SDF 1.4 to 1.7, with models of simple shapes, written in place or included."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from simkit.diagnostics import Diagnostic, Severity, in_order
from simkit.errors import SimkitError
from simkit.physics.engine import GRAVITY, STEP_NS
from simkit.physics.errors import WorldFileError
from simkit.physics.sdf.description import SdfLight, SdfModel, SdfWorld
from simkit.physics.sdf.library import ModelLibrary
from simkit.physics.sdf.models import read_model_element, renamed
from simkit.physics.sdf.page import Page
from simkit.physics.sdf.rules import NUMBER, SYNTAX
from simkit.xml import Document, Element, parse_xml

OLDEST, NEWEST = (1, 4), (1, 7)
"""Versions of SDF that are read."""
DEEPEST = 10
"""So many files may include each other."""

_WORLD = ["include", "model", "light", "gravity", "physics", "plugin"]
_WORLD_SILENT = [
    "gui",
    "scene",
    "wind",
    "atmosphere",
    "magnetic_field",
    "spherical_coordinates",
    "audio",
]
_INCLUDE = ["uri", "name", "pose", "static", "plugin"]


@dataclass(slots=True)
class _Contents:
    """What is in a world, while it is read."""

    models: list[SdfModel] = field(default_factory=list)
    lights: list[SdfLight] = field(default_factory=list)


def read_world(text: str | bytes, *, file: str, library: ModelLibrary | None = None) -> SdfWorld:
    """A world file.

    Args:
        text: The file.
        file: Name to show for it.
        library: Where included models are found; only those that are built in if None.

    Raises:
        WorldFileError: It is not well-formed, no world, of a version that is not read, includes what
            is not there, or a model in it cannot be.
    """
    page = open_page(text, file=file, library=library or ModelLibrary())
    root = page.document.root
    world = None if root is None else root.child("world")
    if root is None or world is None:
        raise _refused(
            page.document, "there is no <world> in it", 'Write <world name="default"> in <sdf>.'
        )
    page.leave_out(root, ["world"])
    page.leave_out(world, _WORLD, silent=_WORLD_SILENT)
    contents = _Contents()
    for child in world.children:
        _take(page, child, contents)
    _check_names(page, world, contents)
    return SdfWorld(
        name=world.get("name") or "default",
        gravity=_gravity(page, world),
        step_ns=_step(page, world),
        models=tuple(contents.models),
        lights=tuple(contents.lights),
        plugins=tuple(world.all("plugin")),
        diagnostics=in_order(page.found),
    )


def read_world_file(path: str | Path, *, library: ModelLibrary | None = None) -> SdfWorld:
    """A world file on disk.

    Args:
        path: The file.
        library: As in `read_world`.

    Raises:
        WorldFileError: As `read_world`, or it cannot be read.
    """
    try:
        data = Path(path).read_bytes()
    except OSError as error:
        reason = "there is no such file" if isinstance(error, FileNotFoundError) else error.strerror
        raise WorldFileError(f"{path}: {reason}") from None
    return read_world(data, file=str(path), library=library)


def read_model_text(
    text: str | bytes, *, file: str, library: ModelLibrary | None = None
) -> tuple[SdfModel, tuple[Diagnostic, ...]]:
    """The model of an SDF file that holds one, as `spawn_model -sdf` takes it, and what is not read of it.

    Args:
        text: The file.
        file: Name to show for it.
        library: As in `read_world`.

    Raises:
        WorldFileError: It is not well-formed, holds no model, or the model cannot be.
    """
    page = open_page(text, file=file, library=library or ModelLibrary())
    root = page.document.root
    element = None if root is None else root.child("model")
    if element is None:
        raise _refused(
            page.document, "there is no <model> in it", 'Write <model name="..."> in <sdf>.'
        )
    model = read_model_element(page, element)
    return model, in_order(page.found)


def open_page(
    text: str | bytes,
    *,
    file: str,
    library: ModelLibrary,
    above: Page | None = None,
) -> Page:
    """A file that is well-formed, with the version of SDF that it says.

    Args:
        text: The file.
        file: Name to show for it.
        library: Where included models are found.
        above: The page that includes it.

    Raises:
        WorldFileError: It is not well-formed, or no SDF of a version that is read.
    """
    document = parse_xml(text, file=file)
    root = document.root
    if document.faults:
        fault = document.faults[0]
        found = [_of_fault(document, one) for one in range(len(document.faults))]
        place = f"{file}:{fault.span.line}:{fault.span.column}"
        raise WorldFileError(f"{place}: {fault.what}; {fault.remedy}", found)
    if root is None or root.name != "sdf":
        name = "nothing" if root is None else f"<{root.name}>"
        raise _refused(document, f"the file holds {name}, not <sdf>", 'Write <sdf version="1.6">.')
    page = Page(document=document, version=OLDEST, library=library)
    if above is not None:
        page.found, page.depth = above.found, above.depth + 1
    page.version = _version(page, root)
    return page


def _take(page: Page, element: Element, contents: _Contents) -> None:
    """Take in one element of a world."""
    match element.name:
        case "model":
            contents.models.append(read_model_element(page, element))
        case "light":
            contents.lights.append(_light(page, element))
        case "include":
            _include(page, element, contents)


def _include(page: Page, element: Element, contents: _Contents) -> None:
    page.leave_out(element, _INCLUDE)
    uri = page.text(element, "uri")
    if not uri:
        raise page.refuse(
            element, "an <include> has no <uri>", "Write <uri>model://ground_plane</uri>."
        )
    try:
        text, file = page.library.read(uri)
    except SimkitError as error:
        raise page.refuse(
            element.child("uri") or element, f"{uri} is not found: {error}", _LIBRARY
        ) from None
    inner = open_page(text, file=file, library=page.library, above=page)
    root = inner.document.root
    for child in [] if root is None else root.children:
        if child.name == "model":
            model = renamed(
                read_model_element(inner, child),
                name=page.text(element, "name"),
                pose=page.pose(element) if element.child("pose") else None,
                is_static=page.flag(element, "static") if element.child("static") else None,
                uri=uri,
            )
            contents.models.append(model)
        elif child.name == "light":
            contents.lights.append(_light(inner, child))


_LIBRARY = "Put its folder, with a model.config, into the folder models of a package."


def _light(page: Page, element: Element) -> SdfLight:
    return SdfLight(
        name=element.get("name") or "",
        type=element.get("type") or "point",
        pose=page.pose(element),
        diffuse=page.colour(element, "diffuse") or (1.0, 1.0, 1.0, 1.0),
        direction=page.vector(element, "direction", (0.0, 0.0, -1.0)),
    )


def _gravity(page: Page, world: Element) -> tuple[float, float, float]:
    """Gravity: a child of the world, before SDF 1.6 of its physics."""
    physics = world.child("physics")
    inner = GRAVITY if physics is None else page.vector(physics, "gravity", GRAVITY)
    return page.vector(world, "gravity", inner)


def _step(page: Page, world: Element) -> int:
    """Time of one step [ns]; other settings of physics engines do not change ours."""
    physics = world.child("physics")
    if physics is None:
        return STEP_NS
    step = page.number(physics, "max_step_size", STEP_NS * 1e-9)
    if not 1e-5 <= step <= 0.01:
        child = physics.child("max_step_size") or physics
        page.say(child, f"steps of {step:g} s make no simulation", "Write 0.001.", rule=NUMBER)
        return STEP_NS
    return round(step * 1e9)


def _check_names(page: Page, world: Element, contents: _Contents) -> None:
    seen: set[str] = set()
    for model in contents.models:
        if model.name in seen:
            raise page.refuse(
                world, f"there are two models named {model.name}", "Give each a <name> of its own."
            )
        seen.add(model.name)


def _version(page: Page, root: Element) -> tuple[int, int]:
    text = root.get("version") or ""
    major, _, minor = text.strip().partition(".")
    if not major.isdigit() or not minor.isdigit():
        raise page.refuse(root, f"{text!r} is no version of SDF", 'Write <sdf version="1.6">.')
    version = (int(major), int(minor))
    if not OLDEST <= version <= NEWEST:
        page.say(root, f"SDF {text} is read as if it were 1.4 to 1.7", 'Write <sdf version="1.6">.')
    return version


def _refused(document: Document, what: str, remedy: str) -> WorldFileError:
    return WorldFileError(f"{document.file}: {what}; {remedy}")


def _of_fault(document: Document, number: int) -> Diagnostic:
    fault = document.faults[number]
    return Diagnostic(
        rule=SYNTAX,
        severity=Severity.ERROR,
        file=document.file,
        span=fault.span,
        source=document.line(fault.span.line),
        what=fault.what,
        remedy=fault.remedy,
    )
