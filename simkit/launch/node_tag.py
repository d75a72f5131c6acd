"""`<node>`, and `<test>`, of which only the parameters count."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Literal, cast

from simkit.errors import near_names
from simkit.graph.names import is_legal_name
from simkit.launch.errors import Kind, LaunchRefused
from simkit.launch.parameter_tags import take_param, take_rosparam
from simkit.launch.plan import PlannedNode
from simkit.launch.rules import ATTRIBUTE, NO_EFFECT, UNKNOWN
from simkit.launch.scope import Scope, as_namespace, name_in
from simkit.launch.small_tags import read_remapping, take_environment
from simkit.launch.tag import LaunchTag
from simkit.launch.values import seconds

_ATTRIBUTES = (
    "pkg",
    "type",
    "machine",
    "name",
    "args",
    "output",
    "respawn",
    "respawn_delay",
    "cwd",
    "ns",
    "clear_params",
    "launch-prefix",
    "required",
)
_OF_TESTS = ("test-name", "time-limit", "retry")
_CHILDREN = ("remap", "param", "rosparam", "env")


@dataclass(frozen=True, slots=True, kw_only=True)
class _Where:
    """Names and scopes of one node."""

    name: str
    inner: Scope
    """The node's namespace."""
    own: Scope
    """The namespace of its private parameters."""


def take_node(tag: LaunchTag, scope: Scope) -> None:
    """Add a node with its parameters; of a `<test>` only the parameters.

    Raises:
        LaunchRefused: It makes no sense.
    """
    if not tag.applies(scope):
        return
    is_invalid = "Invalid <node> tag: {text}. \n\nNode xml is {xml}"
    is_missing = f"<{tag.name}> tag is missing required attribute: {{text}}. Node xml is {{xml}}"
    words = {Kind.KEY: is_missing, Kind.SYNTAX: is_invalid, Kind.VALUE: is_invalid}
    with tag.worded(words):
        node = _node(tag, scope)
    if tag.name == "node":
        with tag.about("name"):
            tag.state.add_node(node)


def _node(tag: LaunchTag, scope: Scope) -> PlannedNode:
    is_test = tag.name == "test"
    tag.check_attributes((*_ATTRIBUTES, *_OF_TESTS) if is_test else _ATTRIBUTES)
    name = (tag.get("name", scope) or "") if is_test else tag.required("name", scope)
    if is_test:
        name = name or tag.required("test-name", scope)
    _check_name(tag, name)
    where = _where(tag, scope, name)
    package, type_name = tag.required("pkg", scope), tag.required("type", scope)
    options = {
        key: tag.get(key, scope)
        for key in (
            "machine",
            "args",
            "output",
            "respawn",
            "respawn_delay",
            "cwd",
            "launch-prefix",
            "required",
        )
    }
    _want_machine(tag, options["machine"])
    required = tag.flag("required", options["required"])
    respawn = tag.flag("respawn", options["respawn"])
    with tag.about("respawn_delay"):
        delay = seconds(options["respawn_delay"], "respawn_delay")
    inner = _take_children(tag, scope, where)
    remappings = tuple(inner.remappings())
    tag.state.budget.tag(len(remappings) + len(inner.environment))
    _check_options(tag, name, package, type_name, options, respawn=respawn, required=required)
    return PlannedNode(
        name=name,
        namespace=where.inner.namespace,
        package=package,
        type=type_name,
        args=options["args"] or "",
        remappings=remappings,
        environment=tuple(inner.environment),
        output=cast(Literal["log", "screen"], options["output"] or "log"),
        respawn=respawn,
        respawn_delay=delay if math.isfinite(delay) and delay > 0 else 0.0,
        required=required,
        launch_prefix=options["launch-prefix"] or "",
        file=tag.launch_file.name,
        shown_file=tag.launch_file.document.file,
        span=tag.element.span,
    )


def _check_name(tag: LaunchTag, name: str) -> None:
    if is_legal_name(name) or not name:
        return
    tag.state.warn(
        f"WARN: illegal <node> name '{name}'.\nhttp://ros.org/wiki/Names\nThis will likely cause problems "
        f"with other ROS tools.\nNode xml is {tag.xml}"
    )
    what = f"{name!r} is no name for a node"
    remedy = "Use letters, digits and _ only, a letter first."
    tag.teach(ATTRIBUTE, what, remedy, at="name")


