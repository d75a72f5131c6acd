"""`<arg>`, `<remap>`, `<env>` and `<machine>`."""

from __future__ import annotations

from simkit.launch.errors import Kind
from simkit.launch.plan import ArgumentDoc
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


_OF_ARGUMENTS = {
    **dict.fromkeys(set(Kind) - {Kind.OURS}, "Invalid <arg> tag: {text}. \n\nArg xml is {xml}"),
    Kind.ARGUMENT: "arg '{text}' is not defined. \n\nArg xml is {xml}",
}


def take_argument(tag: LaunchTag, scope: Scope) -> None:
    """`<arg name default|value doc>`: declare an argument.

    Raises:
        LaunchRefused: It makes no sense.
    """
    if not tag.applies(scope):
        return
    with tag.worded(_OF_ARGUMENTS):
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


def read_remapping(tag: LaunchTag, scope: Scope) -> tuple[str, str] | None:
    """`<remap from to>`: the two names; None if it does not apply.

    Raises:
        LaunchRefused: One is missing.
    """
    if not tag.applies(scope):
        return None
    tag.check_attributes(("from", "to"))
    with tag.worded({Kind.KEY: "<remap> tag is missing required from/to attributes: {xml}"}):
        return tag.required("from", scope), tag.required("to", scope)


def take_remapping(tag: LaunchTag, scope: Scope) -> None:
    """`<remap>` for all nodes that follow in its scope.

    Raises:
        LaunchRefused: It makes no sense.
    """
    words = "Invalid <remap> tag: {text}.\nXML is {xml}"
    with tag.worded({Kind.SYNTAX: words, Kind.LOAD: words}):
        pair = read_remapping(tag, scope)
        if pair is not None:
            scope.add_remapping(*pair)


def take_environment(tag: LaunchTag, scope: Scope) -> None:
    """`<env name value>`: an environment variable for nodes.

    Raises:
        LaunchRefused: It makes no sense.
    """
    if not tag.applies(scope):
        return
    tag.check_attributes(("name", "value"))
    with tag.worded({Kind.KEY: "<env> tag is missing required name/value attributes: {xml}"}):
        name, value = tag.required("name", scope), tag.required("value", scope)
    if not name:
        words = f"Invalid <env> tag: 'name' attribute must be non-empty. \nXML is {tag.xml}"
        raise tag.refuse(words, "name= is empty", "Write the variable's name.", at="name")
    scope.environment.append((name, value))
    what = f"the environment variable {name} does not reach nodes here"
    tag.teach(NO_EFFECT, what, "Use a <param>.")


def take_machine(tag: LaunchTag, scope: Scope) -> None:
    """`<machine>`: looked at, and ignored, since all nodes run here.

    Raises:
        LaunchRefused: Its name or address is missing.
    """
    if not tag.applies(scope):
        return
    tag.check_attributes(_MACHINE)
    with tag.worded({Kind.KEY: "<machine> tag is missing required attribute: {text}"}):
        tag.state.machines.append(tag.required("name", scope))
        tag.required("address", scope)
    what = "<machine> is ignored: all nodes run in this simulation"
    tag.teach(NO_EFFECT, what, "Remove it here.")
