"""What a package promises in `__all__` is there, in order, and explained.

Run as a program with names of modules, it prints their facts as JSON: so the modules of node processes
are looked at in a process of their own.
"""

from __future__ import annotations

import ast
import functools
import importlib
import inspect
import json
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

if __name__ != "__main__":  # as a program it tests nothing
    from tests.laws import broken_laws

ROOT = Path(__file__).resolve().parents[1]
LONGEST_FIRST_LINE = 100
NODE_MODULES = "simkit.ros1."


def promising_modules() -> list[str]:
    """Modules that assign `__all__`, by reading them."""
    found = []
    for path in sorted([*ROOT.glob("simkit/**/*.py"), *ROOT.glob("grader/**/*.py")]):
        tree = ast.parse(path.read_bytes())
        targets = [t for node in tree.body if isinstance(node, ast.Assign) for t in node.targets]
        if any(isinstance(target, ast.Name) and target.id == "__all__" for target in targets):
            parts = path.relative_to(ROOT).with_suffix("").parts
            found.append(".".join(parts).removesuffix(".__init__"))
    return found


def facts(name: str) -> dict[str, Any]:
    """What a module promises, what of it is missing, and first lines of docstrings by name."""
    module = importlib.import_module(name)
    return {
        "promised": list(module.__all__),
        "missing": [name for name in module.__all__ if not hasattr(module, name)],
        "first lines": {
            name: (value.__doc__ or "").strip().split("\n")[0] for name, value in explained(module)
        },
    }


def explained(module: ModuleType) -> Iterator[tuple[str, object]]:
    """The classes, functions and submodules of `__all__`, and the public methods of our classes."""
    for name in module.__all__:
        value = getattr(module, name, None)
        if inspect.isclass(value) or inspect.isroutine(value) or inspect.ismodule(value):
            yield name, value
        if inspect.isclass(value) and value.__module__.split(".")[0] in ("simkit", "grader"):
            for method, function in vars(value).items():
                if inspect.isfunction(function) and not method.startswith("_"):
                    yield f"{name}.{method}", function


def facts_of(name: str) -> dict[str, Any]:
    return node_facts()[name] if name.startswith(NODE_MODULES) else facts(name)


@functools.cache
def node_facts() -> dict[str, dict[str, Any]]:
    """The facts of all modules of node processes, by name."""
    names = [name for name in promising_modules() if name.startswith(NODE_MODULES)]
    command = [sys.executable, __file__, *(name.removeprefix(NODE_MODULES) for name in names)]
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    return dict(zip(names, json.loads(done.stdout), strict=True))


def place_in_all(name: str) -> tuple[int, list[str | int]]:
    """How ruff sorts: CONSTANTS, then Classes, then functions; 2 before 10."""
    kind = 0 if name.isupper() and len(name) > 1 else 1 if name[:1].isupper() else 2
    return kind, [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", name)]


@pytest.mark.parametrize("name", promising_modules())
def test_each_name_is_there_once_and_in_order(name: str) -> None:
    found = facts_of(name)
    broken_laws(found["missing"], f"`__all__` of {name} names it, but it is not there")
    assert found["promised"] == sorted(set(found["promised"]), key=place_in_all)


@pytest.mark.parametrize("name", promising_modules())
def test_each_name_is_explained_in_a_short_first_line(name: str) -> None:
    lines = facts_of(name)["first lines"]
    wrong = {name: line for name, line in lines.items() if not 0 < len(line) <= LONGEST_FIRST_LINE}
    broken_laws(
        wrong,
        f"a name in `__all__` has a docstring whose first line is 1 to {LONGEST_FIRST_LINE} long",
    )


def test_the_packages_promise_something() -> None:
    expected = {"simkit", "simkit.msgs", "simkit.tf", "simkit.graph", "simkit.graph.process"}
    assert expected | {"grader", "grader.checks", "grader.run"} <= set(promising_modules())


if __name__ == "__main__":
    from simkit.graph.process import client
    from simkit.graph.process.child import make_modules_importable

    make_modules_importable()
    with client.preloading():
        print(json.dumps([facts(name) for name in sys.argv[1:]]))
