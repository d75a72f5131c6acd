"""From a launch file to a plan: nothing is started and nothing is set."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path

from simkit.diagnostics import Severity, in_order
from simkit.errors import near_names
from simkit.launch.errors import Kind, LaunchError, LaunchPlace, LaunchRefused, Lesson, error_of
from simkit.launch.files import Budget, Files
from simkit.launch.launch_file import LaunchFile, read_launch_file
from simkit.launch.plan import TEXT_NAME, LaunchPlan
from simkit.launch.rules import UNUSED_ARGUMENT, USE_GUI
from simkit.launch.scope import Scope
from simkit.launch.state import LaunchState
from simkit.launch.substitution import Substitution
from simkit.launch.walk import open_launch_file, walk
from simkit.packages import PackagePath
from simkit.xml import Element


def evaluate(
    source: Path | str,
    *,
    packages: PackagePath,
    arguments: Mapping[str, str] | None = None,
    environment: Mapping[str, str] | None = None,
    anonymous: Callable[[str], str] | None = None,
) -> LaunchPlan:
    """What a launch file comes to. The same input gives the same plan, and it always ends.

    Args:
        source: Path of the file, or its text: what has a `<` in it is a text.
        packages: Where packages are; if they are confined, files outside of them cannot be read.
        arguments: Values of arguments by name, as `name:=value` on the command line; more than it declares do no harm.
        environment: What `$(env X)` sees; that of this process if None, and nothing if the packages are confined.
        anonymous: Makes the name of `$(anon id)` of an id; a number is appended if None.

    Raises:
        LaunchError: roslaunch would refuse the file, or it asks for too much.
    """
    if environment is None:
        environment = {} if packages.confined else os.environ
    budget = Budget()
    files = Files(packages, budget)
    substitution = Substitution(
        files=files,
        budget=budget,
        environment=environment,
        anonymous=anonymous or _Numbered().name,
    )
    state = LaunchState(files=files, budget=budget, substitution=substitution)
    return _Evaluation(state, dict(arguments or {})).plan(source)


class _Evaluation:
    """One evaluation: keeps the first file at hand, for faults that have no other place."""

    def __init__(self, state: LaunchState, arguments: dict[str, str]) -> None:
        self._state = state
        self._arguments = arguments
        self._launch_file: LaunchFile | None = None

    def plan(self, source: Path | str) -> LaunchPlan:
        is_text = isinstance(source, str) and "<" in source
        name = TEXT_NAME if is_text else str(source)
        try:
            self._launch_file, root = self._opened(name, str(source) if is_text else None)
            return self._walked(root, self._launch_file)
        except LaunchRefused as refused:
            raise self._error(refused, name) from None

    def _opened(self, name: str, text: str | None) -> tuple[LaunchFile, Element]:
        if text is None:
            return open_launch_file(name, self._state)
        data = text.encode("utf-8", "replace")
        self._state.budget.launch_file(len(data))
        return read_launch_file(data, name=name, shown="<launch file>")

    def _walked(self, root: Element, launch_file: LaunchFile) -> LaunchPlan:
        state = self._state
        scope = Scope(launch_file)
        scope.arguments = dict(self._arguments)
        walk(root, launch_file, scope, state)
        state.require_machines()
        if any(element.name == "master" for element in root.walk()):
            state.warn("WARNING: ignoring defunct <master /> tag", plain=True)
        self._teach_arguments(scope, root, launch_file)
        self._teach_use_gui()
        return LaunchPlan(
            file=launch_file.name,
            shown_file=launch_file.document.file,
            given=self._arguments,
            files=tuple(state.launch_files),
            params=state.params,
            origins=state.origins,
            clear_params=tuple(state.clear_params),
            steps=tuple(state.steps),
            nodes=tuple(state.nodes.values()),
            arguments=tuple(state.arguments),
            warnings=tuple(state.warnings),
            diagnostics=in_order(state.diagnostics),
        )

    def _teach_arguments(self, scope: Scope, root: Element, launch_file: LaunchFile) -> None:
        place = LaunchPlace(launch_file=launch_file, span=root.span)
        for name in self._arguments:
            if name not in scope.declared:
                declared = ", ".join(scope.declared) or "none"
                what = f"the argument {name!r} is given, but this file declares no such"
                near = near_names(name, scope.declared)
                remedy = f"Did you mean {near[0]}:=?" if near else f"It declares: {declared}."
                lesson = Lesson(rule=UNUSED_ARGUMENT, what=what, remedy=remedy)
                self._state.teach(lesson, place)

    def _teach_use_gui(self) -> None:
        params = self._state.params
        used = [name for name, value in params.items() if name.endswith("/use_gui") and value]
        if used and any(
            node.package == "joint_state_publisher" for node in self._state.nodes.values()
        ):
            what = "use_gui opens sliders here and in Melodic; from Noetic on nothing happens"
            remedy = (
                "On a newer robot start the node joint_state_publisher_gui of the package of that name "
                "in place of joint_state_publisher."
            )
            lesson = Lesson(rule=USE_GUI, what=what, remedy=remedy)
            self._state.teach(lesson, self._state.places[used[-1]], Severity.NOTE)

    def _error(self, refused: LaunchRefused, name: str) -> LaunchError:
        if refused.kind is Kind.ARGUMENT:
            words = f"[{name}] requires the '{refused.text}' arg to be set"
            refused = refused.worded(Kind.SYNTAX, words)
        return error_of(refused, self._state.files.shown(name))


class _Numbered:
    def __init__(self) -> None:
        self._counts: dict[str, int] = {}

    def name(self, identity: str) -> str:
        """An id with the next number of its own."""
        self._counts[identity] = self._counts.get(identity, 0) + 1
        return f"{identity}_{self._counts[identity]}"
