"""What an exercise gives that is no part of it: the turtles' frames, as a finished exercise 3.1 broadcasts them.

Used by checks and by notebooks, so that a fault of an earlier exercise does not cost a later one.
"""

from __future__ import annotations

import dataclasses
import math
import shlex
from typing import Any

from simkit import Simulation
from simkit.msgs import Duration, Message, Time, message_class
from simkit.tf import TransformBroadcaster


def broadcast_turtle(sim: Simulation, turtle: str = "turtle1") -> None:
    """Start a node that broadcasts a turtle's pose, from "world" to the frame with its name.

    Args:
        sim: The simulation; the turtle may come later.
        turtle: Name of the turtle.
    """
    node = sim.graph.create_node(f"/{turtle}_tf_broadcaster")
    broadcaster = TransformBroadcaster(node)

    def on_pose(pose: Any) -> None:
        place = (pose.x, pose.y, 0.0)
        broadcaster.send_transform(
            _transform("world", turtle, place, yaw=pose.theta, stamp=node.now())
        )

    node.subscribe(f"/{turtle}/pose", message_class("turtlesim/Pose"), on_pose)


def broadcast_frame(
    sim: Simulation,
    child: str,
    parent: str,
    *,
    translation: tuple[float, float, float],
    rate: float = 10.0,
) -> None:
    """Start a node that broadcasts a frame which stands still in its parent.

    Args:
        sim: The simulation.
        child: The frame.
        parent: The frame it stands in.
        translation: Where it stands in its parent [m].
        rate: How often it is sent [Hz].
    """
    node = sim.graph.create_node(f"/{child}_in_{parent}_broadcaster")
    broadcaster = TransformBroadcaster(node)
    node.create_timer(
        Duration(1.0 / rate),
        lambda: broadcaster.send_transform(
            _transform(parent, child, translation, yaw=0.0, stamp=node.now())
        ),
    )


BROADCASTER = "turtle_tf_broadcaster.py"
"""The script of exercise 3.1, which takes the name of its turtle as the parameter `~turtle`."""


def without_broadcasters(plan: Any) -> tuple[Any, list[str]]:
    """The plan of a launch file without the broadcasters of exercise 3.1, and the turtles that they would serve.

    Args:
        plan: What `launch_plan` gives.

    Returns:
        The rest of the plan, to be launched, and the names of the turtles, sorted.
    """
    ours = [node for node in plan.nodes if node.type == BROADCASTER]
    names = tuple(f"{node.resolved_name}/" for node in ours)
    rest = dataclasses.replace(
        plan,
        nodes=tuple(node for node in plan.nodes if node not in ours),
        params={name: value for name, value in plan.params.items() if not name.startswith(names)},
    )
    return rest, sorted(_turtle_of(node, plan) for node in ours)


def _turtle_of(node: Any, plan: Any) -> str:
    turtle = str(plan.params.get(f"{node.resolved_name}/turtle", "turtle1"))
    try:
        words = shlex.split(node.args)
    except ValueError:
        words = []
    for word in words:
        name, _, value = word.partition(":=")
        turtle = value if name == "_turtle" else turtle
    return turtle


def _transform(
    parent: str, child: str, place: tuple[float, float, float], *, yaw: float, stamp: Time
) -> Message:
    transform: Any = message_class("geometry_msgs/TransformStamped")()
    transform.header.stamp, transform.header.frame_id = stamp, parent
    transform.child_frame_id = child
    move, turn = transform.transform.translation, transform.transform.rotation
    move.x, move.y, move.z = place
    turn.z, turn.w = math.sin(yaw / 2), math.cos(yaw / 2)
    assert isinstance(transform, Message)
    return transform
