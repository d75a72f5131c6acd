"""The 3D library of a view: three.js, as the package meshcat brings it along, packed into the page."""

from __future__ import annotations

import base64
import importlib.util
import zlib
from functools import cache
from pathlib import Path

from simkit.errors import SimkitError

_FILE = Path("viewer", "dist", "main.min.js")


@cache
def packed_library() -> str:
    """The library as text for a page, a third of its length; `DecompressionStream("deflate")` unpacks it.

    Raises:
        SimkitError: meshcat is not installed.
    """
    # Found without importing it: meshcat loads slowly, and a server of its own would come with it.
    found = importlib.util.find_spec("meshcat")
    if found is None or not found.submodule_search_locations:
        raise SimkitError("a view in 3D needs the package meshcat: pip install meshcat")
    script = Path(found.submodule_search_locations[0]) / _FILE
    return base64.b64encode(zlib.compress(script.read_bytes(), 9)).decode("ascii")
