"""The tree that urdfdom makes of links and joints, or the reason why it makes none."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from simkit.urdf.model import Joint


class NoTreeError(Exception):
    """Links and joints make no tree; holds urdfdom's words."""


def find_root(links: Collection[str], joints: Mapping[str, Joint]) -> str:
    """The link that hangs on nothing. Joints and links are looked at by name, as urdfdom does.

    Raises:
        NoTreeError: There is none, or more than one, or a joint misses a link.
    """
    for name in sorted(joints):
        _check_ends(joints[name], links)
    children = {joint.child for joint in joints.values()}
    roots = sorted(set(links) - children)
    if len(roots) > 1:
        raise NoTreeError(
            f"Failed to find root link: Two root links found: [{roots[0]}] and [{roots[1]}]"
        )
    if not roots:
        raise NoTreeError(
            "Failed to find root link: No root link found. The robot xml is not a valid tree."
        )
    return roots[0]


def children_by_link(joints: Mapping[str, Joint]) -> dict[str, list[Joint]]:
    """The joints below each link that has some, by the name of the joint."""
    below: dict[str, list[Joint]] = {}
    for name in sorted(joints):
        below.setdefault(joints[name].parent, []).append(joints[name])
    return below


def loop_below(root: str, joints: Mapping[str, Joint]) -> list[str]:
    """Links below the root that hang on each other in a circle, first and last the same; mostly none.

    urdfdom does not look for them: check_urdf then prints for ever, and so does whoever walks its tree.
    """
    below = children_by_link(joints)
    way, waiting = [root], [iter(below.get(root, ()))]
    is_on_way = {root: True}  # False: everything below it has been seen
    while waiting:
        joint = next(waiting[-1], None)
        if joint is None:
            is_on_way[way.pop()] = False
            waiting.pop()
        elif is_on_way.get(joint.child):
            return [*way[way.index(joint.child) :], joint.child]
        elif joint.child not in is_on_way:
            is_on_way[joint.child] = True
            way.append(joint.child)
            waiting.append(iter(below.get(joint.child, ())))
    return []


def _check_ends(joint: Joint, links: Collection[str]) -> None:
    if not joint.parent or not joint.child:
        raise NoTreeError(
            f"Failed to build tree: Joint [{joint.name}] is missing a parent and/or child link "
            "specification."
        )
    if joint.child not in links:
        raise NoTreeError(
            f"Failed to build tree: child link [{joint.child}] of joint [{joint.name}] not found"
        )
    if joint.parent not in links:
        raise NoTreeError(
            f"Failed to build tree: parent link [{joint.parent}] of joint [{joint.name}] not "
            "found.  This is not valid according to the URDF spec. Every link you refer to from a "
            "joint needs to be explicitly defined in the robot description. To fix this problem "
            f"you can either remove this joint [{joint.name}] from your urdf file, or add "
            f'"<link name="{joint.parent}" />" to your urdf file.'
        )
