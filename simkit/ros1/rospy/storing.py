"""Subscribers that only keep what they receive, as those of a TransformListener do."""

from __future__ import annotations

from simkit.graph.process import client

from .topics import Subscriber


class StoringSubscriber(Subscriber):
    """A subscriber whose callback only keeps what it is given, so that no turn of the node is spent on it.

    A message waits until the node wakes by itself, if that is soon, and is kept before the node goes on. The callback
    must not block, nor read the clock by `rospy`, which may let time pass: `now_ns` does not.
    """

    _stored = True


def now_ns() -> int:
    """The present [ns], for the callback of a `StoringSubscriber`."""
    return client.current().peek_ns()
