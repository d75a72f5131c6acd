"""`<param>` and `<rosparam>`: parameters, from the text of an attribute, a file, a command or YAML."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from simkit.errors import near_names
from simkit.graph.names import is_legal_name
from simkit.launch.command import output_of
from simkit.launch.errors import Elsewhere, Kind, LaunchRefused, Lesson, ours
from simkit.launch.plan import ParameterStep
from simkit.launch.rules import ATTRIBUTE, FILE, YAML
from simkit.launch.scope import PrivateParameter, Scope, name_in, tidy
from simkit.launch.tag import LaunchTag
from simkit.launch.values import TYPES, convert, load_yaml
from simkit.xml import Span

_PARAM_ATTRIBUTES = ("name", "value", "type", "textfile", "binfile", "command")
_SOURCES = ("value", "textfile", "binfile", "command")
_OTHER_WORDS = {"file": ["textfile"], "default": ["value"]}


@dataclass(frozen=True, slots=True)
class _Found:
    """A value, and the file that it was read from."""

    value: Any
    source: Path | None = None


def take_param(tag: LaunchTag, scope: Scope, *, in_node: bool = False) -> None:
    """Add a parameter: to the server, or, with `~` and in a node, to nodes.

    Args:
        tag: The tag.
        scope: Where it stands.
        in_node: Whether it stands in a `<node>`: then it is private, whatever its name.

    Raises:
        LaunchRefused: It makes no sense.
    """
    if not tag.applies(scope):
        return
    words = {
        Kind.KEY: "<param> tag is missing required attribute: {text}. \n\nParam xml is {xml}",
        Kind.VALUE: "Invalid <param> tag: {text}. \n\nParam xml is {xml}",
    }
    with tag.worded(words):
        _add(tag, scope, in_node=in_node)


def _add(tag: LaunchTag, scope: Scope, *, in_node: bool) -> None:
    tag.check_attributes(_PARAM_ATTRIBUTES)
    type_name = (tag.element.get("type") or "auto").lower().strip()
    sources = {key: value for key in _SOURCES if (value := tag.get(key, scope)) is not None}
    if len(sources) != 1:
        raise tag.refuse(
            "<param> tag must have one and only one of value/textfile/binfile.",
            f"a parameter has one source, and here are {len(sources)}",
            _how_to_have_one(tag, len(sources)),
        )
    name = tag.required("name", scope).strip()
    ((source, text),) = sources.items()
    with tag.about(source if type_name in TYPES else "type"):
        found = _value(tag, name, type_name, source, text)
    _check_name(tag, name)
    if in_node or name.startswith("~"):
        scope.add_parameter(PrivateParameter(name, found.value, (tag.place, found.source)))
    else:
        full = name_in(scope.namespace, name)
        tag.state.add_param(full, found.value, tag.place, found.source)


def _how_to_have_one(tag: LaunchTag, count: int) -> str:
    """What to do about a parameter with no source, or with several."""
    if count:
        return "Keep one of value=, textfile=, binfile=, command=."
    for attribute in tag.element.attributes:
        near = _OTHER_WORDS.get(attribute.name) or near_names(attribute.name, _SOURCES)
        if attribute.name not in _PARAM_ATTRIBUTES and near:
            return f"Write {near[0]}= where {attribute.name}= stands."
    return 'Write value="...", or textfile=, binfile= or command=.'


def _check_name(tag: LaunchTag, name: str) -> None:
    """Tell of a name that the tools of ROS refuse; roslaunch itself takes it."""
    if not name or is_legal_name(name):
        return
    what = f"{name!r} is no legal name of a parameter: rosparam does not read it"
    remedy = "Use letters, digits, _ and / only, a letter first."
    tag.teach(ATTRIBUTE, what, remedy, at="name")


def _value(tag: LaunchTag, name: str, type_name: str, source: str, text: str) -> _Found:
    files = tag.state.files
    if source == "value":
        return _Found(convert(text.strip(), type_name))
    if source == "textfile":
        return _Found(convert(files.read_text(text), type_name), Path(text))
    if source == "binfile":
        return _Found(files.read(text), Path(text))
    output = output_of(text, parameter=name, files=files)
    return _Found(convert(output.text, type_name), output.source)


_ROSPARAM_ATTRIBUTES = ("command", "ns", "file", "param", "subst_value")


def take_rosparam(tag: LaunchTag, scope: Scope) -> None:
    """Load, delete or dump parameters.

    Raises:
        LaunchRefused: It makes no sense.
    """
    if not tag.applies(scope):
        return
    words = {Kind.VALUE: "error loading <rosparam> tag: \n\t{text}\nXML is {xml}"}
    with tag.worded(words, Kind.LOAD):
        _take(tag, scope)


def _take(tag: LaunchTag, scope: Scope) -> None:
    tag.check_attributes(_ROSPARAM_ATTRIBUTES)
    command, namespace, file, name, replaced = (tag.get(key, scope) for key in _ROSPARAM_ATTRIBUTES)
    replace = tag.flag("subst_value", replaced)
    command = command or "load"
    name = name_in(namespace or "", name or "")
    full = name_in(scope.namespace, name) if name else scope.namespace
    if command == "load":
        _load(tag, scope, file, full, named=bool(name), replace=replace)
    elif command == "dump":
        if tag.state.files.confined:
            what, remedy = "a launch file writes no files here", "Remove this tag."
            raise ours(FILE, what, remedy).at(tag.place_of("file"))
        tag.state.steps.append(ParameterStep(command="dump", name=tidy(full), file=file))
    elif command == "delete":
        if file is not None:
            words = "'file' attribute is invalid with 'delete' command."
            raise _wrong(words, "file", "Remove it.").at(tag.place_of("file"))
        tag.state.steps.append(ParameterStep(command="delete", name=tidy(full)))
    else:
        words = "command must be 'load', 'dump', or 'delete'"
        raise _wrong(words, "command", "Leave it out to load.").at(tag.place_of("command"))


def _load(
    tag: LaunchTag, scope: Scope, file: str | None, full: str, *, named: bool, replace: bool
) -> None:
    text = tag.element.text if file is None else _text_of(tag, file)
    if replace:
        text = _replaced(tag, scope, file, text)
    tag.state.budget.yaml(len(text))
    try:
        value = load_yaml(text, file=file)
    except LaunchRefused as refused:
        raise _with_place(refused, tag, file, text) from None
    if not named and not isinstance(value, dict):
        raise LaunchRefused(
            Kind.VALUE,
            "'param' attribute must be set for non-dictionary values",
            _no_mapping(value),
        )
    tag.state.add_tree(full, value, tag.place, Path(file) if file else None)


def _no_mapping(value: object) -> Lesson:
    """What to say of a value without a name; of `speed:1`, which is one word, too."""
    what = "this YAML is no mapping of names to values, so its value has no name"
    remedy = 'Write `name: value`, or give the name by param="...".'
    name, colon, rest = value.partition(":") if isinstance(value, str) else ("", "", "")
    if colon and name and rest:
        what = "this YAML is one word, for there is no blank behind the colon"
        remedy = f"Write {name}: {rest.strip()}".split("\n")[0][:80]
    return Lesson(rule=YAML, what=what, remedy=remedy)


def _text_of(tag: LaunchTag, file: str) -> str:
    files = tag.state.files
    with tag.about("file"):
        if files.may_read(file) and not Path(file).is_file():
            lesson = files.missing(file)
            raise LaunchRefused(Kind.VALUE, f"file does not exist [{file}]", lesson)
        return files.read_text(file)


def _replaced(tag: LaunchTag, scope: Scope, file: str | None, text: str) -> str:
    """The text with every `$(...)` replaced; one that cannot be is named with its line."""
    resolve = tag.state.substitution.resolve
    try:
        return resolve(text, scope)
    except LaunchRefused as refused:
        for number, line in enumerate(text.split("\n"), 1):
            try:
                resolve(line, scope)
            except LaunchRefused:
                refused.mark = (number, line.index("$(") + 1)
                break
        raise _with_place(refused, tag, file, text) from None


def _with_place(
    refused: LaunchRefused, tag: LaunchTag, file: str | None, text: str
) -> LaunchRefused:
    """A fault in YAML, with its place in the file, or in the launch file that the YAML stands in."""
    if refused.mark is None:
        return refused
    line, column = refused.mark
    if file is not None:
        lines = text.split("\n")
        source = lines[line - 1] if line <= len(lines) else ""
        span = Span(line, column)
        shown = tag.state.files.shown(file)
        refused.elsewhere = Elsewhere(file=shown, span=span, source=source)
        return refused.at(tag.place_of("file"))
    begin = tag.element.text_span
    if begin is not None:
        before = text[: len(text) - len(text.lstrip())]
        first = begin.line - before.count("\n")
        offset = begin.column - 1 - len(before) if line == 1 else 0
        refused.at(tag.place_of(Span(first + line - 1, column + offset)))
    return refused


def _wrong(words: str, attribute: str, remedy: str) -> LaunchRefused:
    lesson = Lesson(rule=ATTRIBUTE, what=f"{attribute}= of <rosparam> is wrong", remedy=remedy)
    return LaunchRefused(Kind.VALUE, words, lesson)
