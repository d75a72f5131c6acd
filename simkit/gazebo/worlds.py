"""The world file that gzserver is given: where it is, or what is wrong with its name.

Source: gzserver looks for a relative name below the folders of GAZEBO_RESOURCE_PATH; here those are
the packages and the working folder.
"""

from __future__ import annotations

from pathlib import Path

from simkit.errors import SimkitError, near_names
from simkit.packages import PackagePath
from simkit.physics.sdf import ModelLibrary, SdfWorld, read_world

EMPTY_NAMES = ("worlds/empty.world", "worlds/empty_sky.world", "")
"""Names of the world that comes with Gazebo: sun and ground."""
EMPTY = """<sdf version="1.6"><world name="default">
<include><uri>model://sun</uri></include>
<include><uri>model://ground_plane</uri></include>
</world></sdf>"""


def find_world(name: str, packages: PackagePath) -> SdfWorld:
    """A world by the name that gzserver is given.

    Args:
        name: A path, or `worlds/empty.world`, which is built in.
        packages: Where relative names and models are looked for, and what may be read.

    Raises:
        SimkitError: There is no such file, with near names; or it is no world: `file:line:column: ...`.
    """
    library = ModelLibrary(packages=packages)
    path = _file(name, packages)
    if path is None and name in EMPTY_NAMES:
        return read_world(EMPTY, file="empty.world", library=library)
    if path is None:
        raise SimkitError(f"Could not open file[{name}]: {_advice(name)}")
    try:
        data = path.read_bytes()
    except OSError as error:
        raise SimkitError(f"Could not open file[{name}]: {error.strerror}") from None
    return read_world(data, file=path.name, library=library)


def _file(name: str, packages: PackagePath) -> Path | None:
    if not name:
        return None
    places = [Path(name)]
    if not Path(name).is_absolute():
        places += [package.folder / name for package in packages.packages().values()]
    for path in places:
        if path.is_file() and packages.may_read(path):
            return path
    return None


def _advice(name: str) -> str:
    path = Path(name)
    if path.with_name(path.name + ".world").is_file():
        return f"there is no such file, but {path.name}.world is there: the name needs its ending .world"
    try:
        beside = sorted(child.name for child in path.parent.iterdir())[:1000]
    except OSError:
        return "there is no such folder; give the path of a .world file, best as $(find PACKAGE)/worlds/NAME.world"
    near = near_names(path.name, beside)
    if near:
        return f"there is no such file; did you mean {' or '.join(near)}, which is in that folder?"
    return "there is no such file; give the path of a .world file"
