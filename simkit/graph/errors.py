"""Errors of the graph."""

from __future__ import annotations

from simkit.errors import SimkitError


class GraphError(SimkitError):
    """A name is not legal, a node does not exist any more, an endpoint was used after its end."""


class RosCommandError(GraphError, ValueError):
    """A command line of ROS (remapping, private parameter, ...) cannot be read."""
