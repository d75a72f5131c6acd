"""Where a script runs: a process of its own, in lockstep with virtual time.

`protocol` is what both sides say; `start`, `zygote`, `spawned` and `child` bring a process to life. The node's side:
`line`, `node_client`, `scheduler`, `virtual_time`; `client` hands them to rospy. The graph's side: `link`, `turns`,
`script_node`, and `requests` with those of topics, services, parameters and rosout.
"""

from simkit.graph.process.failure import NodeFailure
from simkit.graph.process.limits import NodeLimits
from simkit.graph.process.permissions import Permissions
from simkit.graph.process.runtime import NodeRuntime, shared_runtime
from simkit.graph.process.script_node import ScriptNode
from simkit.graph.process.spec import StartSpec
from simkit.graph.process.start import StartError

__all__ = [
    "NodeFailure",
    "NodeLimits",
    "NodeRuntime",
    "Permissions",
    "ScriptNode",
    "StartError",
    "StartSpec",
    "shared_runtime",
]
