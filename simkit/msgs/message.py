"""The base of all message classes.

Source:
    genpy's `Message` (Noetic): constructor, errors, comparison, `serialize`, `deserialize`.
"""

from __future__ import annotations

import struct
from collections.abc import Callable
from typing import IO, TYPE_CHECKING, Any, ClassVar, Self

from simkit.errors import near_names
from simkit.msgs.check import explain
from simkit.msgs.definition import MAX_MESSAGE_BYTES, Definition
from simkit.msgs.errors import DeserializationError
from simkit.msgs.strify import strify_message

if TYPE_CHECKING:

    class _MessageType(type):
        # The constants of a class are known from its definition only.
        def __getattr__(cls, name: str) -> Any: ...
else:
    _MessageType = type

# What a generated encoder raises when a value does not fit; SerializationError says which.
_UNSENDABLE = (struct.error, TypeError, AttributeError, ValueError, OverflowError)


class Message(metaclass=_MessageType):
    """A message: its fields are attributes, its constants attributes of the class.

    Without arguments every field has its default. Positional arguments give all fields in
    order, keyword arguments some of them; `None` stands for the default.

    Raises:
        TypeError: Both kinds of arguments, or the wrong number of positional ones.
        AttributeError: A keyword is not a field.
    """

    __slots__ = ["_connection_header"]

    _type: ClassVar[str]
    """Name with its package, `geometry_msgs/Twist`."""
    _md5sum: ClassVar[str]
    """MD5 sum, equal to that of real ROS."""
    _full_text: ClassVar[str]
    """The definition and those of the nested messages."""
    _slot_types: ClassVar[list[str]]
    """Type of each field, in the order of `__slots__`."""
    _has_header: ClassVar[bool]
    """Whether the field `header` is a std_msgs/Header."""
    _definition: ClassVar[Definition]
    _constant_defaults: ClassVar[tuple[tuple[str, Any], ...]]
    _fresh_defaults: ClassVar[tuple[tuple[str, Callable[[], Any]], ...]]
    _encode: ClassVar[Callable[[Any], bytes]]
    _decode: ClassVar[Callable[[bytes, int, int], tuple[Any, int]]]

    _connection_header: dict[str, str]
    """Of a received message: who sent it (`callerid`), on which `topic`, of which `type`."""

    def __init__(self, *args: Any, **kwds: Any) -> None:
        if args or kwds:
            self._assign(args, kwds)
            return
        for name, value in self._constant_defaults:
            setattr(self, name, value)
        for name, make in self._fresh_defaults:
            setattr(self, name, make())

    def _assign(self, args: tuple[Any, ...], kwds: dict[str, Any]) -> None:
        names = self.__slots__
        if args and kwds:
            raise TypeError("Message constructor may only use args OR keywords, not both")
        if args and len(args) != len(names):
            raise TypeError(f"Invalid number of arguments, args should be {names} args are{args}")
        for name in kwds:
            if name not in names:
                raise AttributeError(self._unknown_field(name))
        given = dict(zip(names, args, strict=True)) if args else kwds
        for name, value in self._constant_defaults:
            own = given.get(name)
            setattr(self, name, value if own is None else own)
        for name, make in self._fresh_defaults:
            own = given.get(name)
            setattr(self, name, make() if own is None else own)

    def _unknown_field(self, name: str) -> str:
        text = f"{name} is not an attribute of {type(self).__name__}"
        near = near_names(name, self.__slots__)
        meant = f"; did you mean {near[0]}?" if near else ""
        return f"{text}{meant} Fields: {', '.join(self.__slots__)}"

    if TYPE_CHECKING:
        # The fields of a class are known from its definition only.
        def __getattr__(self, name: str) -> Any: ...
        def __setattr__(self, name: str, value: Any) -> None: ...

    def to_bytes(self) -> bytes:
        """The message in the ROS 1 wire format.

        Raises:
            SerializationError: A field holds a value that its type cannot send; the text
                names the field, `field linear.x must be float type`.
        """
        try:
            return type(self)._encode(self)
        except _UNSENDABLE as error:
            raise explain(self, error) from None

    @classmethod
    def from_bytes(
        cls, data: bytes | bytearray | memoryview, max_bytes: int = MAX_MESSAGE_BYTES
    ) -> Self:
        """The message that `data` holds; text that is not UTF-8 is repaired, as in rospy.

        Args:
            data: Exactly one message in the ROS 1 wire format.
            max_bytes: Largest size accepted.

        Raises:
            DeserializationError: The bytes are not exactly one message of this type.
        """
        if len(data) > max_bytes:
            raise DeserializationError(
                f"{cls._type}: {len(data)} bytes, at most {max_bytes} are accepted"
            )
        message, end = cls._read(bytes(data))
        if end != len(data):
            raise DeserializationError(f"{cls._type}: {len(data) - end} bytes are left over")
        return message

    @classmethod
    def _read(cls, data: bytes) -> tuple[Self, int]:
        try:
            return cls._decode(data, 0, len(data))
        except (struct.error, DeserializationError) as error:
            raise DeserializationError(f"{cls._type}: {error}") from None

    def serialize(self, buff: IO[bytes]) -> None:
        """Write the message to a binary file; see `to_bytes`."""
        buff.write(self.to_bytes())

    def deserialize(self, data: bytes) -> Self:
        """Read all fields from the beginning of `data`; returns the message itself.

        Raises:
            DeserializationError: The bytes do not begin with a message of this type.
        """
        message, _ = self._read(data)
        for name in self.__slots__:
            setattr(self, name, getattr(message, name))
        return self

    def __str__(self) -> str:
        return strify_message(self)

    __repr__ = __str__

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, type(self)):
            return False
        return all(_equal(getattr(self, n), getattr(other, n)) for n in self.__slots__)

    __hash__ = None  # type: ignore[assignment]


def _equal(mine: Any, other: Any) -> bool:
    """Equality of two values of a field; a list and a tuple may be equal."""
    if isinstance(mine, (list, tuple)) and isinstance(other, (list, tuple)):
        return tuple(mine) == tuple(other)
    return bool(mine == other)
