"""Goes through the tags of a launch file in order; `<group>` and `<include>` lead deeper."""

from __future__ import annotations

from collections.abc import Callable

from simkit.errors import near_names
from simkit.launch.errors import Kind, LaunchRefused, Lesson, ours
from simkit.launch.files import MAX_GROUP_DEPTH, MAX_INCLUDE_DEPTH, MAX_LAUNCH_BYTES
from simkit.launch.launch_file import LaunchFile, read_launch_file
from simkit.launch.node_tag import take_node
from simkit.launch.parameter_tags import take_param, take_rosparam
from simkit.launch.rules import ARGUMENT, STRAY_TEXT, TOO_MUCH, UNKNOWN
from simkit.launch.scope import Scope
from simkit.launch.small_tags import (
    take_argument,
    take_environment,
    take_machine,
    take_remapping,
)
from simkit.launch.state import LaunchState
from simkit.launch.tag import LaunchTag
from simkit.xml import Element


def walk(
    root: Element, launch_file: LaunchFile, scope: Scope, state: LaunchState, depth: int = 0
) -> None:
    """Evaluate the tags in a `<launch>` or `<group>`.

    Args:
        root: The element.
        launch_file: Its file.
        scope: What holds in it.
        state: Takes what is found.
        depth: So many groups are around it.

    Raises:
        LaunchRefused: A tag makes no sense, or there are too many.
    """
    _note_stray_text(LaunchTag(root, launch_file, state))
    for element in root.children:
        tag = LaunchTag(element, launch_file, state)
        try:
            _take(tag, scope, depth)
        except LaunchRefused as refused:
            raise refused.at(tag.place) from None


def open_launch_file(
    name: str, state: LaunchState, tag: LaunchTag | None = None
) -> tuple[LaunchFile, Element]:
    """Read a launch file.

    Args:
        name: Its path.
        state: Finds, counts and notes it.
        tag: The `<include>` that names it; None for the first file.

    Raises:
        LaunchRefused: It cannot be read, is no launch file, or includes itself.
    """
    place = tag.place if tag is not None else None
    if tag is not None:
        _require_no_circle(name, tag)
    try:
        data = state.files.read(name, MAX_LAUNCH_BYTES)
    except LaunchRefused as refused:
        if refused.kind is Kind.OURS:
            raise
        words = f"Invalid roslaunch XML syntax: {refused.text}"
        raise refused.worded(Kind.SYNTAX, words) from None
    state.budget.launch_file(len(data))
    shown = state.files.shown(name)
    launch_file, root = read_launch_file(data, name=name, shown=shown, included_at=place)
    state.launch_files.append(name)
    if deprecated := root.get("deprecated"):
        state.warn(f"[{name}] DEPRECATED: {deprecated}")
    return launch_file, root


def _take(tag: LaunchTag, scope: Scope, depth: int) -> None:
    tag.state.budget.tag()
    if tag.name == "group":
        _take_group(tag, scope, depth)
        return
    if tag.name != "rosparam":
        _note_stray_text(tag)
    if tag.name in _HANDLERS:
        _HANDLERS[tag.name](tag, scope)
    elif tag.name != "master":
        _unknown_tag(tag)


def _take_group(tag: LaunchTag, scope: Scope, depth: int) -> None:
    if not tag.applies(scope):
        return
    if depth >= MAX_GROUP_DEPTH:
        what = f"more than {MAX_GROUP_DEPTH} groups in each other"
        raise ours(TOO_MUCH, what, "Use fewer.").at(tag.place)
    tag.check_attributes(("ns", "clear_params"))
    inner = scope.child(_cleared_namespace(tag, scope))
    inner.parameters = list(inner.parameters)
    walk(tag.element, tag.launch_file, inner, tag.state, depth + 1)


def _take_include(tag: LaunchTag, scope: Scope) -> None:
    if not tag.applies(scope):
        return
    tag.check_attributes(("file", "ns", "clear_params", "pass_all_args"))
    name = tag.required("file", scope)
    passes_all = tag.flag("pass_all_args", tag.get("pass_all_args", scope))
    inner = scope.for_include(_cleared_namespace(tag, scope))
    if passes_all:
        for argument, value in scope.arguments.items():
            inner.declare(argument, value=value, default=None)
    inner.passes_all = passes_all
    for child in tag.children():
        tag.state.budget.tag()
        if child.name.lower() == "env":
            take_environment(child, inner)
        elif child.name.lower() == "arg":
            take_argument(child, inner)
        else:
            _unknown_in_include(tag, child)
    shown = name.replace("{", "{{").replace("}", "}}")
    words = {
        Kind.ARGUMENT: f"included file [{shown}] requires the '{{text}}' arg to be set",
        Kind.SYNTAX: f"while processing {shown}:\n{{text}}",
    }
    with tag.worded(words):
        _enter(tag, name, inner, passes_all=passes_all)


