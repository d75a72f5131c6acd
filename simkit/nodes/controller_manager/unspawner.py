"""unspawner: keeps controllers stopped until it ends, and starts them again then.

Source: controller_manager `scripts/unspawner`: order, texts.
"""

from __future__ import annotations

from simkit.graph import Node, ServiceFailed
from simkit.nodes.controller_manager.errand import Errand, run
from simkit.nodes.controller_manager.services import BEST_EFFORT, ManagerClient
from simkit.nodes.program import Program

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
        run(node, self._work())

    def _work(self) -> Errand:
        try:
            yield from self._inhibit()
        except ServiceFailed as failure:
            self._node.error(str(failure))
            self._exit(1)

    def _inhibit(self) -> Errand:
        for service in ("list_controllers", "switch_controller"):
            yield from self._manager.wait_for(service, None)
        self._node.on_shutdown(lambda: run(self._node, self._start_again(), after_shutdown=True))
        while True:
            listed = yield self._manager.list()
            running = [one.name for one in listed.controller if one.state == "running"]
            stop = [name for name in running if name in self._names]
            if stop:
                self._node.info(f"Inhibiting controllers: {', '.join(stop)}")
                yield self._manager.switch(stop=stop, strictness=BEST_EFFORT)
                self._inhibited += [name for name in stop if name not in self._inhibited]
            yield EVERY_SECONDS

    def _start_again(self) -> Errand:
        try:
            yield self._manager.switch(start=self._inhibited, strictness=BEST_EFFORT)
        except ServiceFailed as failure:
            self._node.warn(str(failure))
