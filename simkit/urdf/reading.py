"""A URDF as urdfdom reads it, the verdict of ROS; what our rules say of it is asked for apart."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property, lru_cache
from pathlib import Path
from typing import NamedTuple
from weakref import WeakSet

from simkit.diagnostics import Diagnostic
from simkit.packages import PackagePath
from simkit.urdf.meshes import MeshFinder
from simkit.urdf.model import Joint, Link, Material, Robot
from simkit.urdf.urdfdom.joints import read_joint
from simkit.urdf.urdfdom.links import RawLink, read_global_material, read_link
from simkit.urdf.urdfdom.numbers import Log, MalformedError, check_version
from simkit.urdf.urdfdom.tree import NoTreeError, find_root, loop_below
from simkit.urdf.urdfdom.xml_verdict import XmlRefusedError, robot_element
from simkit.xml import Document, Element, parse_xml

MOST_KEPT = 16
"""So many texts of robots are remembered."""


class _Verdict(NamedTuple):
    """What urdfdom makes of a text."""

    robot: Robot | None
    messages: tuple[str, ...]
    refusal: str


class _Text:
    """The text of a robot, without the name of its file.

    Args:
        text: The URDF.
    """

    def __init__(self, text: str | bytes) -> None:
        self.document = parse_xml(text, file="")
        self.reported: WeakSet[object] = WeakSet()

    @cached_property
    def has_meshes(self) -> bool:
        """Whether what is made of it depends on files, which may come and go."""
        root = self.document.root
        return root is not None and any(one.name == "mesh" for one in root.walk())

    @cached_property
    def verdict(self) -> _Verdict:
        """What urdfdom makes of it, if it has no meshes."""
        return _verdict(self.document, MeshFinder(Path(), None))


_kept = lru_cache(maxsize=MOST_KEPT)(_Text)


class Reading:
    """The text of a robot, read once in a process for check_urdf, launch, publishers, spawn and views.

    Nothing is computed before it is asked for.

    Args:
        text: The URDF.
        file: Name to show for it.
        packages: Where the meshes of `package://` are looked for.
        folder: Where relative names of meshes begin.
    """

    def __init__(
        self, text: str | bytes, *, file: str, packages: PackagePath | None, folder: Path | None
    ) -> None:
        self._text = _kept(text)
        self._packages = packages
        self._folder = folder
        self.document = replace(self._text.document, file=file)
        """The file as XML."""

    @cached_property
    def robot(self) -> Robot | None:
        """The robot; None if urdfdom refuses the file."""
        robot = self._verdict.robot
        return None if robot is None else replace(robot, document=self.document)

    @property
    def messages(self) -> tuple[str, ...]:
        """What urdfdom says on standard error, in its order: `Error:   ...` or `Warning: ...`."""
        return self._verdict.messages

    @property
    def refusal(self) -> str:
        """Why it is refused, in urdfdom's words without `Error:`; empty if it is not refused."""
        return self._verdict.refusal

    @cached_property
    def diagnostics(self) -> tuple[Diagnostic, ...]:
        """All that the rules find in it."""
        from simkit.urdf.rules import check_robot  # many modules, not needed to read a robot

        return check_robot(self.document, packages=self._packages, folder=self._folder)

    def is_first_report_to(self, simulation: object) -> bool:
        """Whether nobody has reported the faults of this text in a simulation yet; from now on somebody has."""
        reported = self._text.reported
        is_first = simulation not in reported
        reported.add(simulation)
        return is_first

    @cached_property
    def _verdict(self) -> _Verdict:
        if not self._text.has_meshes:
            return self._text.verdict
        folder = Path(self.document.file).parent if self._folder is None else self._folder
        return _verdict(self.document, MeshFinder(folder, self._packages))


def read_robot(
    text: str | bytes,
    *,
    file: str,
    packages: PackagePath | None = None,
    folder: Path | None = None,
) -> Reading:
    """Read a URDF as urdfdom does; never raises.

    Args:
        text: The URDF.
        file: Name to show for it.
        packages: Where the meshes of `package://` are looked for; if it is confined, no other file is read.
        folder: Where relative names of meshes begin; the folder of `file` if None.

    Source:
        urdfdom 3.0. One thing is different: a loop below the root is refused, where urdfdom says
        nothing and check_urdf prints without end.
    """
    return Reading(text, file=file, packages=packages, folder=folder)


