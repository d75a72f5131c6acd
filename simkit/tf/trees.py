"""The shape of what a buffer holds: separate trees, loops, and what may join them."""

from __future__ import annotations

import difflib
import re

from simkit.tf.buffer_core import BufferCore

_ALIKE = 0.8
"Least similarity of two spellings of one name."

_SHOWN = 8
"So many members of a tree are named."

_COMPARED = 200
"So many names are searched for a slip: whoever broadcasts thousands must not slow a lookup."


def trees(core: BufferCore) -> dict[str, list[str]]:
    """Members of each tree by the tree's root, root first; a loop has no root and is left out."""
    members: dict[str, list[str]] = {}
    for frame, root in _roots(core).items():
        if root is not None:
            group = members.setdefault(root, [root])
            if frame != root:
                group.append(frame)
    return members


def find_loop(core: BufferCore) -> list[str]:
    """Frames of a loop, each followed by its parent; empty if there is none."""
    start = next((frame for frame, root in _roots(core).items() if root is None), None)
    passed: dict[str, None] = {}
    while start is not None and start not in passed:
        passed[start] = None
        start = core.parent_of(start)
    way = list(passed)
    return way[way.index(start) :] if start is not None else []


def two_trees_hint(core: BufferCore, target: str, source: str) -> str:
    """Names the two trees that frames lie in, and the transform that may be missing."""
    roots, all_trees = _roots(core), trees(core)
    a, b = (all_trees.get(roots.get(frame) or "", []) for frame in (target, source))
    if not a or not b:
        return ""
    return f"There are two trees: {_named(a)}, and {_named(b)}. {_remedy(a, b)}"


def _roots(core: BufferCore) -> dict[str, str | None]:
    """Root of each frame; None for one whose way up never ends."""
    roots: dict[str, str | None] = {}
    for start in core.frame_strings:
        way: dict[str, None] = {}
        frame, parent = start, core.parent_of(start)
        while frame not in roots and frame not in way and parent is not None:
            way[frame] = None
            frame, parent = parent, core.parent_of(parent)
        end = roots.get(frame, None if frame in way else frame)
        roots[frame] = end
        roots.update(dict.fromkeys(way, end))
    return {frame: roots[frame] for frame in core.frame_strings}


def _named(tree: list[str]) -> str:
    root, *rest = tree
    shown = ", ".join(sorted(rest)[:_SHOWN])
    more = f" and {len(rest) - _SHOWN} more" if len(rest) > _SHOWN else ""
    return f'"{root}" with {shown}{more}' if rest else f'"{root}" alone'


def _remedy(a: list[str], b: list[str]) -> str:
    for tree, other in ((a, b), (b, a)):
        for name in other[:_COMPARED]:
            if _spelled_alike(tree[0], name):
                return f'The parent "{tree[0]}" may be a misspelt "{name}".'
    parent, child = (a[0], b[0]) if len(a) >= len(b) else (b[0], a[0])
    return f'No transform joins them; a broadcast with parent "{parent}" and child "{child}" would.'


def _spelled_alike(one: str, other: str) -> bool:
    """Whether two names differ by a slip, and not by their number."""
    if re.findall(r"\d+", one) != re.findall(r"\d+", other):
        return False
    folded = difflib.SequenceMatcher(None, one.lower(), other.lower())
    return folded.ratio() >= _ALIKE
