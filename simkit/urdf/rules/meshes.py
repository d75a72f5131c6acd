"""The rule about the files of meshes, and how large a mesh is."""

from __future__ import annotations

import re
import struct
from collections.abc import Iterable, Iterator
from pathlib import Path

from simkit.diagnostics import Find, Part, Severity, rule
from simkit.errors import SimkitError
from simkit.urdf.meshes import MeshFinder
from simkit.urdf.model import Mesh
from simkit.urdf.rules.entries import BodyEntry
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.wording import numbers_text, part_of, shown, six_digits
from simkit.xml import Attribute, Element

_LARGEST_BYTES = 20_000_000
"Larger files take too long to look at."
_HEADER = struct.Struct("<80xI")
_FACET = struct.Struct("<12x9f2x")


def mesh_extent(path: Path) -> tuple[float, float, float] | None:
    """Lengths of the mesh along x, y, z, in the unit of the file; None if the file does not say."""
    suffix = path.suffix.lower()
    try:
        if suffix not in (".stl", ".obj") or path.stat().st_size > _LARGEST_BYTES:
            return None
        data = path.read_bytes()
    except OSError:
        return None
    if suffix == ".stl" and _is_binary(data):
        return _extent(_binary_points(data))
    return _extent(_text_points(data, b"vertex" if suffix == ".stl" else b"v"))


def _is_binary(data: bytes) -> bool:
    if len(data) < _HEADER.size:
        return False
    count: int = _HEADER.unpack_from(data)[0]
    return len(data) == _HEADER.size + count * _FACET.size


def _binary_points(data: bytes) -> Iterator[tuple[float, ...]]:
    for facet in _FACET.iter_unpack(data[_HEADER.size :]):
        yield facet[0:3]
        yield facet[3:6]
        yield facet[6:9]


def _text_points(data: bytes, word: bytes) -> Iterator[tuple[float, ...]]:
    for line in data.splitlines():
        words = line.split()
        if len(words) >= 4 and words[0] == word:
            try:
                yield (float(words[1]), float(words[2]), float(words[3]))
            except ValueError:
                continue


def _extent(points: Iterable[tuple[float, ...]]) -> tuple[float, float, float] | None:
    columns = list(zip(*points, strict=True))
    if not columns:
        return None
    x, y, z = (max(column) - min(column) for column in columns)
    return (x, y, z)


_LARGEST, _SMALLEST = 10.0, 0.001
"Meshes larger or smaller than this [m] are most likely in another unit."
_FIND = re.compile(r"\$\(find\s+([^)\s]+)\s*\)/?(.*)")
_SCHEME = re.compile(r"([A-Za-z][A-Za-z0-9+.-]+)://")
_LOST = "RViz shows nothing there and names the file in red; as a collision of Gazebo, everything falls through."
_PLACEHOLDER = "The robot is kept, with a placeholder there."


@rule("URDF-E18", "a mesh that is not there, or has an odd size", Severity.ERROR)
def mesh(sheet: Sheet) -> Iterator[Find]:
    """A mesh whose file is not there, is named in a way that ROS does not know, or has an odd size.

    The part is not seen. `package://my_robot/meshes/hand.stl` is the file meshes/hand.stl in the folder of the package
    my_robot; capitals count, on Linux at least. A file relative to the URDF is found here, but not by RViz. A mesh in
    millimetres is a thousand times too large, for URDF takes its numbers for metres: `scale` puts it right.

    Wrong:

        <mesh filename="meshes/Hand.STL"/>

    Right:

        <mesh filename="package://my_robot/meshes/hand.stl" scale="0.001 0.001 0.001"/>
    """
    places: dict[tuple[str, str], list[tuple[BodyEntry, Attribute]]] = {}
    for link in sheet.links:
        for body in (*link.visuals, *link.collisions):
            shape, element = body.shape, body.shape_element
            attribute = None if element is None else element.attribute("filename")
            if isinstance(shape, Mesh) and attribute is not None:
                key = (shape.filename, repr(shape.scale))
                places.setdefault(key, []).append((body, attribute))
    looker = _Looker(sheet)
    for uses in places.values():
        yield from looker.look(*uses[0], count=len(uses))
    yield from looker.unknown_packages()


