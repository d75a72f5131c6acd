"""The ROS graph: nodes, topics, services, parameters and names, on one virtual clock.

Read it in this order: `executor` (time), `topics`, `services`, `params`, `names`, `node`, `graph`; then `process`, where a
student's script becomes a node in a process of its own.
"""

from simkit.graph.errors import GraphError, RosCommandError
from simkit.graph.executor import Executor, ScheduledEvent
from simkit.graph.graph import Graph
from simkit.graph.log import LogLevel, LogRecord
from simkit.graph.node import Node, Timer
from simkit.graph.params import ParameterServer
from simkit.graph.services import ServiceFailed, ServiceServer
from simkit.graph.topic_hints import unmatched_topics
from simkit.graph.topics import Publisher, Subscription

__all__ = [
    "Executor",
    "Graph",
    "GraphError",
    "LogLevel",
    "LogRecord",
    "Node",
    "ParameterServer",
    "Publisher",
    "RosCommandError",
    "ScheduledEvent",
    "ServiceFailed",
    "ServiceServer",
    "Subscription",
    "Timer",
    "unmatched_topics",
]
