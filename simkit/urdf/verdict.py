"""What the program check_urdf prints of a file, and how it ends."""

from __future__ import annotations

from simkit.urdf.model import Robot
from simkit.urdf.reading import Reading
from simkit.urdf.urdfdom.tree import children_by_link

REFUSED = 255
"""Exit code of check_urdf for a file that urdfdom refuses."""
LONGEST = 4_000_000
"""So many letters of a tree are printed, at most."""


def check_urdf_text(reading: Reading) -> tuple[str, str, int]:
    """Standard output, standard error and exit code of check_urdf.

    The output is the original's, byte for byte. The lines of the standard error are the original's
    without those that say where in urdfdom's own source it was ("at line N in ...").

    Different are: a text that is no well-formed XML and is refused, of which we say what is wrong and where; a stray `&`,
    which stays; names that are no UTF-8, which are shown with U+FFFD; a circle below the root,
    which is refused, and a tree of more than some million letters, which is cut off, where the
    original prints for very long and may crash; complaints of more than 1023 letters, which it cuts.

    Source:
        check_urdf of urdfdom 3.0. Children come in the order of the names of their joints.
    """
    messages = "".join(f"{line}\n" for line in reading.messages)
    if reading.robot is None:
        return "", f"{messages}ERROR: Model Parsing the xml failed\n", REFUSED
    return _tree(reading.robot), messages, 0


def _tree(robot: Robot) -> str:
    below = children_by_link(robot.joints)
    count = len(below.get(robot.root, ()))
    lines = [
        f"robot name is: {robot.name}",
        "---------- Successfully Parsed XML ---------------",
        f"root Link: {robot.root} has {count} child(ren)",
    ]
    left = LONGEST
    waiting = [(1, enumerate(below.get(robot.root, ()), 1))]
    while waiting and left > 0:
        depth, children = waiting[-1]
        number, joint = next(children, (0, None))
        if joint is None:
            waiting.pop()
            continue
        lines.append(f"{'    ' * depth}child({number}):  {joint.child}")
        left -= len(lines[-1])
        waiting.append((depth + 1, enumerate(below.get(joint.child, ()), 1)))
    if left <= 0:
        lines.append("...")
    return "\n".join(lines) + "\n"
