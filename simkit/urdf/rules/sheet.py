"""A URDF file as the rules see it: everything in it, however faulty, with its places.

`read_robot` says what urdfdom makes of a file, and has nothing to say of one that it refuses. A sheet lists what is written,
so that each rule can look at its own matter. Misspelt words count as what they are meant to be.
"""

from __future__ import annotations

import enum
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from simkit.errors import near_names
from simkit.urdf.rules.entries import (
    GazeboEntry,
    JointEntry,
    LinkEntry,
    MaterialEntry,
    PluginElement,
    TransmissionEntry,
)
from simkit.urdf.rules.reading import (
    gazebo_entry,
    joint_entry,
    link_entry,
    material_entry,
    plugin_elements,
    transmission_entry,
)
from simkit.urdf.rules.vocabulary import OTHER_TONGUES, WORDS, meant_word
from simkit.xml import Document, Element, FaultKind, Span, parse_xml

if TYPE_CHECKING:
    from simkit.packages import PackagePath


class CompanionKind(enum.Enum):
    """What a companion is."""

    LAUNCH = "launch"
    YAML = "yaml"


@dataclass(frozen=True, kw_only=True)
class Companion:
    """One file beside the URDF."""

    kind: CompanionKind
    """What it is."""
    file: str
    """Name to show for it."""
    text: str
    """What is in it."""

    def document(self) -> Document:
        """It as XML, for a launch file."""
        return parse_xml(self.text, file=self.file)

    def values(self) -> Any:
        """What a YAML file holds; None if it cannot be read."""
        import yaml  # takes 20 ms to load, and most calls have no YAML

        try:
            return yaml.safe_load(self.text)
        except (yaml.YAMLError, ValueError, RecursionError):
            return None

    def line(self, number: int) -> str:
        """A line of it, from 1; empty beyond its end."""
        lines = self.text.splitlines()
        return lines[number - 1] if 0 < number <= len(lines) else ""


Entry = TypeVar("Entry", LinkEntry, JointEntry)

MOST_FINDS = 20
"""So many finds of one rule about one kind of element are shown; of the rest, the number."""
_MOST_NEAR = 60
"""So often near names are looked for; it takes long, and nobody reads the hundredth."""
_MOST_KNOWN = 1000


@dataclass
class _Tally:
    """How often something was done for a sheet so far."""

    near_asked: int = 0
    """Questions for near names."""


@dataclass(frozen=True, kw_only=True)
class Sheet:
    """What a URDF file holds."""

    document: Document
    """The file."""
    packages: PackagePath | None
    """Where `package://` leads; None if it is not known."""
    companions: tuple[Companion, ...]
    """Files beside it."""
    folder: Path
    """Where relative names of meshes begin."""
    robot: Element | None
    """The `<robot>`; None if the file has none. Then all lists are empty."""
    links: tuple[LinkEntry, ...] = ()
    """All links, in the order of the file, also nameless ones, of one name twice, and those in a wrong place."""
    joints: tuple[JointEntry, ...] = ()
    """All joints, likewise."""
    materials: tuple[MaterialEntry, ...] = ()
    """All materials, those of the robot first."""
    gazebo: tuple[GazeboEntry, ...] = ()
    """All `<gazebo>` of the robot."""
    plugins: tuple[PluginElement, ...] = ()
    """All plugins in them."""
    transmissions: tuple[TransmissionEntry, ...] = ()
    """All transmissions."""
    link_by_name: Mapping[str, LinkEntry] = field(default_factory=dict)
    """Links by name; of several of one name the first."""
    joint_by_name: Mapping[str, JointEntry] = field(default_factory=dict)
    """Joints by name; of several of one name the first."""
    joints_below: Mapping[str, tuple[JointEntry, ...]] = field(default_factory=dict)
    """Joints by the name of their parent link, whether or not there is such a link."""
    joints_above: Mapping[str, tuple[JointEntry, ...]] = field(default_factory=dict)
    """Joints by the name of their child link, whether or not there is such a link."""
    xacro: tuple[Element, ...] = ()
    """Elements that only xacro understands. If there are any, all lists above are empty: xacro must be run first."""
    _mismatched: frozenset[Span | None]
    _tally: _Tally

    def near(self, name: str, known: Iterable[str]) -> list[str]:
        """Up to three names of `known` that may be meant by `name`; none once it was asked very often."""
        self._tally.near_asked += 1
        if self._tally.near_asked > _MOST_NEAR or len(name) > 100:
            return []
        short = [one for one in known if len(one) <= 100]
        return near_names(name, short[:_MOST_KNOWN])

    def is_closed_otherwise(self, element: Element) -> bool:
        """Whether an end tag of another name closes an element: a find about XML names it already."""
        return element.span in self._mismatched

    def is_root(self, link: LinkEntry) -> bool:
        """Whether no joint has this link as child."""
        return link.name is not None and link.name not in self.joints_above


