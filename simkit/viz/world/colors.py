"""Colours as Gazebo shows them: its materials, and the grey of what has none."""

from __future__ import annotations

from typing import Final

from simkit.urdf.rules.colours import COLOURS
from simkit.viz.solid import Color

GREY: Final[Color] = (0.7, 0.7, 0.7)
"""Of a link without a material, and of `Gazebo/Grey`."""
_PREFIX: Final = "Gazebo/"
_CLEAR: Final = "Transparent"
_CLEAR_ALPHA: Final = 0.5
_ENDINGS: Final = ("Overlay", _CLEAR, "GlowOutline", "Glow", "Laser", "Bright")
_MORE: Final[dict[str, Color]] = {
    "Grey": GREY,
    "Gray": GREY,
    "DarkGray": COLOURS["DarkGrey"],
    "FlatBlack": (0.1, 0.1, 0.1),
    "RedBright": (0.87, 0.26, 0.07),
    "Wood": (0.62, 0.44, 0.26),
    "Bricks": (0.6, 0.33, 0.26),
}
"Lit colours of materials that are pictures, or darker in the shade than in the light."


def gazebo_color(name: str) -> tuple[Color, float] | None:
    """Colour and opacity of a material of Gazebo; None if it is unknown here.

    Args:
        name: As in `<material>Gazebo/Orange</material>`.

    Source:
        gazebo.material of Gazebo 9, the diffuse colours; what is a picture there is one colour here.
    """
    short = name.strip().removeprefix(_PREFIX)
    alpha = _CLEAR_ALPHA if _CLEAR in short else 1.0
    while short:
        color = _MORE.get(short) or COLOURS.get(short)
        if color is not None:
            return color, alpha
        ending = next((one for one in _ENDINGS if short.endswith(one)), "")
        if not ending:
            return None
        short = short.removesuffix(ending)
    return None
