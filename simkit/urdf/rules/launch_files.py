"""Rules on launch files beside a URDF: are they XML, and do their nodes fit the robot and each other?"""

from __future__ import annotations

from collections.abc import Iterator

from simkit.diagnostics import Find, Related, Severity, rule
from simkit.diagnostics.table import related
from simkit.urdf.rules.companion import CompanionKind
from simkit.urdf.rules.launch_facts import launch_files
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.wording import quoted
from simkit.xml import Span

_PLUGIN = "libgazebo_ros_joint_state_publisher.so"
_CONTROLLER = "joint_state_controller/JointStateController"


@rule(
    "LCH-E04",
    "a launch file that is not well-formed",
    Severity.ERROR,
    here="simkit roslaunch refuses the file.",
    gazebo="roslaunch refuses the file: Invalid roslaunch XML syntax.",
)
def launch_xml(sheet: Sheet) -> Iterator[Find]:
    """A launch file is not well-formed XML.

    Symptom: `RLException: Invalid roslaunch XML syntax`, and nothing is started.

    Cause: A tag that is not closed, a quotation mark that is missing, a stray `>`, `--` in a comment.

    Remedy: The place is named here; roslaunch names the place where its parser gave up, which may be far below.

    Right:

        <rosparam file="$(find hello_ros)/urdf/controllers_simple.yaml" command="load"/>
    """
    for launch in launch_files(sheet):
        for fault in launch.document.faults:
            yield Find(
                fault.span,
                companion=launch.companion,
                what=fault.what,
                remedy=fault.remedy,
                related=() if fault.other is None else [(fault.other, "it belongs to this")],
            )


@rule(
    "LCH-W05",
    "use_gui, which ROS Noetic ignores",
    Severity.NOTE,
    here="simkit shows the sliders, as Melodic does.",
    gazebo="Melodic opens the window with a warning; Noetic ignores the switch, and no sliders appear.",
    remedy="For Noetic start the node joint_state_publisher_gui of the package joint_state_publisher_gui.",
)
def old_gui_switch(sheet: Sheet) -> Iterator[Find]:
    """`use_gui` asks joint_state_publisher for sliders.

    Symptom: In ROS Noetic no window with sliders opens.

    Cause: Melodic's joint_state_publisher opened the window when `use_gui` was true, and warned that this would go away.
    Noetic's does not read it: the sliders are a node of their own.

    Remedy: Start `joint_state_publisher_gui` instead. Here both work.

    Right:

        <node name="joint_state_publisher_gui" pkg="joint_state_publisher_gui" type="joint_state_publisher_gui"/>
    """
    for launch in launch_files(sheet):
        every = [] if launch.document.root is None else list(launch.document.root.walk())
        for parameter in every:
            if parameter.name != "param" or (parameter.get("name") or "").lstrip("/~") != "use_gui":
                continue
            yield Find(
                parameter,
                companion=launch.companion,
                what="use_gui is a switch of ROS Melodic",
            )


@rule(
    "CTL-W07",
    "two publishers of joint states",
    Severity.WARNING,
    here="The robot jumps between two poses in the view.",
    gazebo="RViz shows the robot jumping between two poses.",
    remedy="Leave the node out when the robot is simulated: the simulation knows where the joints are.",
)
def two_joint_states(sheet: Sheet) -> Iterator[Find]:
    """Two nodes publish the positions of the joints.

    Symptom: In RViz the robot flickers between two poses.

    Cause: The simulation publishes `/joint_states` (by a plugin, or by a JointStateController), and so does
    joint_state_publisher with its sliders. Each says where the joints are, and they disagree.

    Remedy: One of them. With a simulation leave joint_state_publisher out; robot_state_publisher stays.

    Right:

        <gazebo>
          <plugin name="joint_state_publisher" filename="libgazebo_ros_joint_state_publisher.so">
            <jointName>hip, shoulder</jointName>
          </plugin>
        </gazebo>
    """
    told = [
        related(one.element, "the plugin", sheet.document)
        for one in sheet.plugins
        if one.filename == _PLUGIN
    ]
    told += [
        Related(file=one.file, span=Span(1, 1), text=f"has a {_CONTROLLER}")
        for one in sheet.companions
        if one.kind is CompanionKind.YAML and _CONTROLLER in one.text
    ]
    for launch in launch_files(sheet):
        spawns = any(node.get("type") == "spawn_model" for node in launch.nodes)
        for node in launch.nodes:
            if (node.get("type") or "").startswith("joint_state_publisher") and told and spawns:
                yield Find(
                    node,
                    companion=launch.companion,
                    what=f"node {quoted(node.get('name'))} and the simulation both publish /joint_states",
                    related=told[:1],
                )
