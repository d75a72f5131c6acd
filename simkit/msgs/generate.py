"""Write the definitions that rosbags has into the folder `definitions`.

`python -m simkit.msgs.generate` writes them, `--check` says whether they are fresh. All other
definitions there (services, actions, packages that rosbags lacks) are written by hand.
"""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

from simkit.msgs.catalog import DEFINITIONS

# rosbags models ROS 2 as well: what follows is not part of a ROS 1 definition.
_OMITTED_PACKAGE = "builtin_interfaces"
_OMITTED_FIELD = "structure_needs_at_least_one_member"
_BUILTIN = {"builtin_interfaces/msg/Time": "time", "builtin_interfaces/msg/Duration": "duration"}


def generated_files() -> dict[Path, str]:
    """Path -> text of each definition that comes from rosbags."""
    from rosbags.typesys.stores.ros1_noetic import FIELDDEFS

    files = {}
    for name, (constants, fields) in FIELDDEFS.items():
        package, _, short = name.split("/")
        if package == _OMITTED_PACKAGE:
            continue
        lines = [f"{base} {constant}={value}" for constant, base, value in constants]
        lines += [""] if constants and fields else []
        lines += [f"{_type_text(d)} {field}" for field, d in fields if field != _OMITTED_FIELD]
        files[DEFINITIONS / package / "msg" / f"{short}.msg"] = "".join(f"{x}\n" for x in lines)
    return files


def _type_text(description: Any) -> str:
    """Type of a field, from rosbags' description of it: (kind, details)."""
    from rosbags.interfaces import Nodetype

    kind, details = description
    if kind == Nodetype.BASE:
        return str(details[0])
    if kind == Nodetype.NAME:
        return _BUILTIN.get(details, str(details).replace("/msg/", "/"))
    element, length = details
    return f"{_type_text(element)}[{length or ''}]"


def stale_files() -> list[Path]:
    """Generated definitions whose file is missing or different."""
    return [
        path
        for path, text in generated_files().items()
        if not path.is_file() or path.read_text("utf-8") != text
    ]


def main(arguments: list[str]) -> int:
    """Write the definitions, or name the stale ones; the exit code."""
    stale = stale_files()
    if "--check" in arguments:
        for path in stale:
            print(f"stale: {path.relative_to(DEFINITIONS)}; run python -m simkit.msgs.generate")
        return 1 if stale else 0
    texts = generated_files()
    for path in stale:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(texts[path], "utf-8", newline="\n")
    print(f"{len(stale)} of {len(texts)} definitions written")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
