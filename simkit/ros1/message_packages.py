"""Makes the message packages of ROS importable: `from geometry_msgs.msg import Twist`.

`install` adds a finder to the import system. It serves `<package>.msg` and `<package>.srv` of
each package that `simkit.msgs` defines, `<package>.msg._<Name>` as editors write it, and the
names of `genpy` that scripts use. A class is made when it is first asked for.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from difflib import get_close_matches
from functools import partial
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec, PathFinder
from types import ModuleType
from typing import Any

import simkit.msgs as msgs
from simkit.errors import near_names

_Names = dict[str, Callable[[], Any]]  # name in a module -> what makes its value


def install() -> None:
    """Make the message packages importable in this process; again is harmless."""
    if not any(isinstance(finder, _Finder) for finder in sys.meta_path):
        # First, or an empty folder of the same name (a namespace package) would win.
        sys.meta_path.insert(0, _Finder())
        sys.meta_path.append(_Adviser())


def uninstall() -> None:
    """Undo `install`, and forget the modules that were imported through it."""
    sys.meta_path[:] = [f for f in sys.meta_path if not isinstance(f, _Finder | _Adviser)]
    for name, module in list(sys.modules.items()):
        if isinstance(module, _LazyModule):
            del sys.modules[name]


class _LazyModule(ModuleType):
    """A module whose names are made when they are first used."""

    def __init__(self, name: str, names: _Names) -> None:
        super().__init__(name)
        self.__all__ = sorted(names)
        self._names = names

    def __getattr__(self, name: str) -> Any:
        names: _Names = self.__dict__["_names"]
        if name not in names:
            raise AttributeError(_unknown_name(self.__name__, name, names))
        value = names[name]()
        setattr(self, name, value)
        return value

    def __dir__(self) -> list[str]:
        return sorted({*super().__dir__(), *self.__all__})


class _Finder(MetaPathFinder, Loader):
    """Finds and loads the modules of the message packages, and genpy."""

    def __init__(self) -> None:
        self._packages = frozenset((*msgs.packages(), "genpy"))

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        package, _, rest = fullname.partition(".")
        if package not in self._packages:
            return None
        if rest.split(".")[0] not in ("msg", "srv") and _has_own_code(package):
            return None
        if _module_names(fullname) is None:
            if not _has_own_code(package):
                _refuse_misspelt(fullname)
            return None
        return ModuleSpec(fullname, self, is_package=True)

    def create_module(self, spec: ModuleSpec) -> ModuleType:
        return _LazyModule(spec.name, _module_names(spec.name) or {})

    def exec_module(self, module: ModuleType) -> None:
        """Nothing to run: the names come on demand."""


class _Adviser(MetaPathFinder):
    """Comes last: explains which package was meant by a name that nothing else found."""

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        # Only what is nearly right: a library that looks for another must not be advised.
        near = get_close_matches(fullname, msgs.packages(), n=1, cutoff=0.8)
        if near and "." not in fullname:
            text = f"No module named {fullname!r}; did you mean {near[0]!r}?"
            raise ModuleNotFoundError(text, name=fullname)
        return None


def _has_own_code(package: str) -> bool:
    """Whether the package is more than messages, as `tf` is: then it is imported as usual."""
    spec = PathFinder.find_spec(package)
    return spec is not None and spec.loader is not None and spec.origin is not None


def _module_names(fullname: str) -> _Names | None:
    """The names in a module, or `None` if there is no such module."""
    package, *rest = fullname.split(".")
    if package == "genpy":
        return _GENPY_MODULES.get(".".join(rest))
    match rest:
        case []:
            return {}
        case ["msg"]:
            return _message_names(package) or None
        case ["srv"]:
            return _service_names(package) or None
        case ["msg", file] if file[1:] in _message_names(package) and file[0] == "_":
            return {file[1:]: _message_names(package)[file[1:]]}
        case ["srv", file] if file[0] == "_":
            own = {file[1:], f"{file[1:]}Request", f"{file[1:]}Response"}
            return {n: make for n, make in _service_names(package).items() if n in own} or None
    return None


def _message_names(package: str) -> _Names:
    names = _own_types(package, msgs.message_types())
    return {short: partial(msgs.message_class, name) for short, name in names.items()}


def _service_names(package: str) -> _Names:
    names: _Names = {}
    for short, name in _own_types(package, msgs.service_types()).items():
        names[short] = partial(msgs.service_class, name)
        names[f"{short}Request"] = partial(_service_part, name, "_request_class")
        names[f"{short}Response"] = partial(_service_part, name, "_response_class")
    return names


def _service_part(service_type: str, part: str) -> Any:
    return getattr(msgs.service_class(service_type), part)


def _own_types(package: str, types: list[str]) -> dict[str, str]:
    """Short name -> full name of the types of one package."""
    prefix = f"{package}/"
    return {name.removeprefix(prefix): name for name in types if name.startswith(prefix)}


def _refuse_misspelt(fullname: str) -> None:
    """Raise for `from geometry_msgs.msg import Twst`, which Python asks for as a module."""
    parent, _, name = fullname.rpartition(".")
    names = _module_names(parent)
    if names is not None and not name.startswith("_"):
        known = list(names) or _submodules(parent)
        text = f"cannot import name {name!r} from {parent!r}{_meant(name, known)}"
        raise ImportError(text, name=fullname)


def _submodules(package: str) -> list[str]:
    return [name for name in ("msg", "srv") if _module_names(f"{package}.{name}") is not None]


def _unknown_name(module: str, name: str, names: _Names) -> str:
    text = f"module {module!r} has no attribute {name!r}"
    if name in _submodules(module):
        return f"{text}; it is a module of its own: import {module}.{name}"
    return text + _meant(name, list(names))


def _meant(name: str, known: list[str]) -> str:
    near = near_names(name, known)
    text = f"; did you mean {' or '.join(map(repr, near))}?" if near else ""
    if known:
        text += f"{'' if near else ';'} Known: {', '.join(sorted(known)[:12])}"
    return text + (", ..." if len(known) > 12 else "")


def _constants(**values: Any) -> _Names:
    return {name: partial(_itself, value) for name, value in values.items()}


def _itself(value: Any) -> Any:
    return value


_TIMES = {"Time": msgs.Time, "Duration": msgs.Duration, "TVal": msgs.TVal}
_MESSAGES = {
    "Message": msgs.Message,
    "MessageException": msgs.MessageError,
    "SerializationError": msgs.SerializationError,
    "DeserializationError": msgs.DeserializationError,
}
_GENPY_MODULES = {
    "": _constants(**_TIMES, **_MESSAGES),
    "message": _constants(
        **_TIMES,
        **_MESSAGES,
        get_message_class=msgs.message_class,
        get_service_class=msgs.service_class,
        strify_message=msgs.strify_message,
    ),
    "rostime": _constants(**_TIMES),
}
