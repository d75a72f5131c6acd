"""One tag of a launch file, as its handlers see it."""

from __future__ import annotations

import contextlib
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass

from simkit.errors import near_names
from simkit.launch.errors import Kind, LaunchPlace, LaunchRefused, Lesson
from simkit.launch.launch_file import LaunchFile
from simkit.launch.rules import ATTRIBUTE, UNKNOWN
from simkit.launch.scope import Scope
from simkit.launch.state import LaunchState
from simkit.launch.values import flag, truth
from simkit.xml import Element, Span

_OF_ROS_2 = {"type": ("exec", "executable"), "ns": ("namespace",)}
"""What the launch files of ROS 2 call an attribute."""


@dataclass(frozen=True, slots=True)
class LaunchTag:
    """A tag, its file, and what it adds to."""

    element: Element
    """The element."""
    launch_file: LaunchFile
    """The file it is in."""
    state: LaunchState
    """What has been gathered so far."""

    @property
    def name(self) -> str:
        """Name of the element."""
        return self.element.name

    @property
    def place(self) -> LaunchPlace:
        """Where it stands."""
        return LaunchPlace(launch_file=self.launch_file, span=self.element.span)

    @property
    def xml(self) -> str:
        """The whole element, as roslaunch's messages show it."""
        return self.launch_file.xml_of(self.element)

    def children(self) -> list[LaunchTag]:
        """The tags in it."""
        return [LaunchTag(child, self.launch_file, self.state) for child in self.element.children]

    def has(self, attribute: str) -> bool:
        """Whether an attribute is there."""
        return self.element.attribute(attribute) is not None

    def get(self, attribute: str, scope: Scope) -> str | None:
        """The value of an attribute, `$(...)` replaced; None if it is not there.

        Raises:
            LaunchRefused: It cannot be replaced.
        """
        value = self.element.get(attribute)
        if value is None:
            return None
        with self.about(attribute):
            return self.state.substitution.resolve(value, scope)

    def required(self, attribute: str, scope: Scope) -> str:
        """The value of an attribute that must be there.

        Raises:
            LaunchRefused: It is not there, or cannot be replaced.
        """
        value = self.get(attribute, scope)
        if value is None:
            what = f"<{self.name}> has no attribute {attribute!r}"
            remedy = f'Write {attribute}="..." into it.'
            given = [one.name for one in self.element.attributes]
            other = [one for one in given if one in _OF_ROS_2.get(attribute, ())]
            if near := other or near_names(attribute, given):
                remedy = f"Write {attribute}= where {near[0]}= stands."
            lesson = Lesson(rule=ATTRIBUTE, what=what, remedy=remedy)
            raise LaunchRefused(Kind.KEY, f"'{attribute}'", lesson, place=self.place)
        return value

    def place_of(self, what: str | Span) -> LaunchPlace:
        """Where the value of an attribute stands, or the tag itself if it has none; or a place in its file."""
        span = self.element.span_of(what) if isinstance(what, str) else what
        return LaunchPlace(launch_file=self.launch_file, span=span)

    @contextlib.contextmanager
    def about(self, attribute: str) -> Iterator[None]:
        """A fault in the body without a place of its own is one of this attribute."""
        try:
            yield
        except LaunchRefused as refused:
            raise refused.at(self.place_of(attribute)) from None

    def flag(self, attribute: str, value: str | None) -> bool:
        """Whether an attribute's value says true; false if it is None.

        Raises:
            LaunchRefused: It is neither true nor false.
        """
        with self.about(attribute):
            return flag(value, attribute)

    def applies(self, scope: Scope) -> bool:
        """Whether its `if` or `unless` lets it count.

        Raises:
            LaunchRefused: It has both, or one that is neither true nor false.
        """
        wanted, unwanted = self.get("if", scope), self.get("unless", scope)
        if wanted is not None and unwanted is not None:
            words = "cannot set both 'if' and 'unless' on the same tag"
            lesson = Lesson(rule=ATTRIBUTE, what="if= and unless= on one tag", remedy="Keep one.")
            raise LaunchRefused(Kind.SYNTAX, words, lesson, place=self.place_of("unless"))
        attribute = "if" if wanted is not None else "unless"
        value = wanted if wanted is not None else unwanted
        if value is None:
            return True
        with self.about(attribute):
            return truth(value) is (attribute == "if")

    def check_attributes(self, known: Collection[str]) -> None:
        """Warn of attributes that nobody knows."""
        for attribute in self.element.attributes:
            if attribute.name in known or attribute.name in ("if", "unless"):
                continue
            words = f"[{self.launch_file.name}] unknown <{self.name}> attribute '{attribute.name}'"
            self.state.warn(words)
            near = near_names(attribute.name, known)
            remedy = f"Did you mean {near[0]}?" if near else "It has: " + ", ".join(known) + "."
            what = f"<{self.name}> has no attribute {attribute.name!r}: it is ignored"
            self.teach(UNKNOWN, what, remedy, at=attribute.name_span)

    def teach(self, rule: str, what: str, remedy: str, *, at: str | Span | None = None) -> None:
        """Keep what a teacher says about this tag, which works.

        Args:
            rule: Id of the rule.
            what: What is odd.
            remedy: What would be right.
            at: The attribute that it is about, or a place; None for the tag.
        """
        place = self.place if at is None else self.place_of(at)
        self.state.teach(Lesson(rule=rule, what=what, remedy=remedy), place)

    def refuse(
        self,
        words: str,
        what: str,
        remedy: str,
        *,
        at: str | None = None,
        kind: Kind = Kind.SYNTAX,
    ) -> LaunchRefused:
        """A fault of this tag.

        Args:
            words: What roslaunch says.
            what: What is wrong.
            remedy: What would be right.
            at: The attribute that it is about; None for the tag.
            kind: How handlers treat it.
        """
        place = self.place if at is None else self.place_of(at)
        lesson = Lesson(rule=ATTRIBUTE, what=what, remedy=remedy)
        return LaunchRefused(kind, words, lesson, place=place)

    @contextlib.contextmanager
    def worded(self, words: Mapping[Kind, str], kind: Kind = Kind.SYNTAX) -> Iterator[None]:
        """A fault in the body becomes one of this tag, in roslaunch's words.

        Args:
            words: For the kinds of faults that roslaunch's handler catches; in them `{text}` is what the fault says,
                `{xml}` this tag.
            kind: What the fault is then.
        """
        try:
            yield
        except LaunchRefused as refused:
            refused.at(self.place)
            if refused.kind not in words:
                raise
            text = words[refused.kind].format(text=refused.text, xml=self.xml)
            raise refused.worded(kind, text) from None

    def namespace(self, scope: Scope) -> str | None:
        """The value of `ns`, or None.

        Raises:
            LaunchRefused: It is empty.
        """
        namespace = self.get("ns", scope)
        if namespace == "":
            words = f"<{self.name}> tag has an empty 'ns' attribute"
            raise self.refuse(words, "ns= is empty", 'Write a name, e.g. ns="robot1".', at="ns")
        return namespace
