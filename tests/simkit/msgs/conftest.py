"""Random messages of any type, from a seed."""

from __future__ import annotations

import random
import struct
from collections.abc import Callable
from typing import Any

import pytest

from simkit.msgs import Duration, Message, Time, message_class
from simkit.msgs.definition import NUMBER_CODES, Field

ALPHABET = "abcXYZ 012_/-.:'\"\\\n#äß€🐢"


def random_number(base: str, chance: random.Random) -> Any:
    if base == "bool":
        return chance.random() < 0.5
    if base == "float32":
        return struct.unpack("<f", struct.pack("<f", chance.uniform(-1e6, 1e6)))[0]
    if base == "float64":
        return chance.choice([0.0, -1.5, chance.uniform(-1e9, 1e9), float("inf")])
    code = NUMBER_CODES[base]
    bits = 8 * struct.calcsize("<" + code)
    low, high = (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1) if code.islower() else (0, 2**bits - 1)
    return chance.choice([low, high, chance.randint(low, high)])


def random_value(field: Field, chance: random.Random) -> Any:
    if field.base in NUMBER_CODES:
        return random_number(field.base, chance)
    if field.base == "string":
        return "".join(chance.choices(ALPHABET, k=chance.randrange(6)))
    if field.base == "time":
        # ROS 1 has unsigned seconds, rosbags (as ROS 2) signed ones: half of them must do.
        return Time(chance.randrange(2**31), chance.randrange(10**9))
    if field.base == "duration":
        return Duration(chance.randrange(-(2**31), 2**31), chance.randrange(10**9))
    return fill_randomly(message_class(field.base)(), chance)


def fill_randomly(message: Message, chance: random.Random) -> Message:
    for field in message._definition.fields:
        if field.is_array:
            count = chance.randrange(4) if field.length is None else field.length
            value: Any = [random_value(field, chance) for _ in range(count)]
            if field.is_octets:
                value = bytes(value)
        else:
            value = random_value(field, chance)
        setattr(message, field.attribute, value)
    return message


@pytest.fixture
def random_message() -> Callable[[type[Message], int], Message]:
    return lambda made, seed: fill_randomly(made(), random.Random(seed))


@pytest.fixture(scope="session")
def all_classes() -> list[type[Message]]:
    from simkit.msgs import message_types, service_class, service_types

    services = [service_class(name) for name in service_types()]
    return [
        *(message_class(name) for name in message_types()),
        *(service._request_class for service in services),
        *(service._response_class for service in services),
    ]
