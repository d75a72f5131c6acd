"""What a message of ros_control does not tell: which of several places is the wrong one."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping

from simkit.errors import near_names
from simkit.graph.params import ParameterServer
from simkit.plugins.control.interfaces import FAMILIES, PREFIX


def missing_joint(
    name: str,
    *,
    controller: str,
    type_name: str,
    wanted: str,
    offered: Mapping[str, str],
    types: Collection[str],
) -> str:
    """Why a controller cannot have a joint: its transmission, the YAML file, or the type does not fit.

    Args:
        name: The joint that it asks for.
        controller: Its name.
        type_name: Its type.
        wanted: The interface that this type needs.
        offered: The interface of each joint that has a transmission.
        types: All types of controllers.
    """
    if name in offered:
        text = (
            f"the transmission of {name} offers {offered[name]}, and {type_name} needs {wanted}: "
            f"write {PREFIX}{wanted} in the transmission"
        )
        other = f"{FAMILIES[offered[name]]}/{type_name.rpartition('/')[2]}"
        return f"{text}, or type: {other} in the YAML file" if other in types else text
    near = near_names(name, offered)
    if near:
        return (
            f"no transmission is for {name}; did you mean {near[0]}? The name in the joints of "
            f"{controller} and the one in <transmission><joint name=...> must be the same"
        )
    there = f"; there are transmissions for: {', '.join(offered)}" if offered else ""
    return (
        f"no transmission is for {name}: add a <transmission> to the URDF with <joint name={name!r}> "
        f"and <hardwareInterface>{PREFIX}{wanted}</hardwareInterface> in it{there}"
    )


def missing_type(params: ParameterServer, root: str, name: str) -> str:
    """Why there is no type for a controller on the parameter server.

    Args:
        params: The parameters.
        root: Namespace of the controller manager, without a slash at its end.
        name: The controller.
    """
    here = params.get(root or "/", {})
    known = controllers_in(here) if isinstance(here, dict) else []
    near = near_names(name, known)
    if near:
        return (
            f"there are parameters for {near[0]}, and none for {name}: the name in the YAML file and "
            "the one given to the spawner must be the same"
        )
    there = f"; there are parameters for: {', '.join(known)}" if known else ""
    return (
        f"nobody has set {root}/{name}/type: load the YAML file before, with "
        f'<rosparam file="..." command="load"/> in the launch file{there}'
    )


def controllers_in(tree: Mapping[str, object]) -> list[str]:
    """Names of the namespaces that look like controllers."""
    return sorted(
        name for name, value in tree.items() if isinstance(value, dict) and "type" in value
    )


def unknown_type(type_name: str, known: Iterable[str]) -> str:
    """Which type may be meant by one that does not exist."""
    near = near_names(type_name, known)
    return f"did you mean {near[0]}?" if near else f"there are: {', '.join(sorted(known))}"
