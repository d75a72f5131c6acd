"""Parameters."""

from __future__ import annotations

from typing import Any

from simkit.graph.process import client
from simkit.graph.process.client import Refused
from simkit.graph.process.protocol import Op

from .exceptions import ROSException

_NO_DEFAULT = object()


def _ask(do: str, name: str = "", value: Any = None) -> Any:
    try:
        return client.current().ask(Op.PARAM, do=do, name=name, value=value)
    except Refused as error:
        raise ROSException(str(error)) from None
    except TypeError:
        raise ROSException(
            f"a parameter cannot hold {value!r}: numbers, strings, lists and dicts only"
        ) from None


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
    """Set a parameter."""
    _ask("set", param_name, param_value)


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
