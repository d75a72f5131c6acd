"""Graph side: a script that runs as a node in a process of its own.

The node is resumed by events (its wake-up time, a message, an answer), acts within one instant, and blocks again. What it asks
for is done by `requests`; what became of it is worded by `failure`.
"""

from __future__ import annotations

from dataclasses import replace

from simkit.errors import SimkitError
from simkit.graph.graph import Graph
from simkit.graph.log import LogLevel
from simkit.graph.names import CommandLine, join, resolve
from simkit.graph.process import failure as failures
from simkit.graph.process import protocol
from simkit.graph.process.failure import NodeFailure
from simkit.graph.process.fork_server import StartError
from simkit.graph.process.link import Ended, Flooded, NodeLink, Printout, Stuck
from simkit.graph.process.protocol import Op, Outbox, ProtocolError
from simkit.graph.process.requests import Requests
from simkit.graph.process.runtime import NodeRuntime
from simkit.graph.process.spec import Permissions, StartSpec
from simkit.graph.process.starters import StartedProcess
from simkit.graph.process.turns import Turns
from simkit.graph.services import ServiceServer
from simkit.graph.topics import Publisher, Subscription

MAX_FAULTS = 20
"""So many different faults of callbacks are kept."""
SHUTDOWN_GRACE_NS = 2_000_000_000
"""How long a node may live on after a shutdown request [ns of virtual time]."""


