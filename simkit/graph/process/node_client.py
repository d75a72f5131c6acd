"""Node side: what a script's modules (`rospy`, `tf`) use to reach the graph. One client per node process.

Everything a script does on the graph is put in an outbox, and leaves when the node blocks: a node acts at one instant, then
sleeps. A question (a parameter, a topic's type) is answered at once; only blocking lets virtual time pass.
"""

from __future__ import annotations

import contextlib
import socket
import sys
from collections.abc import Callable, Iterator
from typing import Any

from simkit.graph.process import failure, protocol
from simkit.graph.process.link import Line
from simkit.graph.process.protocol import Op
from simkit.graph.process.scheduler import Scheduler, Task, Worker

MILLISECOND = 1_000_000
FREE_CLOCK_READS = 50
"""So often may a script read the clock at one instant before reading it lets a millisecond pass."""

FREE_QUESTIONS = 100
"""So many questions may a script put to the graph at one instant; then each lets a millisecond pass, until it sleeps."""


class Refused(Exception):
    """The graph refused a request; the text is a sentence for the student."""


class NodeClient:
    """A node process's line to the graph.

    Args:
        connection: Connected stream socket; the graph is at the other end.
        now_ns: Virtual time at the start [ns].
    """

    def __init__(self, connection: socket.socket, now_ns: int) -> None:
        self._line = Line(connection)
        self._now_ns = now_ns
        self._clock_reads = 0
        self._questions = 0
        self._looks: tuple[int, int] | None = None
        self._reply: Any = None
        self._next_call = 0
        self._results: dict[int, tuple[bool, bytes]] = {}
        self._calling: dict[int, Task] = {}
        self._sinks: dict[int, tuple[Worker, Callable[[bytes, str], None]]] = {}
        self._stores: dict[int, Callable[[bytes, str], None]] = {}
        self._handlers: dict[int, tuple[Worker, Callable[[bytes, str], tuple[bool, bytes]]]] = {}
        self.shutdown_reason: str | None = None
        self.on_shutdown: Callable[[str], None] = self.request_shutdown
        self._told_to_end = False
        self.scheduler = Scheduler(self._exchange, lambda: self._now_ns)

    # -- time

    def now_ns(self) -> int:
        """Virtual time [ns]; a loop that only reads the clock lets it run."""
        self._clock_reads += 1
        if self._clock_reads > FREE_CLOCK_READS and self.scheduler.is_task():
            self.sleep_until(self._now_ns + MILLISECOND)
        return self._now_ns

    def peek_ns(self) -> int:
        """Virtual time [ns], for our own use."""
        return self._now_ns

    def sleep_until(self, time_ns: int) -> None:
        """Block the calling task until a virtual time [ns], or a shutdown; never returns without any passing."""
        if time_ns <= self._now_ns:
            self.let_time_pass()
        while self._now_ns < time_ns and self.shutdown_reason is None:
            self.scheduler.block(time_ns)

    @contextlib.contextmanager
    def looking(self, period_ns: int, end_ns: int) -> Iterator[None]:
        """The sleeps in this block, of a period [ns] each, only wait for something that the graph brings.

        While it brings nothing, nobody need wake: the next sleep ends where the first one with news would, or the
        first one at or after an end [ns].
        """
        self._looks = (period_ns, end_ns) if period_ns >= protocol.LEAST_PERIOD_NS else None
        try:
            yield
        finally:
            self._looks = None

    def let_time_pass(self) -> None:
        """Let a millisecond pass, unless the calling task has blocked since it last came here."""
        task = self.scheduler.current
        if not task.blocked_since_asked:
            self.scheduler.block(self._now_ns + MILLISECOND)
        task.blocked_since_asked = False

    # -- the graph

    def ask(self, op: Op, **request: Any) -> Any:
        """Put a request to the graph and have the answer at once.

        A loop that only asks ("is anybody connected?") lets time pass.

        Raises:
            Refused: The graph refused, with the reason.
        """
        self._questions += 1
        if self._questions > FREE_QUESTIONS and self.scheduler.is_task():
            self.sleep_until(self._now_ns + MILLISECOND)
            self._questions = FREE_QUESTIONS
        self._line.outbox.add_json(op, request)
        self._line.outbox.add(Op.ASK)
        self._turn()
        reply, self._reply = self._reply, None
        if isinstance(reply, dict) and "error" in reply:
            raise Refused(reply["error"])
        return reply

    def advertise(self, topic: str, type_name: str, *, latch: bool) -> int:
        """A publisher's id."""
        return int(self.ask(Op.ADVERTISE, topic=topic, type=type_name, latch=latch)["id"])

    def unadvertise(self, publisher_id: int) -> None:
        """End a publisher."""
        self._line.outbox.add(Op.UNADVERTISE, protocol.pack_id(publisher_id))

    def publish(self, publisher_id: int, data: bytes) -> None:
        """Send a message, in wire format, when the node blocks next."""
        self._line.outbox.add(Op.PUBLISH, protocol.pack_id(publisher_id), data)

    def subscribe(
        self,
        topic: str,
        type_name: str,
        sink: Callable[[bytes, str], None],
        queue_size: int | None,
        *,
        stored: bool = False,
    ) -> int:
        """A subscription's id.

        Args:
            topic: Name of the topic, as written.
            type_name: Type of its messages.
            sink: Takes wire bytes and the publisher's name, in a task of its own.
            queue_size: At most so many messages wait; None for any number.
            stored: `sink` only keeps what it gets: it never blocks, nor asks the graph. It is called before the
                node goes on, and a message waits until the node wakes by itself, if it does so soon.
        """
        number = int(
            self.ask(
                Op.SUBSCRIBE, topic=topic, type=type_name, queue_size=queue_size, stored=stored
            )["id"]
        )
        if stored:
            self._stores[number] = sink
        else:
            worker = Worker(self.scheduler, f"callbacks of {topic}", self.report_fault, queue_size)
            self._sinks[number] = (worker, sink)
        return number

    def unsubscribe(self, subscription_id: int) -> None:
        """End a subscription; what is on its way is dropped."""
        self._stores.pop(subscription_id, None)
        if subscription_id in self._sinks:
            worker, _ = self._sinks.pop(subscription_id)
            worker.close(drop=True)
        self._line.outbox.add(Op.UNSUBSCRIBE, protocol.pack_id(subscription_id))

    def offer_service(
        self, service: str, type_name: str, handler: Callable[[bytes, str], tuple[bool, bytes]]
    ) -> int:
        """A service's id; `handler` takes a request and the caller, gives (success, answer)."""
        number = int(self.ask(Op.OFFER_SERVICE, service=service, type=type_name)["id"])
        worker = Worker(self.scheduler, f"calls of {service}", self.report_fault)
        self._handlers[number] = (worker, handler)
        return number

    def withdraw_service(self, service_id: int) -> None:
        """End a service; calls that have come are answered still."""
        if service_id in self._handlers:
            worker, _ = self._handlers.pop(service_id)
            worker.close(drop=False)
        self._line.outbox.add(Op.WITHDRAW_SERVICE, protocol.pack_id(service_id))

    def call_service(self, service: str, request: bytes) -> tuple[bool, bytes]:
        """Call a service and block until the answer: (success, response or error text)."""
        self._next_call += 1
        number = self._next_call
        self._calling[number] = self.scheduler.current
        self._line.outbox.add(
            Op.CALL, protocol.pack_id(number), protocol.pack_name(service), request
        )
        while number not in self._results and self.shutdown_reason is None:
            self.scheduler.block()
        del self._calling[number]
        return self._results.pop(number, (False, b"node is shutting down"))

    def log(self, level: int, text: str) -> None:
        """Say something on rosout."""
        self._line.outbox.add(Op.LOG, bytes([level]), text.encode("utf-8", "replace"))

    def report_fault(self, error: BaseException) -> None:
        """Tell the graph of an error that the node survives."""
        self._line.outbox.add_json(Op.FAULT, {**failure.describe(error, sys.argv[0])})

    def finish(self, code: int, failure: dict[str, Any] | None) -> None:
        """The last word of the process."""
        self._line.outbox.add_json(Op.EXIT, {"code": code, "failure": failure})
        self._line.send()

    # -- what the graph says

    def _exchange(self, wake_ns: int | None) -> None:
        if wake_ns is None:
            body = protocol.pack_time(protocol.NEVER)
        elif self._looks is not None and self.scheduler.sleeper_count == 1:
            body = protocol.pack_looks(wake_ns, *self._looks)
        else:
            body = protocol.pack_time(wake_ns)
        self._line.outbox.add(Op.WAIT, body)
        self._turn()

    def _turn(self) -> None:
        for op, body in self._line.turn():
            self._handle(op, body)

    def _handle(self, op: Op, body: bytes) -> None:
        if op is Op.RESUME:
            time_ns = protocol.unpack_time(body)
            if time_ns != self._now_ns:
                self._clock_reads = self._questions = 0
            self._now_ns = time_ns
        elif op is Op.REPLY:
            self._reply = protocol.unpack_json(body)
        elif op is Op.DELIVER:
            self._deliver(body)
        elif op is Op.CALL_RESULT:
            number, rest = protocol.unpack_id(body)
            self._results[number] = (rest[:1] == b"\x01", rest[1:])
            if number in self._calling:
                self.scheduler.make_ready(self._calling[number])
        elif op is Op.SERVE:
            self._serve(body)
        elif op is Op.SHUTDOWN:
            self._shut_down(body.decode())

    def _deliver(self, body: bytes) -> None:
        number, rest = protocol.unpack_id(body)
        caller, data = protocol.unpack_name(rest)
        if number in self._stores:
            self._stores[number](data, caller)
        elif number in self._sinks:
            worker, sink = self._sinks[number]
            worker.add(lambda: sink(data, caller))

    def _serve(self, body: bytes) -> None:
        call, rest = protocol.unpack_id(body)
        number, rest = protocol.unpack_id(rest)
        caller, request = protocol.unpack_name(rest)
        worker, handler = self._handlers.get(number, (None, None))
        if worker is None or handler is None:
            self._answer(call, success=False, data=b"service is gone")
            return

        def work() -> None:
            success, data = handler(request, caller)
            self._answer(call, success=success, data=data)

        worker.add(work)

    def _answer(self, call: int, *, success: bool, data: bytes) -> None:
        self._line.outbox.add(Op.SERVICE_ANSWER, protocol.pack_id(call), bytes([success]), data)

    def _shut_down(self, reason: str) -> None:
        if not self._told_to_end:
            self._told_to_end = True
            self.scheduler.start(lambda: self.on_shutdown(reason), "shutdown hooks")

    def request_shutdown(self, reason: str) -> None:
        """End every wait of this node: sleeps return, calls fail."""
        if self.shutdown_reason is None:
            self.shutdown_reason = reason
            for task in self.scheduler.tasks():
                self.scheduler.make_ready(task)
