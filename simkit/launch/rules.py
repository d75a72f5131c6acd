"""The rows of launch files in the table of diagnostics: a stable id for each kind of fault, and what there is to know of it.

Those that can be seen without launching (`LCH-E02`, `LCH-E03`, `LCH-E04`, `LCH-W05`, `LCH-I15`) have their rows beside the
generators that look for them, in `simkit.urdf.rules`.
"""

from __future__ import annotations

from simkit.diagnostics import Rule, Severity

NOT_FOUND = "LCH-E01"
"""The launch file or its package cannot be found."""
COMMAND = "LCH-E02"
"""The `command=` of a parameter fails."""
DESCRIPTION = "LCH-E03"
"""A node needs the description of a robot, and nobody has set it."""
SYNTAX = "LCH-E04"
"""The launch file is not XML, or has no `<launch>`."""
USE_GUI = "LCH-W05"
"""`use_gui`, which newer ROS ignores."""
SUBSTITUTION = "LCH-E06"
"""A `$(...)` that cannot be replaced."""
ATTRIBUTE = "LCH-E07"
"""An attribute is missing, or has a value that makes no sense."""
FILE = "LCH-E08"
"""A file cannot be read."""
YAML = "LCH-E09"
"""YAML cannot be read, or has values that ROS cannot take."""
TOO_MUCH = "LCH-E10"
"""The launch file has no end, or asks for too much."""
UNKNOWN = "LCH-W11"
"""A tag or attribute that nobody knows, and that is ignored."""
NO_EFFECT = "LCH-W12"
"""Something that has no effect here."""
ARGUMENT = "LCH-E13"
"""An argument is declared or given wrongly."""
UNUSED_ARGUMENT = "LCH-W14"
"""An argument is given, and nobody takes it."""
STRAY_TEXT = "LCH-W16"
"""Text between tags, which nobody reads."""

