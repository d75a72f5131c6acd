"""One idea, one home: a public class or function of simkit is defined once."""

from __future__ import annotations

import ast
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.laws import broken_laws

ROOT = Path(__file__).resolve().parents[1]
MIRRORS = ("simkit/ros1/", "simkit/tf/transformations.py")
"""Parts that have the names of ROS, some of which stand twice there."""
SIBLINGS = {
    "main": "what `python -m` runs",
    "run": "what the table of commands calls",
    "add_arguments": "what a command adds to its parser",
    "add_options": "what roscore, roslaunch and rosrun add to the parser of a terminal",
    "own_words": "what is left for roscore, roslaunch and rosrun without a terminal's options",
    "info": "`info` behind rosnode, rosservice and rostopic",
    "find": "`find` behind rosservice and rostopic",
    "type_of": "`type` behind rosservice and rostopic",
}
"""Names of functions that each module of a kind has, and what calls them by that name."""


def definitions(*kinds: type[ast.stmt]) -> Iterator[tuple[str, str]]:
    """Each public definition of these kinds at the top of a module, and where it stands."""
    for path in sorted(ROOT.glob("simkit/**/*.py")):
        where = path.relative_to(ROOT).as_posix()
        if where.startswith(MIRRORS):
            continue
        for node in ast.parse(path.read_bytes()).body:
            if isinstance(node, kinds) and not node.name.startswith("_"):
                yield node.name, f"{where}:{node.lineno}"


@pytest.mark.parametrize("kind", [ast.ClassDef, ast.FunctionDef])
def test_a_public_name_has_one_home(kind: type[ast.stmt]) -> None:
    homes = defaultdict(list)
    for name, place in definitions(kind):
        if name not in SIBLINGS:
            homes[name].append(place)
    broken_laws(
        {name: ", ".join(places) for name, places in homes.items() if len(places) > 1},
        "say in the name what tells the two apart, without the folder, or import the one where the other"
        " stands now; what only its module uses begins with _;"
        " SIBLINGS of this test are functions that a table calls by their name",
    )