def _enter(tag: LaunchTag, name: str, inner: Scope, *, passes_all: bool) -> None:
    with tag.about("file"):
        launch_file, root = open_launch_file(name, tag.state, tag)
    given = inner.enter(launch_file)
    walk(root, launch_file, inner, tag.state)
    unused = [argument for argument in given if argument not in inner.declared]
    if unused and not passes_all:
        culprits = [child for child in tag.children() if child.element.get("name") in unused]
        raise _unused(unused, name, inner).at((culprits or [tag])[0].place)


def _cleared_namespace(tag: LaunchTag, scope: Scope) -> str | None:
    """The namespace of a group or include; noted if its parameters are to be cleared."""
    namespace = tag.namespace(scope)
    if tag.flag("clear_params", tag.get("clear_params", scope) or None):
        if not namespace:
            words = "'ns' attribute must be set in order to use 'clear_params'"
            raise tag.refuse(words, "clear_params= needs ns=", 'Write ns="...".', at="clear_params")
        tag.state.clear_params.append(scope.child(namespace).namespace)
    return namespace


def _require_no_circle(name: str, tag: LaunchTag) -> None:
    around = [tag.launch_file, *(place.launch_file for place in tag.launch_file.chain())]
    if name in (launch_file.name for launch_file in around):
        what = f"{tag.state.files.shown(name)} includes itself"
        remedy = "Remove one of these includes, or give it an if= that ends the circle."
        lesson = Lesson(rule=TOO_MUCH, what=what, remedy=remedy)
        words = "maximum recursion depth exceeded"
        raise LaunchRefused(Kind.OTHER, words, lesson, name="RecursionError")
    if len(around) > MAX_INCLUDE_DEPTH:
        what = f"more than {MAX_INCLUDE_DEPTH} launch files include each other in a chain"
        raise ours(TOO_MUCH, what, "Use fewer.")


def _unused(unused: list[str], name: str, inner: Scope) -> LaunchRefused:
    what = f"the included file declares no argument {' or '.join(map(repr, unused))}"
    remedy = "Remove it, or declare it there: <arg name=... default=.../>."
    if near := near_names(unused[0], inner.declared):
        remedy = f"Did you mean {near[0]!r}?"
    words = f"unused args [{', '.join(unused)}] for include of [{name}]"
    return LaunchRefused(Kind.LOAD, words, Lesson(rule=ARGUMENT, what=what, remedy=remedy))


def _unknown_in_include(tag: LaunchTag, child: LaunchTag) -> None:
    words = f"WARN: unrecognized '{child.name}' tag in <{tag.name}> tag"
    tag.state.warn(words, plain=True)
    what = f"<{child.name}> cannot stand in an <include>: it is ignored"
    child.teach(UNKNOWN, what, "Only <arg> and <env> can.")


def _note_stray_text(tag: LaunchTag) -> None:
    """Tell of text that nobody reads; most often it is a second `>`."""
    text, span = tag.element.text.strip(), tag.element.text_span
    if not text or span is None:
        return
    shown = text.split("\n")[0][:40]
    what = f"the text {shown!r} in <{tag.name}> is read by nobody"
    remedy = "Remove it, or make a comment of it: <!-- ... -->."
    tag.teach(STRAY_TEXT, what, remedy, at=span)


def _unknown_tag(tag: LaunchTag) -> None:
    tag.state.warn(f"unrecognized tag {tag.name}")
    known = [*_HANDLERS, "group"]
    near = near_names(tag.name, known)
    remedy = f"Did you mean <{near[0]}>?" if near else f"There are: {', '.join(known)}."
    what = f"there is no tag <{tag.name}>: it is ignored, with all that is in it"
    tag.teach(UNKNOWN, what, remedy)


_HANDLERS: dict[str, Callable[[LaunchTag, Scope], None]] = {
    "arg": take_argument,
    "env": take_environment,
    "include": _take_include,
    "machine": take_machine,
    "node": take_node,
    "param": take_param,
    "remap": take_remapping,
    "rosparam": take_rosparam,
    "test": take_node,
}
