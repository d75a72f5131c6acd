"""There is one geometry: `simkit.geometry` alone knows how rotations and rigid transforms multiply."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

from tests.laws import broken_laws

ROOT = Path(__file__).resolve().parents[1]
HOME = "simkit/geometry.py"

# Files that may write a product of quaternions out, and why.
WRITTEN_OUT = {
    "simkit/tf/cache.py": "a lookup spends its time there: one product without a call",
}
# ROS's own names, under which students find them.
OF_ROS = ("simkit/ros1/", "simkit/tf/transformations")


def trees() -> Iterator[tuple[str, ast.Module]]:
    for path in sorted((ROOT / "simkit").rglob("*.py")):
        name = path.relative_to(ROOT).as_posix()
        if name != HOME and not name.startswith(OF_ROS):
            yield name, ast.parse(path.read_bytes())


def terms(node: ast.expr) -> list[ast.expr]:
    """What a sum or difference adds up."""
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub):
        return [*terms(node.left), *terms(node.right)]
    return [node]


def is_product_of_names(node: ast.expr) -> bool:
    return (
        isinstance(node, ast.BinOp)
        and isinstance(node.op, ast.Mult)
        and isinstance(node.left, ast.Name)
        and isinstance(node.right, ast.Name)
    )


def is_quaternion_product(node: ast.AST) -> bool:
    """Whether a tuple has four entries, each a sum of four products of two names."""
    return (
        isinstance(node, ast.Tuple)
        and len(node.elts) == 4
        and all(
            len(terms(entry)) == 4 and all(map(is_product_of_names, terms(entry)))
            for entry in node.elts
        )
    )


def fields(node: ast.ClassDef) -> set[str]:
    return {
        one.target.id
        for one in node.body
        if isinstance(one, ast.AnnAssign) and isinstance(one.target, ast.Name)
    }


def test_products_of_quaternions_are_computed_in_one_place():
    found = [
        f"{name}:{node.lineno}"
        for name, tree in trees()
        for node in ast.walk(tree)
        if is_quaternion_product(node) and name not in WRITTEN_OUT
    ]
    broken_laws(
        found,
        "use `multiply` or `Transform.__matmul__` of simkit.geometry; exceptions: WRITTEN_OUT",
    )


def test_there_is_one_type_of_a_rigid_transform():
    found = [
        f"{name}:{node.lineno} {node.name}"
        for name, tree in trees()
        for node in ast.walk(tree)
        if isinstance(node, ast.ClassDef)
        and (
            fields(node) in ({"translation", "rotation"}, {"rotation", "origin"})
            or any(
                isinstance(one, ast.FunctionDef) and one.name == "__matmul__" for one in node.body
            )
        )
    ]
    broken_laws(found, "use `Transform` of simkit.geometry, and convert at the edge")


def test_vector_and_quaternion_are_defined_once():
    names = {"Vector", "Quaternion", "Transform"}
    found = [
        f"{name}:{node.lineno}"
        for name, tree in trees()
        for node in tree.body
        if (isinstance(node, ast.ClassDef) and node.name in names)
        or (
            isinstance(node, ast.AnnAssign)
            and isinstance(node.target, ast.Name)
            and node.target.id in names
        )
    ]
    broken_laws(found, "import the name from simkit.geometry")
