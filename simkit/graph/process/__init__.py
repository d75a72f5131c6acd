"""Where a script runs: a process of its own, in lockstep with virtual time.

`protocol` is what both sides say; `starters` and `child` bring a process to life, forked by a `fork_server` (`zygote`)
where there is one. The node's side: `node_client`, `scheduler`, `virtual_time`; `client` hands them to rospy. The
graph's side: `link`, `turns`, `script_node`, and `requests` with those of topics and services.
"""

from simkit.graph.process.failure import NodeFailure
from simkit.graph.process.fork_server import (
    HAS_FORK,
    ForkServer,
    StartError,
    clean_environment,
    each_request,
    fork_task,
    python_command,
    share_memory,
)
from simkit.graph.process.process_tree import (
    become_reaper,
    descendants,
    end_tree,
    end_with_parent,
)
from simkit.graph.process.runtime import NodeRuntime, shared_runtime
from simkit.graph.process.script_node import ScriptNode
from simkit.graph.process.spec import NodeLimits, Permissions, StartSpec

__all__ = [
    "HAS_FORK",
    "ForkServer",
    "NodeFailure",
    "NodeLimits",
    "NodeRuntime",
    "Permissions",
    "ScriptNode",
    "StartError",
    "StartSpec",
    "become_reaper",
    "clean_environment",
    "descendants",
    "each_request",
    "end_tree",
    "end_with_parent",
    "fork_task",
    "python_command",
    "share_memory",
    "shared_runtime",
]