ROWS = (
    Rule(
        NOT_FOUND,
        "a launch file or package that cannot be found",
        Severity.ERROR,
        """\
    The launch file, or the package that has it, is not there.

    Symptom: `[x.launch] is neither a launch file in package [p] nor is [p] a launch file name`.

    Cause: A slip in one of the two names; a terminal in another folder than the one that holds the packages; a folder
    without `package.xml`, which is no package.

    Remedy: `simkit rospack list` shows the packages that are found from here. A path works as well.

    Right:

        simkit roslaunch hello_ros urdf_launch_1.launch
        simkit roslaunch hello_ros/launch/urdf_launch_1.launch
    """,
    ),
    Rule(
        SUBSTITUTION,
        "a $(...) that cannot be replaced",
        Severity.ERROR,
        """\
    A `$(...)` in an attribute stands for nothing.

    Symptom: `Resource not found`, `requires the 'x' arg to be set`, `Unknown substitution command`.

    Cause: `$(find ...)` of a package that is not there, `$(arg ...)` of an argument that was not declared above or has no
    value, `$(env ...)` of a variable that is not set, `$(eval ...)` with a slip in its expression.

    Remedy: Declare each argument with a default in front of its first use. `$(eval ...)` must be the whole value. Nothing is
    replaced inside of a `<rosparam>` without `subst_value="true"`.

    Right:

        <arg name="speed" default="2"/>
        <param name="double_speed" value="$(eval 2 * speed)"/>
        <param name="robot_description" textfile="$(find hello_ros)/urdf/hello_ros_robot_1.urdf"/>
    """,
    ),
    Rule(
        ATTRIBUTE,
        "an attribute that is missing, or makes no sense",
        Severity.ERROR,
        """\
    A tag lacks an attribute that it needs, or has one whose value cannot be used.

    Symptom: `tag is missing required attribute`, `Invalid <param> tag`, `Invalid <node> tag`, two nodes of one name.

    Cause: A `<node>` needs `pkg`, `type` and `name`; a `<param>` a `name` and one source; a `<remap>` `from` and `to`.
    `if` and `unless` take true, false, 1 and 0, but `respawn` and `required` only true and false.

    Remedy: Write what the message names. Names have letters, digits and `_`, and begin with a letter; a namespace goes into
    `ns="..."`, not into `name`.

    Right:

        <node pkg="turtlesim" type="turtlesim_node" name="sim" output="screen" respawn="true"/>
    """,
    ),
    Rule(
        FILE,
        "a file that cannot be read",
        Severity.ERROR,
        """\
    A file that the launch file names is not there, or is no text.

    Symptom: `No such file or directory`, `file does not exist`.

    Cause: A slip in the path; a path that begins in the folder of the terminal and not in the package; a file that was not
    saved in UTF-8. A launch file that is graded reads nothing outside of the packages that were handed in.

    Remedy: Begin every path with `$(find PACKAGE)`. Upper and lower case letters differ.

    Right:

        <param name="robot_description" textfile="$(find hello_ros)/urdf/hello_ros_robot_1.urdf"/>
    """,
    ),
    Rule(
        YAML,
        "YAML that cannot be read, or is no parameter",
        Severity.ERROR,
        """\
    The YAML of a `<rosparam>`, or in a file that it loads, cannot be used.

    Symptom: `Error within YAML block`, `contains invalid YAML`, `'param' attribute must be set`.

    Cause: No blank behind a colon (`speed:1` is one word), a tab in front of a name, a bracket that is not closed, an empty
    value, a number beyond 32 bits, a date, a name that is a number.

    Remedy: One `name: value` a line, nested with two blanks. Texts that look like something else go into quotation marks.
    Angles may be written `deg(90)` and `rad(pi/2)`.

    Right:

        <rosparam>
          gains: {p: 10.0, i: 0.5}
          limit: deg(90)
        </rosparam>
    """,
    ),
    Rule(
        TOO_MUCH,
        "a launch file without end",
        Severity.ERROR,
        """\
    Launch files include each other in a circle, or come to more than any robot needs.

    Symptom: `maximum recursion depth exceeded` in ROS; here the place of the `<include>` that closes the circle.

    Cause: A file that includes itself, perhaps by way of others; a copy of an include in the file that it names. There are
    bounds here too: 10,000 tags, 300 files, 25 files in a chain, values of 100,000 characters.

    Remedy: Remove one include of the circle, or let an argument end it.

    Right:

        <arg name="with_world" default="true"/>
        <include file="$(find gazebo_ros)/launch/empty_world.launch" if="$(arg with_world)"/>
    """,
    ),
    Rule(
        UNKNOWN,
        "a tag or attribute that nobody knows",
        Severity.WARNING,
        """\
    A tag or attribute is not one of roslaunch's, and is ignored, with all that stands in it.

    Symptom: `WARNING: unrecognized tag`, `unknown <param> attribute`; a node that does not start, a parameter that is not set.

    Cause: Mostly a slip (`<nod>`, `valu=`), or a word of another kind of file: a URDF's `<link>`, a ROS 2 launch file's `exec=`.
    Upper case counts: `<Node>` is no `<node>`.

    Remedy: Write the word that the message proposes.

    Right:

        <node pkg="turtlesim" type="turtlesim_node" name="sim"/>
        <param name="speed" value="1.5"/>
    """,
    ),
    Rule(
        NO_EFFECT,
        "something that has no effect here",
        Severity.WARNING,
        """\
    The launch file asks for something that counts in ROS, and changes nothing in this kit.

    Symptom: None; the rest of the file works.

    Cause: `<machine>` spreads nodes over computers, and here all run in one simulation. `launch-prefix` runs a node under another
    program, such as a debugger. `<env>` sets variables that scripts do not see here, so that a result depends on nothing but
    its files.

    Remedy: Leave it in if the file is for ROS, too. What a node must know belongs into a parameter.

    Right:

        <node pkg="hello_ros" type="listener.py" name="listener">
          <param name="verbose" value="true"/>
        </node>
    """,
    ),
    Rule(
        ARGUMENT,
        "an argument that is declared or given wrongly",
        Severity.ERROR,
        """\
    An `<arg>` is declared twice, or given where it cannot be.

    Symptom: `has already been declared`, `cannot override arg`, `unused args`, `include args must have declared values`.

    Cause: `value="..."` fixes an argument for good, `default="..."` lets others set it. An `<arg>` in an `<include>` must be
    declared in the included file. On a command line an argument is `name:=value`, with `:=` and without blanks.

    Remedy: Declare each argument once, near the top, with a default.

    Right:

        <arg name="robot" default="m2wr"/>
        <include file="$(find my_robot)/launch/spawn.launch">
          <arg name="model" value="$(arg robot)"/>
        </include>
    """,
    ),
    Rule(
        UNUSED_ARGUMENT,
        "an argument that nobody takes",
        Severity.WARNING,
        """\
    An argument was given on the command line, and the launch file declares none of that name.

    Symptom: The default is used, and ROS says nothing.

    Cause: A slip in the name, or an argument of an included file, which the outer file does not hand on.

    Remedy: `simkit roslaunch --ros-args PACKAGE FILE` lists the arguments that there are. To hand one on, declare it, and name it
    in the `<include>`.

    Right:

        simkit roslaunch gazebo_ros empty_world.launch paused:=true
    """,
    ),
    Rule(
        STRAY_TEXT,
        "text between tags, which nobody reads",
        Severity.WARNING,
        """\
    Text stands where only tags are read.

    Symptom: None in ROS, which ignores it: but something that was meant does not happen.

    Cause: A second `>` at the end of a tag, a comment without `<!--` and `-->`, a value that belongs into `value="..."`. Only a
    `<rosparam>` has text of its own.

    Remedy: Remove it, or make a comment or an attribute of it.

    Right:

        <!-- the speed in metres per second -->
        <param name="speed" value="1.5"/>
    """,
    ),
)
"""The rows of faults that are met while a launch file is evaluated, in the order of their numbers."""
