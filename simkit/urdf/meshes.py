"""Files of meshes: `package://name/...`, `file://...`, or beside the URDF.

Names are compared letter by letter with what the folders list. So a mesh in the wrong case is
missing on every machine, as it is for ROS on Linux.

Source: resource_retriever, which knows the first two.
"""

from __future__ import annotations

import re
from pathlib import Path, PurePosixPath

from simkit.errors import SimkitError, near_names
from simkit.packages import PackagePath

_SCHEME = r"([A-Za-z][A-Za-z0-9+.-]+):"
_DRIVE = r"/[A-Za-z]:"


class MeshFinder:
    """Finds the files of the meshes of one robot; remembers what it has found.

    Args:
        folder: Where relative names begin.
        packages: Where `package://` looks; None if there are no packages.
    """

    def __init__(self, folder: Path, packages: PackagePath | None) -> None:
        self._folder = folder
        self._packages = packages
        self._found: dict[str, tuple[Path | None, str]] = {}
        self._package_folders: dict[str, Path] = {}

    def find(self, filename: str) -> tuple[Path | None, str]:
        """The file that a name in a URDF means, or None and the reason in a sentence."""
        if filename not in self._found:
            try:
                self._found[filename] = (self._path(filename), "")
            except SimkitError as error:
                self._found[filename] = (None, str(error))
            except (OSError, ValueError):  # a name that no file can have
                self._found[filename] = (None, f"{filename!r} is not a name that a file can have")
        return self._found[filename]

    def _path(self, filename: str) -> Path:
        match = re.match(_SCHEME, filename)
        scheme = match[1].lower() if match else ""
        rest = filename[len(scheme) + 1 :].removeprefix("//") if match else filename
        if not filename.strip():
            raise SimkitError("the name of the mesh is empty")
        if "\\" in filename:
            raise SimkitError(f"{filename} has backslashes; write {filename.replace(chr(92), '/')}")
        if scheme == "package":
            name, _, inner = rest.partition("/")
            return self._file(self._package(name), inner, f"package {name} has no {inner}")
        if scheme == "file":
            path = Path(rest[1:] if re.match(_DRIVE, rest) else rest)
            return self._file(path.parent, path.name, f"there is no {filename}")
        if not scheme:
            return self._file(self._folder, filename, f"there is no {filename} beside the URDF")
        raise SimkitError(
            f"{scheme}: does not name a mesh; what does: package://NAME/meshes/FILE, file:///FOLDER/FILE, "
            "or a name relative to the URDF"
        )

    def _package(self, name: str) -> Path:
        if self._packages is None:
            raise SimkitError(
                f"package {name} was not looked for: no package folders are known here"
            )
        if name not in self._package_folders:
            self._package_folders[name] = self._packages.find(name).folder
        return self._package_folders[name]

    def _file(self, folder: Path, inner: str, complaint: str) -> Path:
        path = folder / inner
        if self._packages is not None and not self._packages.may_read(path):
            raise SimkitError(f"{inner} is outside of the package folders, so it is not read")
        for part in PurePosixPath(inner).parts:
            folder = folder.parent if part == ".." else folder / _listed(folder, part, complaint)
        if folder.is_dir():
            raise SimkitError(f"{complaint} that is a file: it is a folder")
        return folder


def _listed(folder: Path, name: str, complaint: str) -> str:
    """The name, if the folder has it, letter by letter."""
    names = sorted(child.name for child in folder.iterdir()) if folder.is_dir() else []
    if name in names:
        return name
    same = [other for other in names if other.lower() == name.lower()]
    if same:
        raise SimkitError(f"{complaint}; there is {same[0]}: upper and lower case count")
    near = near_names(name, names)
    meant = f"; did you mean {' or '.join(near)}?" if near else ""
    raise SimkitError(f"{complaint}{meant}")
