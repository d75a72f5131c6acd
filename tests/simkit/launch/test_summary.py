"""What is printed of a plan: the summary, and the lists of the options."""

import pytest

from simkit.errors import SimkitError
from simkit.launch import summary_of
from simkit.launch.summary import (
    arguments_text,
    command_of_node_text,
    file_of_node_text,
    files_text,
    nodes_text,
    params_text,
)

INNER = """
    <arg name="who" default="me" doc="who it is"/> <arg name="what"/> <arg name="so" default=""/>
    <param name="robot_description" value="&lt;?xml version=&quot;1.0&quot;?&gt; and so on"/>
    <param name="lines" type="yaml" value="&quot;a\\nb&quot;"/> <param name="b" value="true"/>
    <param name="a" value="1.50"/>
    <group ns="g" clear_params="true"><node name="z" pkg="play" type="talker.py"/></group>
    <node name="b" pkg="play" type="talker.py" args="x 'y z'"><remap from="in" to="out"/>
      <env name="MODE" value="fast"/></node>
    <node name="a" pkg="turtlesim" type="turtlesim_node"/>
    """


@pytest.fixture
def found(plan):
    return plan(INNER)


def test_the_summary_has_the_shape_of_the_original(found):
    assert summary_of(found) == (
        "SUMMARY\n========\n\nCLEAR PARAMETERS\n * /g/\n\nPARAMETERS\n * /a: 1.5\n * /b: True\n"
        ' * /lines: <...>\n * /robot_description: <?xml version="1....\n\n'
        "NODES\n  /g/\n    z (play/talker.py)\n  /\n    a (turtlesim/turtlesim_node)\n"
        "    b (play/talker.py)\n"
    )


def test_a_file_with_nothing_in_it(plan):
    assert summary_of(plan("")) == "SUMMARY\n========\n\nNODES\n"


def test_lists(found, write, packages, package):
    package("talker.py", "")
    assert nodes_text(found) == "/g/z\n/b\n/a\n"
    assert files_text(found) == f"{write.folder}/a.launch\n"
    assert params_text(found) == (
        "/a: 1.5\n/b: true\n/lines: 'a\n\n  b'\n/robot_description: <?xml version=\"1.0\"?> and so on\n\n"
    )
    assert arguments_text(found) == (
        "Required Arguments:\n  what: undocumented\nOptional Arguments:\n"
        '  so (default ""): undocumented\n  who (default "me"): who it is\n'
    )
    assert file_of_node_text(found, "b") == f"{write.folder}/a.launch\n"
    script = write.folder / "scripts/talker.py"
    assert command_of_node_text(found, "/b", packages) == (
        f"MODE=fast {script} x y z in:=out __name:=b\n"
    )
    assert command_of_node_text(found, "g/z", packages) == (
        f"ROS_NAMESPACE=/g {script} __name:=z\n"
    )
    assert command_of_node_text(found, "a", packages) == "turtlesim/turtlesim_node __name:=a\n"


def test_an_empty_value_is_a_value(plan):
    found = plan('<arg name="a" value=""/><arg name="b" default=""/><arg name="c"/>')
    assert [one.name for one in found.arguments] == ["b", "c"]


def test_no_arguments(plan):
    assert arguments_text(plan("")) == "No arguments.\n"


def test_a_node_that_is_not_there(found):
    with pytest.raises(SimkitError) as caught:
        file_of_node_text(found, "bb")
    assert str(caught.value).startswith("ERROR: Cannot find node named [/bb] in [")
    assert str(caught.value).endswith("Node names are:\n * /g/z\n * /b\n * /a\ndid you mean /b?")
