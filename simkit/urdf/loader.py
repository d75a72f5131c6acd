"""Robots for those who need one: a robot, or one line that says what is wrong and what would be right."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from simkit.diagnostics import Diagnostic, Severity
from simkit.errors import SimkitError
from simkit.packages import PackagePath
from simkit.urdf.model import Robot
from simkit.urdf.reading import Reading, read_robot


class UrdfError(SimkitError):
    """A robot that cannot be loaded, in one line."""

    def __init__(self, text: str, diagnostics: Sequence[Diagnostic] = ()) -> None:
        super().__init__(text)
        self.diagnostics = tuple(diagnostics)
        """All that the rules find in the file, not only the first error."""


def load_robot(
    text: str | bytes,
    *,
    file: str,
    packages: PackagePath | None = None,
    folder: Path | None = None,
) -> Robot:
    """The robot that a URDF describes.

    Args:
        text: The URDF.
        file: Name to show for it.
        packages: Where the meshes of `package://` are looked for.
        folder: Where relative names of meshes begin; the folder of `file` if None.

    Raises:
        UrdfError: ROS refuses the file: `file:line:column: what is wrong; what would be right`.
    """
    reading = read_robot(text, file=file, packages=packages, folder=folder)
    return robot_of(reading)


def read_robot_file(path: str | Path, packages: PackagePath | None = None) -> Reading:
    """Read a URDF file as urdfdom does.

    Args:
        path: The file.
        packages: Where the meshes of `package://` are looked for.

    Raises:
        UrdfError: There is no such file, or it cannot be read.
    """
    try:
        data = Path(path).read_bytes()
    except OSError as error:
        reason = "there is no such file" if isinstance(error, FileNotFoundError) else error.strerror
        raise UrdfError(f"{path}: {reason}") from None
    return read_robot(data, file=str(path), packages=packages)


def robot_of(reading: Reading) -> Robot:
    """The robot of a reading.

    Raises:
        UrdfError: urdfdom refuses the file.
    """
    if reading.robot is not None:
        return reading.robot
    found = reading.diagnostics
    first = next((one for one in found if one.severity is Severity.ERROR), None)
    if first is None:
        raise UrdfError(f"{reading.document.file}: {reading.refusal}", found)
    place = f"{first.file}:{first.span.line}:{first.span.column}"
    raise UrdfError(f"{place}: {first.what}; {first.remedy}", found)
