"""A robot that passed `check_urdf` as an object of yourdfpy, for whoever wants a scene of trimesh.

yourdfpy gives no verdict here: it repairs broken XML in silence, so it is given sound robots only. It loads slowly,
and is imported when it is asked for.
"""

from __future__ import annotations

import io
import re
from typing import Any

from simkit.urdf.model import Mesh, Robot

_DECLARATION = re.compile(r"^\s*<\?xml[^>]*\?>")


def yourdfpy_robot(robot: Robot) -> Any:
    """The robot as a `yourdfpy.URDF`, with its meshes where `package://` leads here.

    A mesh that is not there is left out.

    Args:
        robot: The robot.
    """
    import yourdfpy

    paths = {
        geometry.filename: str(geometry.path or "")
        for link in robot.links.values()
        for geometry in (
            *(visual.geometry for visual in link.visuals),
            *(collision.geometry for collision in link.collisions),
        )
        if isinstance(geometry, Mesh)
    }
    text = _DECLARATION.sub("", robot.document.text)
    return yourdfpy.URDF.load(
        io.BytesIO(text.encode()),
        filename_handler=lambda fname: paths.get(fname, ""),
        load_meshes=any(paths.values()) or not paths,
    )
