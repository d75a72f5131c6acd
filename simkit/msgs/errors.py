"""What can be wrong with a message: its values, its bytes, or the text it is filled from."""

from __future__ import annotations

from simkit.errors import SimkitError


class MessageError(SimkitError):
    """Root of the errors about messages (genpy calls it MessageException)."""


class SerializationError(MessageError):
    """A field holds a value that its type cannot send; the text names the field."""


class DeserializationError(MessageError):
    """Bytes that are not a message of the type."""


class DefinitionError(MessageError):
    """A .msg, .srv or .action text that cannot be read; the text names the type and the line."""
