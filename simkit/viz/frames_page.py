"""The HTML of a view of frames in space: a canvas to turn, what is wrong, and a table."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping
from typing import Any, Final

from simkit.tf.rotation import roll_pitch_yaw
from simkit.viz.camera import FIELD_OF_VIEW
from simkit.viz.letters import shortened
from simkit.viz.page import escaped, html_page
from simkit.viz.stage import Stage
from simkit.viz.tf_scene import FramePose, TfScene

TITLE: Final = "Frames of tf in space"
LONGEST: Final = 44
"""Letters of a name that are shown; of a longer one the middle is left out."""
MOST_NAMES: Final = 200
"""So many frames are named in the picture; of more than that nobody could read the names."""
_DIGITS = 6
_HELP = (
    "Drag: turn. Shift and drag, or two fingers: move. Wheel after a click, or + and -: zoom. "
    "Arrow keys: turn. Home: as at first. t: from above."
)


def frames_page(scene: TfScene, stage: Stage) -> str:
    """The page for some frames."""
    return html_page(
        title=TITLE, name="frames_view", body=_body(scene, stage), data=_data(scene, stage)
    )


def page_height(scene: TfScene) -> int:
    """Room that the page needs inside another [px]; what is more is scrolled."""
    return 510 + 45 * bool(scene.error) + 22 * min(len(scene.problems), 6)


def summary(scene: TfScene) -> str:
    """One sentence on what is to be seen."""
    count = len(scene.poses)
    if scene.error:
        return scene.error
    return f"{count} frame{'s' * (count != 1)} seen from {scene.fixed_frame}."


def grid_note(stage: Stage) -> str:
    """How large the cells of the grid are, in words."""
    return f"grid: {stage.cell:g} m"


def _body(scene: TfScene, stage: Stage) -> str:
    fixed = escaped(shortened(scene.fixed_frame, LONGEST))
    parts = [
        '<div id="view">',
        '<canvas id="scene" tabindex="0" role="img" aria-describedby="numbers" '
        f'aria-label="{escaped(summary(scene))} {_HELP}"></canvas>',
        f'<p id="scale" class="quiet">{grid_note(stage)}</p>',
        "</div>",
    ]
    if scene.error:
        parts.append(f'<p class="error" role="alert">{escaped(scene.error)}</p>')
    parts += [
        '<div class="row">',
        '<button id="reset">Reset view</button> <button id="top">From above</button>',
        '<label><input type="checkbox" id="names" checked> Names</label>',
        f"<span>Fixed Frame: <b>{fixed}</b></span>",
        '<span><b class="x">x</b> <b class="y">y</b> <b class="z">z</b></span>',
        f'<span class="quiet" title="{_HELP}">drag to turn, shift-drag to move, + and - to zoom</span>',
        "</div>",
        *_problems(scene.problems),
        "<noscript><p>Without JavaScript there is no picture here, only the table.</p></noscript>",
        *(_table(scene) if scene.poses else []),
    ]
    return "\n".join(parts)


def _problems(problems: Iterable[str]) -> list[str]:
    rows = [f"<li>{escaped(problem)}</li>" for problem in problems]
    return ['<ul class="problems">', *rows, "</ul>"] if rows else []


def _table(scene: TfScene) -> list[str]:
    heads = ("x [m]", "y [m]", "z [m]", "roll [°]", "pitch [°]", "yaw [°]")
    return [
        f"<details><summary>{escaped(summary(scene))} The same as numbers</summary>",
        '<div class="wide"><table id="numbers">',
        '<tr><th class="name">frame</th><th class="name">parent</th>'
        + "".join(f"<th>{head}</th>" for head in heads)
        + "</tr>",
        *(_row(pose) for pose in scene.poses),
        "</table></div>",
        "</details>",
    ]


def _row(pose: FramePose) -> str:
    names = (pose.name, pose.parent or "")
    angles = (math.degrees(angle) for angle in roll_pitch_yaw(pose.rotation))
    values = [f"{value:.3f}" for value in pose.origin] + [f"{angle:.1f}" for angle in angles]
    return (
        "<tr>"
        + "".join(f'<td class="name">{escaped(name)}</td>' for name in names)
        + "".join(f"<td>{_without_minus_zero(value)}</td>" for value in values)
        + "</tr>"
    )


def _without_minus_zero(text: str) -> str:
    return text.lstrip("-") if not text.strip("-0.") else text


def _data(scene: TfScene, stage: Stage) -> Mapping[str, Any]:
    numbers = {pose.name: number for number, pose in enumerate(scene.poses)}
    camera = stage.camera
    return {
        "mostNames": MOST_NAMES,
        "axisLength": stage.axis_length,
        "cell": stage.cell,
        "gridX": stage.grid_x,
        "gridY": stage.grid_y,
        "fieldOfView": FIELD_OF_VIEW,
        "camera": {
            "target": camera.target,
            "distance": camera.distance,
            "azimuth": camera.azimuth,
            "elevation": camera.elevation,
        },
        "frames": [
            {
                "label": shortened(pose.name, LONGEST),
                "isFixed": pose.name == scene.fixed_frame,
                "parent": numbers.get(pose.parent) if pose.parent is not None else None,
                "origin": [round(value, _DIGITS) for value in pose.origin],
                "axes": [[round(value, _DIGITS) for value in axis] for axis in pose.axes],
            }
            for pose in scene.poses
        ],
    }
