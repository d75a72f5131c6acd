"""spawner: loads controllers and starts them, and takes them down when it ends.

Source: controller_manager `scripts/spawner`: options, order, texts.
"""

from __future__ import annotations

import argparse
from typing import Any, NoReturn

from simkit.commands.parameter_yaml import load_parameters
from simkit.graph import Node, ServiceFailed
from simkit.msgs import message_class
from simkit.nodes.controller_manager.services import (
    BEST_EFFORT,
    ManagerClient,
    Routine,
    start_routine,
)
from simkit.nodes.program import Program

_LOST = "Controller Spawner couldn't find the expected controller_manager ROS interface."


class UsageFault(Exception):
    """The command line cannot be; the text is what is printed."""


class Words(argparse.ArgumentParser):
    """A parser that raises instead of ending Python."""

    def error(self, message: str) -> NoReturn:
        """Raise what would be printed."""
        raise UsageFault(f"{self.format_usage()}{self.prog}: error: {message}\n")

    def print_help(self, file: object = None) -> NoReturn:  # noqa: ARG002 - argparse's argument
        """Raise the help."""
        raise UsageFault(self.format_help())


def _parser() -> Words:
    parser = Words("spawner", description="Controller spawner", allow_abbrev=False)
    parser.add_argument("--stopped", action="store_true", help="load, but do not start")
    parser.add_argument("--wait-for", metavar="topic", help="until True is heard on it (Bool)")
    parser.add_argument("--namespace", metavar="ns", default="", help="of the controller manager")
    parser.add_argument(
        "--timeout",
        metavar="T",
        type=float,
        default=30.0,
        help="how long to wait for the controller manager [s] (default: 30); 0: for ever",
    )
    parser.add_argument("--no-timeout", action="store_true", help="wait for ever")
    parser.add_argument("--shutdown-timeout", help="has no effect any more")
    parser.add_argument("controllers", metavar="controller", nargs="+", help="names, or YAML files")
    return parser


