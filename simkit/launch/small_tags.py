"""`<arg>`, `<remap>`, `<env>` and `<machine>`."""

from __future__ import annotations

from simkit.launch.plan import ArgumentDoc
from simkit.launch.refusal import Kind, LaunchRefused, Lesson
from simkit.launch.rules import NO_EFFECT
from simkit.launch.scope import Scope
from simkit.launch.tag import LaunchTag

_MACHINE = (
    "name",
    "address",
    "env-loader",
    "ssh-port",
    "user",
    "password",
    "default",
    "timeout",
)


def take_argument(tag: LaunchTag, scope: Scope) -> None:
    """`<arg name default|value doc>`: declare an argument.

    Raises:
        LaunchRefused: It makes no sense.
    """
    if not tag.applies(scope):
        return
    try:
        tag.check_attributes(("name", "value", "default", "doc"))
        name = tag.required("name", scope)
        value, default, doc = (tag.get(key, scope) for key in ("value", "default", "doc"))
        if value is not None and default is not None:
            raise tag.refuse(
                "<arg> tag must have one and only one of value/default.",
                f"the argument {name!r} has value= and default=",
                "Keep value= if nobody may change it, default= if somebody may.",
                at="default",
            )
        scope.declare(name, value=value, default=default)
        if scope.parent is None and value is None:
            tag.state.arguments.append(ArgumentDoc(name=name, default=default, doc=doc))
    except LaunchRefused as refused:
        refused.at(tag.place)
        if refused.kind is Kind.OURS:
            raise
        words = f"Invalid <arg> tag: {refused.text}. \n\nArg xml is {tag.xml}"
        if refused.kind is Kind.ARGUMENT:
            words = f"arg '{refused.text}' is not defined. \n\nArg xml is {tag.xml}"
        raise refused.worded(Kind.SYNTAX, words) from None


def read_remapping(tag: LaunchTag, scope: Scope) -> tuple[str, str] | None:
    """`<remap from to>`: the two names; None if it does not apply.

    Raises:
        LaunchRefused: One is missing.
    """
    if not tag.applies(scope):
        return None
    tag.check_attributes(("from", "to"))
    try:
        return tag.required("from", scope), tag.required("to", scope)
    except LaunchRefused as refused:
        if refused.kind is not Kind.KEY:
            raise
        words = f"<remap> tag is missing required from/to attributes: {tag.xml}"
        raise refused.worded(Kind.SYNTAX, words) from None


def take_remapping(tag: LaunchTag, scope: Scope) -> None:
    """`<remap>` for all nodes that follow in its scope.

    Raises:
        LaunchRefused: It makes no sense.
    """
    try:
        pair = read_remapping(tag, scope)
        if pair is not None:
            scope.add_remapping(*pair)
    except LaunchRefused as refused:
        if refused.kind not in (Kind.SYNTAX, Kind.LOAD):
            raise
        words = f"Invalid <remap> tag: {refused.text}.\nXML is {tag.xml}"
        raise refused.at(tag.place).worded(Kind.SYNTAX, words) from None


def take_environment(tag: LaunchTag, scope: Scope) -> None:
    """`<env name value>`: an environment variable for nodes.

    Raises:
        LaunchRefused: It makes no sense.
    """
    if not tag.applies(scope):
        return
    tag.check_attributes(("name", "value"))
    try:
        name, value = tag.required("name", scope), tag.required("value", scope)
    except LaunchRefused as refused:
        if refused.kind is not Kind.KEY:
            raise
        words = f"<env> tag is missing required name/value attributes: {tag.xml}"
        raise refused.worded(Kind.SYNTAX, words) from None
    if not name:
        words = f"Invalid <env> tag: 'name' attribute must be non-empty. \nXML is {tag.xml}"
        raise tag.refuse(words, "name= is empty", "Write the variable's name.", at="name")
    scope.environment.append((name, value))
    _no_effect(tag, f"the environment variable {name} does not reach nodes here", "Use a <param>.")


def take_machine(tag: LaunchTag, scope: Scope) -> None:
    """`<machine>`: looked at, and ignored, since all nodes run here.

    Raises:
        LaunchRefused: Its name or address is missing.
    """
    if not tag.applies(scope):
        return
    tag.check_attributes(_MACHINE)
    try:
        tag.state.machines.append(tag.required("name", scope))
        tag.required("address", scope)
    except LaunchRefused as refused:
        if refused.kind is not Kind.KEY:
            raise
        words = f"<machine> tag is missing required attribute: {refused.text}"
        raise refused.worded(Kind.SYNTAX, words) from None
    _no_effect(tag, "<machine> is ignored: all nodes run in this simulation", "Remove it here.")


def _no_effect(tag: LaunchTag, what: str, remedy: str) -> None:
    tag.state.teach(Lesson(rule=NO_EFFECT, what=what, remedy=remedy), tag.place)