class _Looker:
    """Looks at one mesh after the other; each package is looked for once."""

    def __init__(self, sheet: Sheet) -> None:
        self._sheet = sheet
        self._finder = MeshFinder(sheet.folder, sheet.packages)
        self._packages: dict[str, bool] = {}
        self._unknown: dict[str, list[tuple[Element, Attribute, str]]] = {}

    def look(self, body: BodyEntry, attribute: Attribute, *, count: int) -> Iterator[Find]:
        """What is wrong with a mesh, reported at the first of its `count` uses."""
        shape, element = body.shape, body.shape_element
        if not isinstance(shape, Mesh) or element is None:
            return
        name = shape.filename
        match, scheme = _FIND.match(name), _SCHEME.match(name)
        more = f" ({count} times)" if count > 1 else ""
        if match is not None:
            remedy = f'$(find ...) is for launch files: write "package://{shown(match[1])}/{shown(match[2])}".'
            yield self._lost(
                element, attribute, f"mesh {shown(name)!r}{more} names no file", remedy
            )
        elif scheme is not None and scheme[1].lower() not in ("package", "file"):
            yield self._other_scheme(element, attribute, scheme[1].lower())
        elif name.startswith("package:") and self._sheet.packages is None:
            return
        else:
            yield from self._file(body, element, attribute, more)

    def _file(
        self, body: BodyEntry, element: Element, attribute: Attribute, more: str
    ) -> Iterator[Find]:
        name = attribute.value
        path, problem = self._finder.find(name)
        if path is None and not self._knows_package(name):
            package = name.removeprefix("package://").partition("/")[0]
            self._unknown.setdefault(package, []).append((element, attribute, problem))
            return
        if path is None:
            what = f"the mesh of {part_of(element)}{more} is not found: {shown_long(problem)}"
            remedy = "Correct the name, or put the file there."
            yield self._lost(element, attribute, what, remedy)
            return
        if not _SCHEME.match(name):
            yield self._relative(element, attribute, more)
        if isinstance(body.shape, Mesh):
            extent = mesh_extent(path)
            if extent is not None:
                yield from self._odd_size(element, attribute, body.shape, extent)

    def unknown_packages(self) -> Iterator[Find]:
        """One find for each package that is not there, however many meshes are in it."""
        remedy = "Put the package (a folder with a package.xml) beside this one, or name it in SIMKIT_PACKAGE_PATH."
        for meshes in self._unknown.values():
            element, attribute, problem = meshes[0]
            others = f", nor {len(meshes) - 1} more of that package" if len(meshes) > 1 else ""
            what = f"the mesh of {part_of(element)} is not found{others}: {shown_long(problem)}"
            yield self._lost(element, attribute, what, remedy, Severity.WARNING)

    def _knows_package(self, filename: str) -> bool:
        if not filename.startswith("package://") or self._sheet.packages is None:
            return True
        name = filename.removeprefix("package://").partition("/")[0]
        if name not in self._packages:
            try:
                self._sheet.packages.find(name)
                self._packages[name] = True
            except SimkitError:
                self._packages[name] = False
        return self._packages[name]

    def _lost(
        self,
        element: Element,
        attribute: Attribute,
        what: str,
        remedy: str,
        severity: Severity = Severity.ERROR,
    ) -> Find:
        return Find(
            Part(element, attribute.name),
            severity=severity,
            what=what,
            remedy=remedy,
            here=_PLACEHOLDER,
            gazebo=_LOST,
        )

    def _other_scheme(self, element: Element, attribute: Attribute, scheme: str) -> Find:
        gazebo = "ROS does not know it, and shows nothing."
        if scheme in ("http", "https"):
            gazebo = "ROS fetches it from the network, each time anew."
        elif scheme == "model":
            gazebo = "Only Gazebo knows it; RViz shows nothing."
        return Find(
            Part(element, attribute.name),
            severity=Severity.WARNING,
            what=f"mesh {shown(attribute.value)!r} is named with {scheme}://, which is not read here",
            remedy='Put the file into a package, and write "package://my_robot/meshes/...".',
            here=_PLACEHOLDER,
            gazebo=gazebo,
        )

    def _relative(self, element: Element, attribute: Attribute, more: str) -> Find:
        inner = attribute.value.lstrip("./")
        return Find(
            Part(element, attribute.name),
            severity=Severity.WARNING,
            what=f"mesh {shown(attribute.value)!r}{more} is named relative to this file, which ROS does not understand",
            remedy=f'Write "package://my_robot/{shown(inner)}", with the name of your package and the way from its folder.',
            here="The file is found.",
            gazebo=_LOST,
        )

    def _odd_size(
        self,
        element: Element,
        attribute: Attribute,
        shape: Mesh,
        extent: tuple[float, float, float],
    ) -> Iterator[Find]:
        x, y, z = (abs(f) * size for f, size in zip(shape.scale, extent, strict=True))
        size = max(x, y, z)
        if _SMALLEST <= size <= _LARGEST or size == 0.0:
            return
        factor = 0.001 if size > _LARGEST else 1000.0
        scale = numbers_text(number * factor for number in shape.scale)
        right = six_digits(size * factor)
        fits = _SMALLEST < size * factor < _LARGEST
        yield Find(
            element.attribute("scale") or attribute,
            severity=Severity.WARNING,
            element=element,
            what=f"the mesh of {part_of(element)} is {six_digits(size)} m long",
            remedy=f'If it is drawn in millimetres, write scale="{scale}": then it is {right} m long.'
            if fits and factor < 1
            else f'Check its unit; with scale="{scale}" it is {right} m long.',
            both="Its numbers are taken for metres.",
        )


def shown_long(text: str) -> str:
    """A reason for a message, on one line."""
    text = " ".join(text.split())
    return text if len(text) <= 200 else text[:197] + "..."
