"""Records: values with named fields that never change, as frozen dataclasses are, but of classes that are made quickly.

A command line starts often, and makes some sixty such classes at each start. `dataclasses` writes and compiles methods for
each of them, in about 1 ms, and loads `inspect` to do so. Here all classes share the methods of one base: 0.03 ms. A record
itself is made as fast as a frozen dataclass. What is made by the ten thousand is a named tuple, 0.2 ms a class.
"""

from __future__ import annotations

from typing import Any, ClassVar, TypeVar, dataclass_transform

_keep = object.__setattr__


@dataclass_transform(frozen_default=True, kw_only_default=True)
class Record:
    """Base of records: a subclass lists its fields with their types, and with defaults where there are some.

    Two are equal if they are of one class and all fields are equal; a record is hashable if its fields are.

    Args:
        kw_only: A keyword of the class: whether the fields must be given by name.
        values: Fields by place, in their order.
        named: Fields by name.

    Raises:
        TypeError: A field is missing, unknown, or given twice.
    """

    __match_args__: ClassVar[tuple[str, ...]] = ()
    _fields: ClassVar[tuple[str, ...]] = ()
    _defaults: ClassVar[dict[str, Any]] = {}

    def __init_subclass__(cls, *, kw_only: bool = True) -> None:
        own = tuple(cls.__annotations__)
        cls._fields = tuple(dict.fromkeys((*cls._fields, *own)))
        cls._defaults = {
            **cls._defaults,
            **{name: cls.__dict__[name] for name in own if name in cls.__dict__},
        }
        cls.__match_args__ = () if kw_only else cls._fields  # type: ignore[misc]  # not final here

    def __init__(self, *values: Any, **named: Any) -> None:
        if values and not named and len(values) == len(self.__match_args__):
            named = dict(zip(self.__match_args__, values, strict=True))  # quicker than what follows
            _keep(self, "__dict__", named)
            return
        if values:
            named = self._with_names(values, named)
        if len(named) != len(self._fields):
            named = {**self._defaults, **named}
        if len(named) != len(self._fields) or not all(map(named.__contains__, self._fields)):
            raise TypeError(self._complaint(named))
        _keep(self, "__dict__", named)

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"{type(self).__name__} never changes: cannot set {name!r}")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"{type(self).__name__} never changes: cannot delete {name!r}")

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        return self.__dict__ == other.__dict__

    def __hash__(self) -> int:
        return hash(tuple(map(self.__dict__.__getitem__, self._fields)))

    def __repr__(self) -> str:
        shown = ", ".join(f"{name}={self.__dict__[name]!r}" for name in self._fields)
        return f"{type(self).__qualname__}({shown})"

    def _with_names(self, values: tuple[Any, ...], named: dict[str, Any]) -> dict[str, Any]:
        """All fields that were given, by name."""
        placed = dict(zip(self.__match_args__, values, strict=False))
        if len(placed) < len(values):
            raise TypeError(
                f"{type(self).__name__} takes {len(self.__match_args__)} fields by place, "
                f"and {len(values)} were given"
            )
        twice = [name for name in placed if name in named]
        if twice:
            raise TypeError(f"{type(self).__name__} got {', '.join(twice)} twice")
        return {**placed, **named}

    def _complaint(self, named: dict[str, Any]) -> str:
        missing = [name for name in self._fields if name not in {**self._defaults, **named}]
        unknown = [name for name in named if name not in self._fields]
        lacks = f"lacks {', '.join(missing)}" if missing else ""
        has_no = f"has no field {', '.join(unknown)}" if unknown else ""
        fields = f"its fields are {', '.join(self._fields)}"
        return f"{type(self).__name__} {'; '.join(filter(None, (lacks, has_no, fields)))}"


AnyRecord = TypeVar("AnyRecord", bound=Record)


def replace(record: AnyRecord, **changes: Any) -> AnyRecord:
    """The same record with other values in some fields.

    Args:
        record: The record; it stays as it is.
        changes: The fields that differ, by name.

    Raises:
        TypeError: It has no such field.
    """
    return type(record)(**{**vars(record), **changes})
