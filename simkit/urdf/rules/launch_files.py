"""Rules on launch files beside a URDF: are they XML, and do their nodes fit the robot and each other?"""

from __future__ import annotations

from collections.abc import Iterator

from simkit.diagnostics import Diagnostic, Related, Rule, Severity
from simkit.urdf.rules.companion import CompanionKind
from simkit.urdf.rules.launch_facts import LaunchFile, launch_files
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.wording import quoted
from simkit.xml import Span

_PLUGIN = "libgazebo_ros_joint_state_publisher.so"
_CONTROLLER = "joint_state_controller/JointStateController"


def launch_xml(sheet: Sheet) -> Iterator[Diagnostic]:
    """A launch file is not well-formed XML.

    Symptom: `RLException: Invalid roslaunch XML syntax`, and nothing is started.

    Cause: A tag that is not closed, a quotation mark that is missing, a stray `>`, `--` in a comment.

    Remedy: The place is named here; roslaunch names the place where its parser gave up, which may be far below.

    Right:

        <rosparam file="$(find hello_ros)/urdf/controllers_simple.yaml" command="load"/>
    """
    for launch in launch_files(sheet):
        for fault in launch.document.faults:
            yield Diagnostic(
                rule="LCH-E04",
                severity=Severity.ERROR,
                file=launch.companion.file,
                span=fault.span,
                source=launch.document.line(fault.span.line),
                what=fault.what,
                here="simkit roslaunch refuses the file.",
                gazebo="roslaunch refuses the file: Invalid roslaunch XML syntax.",
                remedy=fault.remedy,
                related=() if fault.other is None else (_other(launch, fault.other),),
            )


def old_gui_switch(sheet: Sheet) -> Iterator[Diagnostic]:
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
            yield sheet.find(
                "LCH-W05",
                Severity.NOTE,
                parameter,
                companion=launch.companion,
                what="use_gui is a switch of ROS Melodic",
                here="simkit shows the sliders, as Melodic does.",
                gazebo="Melodic opens the window with a warning; Noetic ignores the switch, and no sliders appear.",
                remedy="For Noetic start the node joint_state_publisher_gui of the package joint_state_publisher_gui.",
            )


def two_joint_states(sheet: Sheet) -> Iterator[Diagnostic]:
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
        sheet.related(one.element, "the plugin") for one in sheet.plugins if one.filename == _PLUGIN
    ] + [
        Related(file=one.file, span=Span(1, 1), text=f"has a {_CONTROLLER}")
        for one in sheet.companions
        if one.kind is CompanionKind.YAML and _CONTROLLER in one.text
    ]
    for launch in launch_files(sheet):
        spawns = any(node.get("type") == "spawn_model" for node in launch.nodes)
        for node in launch.nodes:
            if (node.get("type") or "").startswith("joint_state_publisher") and told and spawns:
                yield sheet.find(
                    "CTL-W07",
                    Severity.WARNING,
                    node,
                    companion=launch.companion,
                    what=f"node {quoted(node.get('name'))} and the simulation both publish /joint_states",
                    here="The robot jumps between two poses in the view.",
                    gazebo="RViz shows the robot jumping between two poses.",
                    remedy="Leave the node out when the robot is simulated: the simulation knows where the joints are.",
                    related=told[:1],
                )


def _other(launch: LaunchFile, span: Span) -> Related:
    source = launch.document.line(span.line)
    return Related(file=launch.companion.file, span=span, text="it belongs to this", source=source)


RULES = (
    Rule(
        id="LCH-E04",
        title="a launch file that is not well-formed",
        severity=Severity.ERROR,
        look=launch_xml,
    ),
    Rule(
        id="LCH-W05",
        title="use_gui, which ROS Noetic ignores",
        severity=Severity.NOTE,
        look=old_gui_switch,
    ),
    Rule(
        id="CTL-W07",
        title="two publishers of joint states",
        severity=Severity.WARNING,
        look=two_joint_states,
    ),
)