class ScriptNode:
    """One script process on the graph.

    Args:
        graph: The graph it joins.
        runtime: Starts its process.
        spec: The script.
        command_line: What its arguments say.
        permissions: What it may write.
    """

    def __init__(
        self,
        graph: Graph,
        runtime: NodeRuntime,
        spec: StartSpec,
        command_line: CommandLine,
        permissions: Permissions,
    ) -> None:
        self.graph = graph
        self.name = join(command_line.namespace, command_line.node_name or spec.node_name)
        self.command_line = command_line
        self.permissions = permissions
        self.publishers: list[Publisher] = []
        self.subscriptions: list[Subscription] = []
        self.servers: list[ServiceServer] = []
        self.refusals: list[str] = []
        self.alive = True
        self.exit_code: int | None = None
        self.end_failure: NodeFailure | None = None
        self.faults: list[NodeFailure] = []
        self.outbox = Outbox()
        self._runtime = runtime
        self._spec = spec
        self._process: StartedProcess | None = None
        self._link: NodeLink | None = None
        self._acting = False
        self._printout = Printout(lambda text: graph.show_output(self.name, text))
        self._remappings: dict[str, str] = {}
        self._requests = Requests(self)
        self._turns = Turns(graph.executor, self._resume, lambda: not self.outbox.is_empty)
        self._shutdown_requested = False
        self._start_event = graph.executor.call_soon(self._start)

    def __repr__(self) -> str:
        if self.alive:
            state = "running" if self._process is not None else "starting"
        else:
            state = f"ended: {self.end_failure}" if self.end_failure else "ended"
        return f"<node {self.name} ({self._spec.shown_path}), {state}>"

    # -- what others ask of it

    @property
    def output(self) -> str:
        """What the node has printed so far, standard output and error in one."""
        return self._printout.text

    @property
    def failure(self) -> NodeFailure | None:
        """Why it ended, or else the first fault of a callback; None while all is well."""
        return self.end_failure or (self.faults[0] if self.faults else None)

    def add_fault(self, value: object) -> None:
        """Note a fault that the node survived."""
        fault = failures.from_exit_record(value)
        if fault is not None and fault not in self.faults and len(self.faults) < MAX_FAULTS:
            self.faults.append(fault)

    def shutdown(self, reason: str = "shutdown request") -> None:
        """Ask the node to end; it has a moment of virtual time for its last words."""
        if not self.alive:
            return
        self.graph.remove_node(self)
        self._shutdown_requested = True
        if self._process is None or self._acting:
            self._end(
                kill=True
            )  # it has not begun, or Ctrl-C came while it was busy: it can be sent nothing
            return
        self.outbox.add(Op.SHUTDOWN, reason.encode())
        self.resume_soon()
        self.graph.executor.call_at(
            self.graph.executor.now_ns + SHUTDOWN_GRACE_NS, lambda: self._end(kill=True)
        )

    def close(self) -> None:
        """End the process now, virtual time standing still: the simulation is over."""
        if self.alive and self._process is not None and not self._acting:
            self.outbox.add(Op.SHUTDOWN, b"the simulation is closed")
            self._resume()
        self._end(kill=True)

    def post(self, op: Op, *body: bytes, stored: bool = False) -> bool:
        """Put a record in the node's outbox and give the node a turn.

        Args:
            op: The operation.
            body: The parts of its body.
            stored: The node only keeps it for later, so it can wait until the node is about to wake by itself.

        Returns:
            False for a message that was dropped, since too much waits for the node already, and for one that came too
            late. An answer cannot be dropped: a node that has no room for it ends.
        """
        if not self.alive:
            return False
        if not self.outbox.has_room(sum(map(len, body))):
            if op is not Op.DELIVER:
                self._fail(failures.overwhelmed())
            return False
        self.outbox.add(op, *body)
        if self._process is not None:
            if stored:
                self._turns.before_long()
            else:
                self._turns.soon()
        return True

    def resume_soon(self) -> None:
        """Give the node a turn at this instant, with what waits in its outbox."""
        if self.alive and self._process is not None:
            self._turns.soon()

    # -- what its process asks

    def take_name(self, name: str) -> None:
        """Join the graph under a name.

        Raises:
            SimkitError: It cannot; the node keeps the name that it had.
        """
        before, self.name = self.name, name
        try:
            self._remappings = self.command_line.resolved_remappings(name)
            self.graph.add_node(self)
        except SimkitError:
            self.name = before
            raise

    def resolve(self, name: str) -> str:
        """The global name that a name stands for in this node.

        Raises:
            GraphError: It is not a legal name.
        """
        return resolve(name, self.name, self._remappings)

    def refuse(self, sentence: str) -> dict[str, str]:
        """Note, once, that the node reached for what it may not; the answer that it gets."""
        if sentence not in self.refusals:
            self.refusals.append(sentence)
            self.graph.log(self.name, LogLevel.ERROR, f"refused: {sentence}")
        return {"error": sentence}

    # -- its life

    def _start(self) -> None:
        if not self.alive:
            return
        spec = replace(self._spec, now_ns=self.graph.executor.now_ns)
        try:
            self._process = self._runtime.start(spec)
        except StartError as error:
            self._fail(NodeFailure(kind="start", text=str(error)))
            return
        self._link = NodeLink(
            self._process, self._runtime.allowance, self._runtime.limits.output_bytes
        )
        self._printout.data = self._link.output
        self._turn(send=False)

    def _resume(self) -> None:
        self._turns.begin()
        if self.alive:
            self._turn(send=True)

    def _turn(self, *, send: bool) -> None:
        self._acting = (
            True  # stays so if Ctrl-C comes in between: then it cannot be sent anything any more
        )
        try:
            self._converse(send=send)
        except Stuck:
            assert self._link is not None
            self._fail(failures.stuck(self._link.stack(), self._runtime.allowance))
        except Flooded:
            self._fail(failures.flooded(self._runtime.limits.output_bytes))
        except ProtocolError as error:
            self._fail(failures.unreadable(str(error)))
        except Ended:
            self._end(kill=True)
            if self.end_failure is None:
                self.end_failure = failures.abrupt_end(self.exit_code)
                self._report_death()

    def _converse(self, *, send: bool) -> None:
        """Let the node act until it blocks or ends."""
        assert self._link is not None
        self._link.begin_turn()
        while True:
            if send:
                self.outbox.add(Op.RESUME, protocol.pack_time(self.graph.executor.now_ns))
                self._link.send(self.outbox.take())
            frame = self._link.receive()
            self._printout.show_new_text()
            last, body = self._requests.perform(frame)
            if last is Op.ASK:
                send = True
                continue
            self._acting = False
            if last is Op.EXIT:
                self._leave(protocol.unpack_json(body))
            else:
                self._turns.sleep(*protocol.unpack_looks(body))
            return

    def _leave(self, last_words: object) -> None:
        self._end(kill=False)
        if self._shutdown_requested:
            return  # whatever its waits raised when they were cut short is no failure
        reported = last_words.get("failure") if isinstance(last_words, dict) else None
        self.end_failure = failures.from_exit_record(reported)
        if self.end_failure is not None:
            self._report_death()

    def _fail(self, failure: NodeFailure) -> None:
        self.end_failure = failure
        self._end(kill=True)
        self._report_death()

    def _end(self, *, kill: bool) -> None:
        if not self.alive:
            return
        self.alive = False
        self._start_event.cancel()
        self._turns.cancel()
        if self._link is not None and self._process is not None:
            self.exit_code = self._process.end(kill=kill)
            self._collect_last_output()
        for endpoint in (*self.publishers, *self.subscriptions, *self.servers):
            endpoint.unregister()
        self._requests.abandon_calls()
        self.graph.remove_node(self)

    def _collect_last_output(self) -> None:
        assert self._link is not None
        try:
            self._link.drain()
        except Flooded:
            self.end_failure = self.end_failure or failures.flooded(
                self._runtime.limits.output_bytes
            )
        self._link.close()
        self._link = None
        self._printout.show_new_text()

    def _report_death(self) -> None:
        self.graph.log(
            self.name,
            LogLevel.ERROR,
            f"process has died [exit code {self.exit_code}]: {self.failure}",
        )
