"""Lay a student's files out as ROS packages, where the nodes of a check find them."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path, PurePosixPath

_MANIFEST = """\
<?xml version="1.0"?>
<package format="2">
  <name>{name}</name>
  <version>0.0.0</version>
  <description>The student's package.</description>
  <maintainer email="nobody@example.com">nobody</maintainer>
  <license>none</license>
</package>
"""


def lay_out(files: Mapping[str, str], folder: Path, *, package: str) -> None:
    """Write the files of a submission below a folder.

    Scripts can be executed, and each package has a manifest: the book makes both by commands that
    leave no trace in a notebook.

    Args:
        files: Text by path, e.g. "hello_ros/scripts/listener.py"; the reader of submissions has
            refused every path that leads elsewhere.
        folder: Where to put them.
        package: The package of the exercise; there even if the student wrote no file in it.
    """
    folder.mkdir(mode=0o755)
    for name in sorted({package, *(PurePosixPath(path).parts[0] for path in files)}):
        _write(folder, f"{name}/package.xml", _MANIFEST.format(name=name))
    for path, text in sorted(files.items()):
        _write(folder, path, text)
    for entry in (folder, *folder.rglob("*")):
        entry.chmod(0o755 if entry.is_dir() or _is_script(entry) else 0o644)


def _write(folder: Path, path: str, text: str) -> None:
    parts = PurePosixPath(path).parts
    if not parts or PurePosixPath(path).is_absolute() or ".." in parts:
        raise ValueError(f"{path!r} leads out of the submission")
    target = folder.joinpath(*parts)
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_bytes(text.encode("utf-8", "replace"))


def _is_script(path: Path) -> bool:
    return path.suffix == ".py" or path.read_bytes()[:2] == b"#!"
