"""Which types of data a buffer can transform, and how types turn into each other.

A package such as tf2_geometry_msgs registers its types when it is imported.
"""

from __future__ import annotations

from collections.abc import Callable
from copy import deepcopy
from typing import Any, ClassVar

_Function = Callable[..., Any]
_KNOWN = "tf2_geometry_msgs"


class TypeException(Exception):
    """No function is registered for a type of data.

    Args:
        errstr: tf2's text.

    Attributes:
        hint: What to import.
    """

    def __init__(self, errstr: str) -> None:
        super().__init__(errstr)
        self.errstr = errstr
        self.hint = (
            f"Write `import {_KNOWN}` in your script: it registers PointStamped, Vector3Stamped, "
            "PoseStamped and WrenchStamped of geometry_msgs. Other types are not known."
        )


class TransformRegistration:
    """The functions that transform data, by the type of the data; one table for all objects."""

    _functions: ClassVar[dict[Any, _Function]] = {}

    def add(self, key: Any, callback: _Function) -> None:
        """Use `callback(data, transform)` for data of the type `key`."""
        self._functions[key] = callback

    def get(self, key: Any) -> _Function:
        """The function for a type.

        Raises:
            TypeException: None is registered.
        """
        return _registered(self._functions, key)

    def print_me(self) -> None:
        """Print the table."""
        print(self._functions)


class ConvertRegistration:
    """The functions that turn data of one type into another, or into a message and back."""

    _to_message: ClassVar[dict[Any, _Function]] = {}
    _from_message: ClassVar[dict[Any, _Function]] = {}
    _direct: ClassVar[dict[Any, _Function]] = {}

    def add_from_msg(self, key: Any, callback: _Function) -> None:
        """Use `callback(message)` to make data of the type `key`."""
        self._from_message[key] = callback

    def add_to_msg(self, key: Any, callback: _Function) -> None:
        """Use `callback(data)` to make a message of data of the type `key`."""
        self._to_message[key] = callback

    def add_convert(self, key: tuple[Any, Any], callback: _Function) -> None:
        """Use `callback(data)` between the two types of `key`."""
        self._direct[key] = callback

    def get_from_msg(self, key: Any) -> _Function:
        """The function that makes data of a type from a message.

        Raises:
            TypeException: None is registered.
        """
        return _registered(self._from_message, key)

    def get_to_msg(self, key: Any) -> _Function:
        """The function that makes a message of data of a type.

        Raises:
            TypeException: None is registered.
        """
        return _registered(self._to_message, key)

    def get_convert(self, key: tuple[Any, Any]) -> _Function:
        """The function between two types.

        Raises:
            TypeException: None is registered.
        """
        return _registered(self._direct, key)


def convert(a: Any, b_type: Any) -> Any:
    """The data `a` as an object of another type.

    Raises:
        TypeException: No way is registered.
    """
    registration = ConvertRegistration()
    try:
        return registration.get_convert((type(a), b_type))(a)
    except TypeException:
        if type(a) is b_type:
            return deepcopy(a)
    return registration.get_from_msg(b_type)(registration.get_to_msg(type(a))(a))


def _registered(functions: dict[Any, _Function], key: Any) -> _Function:
    if key not in functions:
        raise TypeException(f"Type {key} if not loaded or supported")
    return functions[key]
