"""Which messages, services and actions there are, and the text of each.

The folder `definitions` is laid out as ROS packages are: `<package>/msg/<Name>.msg`,
`<package>/srv/<Name>.srv`, `<package>/action/<Name>.action`.
"""

from __future__ import annotations

from functools import cache
from pathlib import Path

from simkit.errors import UnknownNameError

DEFINITIONS = Path(__file__).with_name("definitions")

# Source: actionlib_msgs' genaction: the seven messages of an action, in terms of its three parts.
_ACTION_MESSAGES = {
    "Goal": "{goal}",
    "Result": "{result}",
    "Feedback": "{feedback}",
    "ActionGoal": "Header header\nactionlib_msgs/GoalID goal_id\n{name}Goal goal\n",
    "ActionResult": "Header header\nactionlib_msgs/GoalStatus status\n{name}Result result\n",
    "ActionFeedback": "Header header\nactionlib_msgs/GoalStatus status\n{name}Feedback feedback\n",
    "Action": "{name}ActionGoal action_goal\n{name}ActionResult action_result\n"
    "{name}ActionFeedback action_feedback\n",
}


def packages() -> list[str]:
    """Names of the packages that define messages or services."""
    return sorted({name.split("/")[0] for name in (*_messages(), *_services())})


def message_types() -> list[str]:
    """Names of all message types, `geometry_msgs/Twist`, those of actions included."""
    return sorted(_messages())


def service_types() -> list[str]:
    """Names of all service types, `turtlesim/Spawn`."""
    return sorted(_services())


def message_definition_text(message_type: str) -> str:
    """Text of the .msg file, or of the message that an action implies.

    Raises:
        UnknownNameError: There is no such message type.
    """
    known = _messages()
    if message_type not in known:
        raise UnknownNameError("message type", message_type, known)
    path, template = known[message_type]
    text = path.read_text("utf-8")
    if not template:
        return text
    goal, result, feedback = _parts(text, 3)
    return template.format(name=path.stem, goal=goal, result=result, feedback=feedback)


def service_definition_texts(service_type: str) -> tuple[str, str]:
    """Texts of the request and of the response.

    Raises:
        UnknownNameError: There is no such service type.
    """
    known = _services()
    if service_type not in known:
        raise UnknownNameError("service type", service_type, known)
    request, response = _parts(known[service_type].read_text("utf-8"), 2)
    return request, response


def _parts(text: str, count: int) -> list[str]:
    """The parts of a text between lines of three dashes, `count` of them."""
    parts = [""]
    for line in text.splitlines(keepends=True):
        if line.strip() == "---":
            parts.append("")
        else:
            parts[-1] += line
    return parts + [""] * (count - len(parts))


@cache
def _messages() -> dict[str, tuple[Path, str]]:
    """Message type -> file, and the template if the file is an action."""
    known = {name: (path, "") for name, path in _files("msg").items()}
    for name, path in _files("action").items():
        for suffix, template in _ACTION_MESSAGES.items():
            known[name + suffix] = (path, template)
    return known


@cache
def _services() -> dict[str, Path]:
    return _files("srv")


def _files(kind: str) -> dict[str, Path]:
    """`package/Name` -> file, of all files `<package>/<kind>/<Name>.<kind>`."""
    return {
        f"{folder.parent.name}/{file.stem}": file
        for folder in sorted(DEFINITIONS.glob(f"*/{kind}"))
        for file in sorted(folder.iterdir())
    }
