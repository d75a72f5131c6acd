"""rospy's exceptions."""

from __future__ import annotations


class ROSException(Exception):
    """Base of rospy's exceptions."""


class ROSSerializationException(ROSException):
    """A message has a field of the wrong type."""


class ROSInternalException(Exception):
    """Base of internal errors; scripts may name it."""


class ROSInitException(ROSException):
    """Something needs `init_node` first."""


class ROSInterruptException(ROSException, KeyboardInterrupt):
    """A wait was interrupted by the node's shutdown."""


class ROSTimeMovedBackwardsException(ROSInterruptException):
    """Time jumped back during a sleep."""

    def __init__(self, time: float) -> None:
        self.time = time
        super().__init__("ROS time moved backwards")


class TransportException(ROSInternalException):
    """Base of transport errors."""


class TransportInitError(TransportException):
    """A connection cannot be made."""


class TransportTerminated(TransportException):
    """A connection has ended."""
