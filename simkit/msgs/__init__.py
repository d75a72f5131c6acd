"""The messages of ROS 1: classes made from definitions, their wire format, and ROS time."""

from simkit.msgs.catalog import message_types, packages, service_types
from simkit.msgs.classes import Service, message_class, service_class
from simkit.msgs.errors import (
    DefinitionError,
    DeserializationError,
    MessageError,
    SerializationError,
)
from simkit.msgs.fill import field_paths, fill_message
from simkit.msgs.message import Message
from simkit.msgs.rostime import Duration, Time, TVal
from simkit.msgs.strify import strify_message

__all__ = [
    "DefinitionError",
    "DeserializationError",
    "Duration",
    "Message",
    "MessageError",
    "SerializationError",
    "Service",
    "TVal",
    "Time",
    "field_paths",
    "fill_message",
    "message_class",
    "message_types",
    "packages",
    "service_class",
    "service_types",
    "strify_message",
]