def _where(tag: LaunchTag, scope: Scope, name: str) -> _Where:
    inner = scope.child(tag.namespace(scope))
    if tag.flag("clear_params", tag.get("clear_params", scope) or None):
        if not name:
            words = f"<{tag.name}> tag must have a 'name' attribute to use 'clear_params' attribute"
            raise tag.refuse(words, "clear_params= needs a name", 'Write name="...".')
        tag.state.clear_params.append(as_namespace(name_in(inner.namespace, name)))
    own = inner.child(name)
    own.parameters = []
    return _Where(name=name, inner=inner, own=own)


def _take_children(tag: LaunchTag, scope: Scope, where: _Where) -> Scope:
    """Take what stands in a node; a scope with its remappings and environment."""
    inner = scope.child()
    for child in tag.children():
        tag.state.budget.tag()
        kind = child.name.lower()
        if kind == "remap":
            pair = read_remapping(child, scope)
            if pair is not None:
                inner.add_remapping(*pair)
        elif kind == "param":
            take_param(child, where.own, in_node=True)
        elif kind == "rosparam":
            take_rosparam(child, where.own)
        elif kind == "env":
            take_environment(child, inner)
        else:
            _unknown_child(tag, child)
    for parameter in (*scope.parameters, *where.own.parameters):
        place, source = parameter.source
        name = where.own.namespace + parameter.name.removeprefix("~")
        tag.state.add_param(name, parameter.value, place, source)
    return inner


def _unknown_child(tag: LaunchTag, child: LaunchTag) -> None:
    tag.state.warn(
        f"WARN: unrecognized '{child.name}' child tag in the parent tag element: {tag.xml}"
    )
    near = near_names(child.name, _CHILDREN)
    remedy = f"Did you mean <{near[0]}>?" if near else "A node has param, rosparam, remap and env."
    what = f"<{child.name}> cannot stand in a <{tag.name}>: it is ignored"
    child.teach(UNKNOWN, what, remedy)


def _want_machine(tag: LaunchTag, name: str | None) -> None:
    """Note the machine that a node is meant for: there must be a `<machine>` of its name, before or behind."""
    if name is None:
        return
    if not name.strip():
        words = f"<node> 'machine' must be non-empty: [{name}]"
        raise tag.refuse(words, "machine= is empty", "Remove it.", at="machine")
    tag.state.wanted_machines.append((name, tag.place_of("machine")))


def _check_options(
    tag: LaunchTag,
    name: str,
    package: str,
    type_name: str,
    options: dict[str, Any],
    *,
    respawn: bool,
    required: bool,
) -> None:
    if respawn and required:
        raise _wrong(
            tag, "respawn and required cannot both be set to true", "required", "Keep one of them."
        )
    if "/" in name:
        remedy = 'Put the namespace into ns="...".'
        raise _wrong(tag, "node name cannot contain a namespace", "name", remedy)
    for attribute, value in (("package", package), ("type", type_name)):
        if not value.strip():
            where = "pkg" if attribute == "package" else attribute
            raise _wrong(tag, f"{attribute} must be non-empty", where, "Write a name.")
    if options["output"] not in ("log", "screen", None):
        remedy = 'Write output="screen" to see what the node prints.'
        raise _wrong(tag, "output must be one of 'log', 'screen'", "output", remedy)
    if options["cwd"] not in ("ROS_HOME", "ros_home", "node", "cwd", None):
        words = "cwd must be one of 'ROS_HOME', 'node', 'cwd'"
        raise _wrong(tag, words, "cwd", "Leave it out: a script runs in its own folder.")
    if options["launch-prefix"]:
        what = "launch-prefix= is ignored: no program is run in front of a node here"
        tag.teach(NO_EFFECT, what, "Remove it here.", at="launch-prefix")


def _wrong(tag: LaunchTag, words: str, attribute: str, remedy: str) -> LaunchRefused:
    return tag.refuse(words, words, remedy, at=attribute, kind=Kind.VALUE)
