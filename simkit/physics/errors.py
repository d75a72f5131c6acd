"""What can go wrong with physics."""

from __future__ import annotations

from collections.abc import Sequence

from simkit.diagnostics import Diagnostic
from simkit.errors import SimkitError


class PhysicsError(SimkitError):
    """Something that the simulator cannot do, in one line."""


class NoEngineError(PhysicsError):
    """dartpy is not there."""


class ModelError(PhysicsError):
    """A model that cannot be simulated: of which part, why, and what would be right."""


class WorldFileError(PhysicsError):
    """A world file that cannot be read: `file:line:column: what is wrong; what would be right`."""

    def __init__(self, text: str, diagnostics: Sequence[Diagnostic] = ()) -> None:
        super().__init__(text)
        self.diagnostics = tuple(diagnostics)
        """All that was found in the file, the first error among it."""
