"""rosbags' serializer, written independently, is the oracle of the wire format."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from rosbags.interfaces import Nodetype
from rosbags.typesys import Stores, get_typestore
from rosbags.typesys.base import normalize_fieldname

from simkit.msgs import Message, TVal, message_class

STORE = get_typestore(Stores.ROS1_NOETIC)
TYPES = [name for name in STORE.fielddefs if not name.startswith("builtin_interfaces/")]
NUMPY = {"bool": "bool", "byte": "int8", "char": "uint8"}
PADDING = "structure_needs_at_least_one_member"


def their_value(description: Any, value: Any) -> Any:
    kind, details = description
    if kind == Nodetype.BASE:
        return value
    if kind == Nodetype.NAME:
        if isinstance(value, TVal):
            return STORE.types[details](value.secs, value.nsecs)
        return their_message(details, value)
    element, _ = details
    if element[0] == Nodetype.BASE and element[1][0] != "string":
        base = element[1][0]
        return np.array(list(value), dtype=NUMPY.get(base, base))
    return [their_value(element, item) for item in value]


def their_message(name: str, message: Message) -> Any:
    values = {
        normalize_fieldname(field): their_value(description, getattr(message, field))
        for field, description in STORE.fielddefs[name][1]
        if field != PADDING
    }
    return STORE.types[name](**values)


@pytest.mark.parametrize("name", TYPES)
def test_bytes_and_md5_agree(name, random_message):
    made = message_class(name.replace("/msg/", "/"))
    assert made._md5sum == STORE.generate_msgdef(name)[1]
    for seed in range(5):
        message = random_message(made, seed)
        theirs = bytes(STORE.serialize_ros1(their_message(name, message), name))
        assert message.to_bytes() == theirs
        assert made.from_bytes(theirs) == message