class Spawner(Program):
    """The program `spawner` of the package controller_manager.

    Args:
        node: Its place in the graph.
        argv: Options, and the names of controllers.
    """

    def __init__(self, node: Node, argv: list[str]) -> None:
        super().__init__(node)
        self._loaded: list[str] = []
        try:
            self._options = _parser().parse_args(argv)
        except UsageFault as fault:
            self._print(str(fault))
            self._exit(0 if "-h" in argv or "--help" in argv else 2)
            return
        self._manager = ManagerClient(node, self._options.namespace)
        start_routine(node, self._work())

    def _work(self) -> Routine:
        try:
            yield from self._spawn()
        except ServiceFailed as failure:
            self._node.error(str(failure))
            self._exit(1)

    def _spawn(self) -> Routine:
        node, options = self._node, self._options
        if options.shutdown_timeout is not None:
            node.warn("DEPRECATION warning: --shutdown-timeout has no effect.")
        timeout_s = None if options.no_timeout or options.timeout <= 0.0 else options.timeout
        for service in ("load_controller", "switch_controller", "unload_controller"):
            node.info(f"Controller Spawner: Waiting for service {self._manager.shown(service)}")
            is_there = yield from self._manager.wait_for(service, timeout_s)
            if not is_there:
                node.warn(_LOST)
                self._exit(0)
                return
        if options.wait_for:
            yield from self._wait_for_topic(options.wait_for, timeout_s)
        node.on_shutdown(self._take_down)
        yield from self._load_and_start()

    def _wait_for_topic(self, topic: str, timeout_s: float | None) -> Routine:
        received: list[Any] = []
        node = self._node
        node.subscribe(topic, message_class("std_msgs/Bool"), received.append)
        begin_ns, has_warned = node.graph.executor.now_ns, False
        while not (received and received[-1].data):
            waited_s = (node.graph.executor.now_ns - begin_ns) / 1e9
            if not received and not has_warned and timeout_s is not None and waited_s > timeout_s:
                has_warned = True
                node.warn(
                    f'Controller Spawner hasn\'t heard anything from its "wait for" topic ({topic})'
                )
            yield 0.01

    def _load_and_start(self) -> Routine:
        node, manager = self._node, self._manager
        for name in self._names():
            node.info(f"Loading controller: {name}")
            response = yield manager.load(name)
            if response.ok:
                self._loaded.append(name)
            else:
                yield 1.0
                node.error(f"Failed to load {name}")
        names = ", ".join(self._loaded)
        node.info(f"Controller Spawner: Loaded controllers: {names}")
        if self._options.stopped:
            return
        response = yield manager.switch(start=self._loaded)
        if response.ok:
            node.info(f"Started controllers: {names}")
        else:
            node.error(f"Failed to start controllers: {names}")

    def _names(self) -> list[str]:
        """The controllers; a YAML file is loaded, and names all that are in it."""
        names: list[str] = []
        for word in self._options.controllers:
            path = self._folder / word
            if not path.is_file():
                names.append(word)
                continue
            for tree in load_parameters(path.read_text(encoding="utf-8")):
                for key, value in tree.items() if isinstance(tree, dict) else ():
                    self._node.set_param(str(key), value)
                    names.append(str(key))
        return names

    def _take_down(self) -> None:
        """Stop and unload the controllers, now that the node leaves."""
        self._node.info("Shutting down spawner. Stopping and unloading controllers...")
        start_routine(self._node, self._take_down_all(), after_shutdown=True)

    def _take_down_all(self) -> Routine:
        node, manager = self._node, self._manager
        try:
            node.info("Stopping all controllers...")
            yield manager.switch(stop=self._loaded)
            node.info("Unloading all loaded controllers...")
            for name in reversed(self._loaded):
                node.info(f"Trying to unload {name}")
                yield manager.unload(name)
                node.info(f"Succeeded in unloading {name}")
        except ServiceFailed as failure:
            node.warn(f"Controller Spawner error while taking down controllers: {failure}")


USAGE = """\
./unspawner name1 name2 name3

\tStops a set of controllers until killed.
\tUseful in roslaunch files to temporarily stop controllers
"""
"""What the program prints when it is given no name."""
EVERY_SECONDS = 3.0
"""How often it looks whether one of them runs again [s]."""


class Unspawner(Program):
    """The program `unspawner` of the package controller_manager.

    Args:
        node: Its place in the graph.
        argv: Names of controllers.
    """

    def __init__(self, node: Node, argv: list[str]) -> None:
        super().__init__(node)
        if not argv or argv[0] in ("-h", "--help"):
            self._print(USAGE)
            self._exit(1)
            return
        self._names = argv
        self._inhibited: list[str] = []
        self._manager = ManagerClient(node)
        start_routine(node, self._work())

    def _work(self) -> Routine:
        try:
            yield from self._inhibit()
        except ServiceFailed as failure:
            self._node.error(str(failure))
            self._exit(1)

    def _inhibit(self) -> Routine:
        for service in ("list_controllers", "switch_controller"):
            yield from self._manager.wait_for(service, None)
        self._node.on_shutdown(
            lambda: start_routine(self._node, self._start_again(), after_shutdown=True)
        )
        while True:
            listed = yield self._manager.list()
            running = [one.name for one in listed.controller if one.state == "running"]
            stop = [name for name in running if name in self._names]
            if stop:
                self._node.info(f"Inhibiting controllers: {', '.join(stop)}")
                yield self._manager.switch(stop=stop, strictness=BEST_EFFORT)
                self._inhibited += [name for name in stop if name not in self._inhibited]
            yield EVERY_SECONDS

    def _start_again(self) -> Routine:
        try:
            yield self._manager.switch(start=self._inhibited, strictness=BEST_EFFORT)
        except ServiceFailed as failure:
            self._node.warn(str(failure))
