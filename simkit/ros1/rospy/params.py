"""Parameters."""

from __future__ import annotations

from typing import Any

from simkit.graph.process import client
from simkit.graph.process.node_client import Refused
from simkit.graph.process.protocol import MAX_DEPTH, Op

from .exceptions import ROSException

_NO_DEFAULT = object()
_INT_LIMIT = 2**31
"""XML-RPC, which carries parameters in ROS, has 32 bits for an integer."""


def _ask(do: str, name: str = "", value: Any = None) -> Any:
    try:
        return client.current().ask(Op.PARAM, do=do, name=name, value=value)
    except Refused as error:
        raise ROSException(str(error)) from None


def _storable(value: Any, depth: int = MAX_DEPTH - 2) -> Any:
    """`value` as plain data; what XML-RPC cannot carry is refused as it would be there."""
    if depth == 0:
        raise TypeError(f"a parameter cannot be nested more than {MAX_DEPTH - 2} times")
    if isinstance(value, bool | str):
        return value
    if isinstance(value, int):
        if not -_INT_LIMIT <= value < _INT_LIMIT:
            raise OverflowError(f"int exceeds XML-RPC limits: {value}")
        return value
    if isinstance(value, float):
        return float(value)
    if isinstance(value, list | tuple):
        return [_storable(item, depth - 1) for item in value]
    if isinstance(value, dict):
        if not all(isinstance(key, str) for key in value):
            raise TypeError(f"dictionary key must be string: {list(value)}")
        return {key: _storable(item, depth - 1) for key, item in value.items()}
    raise TypeError(
        f"cannot marshal {'None' if value is None else type(value)} objects: a parameter holds "
        "numbers, strings, booleans, lists and dicts"
    )


def get_param(param_name: str, default: Any = _NO_DEFAULT) -> Any:
    """Value of a parameter; `~x` is private.

    Raises:
        KeyError: It is not set and there is no default.
    """
    reply = _ask("get", param_name)
    if "value" in reply:
        return reply["value"]
    if default is _NO_DEFAULT:
        raise KeyError(param_name)
    return default


def get_param_cached(param_name: str, default: Any = _NO_DEFAULT) -> Any:
    """As `get_param`."""
    return get_param(param_name, default)


def set_param(param_name: str, param_value: Any) -> None:
    """Set a parameter.

    Raises:
        TypeError: A parameter cannot hold such a value.
        OverflowError: An integer has more than 32 bits.
    """
    _ask("set", param_name, _storable(param_value))


def has_param(param_name: str) -> bool:
    """Whether a parameter is set."""
    return bool(_ask("has", param_name)["value"])


def delete_param(param_name: str) -> None:
    """Remove a parameter.

    Raises:
        KeyError: It is not set.
    """
    if "missing" in _ask("delete", param_name):
        raise KeyError(param_name)


def search_param(param_name: str) -> str | None:
    """Full name of the nearest parameter of that name, or None."""
    found = _ask("search", param_name)["value"]
    return None if found is None else str(found)


def get_param_names() -> list[str]:
    """Names of all parameters."""
    return list(_ask("names")["value"])
