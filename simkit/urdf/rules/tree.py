"""Rules about the tree: joints that name no link, several roots, links with two parents, loops."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.diagnostics import Find, Part, Severity, rule
from simkit.urdf.rules.entries import JointEntry, LinkEntry
from simkit.urdf.rules.sheet import MOST_FINDS, Sheet
from simkit.urdf.rules.tree_facts import (
    Loop,
    Wanted,
    loops,
    names_for_spare_links,
    two_parents,
    wanted_links,
)
from simkit.urdf.rules.wording import REFUSED, called, listed, meant, quoted, shown
from simkit.xml import Element


@rule("URDF-E02", "a joint names a link that does not exist", Severity.ERROR)
def unknown_link(sheet: Sheet) -> Iterator[Find]:
    """A joint names a link that does not exist.

    ROS says `parent link [bas_link] of joint [hip] not found` and refuses the robot. Most often the name is misspelt, or the
    link was renamed and the joint was not. Names must agree letter by letter, capitals too.

    Wrong, if the link is called `base_link`:

        <parent link="bas_link"/>

    Right:

        <parent link="base_link"/>
    """
    explained = names_for_spare_links(sheet)
    by_name: dict[str, list[Wanted]] = {}
    for wanted in wanted_links(sheet):
        by_name.setdefault(wanted.name, []).append(wanted)
    for name, uses in by_name.items():
        if name not in explained:
            yield _unknown(sheet, name, uses)


def _unknown(sheet: Sheet, name: str, uses: list[Wanted]) -> Find:
    first = uses[0]
    near = sheet.near(name, sheet.link_by_name)
    more = len(uses) - 1
    others = (
        f", and {more} more {'joint asks' if more == 1 else 'joints ask'} for it" if more else ""
    )
    related = [
        (Part(sheet.link_by_name[one].element, "name"), f"link {quoted(one)} is here")
        for one in near[:1]
    ]
    related += [(use.at, f"{called(use.joint.element)} asks for it, too") for use in uses[1:4]]
    what = f"{called(first.joint.element)} has the {first.role} link {quoted(name)}, which does not exist"
    return Find(
        first.at,
        what=what + others,
        remedy=_known_link(sheet, name, near, len(uses)),
        loss=REFUSED,
        related=related,
    )


def _known_link(sheet: Sheet, name: str, near: list[str], uses: int) -> str:
    """Which link may be meant, or how it would be called right."""
    if near and uses > 1 and not {near[0]} & {*sheet.joints_above, *sheet.joints_below}:
        line = sheet.link_by_name[near[0]].element.span.line
        return f'{meant(near[:1])}No joint names that link: call it name="{shown(name)}" in line {line}.'
    if near:
        return f'{meant(near)}Write link="{near[0]}".'
    if name in sheet.joint_by_name:
        child = sheet.joint_by_name[name].child
        return f"{quoted(name)} is a joint; a joint hangs on links. Its own child is link {quoted(child)}."
    known = f", or name one of these: {listed(sheet.link_by_name)}" if sheet.links else ""
    return f"Add the link{known}."


@rule("URDF-E03", "several links hang on nothing", Severity.ERROR)
def several_roots(sheet: Sheet) -> Iterator[Find]:
    """More than one link hangs on nothing.

    ROS says `Two root links found` and refuses the robot. A robot is a tree: one link, the root, hangs on nothing; each other
    one is the child of exactly one joint. Here a joint is missing, or one has the wrong child.

    Wrong, if nothing else names `torso`:

        <link name="base_link"/>
        <link name="torso"/>

    Right:

        <link name="base_link"/>
        <link name="torso"/>
        <joint name="hip" type="fixed">
          <parent link="base_link"/>
          <child link="torso"/>
        </joint>
    """
    roots = _unexplained_roots(sheet)
    if len(roots) < 2:
        return
    sizes = {id(root): len(_below(sheet, root)) for root in roots}
    main = max(roots, key=lambda root: sizes[id(root)])
    others = [root for root in roots if root is not main]
    trees = "; ".join(f"{quoted(root.name)} carries {_carried(sheet, root)}" for root in roots[:4])
    ends = f'<parent link="{main.name}"/><child link="{others[0].name}"/>'
    joint = f'<joint name="{others[0].name}_joint" type="fixed">{ends}</joint>'
    yield Find(
        Part(others[0].element, "name"),
        what=f"{len(roots)} links hang on nothing: {listed(str(root.name) for root in roots)}; a robot has one root ({trees})",
        remedy=f"Join them, e.g. {joint}, or give a joint that has the wrong child the right one.",
        loss=REFUSED,
        related=[
            (Part(root.element, "name"), f"root {quoted(root.name)}")
            for root in (main, *others[1:4])
        ],
    )


def _unexplained_roots(sheet: Sheet) -> list[LinkEntry]:
    """Roots, without those that another find already explains: a joint with a wrong child, or with none, leaves its own alone."""
    roots = [root for root in sheet.link_by_name.values() if sheet.is_root(root)]
    asked = [wanted.name for wanted in wanted_links(sheet) if wanted.role == "child"]
    asked += ["" for joint in sheet.joints if joint.child is None]
    asked += ["" for _ in two_parents(sheet)]
    for name in asked[:MOST_FINDS]:
        names = [str(root.name) for root in roots]
        if len(roots) > 1:
            near = sheet.near(name, names) if name else []
            roots.pop(names.index(near[0]) if near else len(roots) - 1)
    return roots[: max(1, len(roots) - len(asked[MOST_FINDS:]))]


def _below(sheet: Sheet, root: LinkEntry) -> list[str]:
    """Names of the links below a link; each once, also in a loop."""
    found: dict[str, None] = {}
    waiting = [str(root.name)]
    while waiting:
        for joint in sheet.joints_below.get(waiting.pop(), ()):
            if joint.child is not None and joint.child not in found:
                found[joint.child] = None
                waiting.append(joint.child)
    return list(found)


def _carried(sheet: Sheet, root: LinkEntry) -> str:
    return listed(_below(sheet, root), 4) or "nothing"


@rule("URDF-E04", "a loop, or a link with two parents", Severity.ERROR)
def no_tree(sheet: Sheet) -> Iterator[Find]:
    """A link with two parents, or a loop of joints.

    In a robot each link hangs on one joint, and following the parents ends at the root. A loop has no end: ROS finds no root,
    or loses the links of the loop without a word. A link with two parents would be at two places. Most often a joint was
    copied and its child not changed, or parent and child were swapped. Real machines with loops are cut open at one joint.

    Wrong:

        <joint name="a" type="fixed"><parent link="base"/><child link="arm"/></joint>
        <joint name="b" type="fixed"><parent link="arm"/><child link="base"/></joint>

    Right:

        <joint name="a" type="fixed"><parent link="base"/><child link="arm"/></joint>
        <joint name="b" type="fixed"><parent link="arm"/><child link="hand"/></joint>
    """
    roots = [root for root in sheet.link_by_name.values() if sheet.is_root(root)]
    free = [str(root.name) for root in roots if root.name not in sheet.joints_below]
    for loop in loops(sheet):
        yield _loop(loop, free, has_root=bool(roots))
    for joint, before in two_parents(sheet):
        yield _second_parent(joint, before, free, is_tree=len(roots) == 1)


def _loop(loop: Loop, free: list[str], *, has_root: bool) -> Find:
    joint = loop.joints[-1]
    around = " -> ".join(quoted(name) for name in (*loop.links[:8], loop.links[0]))
    what = f"{called(joint.element)} closes a loop: {around}"
    if len(loop.joints) == 1:
        what = f"{called(joint.element)} hangs link {quoted(joint.child)} on itself"
    gazebo = "ROS finds no root and refuses the file."
    if loop.is_entered:
        gazebo = "ROS follows the loop for ever: its check_urdf never ends."
    elif has_root:
        gazebo = "ROS accepts the file, and loses the links of the loop without a word."
    other = _other_child(joint, free)
    return Find(
        _at(joint),
        what=what,
        remedy=other or f"Take {called(joint.element)} out, or give it another child.",
        here="simkit refuses the file.",
        gazebo=gazebo,
        related=[
            (
                one.element,
                f"{called(one.element)}: {quoted(one.parent)} -> {quoted(one.child)}",
            )
            for one in loop.joints[:6]
            if one is not joint
        ],
    )


def _second_parent(
    joint: JointEntry, before: JointEntry, free: list[str], *, is_tree: bool
) -> Find:
    gazebo = "ROS accepts the file and shows the link twice; in TF its frame gets two parents, and jumps."
    name, first, second = quoted(joint.child), called(before.element), called(joint.element)
    return Find(
        _at(joint),
        what=f"link {name} has two parents: {quoted(before.parent)} by {first}, {quoted(joint.parent)} by {second}",
        remedy=_other_child(joint, free)
        or f"Take {first} or {second} out, or give it another child.",
        here="simkit shows it twice, too." if is_tree else REFUSED.here,
        gazebo=gazebo if is_tree else REFUSED.gazebo,
        related=[(_at(before), "its first parent is given here")],
    )


def _other_child(joint: JointEntry, free: list[str]) -> str:
    """The advice to take another child: a link that hangs on nothing and carries nothing, if there is just one."""
    others = [name for name in free if name != joint.parent]
    if len(others) != 1:
        return ""
    return f'Link {quoted(others[0])} hangs on nothing: did you mean <child link="{others[0]}"/>?'


def _at(joint: JointEntry) -> Part | Element:
    """Where a joint names its child."""
    return joint.element if joint.child_element is None else Part(joint.child_element, "link")
