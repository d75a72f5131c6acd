"""Fixed joints: which links of a robot are one body in Gazebo.

A link that hangs on its parent by a fixed joint is merged into it: its mass, shapes and sensors move, and the link is gone.
A fixed joint is kept where its parent is the root link `world`, which is the ground, and where a `<gazebo>` of the joint asks
for it.

Source: sdformat's fixed joint reduction.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping

WORLD = "world"
"""A root link of this name is no body but the ground: what hangs on it hangs on the world."""
KEEP_TAGS = ("preserveFixedJoint", "disableFixedJointLumping")
"""Tags in the `<gazebo>` of a joint that keep Gazebo from merging its links, if they are true."""
TRUE = ("true", "yes", "1")
"""What sdformat takes for true, in small letters."""


def merged_links(
    fixed: Iterable[tuple[str | None, str, str]], *, kept: Collection[str | None], has_ground: bool
) -> dict[str, str]:
    """For each link that is merged into its parent: the parent.

    Args:
        fixed: The fixed joints: name, parent and child.
        kept: Names of joints whose `<gazebo>` keeps them.
        has_ground: Whether the root link is `world`.
    """
    return {
        child: parent
        for name, parent, child in fixed
        if name not in kept and not (has_ground and parent == WORLD)
    }


def leaders(links: Iterable[str], merged: Mapping[str, str]) -> dict[str, str]:
    """For each link the one that the body it belongs to is named after: the nearest to the root; of a loop the first one.

    Args:
        links: All links.
        merged: What `merged_links` says of them.
    """
    found: dict[str, str] = {}
    for link in links:
        way: dict[str, None] = {}
        here = link
        while here not in found and here in merged and here not in way:
            way[here] = None
            here = merged[here]
        leader = found.setdefault(here, here)
        found.update((name, leader) for name in way)
    return found
