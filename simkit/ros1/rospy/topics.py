"""Publishers and subscribers."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from typing import Any

from simkit.graph.process import client
from simkit.graph.process.node_client import Refused
from simkit.graph.process.protocol import Op
from simkit.msgs import DeserializationError, Message, SerializationError

from .core import interrupted, is_initialized, require_init, resolve_name, when_initialized
from .exceptions import ROSException, ROSSerializationException
from .logs import report_bad_callback


class AnyMsg:
    """Stands for any message type; subscribing to any type is not offered here."""

    _type = "*"


def _check_class(data_class: Any, name: Any) -> None:
    if not isinstance(name, str) or not name:
        raise ValueError(f"topic name is not a non-empty string: {name}")
    if not isinstance(data_class, type) or not issubclass(data_class, Message):
        raise ValueError(f"data_class [{data_class}] is not a message data class")


class _Topic:
    """What publishers and subscribers share."""

    def __init__(self, name: str, data_class: Any) -> None:
        _check_class(data_class, name)
        self.name = name
        self.data_class = data_class
        self.type = data_class._type
        self.md5sum = data_class._md5sum
        self._id: int | None = None
        self._closed = False

    @property
    def resolved_name(self) -> str:
        """Global name of the topic."""
        return resolve_name(self.name)

    def get_num_connections(self) -> int:
        """How many others are connected to this end."""
        if self._id is None:
            return 0
        return int(client.current().ask(Op.QUERY, what="connections", id=self._id)["value"])


class _Line:
    """A node's one publisher on a topic, which all `Publisher` objects of that topic share.

    Scripts make a broadcaster in every callback; as in rospy, that must not register anew each time.
    """

    def __init__(self, number: int) -> None:
        self.id = number
        self.users = 0
        self.sequence = 0


_lines: dict[tuple[str, str, bool], _Line] = {}


class Publisher(_Topic):
    """Sends messages on a topic.

    Args:
        name: Topic name.
        data_class: Message class.
        subscriber_listener: Taken for rospy's sake.
        tcp_nodelay: Taken for rospy's sake.
        latch: Give the last message to each later subscriber.
        headers: Taken for rospy's sake.
        queue_size: Length of the queue that real rospy keeps for slow subscribers.
    """

    def __init__(
        self,
        name: str,
        data_class: Any,
        subscriber_listener: object = None,
        tcp_nodelay: bool = False,
        latch: bool = False,
        headers: object = None,
        queue_size: int | None = None,
    ) -> None:
        super().__init__(name, data_class)
        if queue_size is None:
            warnings.warn(
                "The publisher should be created with an explicit keyword argument 'queue_size'. "
                "Please see http://wiki.ros.org/rospy/Overview/Publishers%20and%20Subscribers for more information.",
                SyntaxWarning,
                stacklevel=2,
            )
        self.latch = latch
        self._key = (name, self.type, bool(latch))
        when_initialized(self._register)

    def _register(self) -> None:
        if self._key not in _lines:
            try:
                number = client.current().advertise(self.name, self.type, latch=self.latch)
            except Refused as error:
                raise ROSException(str(error)) from None
            _lines[self._key] = _Line(number)
        self._line = _lines[self._key]
        self._line.users += 1
        self._id = self._line.id

    def publish(self, *args: Any, **kwds: Any) -> None:
        """Send a message: an instance, or the fields of one.

        Raises:
            ROSException: The topic is closed, or there is no node yet.
            ROSSerializationException: A field has the wrong type.
        """
        if not is_initialized():
            raise ROSException(
                "ROS node has not been initialized yet. Please call init_node() first"
            )
        if self._closed or self._id is None:
            raise ROSException("publish() to an unregistered() handle")
        message = as_message(self.data_class, args, kwds)
        if message._has_header:
            self._line.sequence += 1
            message.header.seq = self._line.sequence
        try:
            data = message.to_bytes()
        except SerializationError as error:
            raise ROSSerializationException(str(error)) from None
        client.current().publish(self._id, data)

    def unregister(self) -> None:
        """Leave the topic."""
        if self._id is not None and not self._closed:
            self._line.users -= 1
            if self._line.users == 0:
                client.current().unadvertise(self._id)
                del _lines[self._key]
        self._closed = True


class Subscriber(_Topic):
    """Calls back with each message of a topic.

    Args:
        name: Topic name.
        data_class: Message class.
        callback: Takes the message, and `callback_args` if they are given.
        callback_args: Second argument of the callback.
        queue_size: At most so many messages wait; the oldest is dropped.
        buff_size: Taken for rospy's sake.
        tcp_nodelay: Taken for rospy's sake.
    """

    _stored = False

    def __init__(
        self,
        name: str,
        data_class: Any,
        callback: Callable[..., object] | None = None,
        callback_args: Any = None,
        queue_size: int | None = None,
        buff_size: int = 65536,
        tcp_nodelay: bool = False,
    ) -> None:
        super().__init__(name, data_class)
        if callback is not None and not callable(callback):
            raise ValueError(f"callback is not a function or callable object: {callback}")
        if queue_size == 0:
            raise ROSException("queue size may not be set to zero")
        if queue_size is not None and (type(queue_size) is not int or queue_size < -1):
            raise ROSException("queue size must be an integer")
        self.callback = callback
        self.callback_args = callback_args
        self._queue_size = None if queue_size == -1 else queue_size
        when_initialized(self._register)

    def _register(self) -> None:
        try:
            self._id = client.current().subscribe(
                self.name, self.type, self._receive, self._queue_size, stored=self._stored
            )
        except Refused as error:
            raise ROSException(str(error)) from None

    def _receive(self, data: bytes, caller: str) -> None:
        if self.callback is None or self._closed:
            return
        try:
            message = self.data_class.from_bytes(data)
        except DeserializationError:
            return
        message._connection_header = {"callerid": caller, "topic": self.name, "type": self.type}
        try:
            if self.callback_args is not None:
                self.callback(message, self.callback_args)
            else:
                self.callback(message)
        except Exception as error:
            report_bad_callback(self.callback, error)

    def unregister(self) -> None:
        """Leave the topic."""
        if self._id is not None and not self._closed:
            client.current().unsubscribe(self._id)
        self._closed = True


def as_message(data_class: Any, args: tuple[Any, ...], kwds: dict[str, Any]) -> Any:
    """The message that the arguments of `publish` (or of a service call) mean.

    Raises:
        TypeError: They fit no message of that class.
    """
    if args and kwds:
        raise TypeError("publish() can be called with arguments or keywords, but not both.")
    if kwds:
        return data_class(**kwds)
    if len(args) == 1 and isinstance(args[0], data_class):
        return args[0]
    if len(args) == 1 and isinstance(args[0], Message) and not _takes(data_class, args[0]):
        raise TypeError(f"expected [{data_class._type}] but got [{args[0]._type}]")
    return data_class(*args)


def _takes(data_class: Any, message: Message) -> bool:
    return list(data_class._slot_types) == [message._type]


def wait_for_message(topic: str, topic_type: Any, timeout: float | None = None) -> Any:
    """Block until the next message of a topic.

    Raises:
        ROSException: None came within `timeout` [s].
        ROSInterruptException: The node is shut down.
    """
    require_init("rospy.wait_for_message")
    line = client.current()
    task = line.scheduler.current
    received: list[Any] = []

    def receive(message: Any) -> None:
        received.append(message)
        line.scheduler.make_ready(task)

    subscriber = Subscriber(topic, topic_type, receive)
    until = None if timeout is None else line.peek_ns() + round(timeout * 1e9)
    try:
        while not received and (until is None or line.peek_ns() < until):
            line.scheduler.block(until)
            if line.shutdown_reason is not None:
                raise interrupted()
    finally:
        subscriber.unregister()
    if not received:
        raise ROSException(f"timeout exceeded while waiting for message on topic {topic}")
    return received[0]
