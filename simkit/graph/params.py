"""The parameter server: a tree of values under global names.

Source: rosmaster's `ParamDictionary` (a parameter that is a dict is a namespace; setting one replaces what was below it), and
XML-RPC as rosmaster speaks it: whole numbers of 32 bits, no empty value, keys that are texts.
"""

from __future__ import annotations

import copy
from dataclasses import dataclass
from typing import Any

from simkit.errors import UnknownNameError
from simkit.graph.errors import GraphError

_MISSING = object()
_INT_LIMIT = 2**31


class ParameterServer:
    """Values by global name, e.g. `/turtlesim/background_r`."""

    def __init__(self) -> None:
        self._tree: dict[str, Any] = {}

    def get(self, name: str, default: Any = _MISSING) -> Any:
        """A copy of the value at a global name; a dict for a namespace.

        Raises:
            UnknownNameError: Nothing is there and no default was given.
        """
        value: Any = self._tree
        for key in _keys(name):
            if not isinstance(value, dict) or key not in value:
                if default is _MISSING:
                    raise UnknownNameError("parameter", name, self.names())
                return default
            value = value[key]
        return copy.deepcopy(value)

    def has(self, name: str) -> bool:
        """Whether a value or a namespace is at that global name."""
        return self.get(name, None) is not None

    def set(self, name: str, value: Any) -> None:
        """Set a value; dicts become namespaces, and values in the way are replaced."""
        keys = _keys(name)
        value = copy.deepcopy(value)
        if not keys:
            if not isinstance(value, dict):
                raise GraphError("the root of the parameters can only be set to a dict")
            self._tree = value
            return
        tree = self._tree
        for key in keys[:-1]:
            if not isinstance(tree.get(key), dict):
                tree[key] = {}
            tree = tree[key]
        tree[keys[-1]] = value

    def delete(self, name: str) -> None:
        """Remove a value or a whole namespace.

        Raises:
            UnknownNameError: Nothing is there.
        """
        keys = _keys(name)
        if not keys:
            self._tree = {}
            return
        parent = self.get(name.rstrip("/").rpartition("/")[0] or "/", None)
        if not isinstance(parent, dict) or keys[-1] not in parent:
            raise UnknownNameError("parameter", name, self.names())
        tree = self._tree
        for key in keys[:-1]:
            tree = tree[key]
        del tree[keys[-1]]

    def search(self, namespace: str, name: str) -> str | None:
        """The nearest `name` seen from a namespace outwards, or None; a global name stands for itself.

        Args:
            namespace: Where to begin, e.g. the resolved name of a node.
            name: Only its first part has to be found, as in rosmaster.
        """
        if name.startswith("/"):
            return name if self.has(name) else None
        first = _keys(name)[0] if _keys(name) else name
        keys = _keys(namespace)
        for depth in range(len(keys), -1, -1):
            candidate = "/" + "/".join([*keys[:depth], first])
            if self.has(candidate):
                return "/" + "/".join([*keys[:depth], *_keys(name)])
        return None

    def names(self) -> list[str]:
        """Global names of all values, sorted."""
        return sorted(_leaves("", self._tree))


def _keys(name: str) -> list[str]:
    return [key for key in name.split("/") if key]


def _leaves(prefix: str, tree: dict[str, Any]) -> list[str]:
    names: list[str] = []
    for key, value in tree.items():
        if isinstance(value, dict) and value:
            names += _leaves(f"{prefix}/{key}", value)
        else:
            names.append(f"{prefix}/{key}")
    return names


@dataclass(frozen=True, slots=True, kw_only=True)
class Unsendable:
    """Why a value cannot be sent."""

    cause: str
    """What ROS says."""
    what: str
    """The same for people."""


def why_unsendable(value: Any) -> Unsendable | None:
    """Why a value cannot be that of a parameter; None if it can.

    Args:
        value: Any value of YAML; it must not stand in itself.
    """
    parts = [value]
    while parts:
        part = parts.pop()
        if isinstance(part, dict):
            parts += [*part.keys(), *part.values()]
        elif isinstance(part, list):
            parts += part
        elif found := _of_one(part):
            return found
    return None


def _of_one(part: Any) -> Unsendable | None:
    if part is None:
        cause = "cannot marshal None unless allow_none is enabled"
        return Unsendable(cause=cause, what="a parameter cannot be empty (null)")
    if isinstance(part, int) and not -_INT_LIMIT <= part < _INT_LIMIT:
        return Unsendable(cause="int exceeds XML-RPC limits", what=f"{part} is too large")
    if isinstance(part, bool | int | float | str | bytes):
        return None
    kind = type(part)
    return Unsendable(
        cause=f"cannot marshal {kind} objects", what=f"{part} is a {kind.__name__} in YAML"
    )
