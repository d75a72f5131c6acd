"""What every widget of a notebook needs: ipywidgets, a text where there is none, and a way to name a fault."""

from __future__ import annotations

import html
from typing import Any

from simkit.errors import SimkitError
from simkit.viz.by_hand.saved_still import SavedStill
from simkit.viz.live_view import running_notebook

BOX: dict[str, str] = {"border": "1px solid #bbb", "padding": "4px 8px", "width": "fit-content"}
"""Layout of the box around the widgets of one view."""


def ipywidgets_for(what: str) -> Any:
    """The module ipywidgets.

    Args:
        what: What needs it, e.g. `the sliders`.

    Raises:
        SimkitError: It is not installed.
    """
    try:
        import ipywidgets
    except ImportError as error:
        raise SimkitError(f"{what} need ipywidgets: pip install ipywidgets") from error
    return ipywidgets


class NotebookWidgets:
    """Shows the box `widget` in a notebook, and what `_repr_html_` says where no kernel runs."""

    message: Any = None
    """The label of the last fault, once it is built."""
    _still: SavedStill | None = None

    @property
    def widget(self) -> Any:
        """The ipywidgets box."""
        raise NotImplementedError

    def say(self, text: str) -> None:
        """Show a fault below the widgets; none if empty."""
        if self.message is not None:
            self.message.value = text
            self.message.layout.display = None if text else "none"

    def _repr_html_(self) -> str:
        lines = html.escape(repr(self))
        return f"<pre>{lines}</pre><small>The widgets need a running notebook.</small>"

    def _ipython_display_(self) -> None:
        if running_notebook() is None:
            raise NotImplementedError  # IPython falls back to the text
        self._still = self._still or SavedStill(self._repr_html_, self.__repr__)
        self._still.show(self._widget_or_none())

    def _widget_or_none(self) -> Any:
        try:
            return self.widget
        except SimkitError:
            return None
