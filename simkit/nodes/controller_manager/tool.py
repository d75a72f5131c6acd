"""controller_manager: lists controllers, loads, starts, stops and unloads them, from the command line.

Source: controller_manager `scripts/controller_manager`, `controller_manager_interface.py`: words and texts.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from simkit.graph import Node, ServiceFailed
from simkit.nodes.controller_manager.services import (
    BEST_EFFORT,
    ManagerClient,
    Routine,
    start_routine,
)
from simkit.nodes.program import Program

USAGE = """\
Commands:
    load <name>          - Load the controller named <name>
    unload <name>        - Unload the controller named <name>
    start <name>         - Start the controller named <name>
    stop <name>          - Stop the controller named <name>
    spawn <name>         - Load and start the controller named <name>
    kill <name>          - Stop and unload the controller named <name>
    list                 - List active controllers
    list-types           - List controller Types
    reload-libraries     - Reloads all plugin controller libraries
"""
"""What the program prints when it is given no command, or one that there is not."""


class ControllerManagerTool(Program):
    """The program `controller_manager` of the package of that name.

    Args:
        node: Its place in the graph.
        argv: A command, and what it is for.
    """

    def __init__(self, node: Node, argv: list[str]) -> None:
        super().__init__(node)
        commands: dict[str, Callable[[Sequence[str]], Routine]] = {
            "lt": self._list_types,
            "list-types": self._list_types,
            "lc": self._list,
            "list": self._list,
            "reload-libraries": self._reload,
            "load": self._each(self._load),
            "unload": self._each(self._unload),
            "start": self._each(self._start),
            "stop": self._each(self._stop),
            "sp": self._each(self._load, self._start),
            "spawn": self._each(self._load, self._start),
            "kl": self._each(self._stop, self._unload),
            "kill": self._each(self._stop, self._unload),
        }
        if not argv or argv[0] not in commands:
            self._print(USAGE)
            self._exit(1 if argv else 0)
            return
        self._manager = ManagerClient(node)
        start_routine(node, self._work(commands[argv[0]](argv[1:])))

    def _work(self, routine: Routine) -> Routine:
        try:
            yield from self._manager.wait_for("list_controllers", None)
            yield from routine
        except ServiceFailed as failure:
            self._print(f"{failure}\n")
            self._exit(1)
            return
        self._exit(0)

    @staticmethod
    def _each(*steps: Callable[[str], Routine]) -> Callable[[Sequence[str]], Routine]:
        """All names for the first step, then all for the second."""

        def routine(names: Sequence[str]) -> Routine:
            for step in steps:
                for name in names:
                    yield from step(name)

        return routine

    def _list_types(self, _words: Sequence[str]) -> Routine:
        answer = yield self._manager.call("list_controller_types", "ListControllerTypes")
        self._print("".join(f"{one}\n" for one in answer.types))

    def _list(self, _words: Sequence[str]) -> Routine:
        answer = yield self._manager.list()
        if not answer.controller:
            self._print("No controllers are loaded in mechanism control\n")
        for one in answer.controller:
            kinds = dict.fromkeys(claim.hardware_interface for claim in one.claimed_resources)
            self._print(f"{one.name} - {'+'.join(kinds)} ( {one.state} )\n")

    def _reload(self, words: Sequence[str]) -> Routine:
        is_restored = "--restore" in words
        self._print(f"Restore: {is_restored}\n")
        before = (yield self._manager.list()).controller if is_restored else []
        answer = yield self._manager.call(
            "reload_controller_libraries", "ReloadControllerLibraries", force_kill=True
        )
        if answer.ok:
            self._print("Successfully reloaded libraries\n")
        else:
            self._print("Failed to reload libraries. Do you still have controllers loaded?\n")
        if is_restored:
            for one in before:
                yield self._manager.load(one.name)
            running = [one.name for one in before if one.state == "running"]
            yield self._manager.switch(start=running, strictness=BEST_EFFORT)
            self._print("Controllers restored to original state\n")

    def _load(self, name: str) -> Routine:
        answer = yield self._manager.load(name)
        self._print(f"Loaded {name}\n" if answer.ok else f"Error when loading {name}\n")

    def _unload(self, name: str) -> Routine:
        answer = yield self._manager.unload(name)
        good = f"Unloaded {name} successfully\n"
        self._print(good if answer.ok else f"Error when unloading {name}\n")

    def _start(self, name: str) -> Routine:
        answer = yield self._manager.switch(start=[name])
        good = f"Started {[name]} successfully\n"
        self._print(good if answer.ok else f"Error when starting  {[name]}\n")

    def _stop(self, name: str) -> Routine:
        answer = yield self._manager.switch(stop=[name])
        good = f"Stopped {[name]} successfully\n"
        self._print(good if answer.ok else f"Error when stopping  {[name]}\n")
