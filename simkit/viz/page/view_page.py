"""The HTML of a view: a picture in 3D to turn, what is wrong, and the same as numbers."""

from __future__ import annotations

import base64
import importlib.util
import math
import zlib
from collections.abc import Iterable, Sequence
from functools import cache
from pathlib import Path
from typing import Final

from simkit.errors import SimkitError
from simkit.geometry import roll_pitch_yaw
from simkit.viz.draw.drawing import Point
from simkit.viz.draw.letters import abbreviated
from simkit.viz.page.html import escaped, html_page
from simkit.viz.page.scene_data import HELP, grid_note, scene_summary
from simkit.viz.stage.frames import FramePose
from simkit.viz.stage.parts import Role
from simkit.viz.stage.scene import LONGEST, Scene

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


TITLE: Final = "RViz"
SCRIPTS: Final = (
    "rviz_camera",
    "rviz_names",
    "rviz_marks",
    "rviz_scene",
    "rviz_guests",
    "rviz_words",
    "rviz",
)
"""The scripts of every view, in their order."""
LIVE_STATUS: Final = '<p id="live" class="quiet" role="status">connecting to the simulation ...</p>'
"""The line below a live view; its scripts say there whether it follows."""
_STILL_SIZE: Final[Point] = (720.0, 450.0)
_ROLE_WORDS: Final = {
    Role.COLLISION: "Collision",
    Role.CENTRE: "Centre of mass",
    Role.INERTIA: "Inertia",
    Role.JOINT: "Joints",
    Role.GROUND: "Ground",
}
_CREDITS = (
    "<!-- The script below holds three.js (three.js authors), MeshCat (R. Deits), dat.GUI (Google) and others, "
    "under the MIT, BSD and Apache licenses; see the package meshcat. -->"
)


def view_page(
    scene: Scene,
    *,
    data: object,
    controls: Sequence[str] = (),
    scripts: Sequence[str] = (),
    connects_to: str = "",
) -> str:
    """A page with a scene.

    Args:
        scene: What it shows at first.
        data: What its scripts find as JSON.
        controls: HTML of more controls.
        scripts: Names of more scripts, behind those of every view.
        connects_to: The one address that it may talk to; none if empty.
    """
    return html_page(
        title=scene.window.title,
        name="rviz",
        body="\n".join([*_view(scene), *controls, *_words(scene), _CREDITS, _library()]),
        data=data,
        scripts=(*SCRIPTS, *scripts),
        connects_to=connects_to,
    )


def page_height(scene: Scene) -> int:
    """Room that the page needs inside another [px]; what is more is scrolled."""
    lines = min(len(scene.problems), 6) + min(len(scene.notes), 3)
    return 510 + 45 * bool(scene.tf.error) + 22 * lines


def _view(scene: Scene) -> list[str]:
    return [
        '<div id="scene" tabindex="0" role="img" aria-describedby="numbers" '
        f'aria-label="{escaped(scene_summary(scene))} {HELP}">',
        f'<img id="still" alt="" src="{_still(scene)}">',
        '<canvas id="picture"></canvas><canvas id="labels"></canvas>',
        f'<p id="scale" class="quiet">{grid_note(scene.stage)}</p>',
        "</div>",
        '<p id="notice" hidden><span></span> <button id="again">Draw again</button></p>',
        "<noscript><p>Without JavaScript the picture stands still and has no names.</p></noscript>",
        '<div class="row">',
        '<button id="reset">Reset view</button> <button id="top">From above</button>',
        *_boxes(scene),
        f'<span>{scene.window.fixed}: <b id="fixed">{_short(scene.tf.fixed_frame)}</b></span>',
        '<span><b class="x">x</b> <b class="y">y</b> <b class="z">z</b></span>',
        f'<span class="quiet" title="{HELP}">drag to turn, shift-drag to move, + and - to zoom</span>',
        "</div>",
    ]


def _boxes(scene: Scene) -> list[str]:
    """A checkbox for each display."""
    shown, roles = scene.displays, {placed.solid.role for placed in scene.solids}
    words = {Role.VISUAL: scene.window.bodies, **_ROLE_WORDS}
    return [
        _box("grid", "Grid", on=shown.grid),
        _box("tf", scene.window.frames, on=shown.tf),
        _box("names", "Names", on=True),
        *(
            _box(role.value, words[role], on=shown.shows(role), hidden=role not in roles)
            for role in Role
        ),
        *(
            []
            if shown.transparent is None
            else [_box("clear", "Transparent", on=shown.transparent)]
        ),
        *(_box(f"marks-{one.name}", escaped(one.label), on=one.is_on) for one in scene.marks),
    ]


def _box(name: str, words: str, *, on: bool, hidden: bool = False) -> str:
    return (
        f"<label{' hidden' * hidden}>"
        f'<input type="checkbox" id="{name}"{" checked" * on}> {words}</label>'
    )


def _words(scene: Scene) -> list[str]:
    error = scene.tf.error
    return [
        f'<p id="error" role="alert"{" hidden" * (not error)}>{escaped(error)}</p>',
        *_list("problems", scene.problems),
        *_list("notes", scene.notes),
        f'<details id="table"{" hidden" * (not scene.tf.poses)}>'
        f'<summary><span id="summary">{escaped(scene_summary(scene))}</span> The same as numbers</summary>',
        '<div class="wide"><table id="numbers">',
        '<tr><th class="name">frame</th><th class="name">parent</th>',
        *(f"<th>{head}</th>" for head in ("x [m]", "y [m]", "z [m]")),
        *(f"<th>{head}</th>" for head in ("roll [°]", "pitch [°]", "yaw [°]")),
        "</tr>",
        *(_row(pose) for pose in scene.tf.poses),
        "</table></div>",
        "</details>",
    ]


def _list(name: str, lines: Iterable[str]) -> list[str]:
    items = [f"<li>{escaped(line)}</li>" for line in lines]
    return [f'<ul id="{name}"{" hidden" * (not items)}>', *items, "</ul>"]


def _row(pose: FramePose) -> str:
    names = (_short(pose.name), _short(pose.parent or ""))
    angles = (math.degrees(angle) for angle in roll_pitch_yaw(pose.rotation))
    values = [f"{value:.3f}" for value in pose.origin] + [f"{angle:.1f}" for angle in angles]
    cells = [f'<td class="name">{name}</td>' for name in names]
    cells += [f"<td>{_without_minus_zero(value)}</td>" for value in values]
    return f"<tr>{''.join(cells)}</tr>"


def _without_minus_zero(text: str) -> str:
    return text.lstrip("-") if not text.strip("-0.") else text


def _short(name: str) -> str:
    return escaped(abbreviated(name, LONGEST))


def _still(scene: Scene) -> str:
    """The picture before the scripts run, and where they cannot draw in 3D."""
    from simkit.viz.draw.files import png_of_pixels
    from simkit.viz.still.scene_raster import scene_pixels

    data = png_of_pixels(scene_pixels(scene, size=_STILL_SIZE))
    return f"data:image/png;base64,{base64.b64encode(data).decode('ascii')}"


def _library() -> str:
    return f'<script type="text/plain" id="library">{packed_library()}</script>'
