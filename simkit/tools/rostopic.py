"""`rostopic`: what topics there are, what is said on them, and saying something oneself.

The functions give what the tool of ROS prints, as text. `echo`, `hz` and `pub` let virtual time
pass; `TopicEcho`, `TopicHz` and `TopicPub` do the same in a simulation that runs by itself.

Source: rostopic of ROS Noetic, outputs and texts.
"""

from __future__ import annotations

from collections.abc import Callable

from simkit.graph import Graph, Node
from simkit.graph.names import free_name
from simkit.tools.errors import ToolError
from simkit.tools.topic_echo import EchoForm, TopicEcho
from simkit.tools.topic_hz import LONGEST_WINDOW, TopicHz
from simkit.tools.topic_pub import ONCE_SECONDS, announcement, publish, value_of
from simkit.tools.topic_search import TopicWatcher, find_topic, similar_topic
from simkit.tools.world import (
    Bounds,
    World,
    Write,
    address,
    is_below,
    publishers,
    resolved,
    subscribers,
    to_stdout,
    topic_types,
)


def list_topics(
    graph: Graph,
    namespace: str = "/",
    *,
    verbose: bool = False,
    publishers_only: bool = False,
    subscribers_only: bool = False,
) -> str:
    """What `rostopic list` prints: names, or with `verbose` types and numbers too.

    Args:
        graph: The graph.
        namespace: Only topics in it.
        verbose: As `-v`.
        publishers_only: As `-p`.
        subscribers_only: As `-s`.
    """
    within = resolved(namespace)
    published, subscribed = (
        {name: nodes for name, nodes in table(graph).items() if is_below(name, within)}
        for table in (publishers, subscribers)
    )
    if not verbose:
        names = set(() if subscribers_only else published) | set(
            () if publishers_only else subscribed
        )
        return "\n".join(sorted(names)) + "\n"
    types, text = topic_types(graph), ""
    if not subscribers_only:
        text += f"\nPublished topics:\n{_counted(published, types, 'publisher')}"
    if not publishers_only:
        text += f"\nSubscribed topics:\n{_counted(subscribed, types, 'subscriber')}"
    return text + "\n"


def info(graph: Graph, topic: str) -> str:
    """What `rostopic info` prints: type, publishers, subscribers.

    Raises:
        ToolError: No node uses the topic.
    """
    name = resolved(topic)
    types = topic_types(graph)
    if name not in types:
        raise ToolError(f"ERROR: Unknown topic {name}{similar_topic(graph, name)}")
    parts = [f"Type: {types[name]}\n"]
    for role, table in (("Publishers", publishers(graph)), ("Subscribers", subscribers(graph))):
        lines = [f" * {node} ({address(node)})\n" for node in table.get(name, ())]
        parts.append(f"{role}: \n{''.join(lines)}" if lines else f"{role}: None\n")
    return "\n".join(parts) + "\n\n"


def type_of(graph: Graph, topic: str) -> str:
    """What `rostopic type` prints: the type of a topic, and of a field if one is named.

    Raises:
        ToolError: No node uses the topic, or its messages have no such field.
    """
    found = find_topic(graph, topic)
    if found is None:
        raise ToolError(
            f"unknown topic type [{resolved(topic)}]{similar_topic(graph, topic)}", exit_code=1
        )
    if not found.field:
        return f"{found.type_name}\n"
    return f"{found.type_name} {found.field} {found.field_type}\n"


def find(graph: Graph, type_name: str) -> str:
    """What `rostopic find` prints: the topics of a type."""
    types = topic_types(graph)
    return "\n".join(name for name, kind in types.items() if kind == type_name) + "\n"


def echo(
    world: World,
    topic: str,
    *,
    write: Write = to_stdout,
    form: EchoForm | None = None,
    bounds: Bounds | None = None,
) -> int:
    """Print messages as they come, as `rostopic echo` does.

    Args:
        world: The simulation, whose time passes meanwhile.
        topic: Topic name, perhaps with a field: `/turtle1/pose/x`.
        write: Takes what is printed, line breaks included.
        form: How many messages, and how they are shown.
        bounds: When to stop if the number is not reached.

    Returns:
        How many messages were printed.

    Raises:
        ToolError: There is no such field, or nothing was said in time.
    """
    bounds = bounds or Bounds()
    node = world.graph.create_node(free_name("/rostopic", world.graph.nodes))
    watcher = TopicEcho(node, topic, write, form=form)
    enough = bounds.messages
    _watch(world, node, watcher, bounds, until=lambda: watcher.printed == enough)
    if watcher.printed == 0:
        raise ToolError(_silence(world.graph, topic, bounds.seconds))
    return watcher.printed


def hz(
    world: World,
    topic: str,
    *,
    write: Write = to_stdout,
    window: int = LONGEST_WINDOW,
    bounds: Bounds | None = None,
) -> None:
    """Print the rate of a topic once a second, as `rostopic hz` does.

    Args:
        world: The simulation, whose time passes meanwhile.
        topic: Topic name.
        write: Takes what is printed, line breaks included.
        window: So many of the latest messages count.
        bounds: When to stop.
    """
    node = world.graph.create_node(free_name("/rostopic", world.graph.nodes))
    watcher = TopicHz(node, topic, write, window=window)
    _watch(world, node, watcher, bounds or Bounds())


def pub(
    world: World,
    topic: str,
    type_name: str,
    *words: str,
    rate: float | None = None,
    once: bool = False,
    latch: bool = False,
    write: Write = to_stdout,
) -> Node:
    """Publish a message, as `rostopic pub` does.

    Args:
        world: The simulation; time passes with `once` only.
        topic: Topic name.
        type_name: `geometry_msgs/Twist`.
        *words: YAML for the whole message, or for each of its fields.
        rate: Repeat so often [Hz].
        once: Stop after 3 s, when all have heard it.
        latch: Give the last message to later subscribers also if `rate` is given.
        write: Takes what is printed, line breaks included.

    Returns:
        The node that publishes; `shutdown()` ends it.

    Raises:
        ToolError: No such type, or a value does not fit.
        UsageError: A word is not YAML.
    """
    values = [value_of(word) for word in words]
    node = publish(world.graph, topic, type_name, values, rate=rate, latch=latch)
    write(announcement(rate=rate, once=once))
    if once:
        world.run_until(lambda: False, ONCE_SECONDS)
        node.shutdown()
    return node


def _watch(
    world: World,
    node: Node,
    watcher: TopicWatcher,
    bounds: Bounds,
    until: Callable[[], bool] = lambda: False,
) -> None:
    """Let time pass until a watcher is done; its node ends with it."""
    try:
        world.run_until(lambda: watcher.done or until(), bounds.seconds)
    finally:
        node.shutdown()
    if watcher.fault is not None:
        raise watcher.fault


def _silence(graph: Graph, topic: str, seconds: float) -> str:
    found = find_topic(graph, topic)
    said = f"nothing was said on {resolved(topic)} within {seconds:g} s"
    if found is None:
        return f"{said}: there is no such topic{similar_topic(graph, topic)}"
    speakers = publishers(graph).get(found.topic, [])
    return f"{said}: {', '.join(speakers) or 'nobody'} publishes it"


def _counted(table: dict[str, list[str]], types: dict[str, str], role: str) -> str:
    return "".join(
        f" * {name} [{types[name]}] {len(nodes)} {role}{'s' if len(nodes) > 1 else ''}\n"
        for name, nodes in table.items()
    )
