"""What an exercise allows, in sentences."""

from simkit.graph.process import Permissions


def test_anything_goes_unless_something_is_said():
    may = Permissions()
    assert may.refuse_node("rostopic", "rostopic") is None
    assert may.refuse_parameter("/x", "/node") is None
    assert may.refuse_publishing("/x") is None


def test_built_in_nodes_are_named_by_package_and_program():
    may = Permissions(nodes=("turtlesim/*", "rviz/rviz"))
    assert may.refuse_node("turtlesim", "turtlesim_node") is None
    assert may.refuse_node("rostopic", "rostopic") == (
        "this launch file starts rostopic/rostopic, which this exercise does not allow "
        "(only turtlesim/*, rviz/rviz)"
    )
    assert "(none at all)" in Permissions(nodes=()).refuse_node("tf", "tf_echo")


def test_private_parameters_of_any_of_the_nodes_are_theirs():
    may = Permissions(parameters=("/robot_description",))
    assert may.refuse_parameter("/a/x", "/a", "/b") is None
    assert may.refuse_parameter("/b/x/y", "/a", "/b") is None
    assert may.refuse_parameter("/robot_description", "/a") is None
    assert may.refuse_parameter("/c/x", "/a", "/b", who="this launch file") == (
        "this launch file sets the parameter /c/x, which this exercise does not allow "
        "(only /robot_description)"
    )
    assert may.refuse_parameter("/ab", "/a") is not None
    assert may.refuse_parameter("/x") is not None
