"""Print how large each package is, and what a robot that is spawned without a view loads.

`python docs/counts.py [REVISION ...]` counts the checkout, and beside it each revision named.
"""

from __future__ import annotations

import ast
import io
import json
import statistics
import subprocess
import sys
import tokenize
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PACKAGES = ("simkit", "grader", "tests")
NOT_CODE = {
    tokenize.COMMENT,
    tokenize.NL,
    tokenize.NEWLINE,
    tokenize.INDENT,
    tokenize.DEDENT,
    tokenize.ENDMARKER,
}
HEAVY = "matplotlib trimesh ipywidgets anywidget meshcat yourdfpy PIL"
HEADLESS = f"""
import json, sys
from simkit import Simulation
sim = Simulation(package_path=["robots"], screen=None)
sim.roslaunch("my_robot_urdf", "spawn_urdf.launch")
sim.run(1.0)
ours = [name for name in sys.modules if name.split(".")[0] == "simkit"]
heavy = [name for name in "{HEAVY}".split() if name in sys.modules]
print(json.dumps([len(ours), sum(".viz" in name for name in ours), heavy]))
"""


@dataclass(frozen=True, slots=True)
class Module:
    """What is counted of one file."""

    lines: int
    code: int
    """Lines with code: no blank ones, no comments, no docstrings."""
    functions: tuple[int, ...]
    """Code lines of each function's body."""
    classes: tuple[str, ...]
    """Names of its public classes."""


def main() -> None:
    """Print a row for each package at each revision, and one for the headless robot."""
    for revision in [*sys.argv[1:], ""]:
        print(revision or "this checkout")
        for package in PACKAGES:
            print(
                "  "
                + row(package, {path: counted(text) for path, text in texts(package, revision)})
            )
    print("a robot spawned without a view: " + headless())


def row(package: str, modules: dict[str, Module]) -> str:
    """One line of the printout."""
    functions = sorted(size for module in modules.values() for size in module.functions)
    lines = sum(module.lines for module in modules.values())
    code = sum(module.code for module in modules.values())
    text = (
        f"{package:7} {len(modules):4} files {lines:6} lines {code:6} of code;"
        f" functions: median {statistics.median(functions):.0f},"
        f" 90 % within {functions[int(len(functions) * 0.9)]}"
    )
    if package != "simkit":
        return text
    front = sum(path.count("/") == 1 for path in modules)
    names = Counter(
        name for path, module in modules.items() if "/ros1/" not in path for name in module.classes
    )
    twice = sum(count > 1 for count in names.values())
    return f"{text}; {front} modules at the front door, {twice} class names defined twice"


def texts(package: str, revision: str) -> Iterator[tuple[str, str]]:
    """Path and text of each Python file of a package, in the checkout or at a revision."""
    listing = ("ls-tree", "-r", "--name-only", revision) if revision else ("ls-files",)
    for path in git(*listing, package).splitlines():
        if path.endswith(".py"):
            yield (
                path,
                git("show", f"{revision}:{path}") if revision else (ROOT / path).read_text("utf-8"),
            )


def git(*arguments: str) -> str:
    """What git prints."""
    command = ["git", *arguments]
    return subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True).stdout


def counted(text: str) -> Module:
    """The counts of a module with this text."""
    tree = ast.parse(text)
    scopes = [
        node
        for node in ast.walk(tree)
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef | ast.AsyncFunctionDef)
    ]
    code = code_lines(text) - {line for scope in scopes for line in docstring_lines(scope)}
    functions = [
        sum(node.body[0].lineno <= line <= (node.end_lineno or 0) for line in code)
        for node in scopes
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
    ]
    classes = [node.name for node in tree.body if isinstance(node, ast.ClassDef)]
    public = tuple(name for name in classes if not name.startswith("_"))
    return Module(len(text.splitlines()), len(code), tuple(functions), public)


def code_lines(text: str) -> set[int]:
    """Numbers of the lines on which a token of code stands."""
    return {
        line
        for token in tokenize.generate_tokens(io.StringIO(text).readline)
        if token.type not in NOT_CODE
        for line in range(token.start[0], token.end[0] + 1)
    }


def docstring_lines(scope: ast.AST) -> range:
    """Numbers of the lines of a docstring."""
    first = next(iter(getattr(scope, "body", [])), None)
    is_text = isinstance(first, ast.Expr) and isinstance(first.value, ast.Constant)
    if not is_text or not isinstance(first.value.value, str):
        return range(0)
    return range(first.lineno, (first.end_lineno or first.lineno) + 1)


def headless() -> str:
    """What a robot that is spawned by a launch file loads, in words; counted with the Python of `.venv`, if there is one."""
    pythons = (ROOT / ".venv/bin/python", ROOT / ".venv/Scripts/python.exe")
    python = next((str(path) for path in pythons if path.exists()), sys.executable)
    done = subprocess.run([python, "-c", HEADLESS], cwd=ROOT, capture_output=True, text=True)
    if done.returncode:
        why = (done.stderr.strip().splitlines() or ["no words"])[-1]
        return f"not counted, for {python} cannot run it ({why}); `make` prepares a .venv that can"
    printed = done.stdout
    modules, views, heavy = json.loads(printed.splitlines()[-1])
    return (
        f"{modules} modules of simkit, {views} of the view, {', '.join(heavy) or 'nothing heavy'}"
    )


if __name__ == "__main__":
    main()
