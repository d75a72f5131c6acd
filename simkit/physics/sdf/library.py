"""The library: where the models are that `model://NAME` means.

Gazebo's own `ground_plane` and `sun` are built in. Others are folders with a `model.config`, or a
`model.sdf`: below the folders that are given, in the folder `models` of a ROS package, or a ROS
package itself.

Source: Gazebo's model path; `model.config` lists a file for each version of SDF.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path

from simkit.errors import SimkitError, UnknownNameError
from simkit.packages import PackagePath
from simkit.xml import parse_xml

SCHEME = "model://"
"""How the name of a model in the library begins."""

NEWEST = (1, 7)
"""Version of SDF that is taken, if a model has several."""

BUILT_IN = {
    "ground_plane": """<sdf version="1.6"><model name="ground_plane"><static>true</static><link name="link">
  <collision name="collision"><geometry><plane><normal>0 0 1</normal><size>100 100</size></plane></geometry>
    <surface><friction><ode><mu>100</mu><mu2>50</mu2></ode></friction></surface></collision>
  <visual name="visual"><geometry><plane><normal>0 0 1</normal><size>100 100</size></plane></geometry>
    <material><script><name>Gazebo/Grey</name></script></material></visual>
</link></model></sdf>""",
    "sun": """<sdf version="1.6"><light name="sun" type="directional"><pose>0 0 10 0 0 0</pose>
  <diffuse>0.8 0.8 0.8 1</diffuse><direction>-0.5 0.1 -0.9</direction></light></sdf>""",
}
"""Models that need no file, as osrf/gazebo_models has them."""


class ModelLibrary:
    """Folders in which models are looked for, the first hit wins.

    Args:
        folders: Folders of models, searched first.
        packages: ROS packages; if they are confined, no file outside of them is read.
    """

    def __init__(
        self, folders: Sequence[str | Path] = (), packages: PackagePath | None = None
    ) -> None:
        self._folders = [Path(folder) for folder in folders]
        self._packages = packages

    def read(self, uri: str) -> tuple[str | bytes, str]:
        """The SDF of a model, and the name of its file.

        Args:
            uri: `model://NAME`, or `file://FOLDER`.

        Raises:
            SimkitError: There is no such model; lists those that there are.
        """
        name = uri.removeprefix(SCHEME).strip("/") if uri.startswith(SCHEME) else ""
        if name in BUILT_IN:
            return BUILT_IN[name], f"{SCHEME}{name}/model.sdf"
        folder = self._folder(uri, name)
        file = self._sdf_file(folder)
        return self._bytes(file), str(file)

    def mesh(self, uri: str) -> tuple[Path | None, str]:
        """The file of a mesh, or None and why there is none."""
        if not uri.startswith(SCHEME):
            return None, f"only names that begin with {SCHEME} are looked for"
        name, _, inner = uri.removeprefix(SCHEME).partition("/")
        try:
            path = self._folder(f"{SCHEME}{name}", name) / inner
            return self._checked(path), ""
        except SimkitError as error:
            return None, str(error)

    def names(self) -> list[str]:
        """The models that there are."""
        return sorted({*BUILT_IN, *(folder.name for folder in self._model_folders())})

    def _folder(self, uri: str, name: str) -> Path:
        if uri.startswith("file://"):
            return self._checked(Path(uri.removeprefix("file://")))
        if not name or "/" in name or name in (".", ".."):
            raise SimkitError(f"{uri} names no model; write {SCHEME}NAME")
        for folder in self._model_folders():
            if folder.name == name:
                return self._checked(folder)
        raise UnknownNameError("model", name, self.names())

    def _model_folders(self) -> Iterator[Path]:
        places = list(self._folders)
        packages = {} if self._packages is None else self._packages.packages()
        places += [package.folder / "models" for package in packages.values()]
        for place in places:
            yield from filter(_is_model, sorted(place.iterdir()) if place.is_dir() else [])
        yield from filter(_is_model, (package.folder for package in packages.values()))

    def _sdf_file(self, folder: Path) -> Path:
        config = folder / "model.config"
        if not config.is_file():
            return self._checked(folder / "model.sdf")
        root = parse_xml(self._bytes(config), file=str(config)).root
        listed = [] if root is None else root.all("sdf")
        files = {_version(one.get("version") or ""): one.text.strip() for one in listed}
        fitting = [version for version in files if version <= NEWEST]
        if not fitting:
            raise SimkitError(f"{config} lists no SDF file of version 1.7 or older")
        return self._checked(folder / files[max(fitting)])

    def _bytes(self, file: Path) -> bytes:
        try:
            return self._checked(file).read_bytes()
        except OSError as error:
            raise SimkitError(f"{file} cannot be read: {error.strerror}") from None

    def _checked(self, path: Path) -> Path:
        if self._packages is not None and not self._packages.may_read(path):
            raise SimkitError(f"{path} is outside of the package folders, so it is not read")
        if not path.exists():
            raise SimkitError(f"there is no {path}")
        return path


def _is_model(folder: Path) -> bool:
    return (folder / "model.config").is_file() or (folder / "model.sdf").is_file()


def _version(text: str) -> tuple[int, int]:
    major, _, minor = text.strip().partition(".")
    return (int(major), int(minor)) if major.isdigit() and minor.isdigit() else (1, 0)
