"""The keys of a teleop pad, and what each commands.

Source: turtlesim's teleop_turtle_key.
"""

from __future__ import annotations

import enum

from simkit.viz.page.html import escaped


class DriveKey(enum.Enum):
    """A key; its value is its name."""

    UP = "up"
    """Forward."""
    DOWN = "down"
    """Backward."""
    LEFT = "left"
    """Turn to the left, which is counter-clockwise."""
    RIGHT = "right"
    """Turn to the right."""
    STOP = "stop"
    """Stand still."""

    @property
    def sign(self) -> str:
        """What stands on its button."""
        return _SIGNS[self]

    @property
    def shares(self) -> tuple[int, int]:
        """Shares of the linear and of the angular speed that it commands."""
        return _SHARES[self]


_SIGNS = {
    DriveKey.UP: "↑",
    DriveKey.DOWN: "↓",
    DriveKey.LEFT: "←",
    DriveKey.RIGHT: "→",
    DriveKey.STOP: "Stop",
}
_SHARES = {
    DriveKey.UP: (1, 0),
    DriveKey.DOWN: (-1, 0),
    DriveKey.LEFT: (0, 1),
    DriveKey.RIGHT: (0, -1),
    DriveKey.STOP: (0, 0),
}
PAD_CLASS = "simkit-teleop"
"""CSS class of the box around the buttons."""


def button_class(key: DriveKey) -> str:
    """CSS class of the button of a key."""
    return f"{PAD_CLASS}-{key.value}"


def keyboard_html() -> str:
    """A field that takes the arrow keys while it has the focus, and clicks the buttons for them.

    ipywidgets has no keyboard. The field is inside of the same page as the buttons; JupyterLab is asked to keep
    its own shortcuts away from it.
    """
    names = ",".join(f"{code!r}:{key.value!r}" for code, key in _CODES.items())
    script = (
        f"const name={{{names}}}[event.key];"
        "if(name){event.preventDefault();event.stopPropagation();"
        f"this.closest('.{PAD_CLASS}').querySelector('.{PAD_CLASS}-'+name).click();}}"
    )
    style = (
        "border:1px dashed #999;border-radius:4px;padding:2px 8px;"
        "text-align:center;cursor:pointer;line-height:1.4"
    )
    return (
        f'<div tabindex="0" data-lm-suppress-shortcuts="true" class="{PAD_CLASS}-keyboard" '
        f'style="{style}" onkeydown="{escaped(script)}">'
        "Click here to drive with the arrow keys; space stops.</div>"
    )


_CODES = {
    "ArrowUp": DriveKey.UP,
    "ArrowDown": DriveKey.DOWN,
    "ArrowLeft": DriveKey.LEFT,
    "ArrowRight": DriveKey.RIGHT,
    " ": DriveKey.STOP,
}