def read_sheet(
    document: Document,
    *,
    packages: PackagePath | None = None,
    companions: Sequence[Companion] = (),
    folder: Path | None = None,
) -> Sheet:
    """Read a file for the rules; never raises.

    Args:
        document: The URDF.
        packages: Where `package://` leads.
        companions: Files beside it.
        folder: Where relative names of meshes begin; the folder of the document's file if None.
    """
    mismatched = [one for one in document.faults if one.kind is FaultKind.MISMATCHED_TAG]
    empty = Sheet(
        document=document,
        packages=packages,
        companions=tuple(companions),
        folder=Path(document.file).parent if folder is None else folder,
        robot=None,
        _mismatched=frozenset(span for one in mismatched for span in (one.span, one.other)),
        _tally=_Tally(),
    )
    robot = document.root
    if robot is None or meant_word(robot, ("robot",)) is None:
        return empty
    xacro = tuple(one for one in robot.walk() if _is_for_xacro(one))
    if xacro:
        return replace(empty, xacro=xacro)
    parts: dict[str, list[Element]] = {word: [] for word in WORDS["robot"].children}
    for word, element in _parts(robot):
        parts[word].append(element)
    links = tuple(link_entry(one) for one in parts["link"])
    joints = tuple(joint_entry(one) for one in parts["joint"])
    gazebo = tuple(gazebo_entry(one) for one in parts["gazebo"])
    return replace(
        empty,
        robot=robot,
        links=links,
        joints=joints,
        materials=_materials(parts["material"], links),
        gazebo=gazebo,
        plugins=tuple(plugin for block in gazebo for plugin in plugin_elements(block)),
        transmissions=tuple(transmission_entry(one) for one in parts["transmission"]),
        link_by_name={name: same[0] for name, same in _grouped(links, _name).items()},
        joint_by_name={name: same[0] for name, same in _grouped(joints, _name).items()},
        joints_below=_grouped(joints, lambda joint: joint.parent),
        joints_above=_grouped(joints, lambda joint: joint.child),
    )


def _is_for_xacro(element: Element) -> bool:
    values = (attribute.value for attribute in element.attributes)
    return element.name.startswith("xacro:") or any(map(is_for_xacro, values))


def is_for_xacro(value: str) -> bool:
    """Whether the value of an attribute waits for xacro: `${width / 2}`, `$(arg prefix)wheel`."""
    return "${" in value or "$(arg " in value or "$(optenv " in value


def _parts(robot: Element) -> Iterator[tuple[str, Element]]:
    """What the robot consists of, by word: what stands in it, and links and joints in a wrong place below."""
    words = WORDS["robot"].children
    waiting = list(reversed(robot.children))
    while waiting:
        element = waiting.pop()
        is_part = element.parent is robot
        word = meant_word(element, words) if is_part else element.name
        if word is not None and (is_part or word in ("link", "joint")):
            yield word, element
        if word not in OTHER_TONGUES:
            waiting.extend(reversed(element.children))


def _materials(
    elements: Iterable[Element], links: Iterable[LinkEntry]
) -> tuple[MaterialEntry, ...]:
    found = [material_entry(one, is_global=True) for one in elements]
    for link in links:
        for visual in link.visuals:
            if visual.material_element is not None:
                found.append(material_entry(visual.material_element, is_global=False))
    return tuple(found)


def _name(entry: LinkEntry | JointEntry) -> str | None:
    return entry.name


def _grouped(
    entries: Iterable[Entry], key: Callable[[Entry], str | None]
) -> dict[str, tuple[Entry, ...]]:
    found: dict[str, list[Entry]] = {}
    for entry in entries:
        name = key(entry)
        if name is not None:
            found.setdefault(name, []).append(entry)
    return {name: tuple(same) for name, same in found.items()}
