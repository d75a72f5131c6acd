"""The process that xacro runs in: `python -m simkit.xacro.child`, with its request on standard input.

The library is the one of ROS. Of ROS it needs one thing only: where packages are, which the request says.
"""

from __future__ import annotations

import json
import sys
import types
from collections.abc import Mapping

MEMORY_BYTES = 2 * 1024**3
"""So much memory may a file ask for."""


def main() -> None:
    """Do what the request asks for, as the program `xacro` does."""
    request = json.load(sys.stdin)
    _limit_memory()
    _offer_packages(request["packages"])
    sys.argv = ["xacro", *request["arguments"]]
    # xacro names the last of these when a file is missing, and nobody else may have imported it.
    import xml.parsers.expat  # noqa: F401

    import xacro

    xacro.main()


def _limit_memory() -> None:
    try:
        import resource
    except ImportError:  # Windows has no such limits
        return
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_BYTES, MEMORY_BYTES))


def _offer_packages(folders: Mapping[str, str]) -> None:
    """Be the module that `$(find PACKAGE)` asks."""

    def get_package_share_directory(name: str) -> str:
        if name not in folders:
            known = ", ".join(sorted(folders)) or "none"
            raise LookupError(f"there is no package {name!r}; there are: {known}")
        return folders[name]

    module = types.ModuleType("ament_index_python.packages")
    module.get_package_share_directory = get_package_share_directory  # type: ignore[attr-defined]
    sys.modules["ament_index_python"] = types.ModuleType("ament_index_python")
    sys.modules[module.__name__] = module


if __name__ == "__main__":
    main()
