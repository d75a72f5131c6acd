"""`rosparam`: reading and writing the parameter server, also from and to YAML files.

Source: rosparam of ROS Noetic, outputs and texts: setting a mapping keeps what it does not name.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from simkit.commands.command import Answer, Call, subcommands
from simkit.commands.errors import ToolError, near_hint
from simkit.commands.graph_facts import is_below, resolved
from simkit.commands.parameter_yaml import dump_parameters, load_parameters
from simkit.commands.parser import ArgumentParser
from simkit.graph import Graph
from simkit.graph.params import why_unsendable

_NAMESPACE_KEY = "_ns"
"As the first key of a YAML document: the namespace of all that follows."

_END_OF_SCALAR = "\n...\n"
"What PyYAML ends a single value with."


def get(graph: Graph, name: str, *, pretty: bool = False) -> str:
    """What `rosparam get` prints: the value as YAML.

    Args:
        graph: The graph.
        name: Parameter or namespace.
        pretty: As `-p`: strings and mappings for people, not for YAML.

    Raises:
        ToolError: It is not set.
    """
    value = _value(graph, name)
    if pretty and isinstance(value, dict):
        return _pretty(value, "")
    if pretty and isinstance(value, str):
        return f"{value}\n"
    return dump_parameters(value).removesuffix(_END_OF_SCALAR) + "\n"


def set_value(graph: Graph, name: str, text: str) -> None:
    """Set a parameter to a value in YAML, as `rosparam set` does; prints nothing.

    Raises:
        ToolError: The text is not YAML, or means nothing.
    """
    values = load_parameters(text) if text else [""]
    if len(values) != 1 or values[0] is None:
        raise ToolError(f"ERROR: {text!r} is no value for a parameter")
    _set(graph, resolved(name), values[0])


def list_parameters(graph: Graph, namespace: str = "/") -> str:
    """What `rosparam list` prints: the names of the parameters, sorted."""
    within = resolved(namespace)
    names = (name for name in graph.params.names() if is_below(name, within) and name != within)
    return "\n".join(names) + "\n"


def delete(graph: Graph, name: str) -> None:
    """Remove a parameter or a namespace, as `rosparam delete` does; prints nothing.

    Raises:
        ToolError: It is not set.
    """
    _value(graph, name)
    graph.params.delete(resolved(name))


def load(graph: Graph, file: str | Path, namespace: str = "/") -> None:
    """Set parameters from a YAML file, as `rosparam load` does; prints nothing.

    Raises:
        ToolError: There is no such file, it is not YAML, or not a mapping.
    """
    path = Path(file)
    if not path.is_file():
        raise ToolError(f"ERROR: file [{file}] does not exist")
    for document in load_parameters(_text_of(path), file=str(file)):
        name, values = resolved(namespace), document
        if isinstance(document, dict) and _NAMESPACE_KEY in document:
            values = dict(document)
            name = _join(name, str(values.pop(_NAMESPACE_KEY)))
        if name == "/" and not isinstance(values, dict):
            raise ToolError("ERROR: global / can only be set to a dictionary")
        _set(graph, name, values)


def dump(graph: Graph, namespace: str = "/") -> str:
    """What `rosparam dump` writes: all parameters of a namespace as YAML.

    Raises:
        ToolError: The namespace is not set.
    """
    return dump_parameters(_value(graph, namespace))


def _value(graph: Graph, name: str) -> Any:
    full = resolved(name)
    value = graph.params.get(full, None)
    if value is None:
        hint = near_hint(full, graph.params.names())
        raise ToolError(f"ERROR: Parameter [{full}] is not set{hint}")
    return value


def _set(graph: Graph, name: str, value: Any) -> None:
    """Set a value, or all values of a mapping, or none if one of them cannot be set."""
    found = list(_leaves(name, value))
    for full, leaf in found:
        if reason := why_unsendable(leaf):
            raise ToolError(f"ERROR: {full}: {reason.what}")
    for full, leaf in found:
        graph.params.set(full, leaf)


def _leaves(name: str, value: Any) -> Iterator[tuple[str, Any]]:
    """The values in a mapping, each with its global name."""
    if not isinstance(value, dict):
        yield name, value
        return
    for key, item in value.items():
        if not isinstance(key, str):
            raise ToolError(
                f"ERROR: YAML dictionaries must have string keys. Invalid dictionary is:\n{value}"
            )
        yield from _leaves(_join(name, key), item)


def _text_of(path: Path) -> str:
    try:
        return path.read_text("utf-8")
    except UnicodeDecodeError:
        raise ToolError(
            f"ERROR: file [{path}] is not a text in UTF-8; save it with that encoding"
        ) from None
    except OSError as error:
        raise ToolError(f"ERROR: file [{path}] cannot be read: {error.strerror}") from None


def _join(namespace: str, name: str) -> str:
    return resolved(name) if name.startswith("/") else f"{namespace.rstrip('/')}/{name}"


def _pretty(tree: dict[str, Any], indent: str) -> str:
    text = ""
    for key, value in sorted(tree.items()):
        if isinstance(value, dict):
            text += f"{indent}{key}:\n{_pretty(value, indent + '  ')}"
        elif isinstance(value, str) and "\n" in value:
            lines = "".join(f"{indent}  {line}\n" for line in value.split("\n"))
            text += f"{indent}{key}: |\n{lines}"
        elif isinstance(value, str):
            text += f"{indent}{key}: {value}\n"
        else:
            text += (
                f"{indent}{key}: {dump_parameters(value).removesuffix(_END_OF_SCALAR).rstrip()}\n"
            )
    return text


def _get_command(call: Call) -> Answer:
    parser = ArgumentParser("rosparam get")
    parser.add_argument("-p", dest="pretty", action="store_true", help="for people")
    parser.add_argument("parameter")
    found = parser.parse_args(call.words)
    yield get(call.graph, found.parameter, pretty=found.pretty)


def _set_command(call: Call) -> None:
    parser = ArgumentParser("rosparam set")
    parser.add_argument("-t", "--textfile", help="file with the text to set")
    parser.add_argument("parameter")
    parser.add_argument("value", nargs="?", help="YAML")
    found = parser.parse_args(call.words)
    if (found.value is None) == (found.textfile is None):
        parser.error("invalid arguments. Please specify a parameter value")
    if found.textfile is None:
        set_value(call.graph, found.parameter, found.value)
        return
    path = Path(found.textfile)
    if not path.is_file():
        parser.error(f"file '{path}' does not exist")
    call.graph.params.set(resolved(found.parameter), _text_of(path))


def _list_command(call: Call) -> Answer:
    parser = ArgumentParser("rosparam list")
    parser.add_argument("namespace", nargs="?", default="/")
    yield list_parameters(call.graph, parser.parse_args(call.words).namespace)


def _delete_command(call: Call) -> None:
    parser = ArgumentParser("rosparam delete")
    parser.add_argument("parameter")
    delete(call.graph, parser.parse_args(call.words).parameter)


def _load_command(call: Call) -> None:
    parser = ArgumentParser("rosparam load")
    parser.add_argument("file")
    parser.add_argument("namespace", nargs="?", default="/")
    found = parser.parse_args(call.words)
    load(call.graph, found.file, found.namespace)


def _dump_command(call: Call) -> Answer:
    parser = ArgumentParser("rosparam dump")
    parser.add_argument("file", nargs="?", help="to write; without it the text is printed")
    parser.add_argument("namespace", nargs="?", default="/")
    found = parser.parse_args(call.words)
    text = dump(call.graph, found.namespace)
    if found.file is None:
        yield text
    else:
        _write_text(Path(found.file), text)


def _write_text(path: Path, text: str) -> None:
    try:
        path.write_text(text, "utf-8")
    except OSError as error:
        raise ToolError(f"ERROR: file [{path}] cannot be written: {error.strerror}") from None


COMMANDS = {
    "delete": _delete_command,
    "dump": _dump_command,
    "get": _get_command,
    "list": _list_command,
    "load": _load_command,
    "set": _set_command,
}
"""The commands of rosparam by name."""
run = subcommands("rosparam", COMMANDS)