def _verdict(document: Document, finder: MeshFinder) -> _Verdict:
    log = Log()
    robot, reason = None, ""
    try:
        robot = _Reader(document, log, finder).robot()
    except _RefusedError as refusal:
        reason = refusal.reason
        log.error(refusal.last_words)
    return _Verdict(robot=robot, messages=tuple(log.lines), refusal=reason)


class _RefusedError(Exception):
    """urdfdom refuses the file.

    Args:
        last_words: The last thing that it says.
        reason: The thing it says that tells most; the last one if there are no others.
    """

    def __init__(self, last_words: str, reason: str = "") -> None:
        super().__init__(last_words)
        self.last_words = last_words
        self.reason = reason or last_words


class _Reader:
    def __init__(self, document: Document, log: Log, finder: MeshFinder) -> None:
        self._document = document
        self._log = log
        self._finder = finder
        self._materials: dict[str, Material] = {}

    def robot(self) -> Robot:
        """The robot, or a refusal with urdfdom's words."""
        try:
            robot = robot_element(self._document)
            name = robot.written("name")
            if name is None:
                raise _RefusedError("No name given for the robot.")
            check_version(robot.written("version"))
            return self._checked_tree(robot, name)
        except (XmlRefusedError, MalformedError, NoTreeError) as refusal:
            raise _RefusedError(str(refusal)) from None

    def _checked_tree(self, robot: Element, name: str) -> Robot:
        self._read_materials(robot)
        links = self._read_links(robot)
        joints = self._read_joints(robot)
        root = find_root(links, joints)
        loop = loop_below(root, joints)
        if loop:
            raise _RefusedError(
                f"The links hang on each other in a circle: {' -> '.join(loop)} (parent -> child)"
            )
        return Robot(
            name=name,
            links=links,
            joints=joints,
            materials=self._materials,
            root=root,
            document=self._document,
        )

    def _read_materials(self, robot: Element) -> None:
        for element in robot.all("material"):
            material = read_global_material(element, self._log)
            if material.name in self._materials:
                raise _RefusedError(f"material '{material.name}' is not unique.")
            self._materials[material.name] = material

    def _read_links(self, robot: Element) -> Mapping[str, Link]:
        links: dict[str, Link] = {}
        for element in robot.all("link"):
            raw = read_link(element, self._log, self._finder.find)
            if raw.name in links:
                raise _RefusedError(f"link '{raw.name}' is not unique.")
            links[raw.name] = self._link(raw, element)
        if not links:
            raise _RefusedError("No link elements found in urdf file")
        return links

    def _link(self, raw: RawLink, place: Element) -> Link:
        if raw.has_all_visuals and raw.visuals:
            self._material(raw, 0)  # urdfdom looks twice for the first one, and complains twice
        visuals = tuple(
            visual.with_material(self._material(raw, number))
            for number, visual in enumerate(raw.visuals)
        )
        return Link(
            name=raw.name,
            inertial=raw.inertial,
            visuals=visuals,
            collisions=tuple(raw.collisions),
            element=place,
        )

    def _material(self, raw: RawLink, number: int) -> Material | None:
        """The material of a visual: the first definition of its name, in whichever link."""
        visual = raw.visuals[number]
        name = visual.material_name
        if not name:
            return visual.material
        if name not in self._materials and visual.material is None:
            self._log.warning(f"link '{raw.name}' material '{name}' undefined.")
            return Material(name)
        if name not in self._materials and visual.material is not None:
            self._materials[name] = visual.material
        return self._materials[name]

    def _read_joints(self, robot: Element) -> Mapping[str, Joint]:
        joints: dict[str, Joint] = {}
        for element in robot.all("joint"):
            before = len(self._log.lines)
            joint = read_joint(element, self._log)
            if joint is None:
                first = self._log.lines[before].partition(":")[2].strip()
                raise _RefusedError("joint xml is not initialized correctly", first)
            if joint.name in joints:
                raise _RefusedError(f"joint '{joint.name}' is not unique.")
            joints[joint.name] = joint
        return joints
