"""One idea, one home: a public class of simkit is defined once."""

from __future__ import annotations

import ast
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

from tests.laws import broken_laws

ROOT = Path(__file__).resolve().parents[1]


def public_classes() -> Iterator[tuple[str, str]]:
    """Each public class at the top of a module, and where it stands."""
    for path in sorted(ROOT.glob("simkit/**/*.py")):
        if "ros1" in path.parts:  # mirrors ROS, which has some names twice
            continue
        for node in ast.parse(path.read_bytes()).body:
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                yield node.name, f"{path.relative_to(ROOT).as_posix()}:{node.lineno}"


def test_a_public_class_has_one_home() -> None:
    homes = defaultdict(list)
    for name, place in public_classes():
        homes[name].append(place)
    broken_laws(
        {name: ", ".join(places) for name, places in homes.items() if len(places) > 1},
        "say in the name what tells the two apart, without the folder, or import the one class where the"
        " other stands now",
    )
