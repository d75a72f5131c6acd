"""The rows of world files in the table of diagnostics: faults that are met while a world is read."""

from __future__ import annotations

from simkit.diagnostics import Rule, Severity

SYNTAX = "SDF-E01"
"""A file that is not XML."""
UNUSABLE = "SDF-E02"
"""Something without which there is no world."""
NO_MASS = "SDF-I03"
"""A link without a mass."""
UNSUPPORTED = "SDF-W04"
"""An element that is not read."""
NUMBER = "SDF-W05"
"""A number that cannot be read."""

ROWS = (
    Rule(
        SYNTAX,
        "a world or model file that is not well-formed XML",
        Severity.ERROR,
        """\
    A world file, or a model that it includes, is not XML.

    Symptom: Gazebo prints `Error [parser.cc]` and opens an empty world, or none.

    Cause: A tag that is not closed, a quotation mark that is missing, a stray `>`, `--` in a comment.

    Remedy: Mend the place that is named; the faults behind it may be gone then, too.

    Right:

        <include>
          <uri>model://sun</uri>
        </include>
    """,
    ),
    Rule(
        UNUSABLE,
        "a world or model file that cannot be used",
        Severity.ERROR,
        """\
    Something is wrong in a world or model file without which there is no world.

    Symptom: The world does not begin, and the message names the place.

    Cause: No `<sdf>` with a version, no `<world>` or `<model>` in it, two models of one name, a model that is not found or
    includes itself.

    Remedy: Do what the message says. A world file begins as below.

    Right:

        <sdf version="1.6">
          <world name="default">
            <include><uri>model://ground_plane</uri></include>
          </world>
        </sdf>
    """,
    ),
    Rule(
        NO_MASS,
        "a link of a world file without a mass",
        Severity.NOTE,
        """\
    A link of a model that can move says nothing of its mass.

    Symptom: A thing of the world is far too heavy or too light.

    Cause: Without `<inertial>` SDF gives a link 1 kg and 1 kg m^2 about each axis, however large it is.

    Remedy: Give it mass and inertia, or make the model `<static>` if it never moves.

    Right:

        <inertial>
          <mass>0.5</mass>
          <inertia><ixx>0.002</ixx><iyy>0.002</iyy><izz>0.002</izz></inertia>
        </inertial>
    """,
    ),
    Rule(
        UNSUPPORTED,
        "an element of a world file that is not supported",
        Severity.WARNING,
        """\
    A world file has something that this kit does not read.

    Symptom: It is missing from the world, or has no effect; the rest works.

    Cause: A slip in the name, or a part of SDF that Gazebo knows and this kit does not: actors, height maps, wind, most plugins
    of worlds.

    Remedy: Write the name that the message proposes, or leave the element out.

    Right:

        <model name="box">
          <static>true</static>
          <link name="link">
            <collision name="c"><geometry><box><size>1 1 1</size></box></geometry></collision>
          </link>
        </model>
    """,
    ),
    Rule(
        NUMBER,
        "a number in a world file that cannot be read",
        Severity.WARNING,
        """\
    An element of a world file should hold numbers, and holds something else, too few, too many, or one beyond all use.

    Symptom: The default is used in its place.

    Cause: Commas between the numbers (SDF wants blanks), a unit behind one, a `<size>` of two numbers, a step of a second.

    Remedy: Write as many numbers as the message says, in metres, kilograms, seconds and radians.

    Right:

        <pose>1 0 0.5 0 0 1.5708</pose>
        <size>1 2 0.5</size>
    """,
    ),
)
"""The rows, in the order of their numbers."""
