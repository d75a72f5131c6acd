"""`$(...)` in attributes."""

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from simkit.launch import LaunchError, evaluate
from simkit.packages import PackagePath

NOWHERE = PackagePath([])


def value_of(text, packages=NOWHERE, environment=None, arguments=""):
    """What a text in an attribute comes to."""
    quoted = text.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")
    inner = f'{arguments}<param name="v" type="str" value="{quoted}"/>'
    plan = evaluate(f"<launch>{inner}</launch>", packages=packages, environment=environment or {})
    return plan.params["/v"]


def test_each_command(packages, write):
    folder = str(write.folder)
    known = {"HOME": "/h", "X": "1"}
    arguments = '<arg name="a" value="1"/><arg name="b" value="$(arg a)2"/>'
    table = {
        "$(find play)": folder,
        "$(find play)/urdf/x.urdf": f"{folder}/urdf/x.urdf",
        "$(find\nplay)/x": f"{folder}/x",
        "x $(find  play )/y z": f"x {folder}/y z",
        "$(find play)x": f"{folder}/x",
        "$(find play) $(find play)": f"{folder} {folder}",
        "$(env HOME)/$(env X)": "/h/1",
        "$(optenv HOME no)": "/h",
        "$(optenv NOPE a b  c)": "a b c",
        "$(optenv NOPE)": "",
        "$(arg b)-$(arg a)": "12-1",
        "$(anon x) $(anon x) $(anon y)": "x_1 x_1 y_1",
        "$(find play": "$(find play",
        "$HOME $$ $( )$": None,
        "a $(eval 1 + 1)": None,
        "no $ here": "no $ here",
        "$()": "$()",
        "$$(arg a)": "$1",
    }
    for text, value in table.items():
        if value is None:
            with pytest.raises(LaunchError, match="Unknown substitution command"):
                value_of(text, packages, known, arguments)
        else:
            assert value_of(text, packages, known, arguments) == value, text


def test_what_find_follows_may_come_out_of_an_argument(packages, write):
    arguments = "<arg name='file' default='$(find play)/a'/>"
    assert value_of("$(arg file).urdf", packages, None, arguments) == f"{write.folder}/a.urdf"
    plan = evaluate(
        "<launch><arg name='f'/><param name='v' value='$(arg f)'/></launch>",
        packages=packages,
        arguments={"f": "$(find play)/b"},
    )
    assert plan.params["/v"] == f"{write.folder}/b"


def test_dirname_is_the_folder_of_the_file(plan, write):
    write("launch/in.launch", '<launch><param name="inner" value="$(dirname)"/></launch>')
    found = plan(
        '<param name="outer" value="$(dirname)"/><include file="$(dirname)/launch/in.launch"/>'
    )
    folder = str(write.folder)
    assert dict(found.params) == {"/outer": folder, "/inner": f"{folder}/launch"}


def test_the_environment_is_that_of_the_process_unless_one_is_given(monkeypatch):
    monkeypatch.setenv("SIMKIT_TEST_MOOD", "fine")
    text = "<launch><param name='v' value='$(env SIMKIT_TEST_MOOD)'/></launch>"
    assert evaluate(text, packages=NOWHERE).params["/v"] == "fine"
    with pytest.raises(LaunchError, match="'SIMKIT_TEST_MOOD' is not set"):
        evaluate(text, packages=NOWHERE, environment={})


def test_a_package_of_the_kit_has_no_folder():
    with pytest.raises(LaunchError) as caught:
        value_of("$(find turtlesim)/launch/x.launch")
    assert caught.value.said == "Resource not found: turtlesim"
    assert "comes with simkit as built-in nodes" in caught.value.diagnostic.what
    with pytest.raises(LaunchError, match="of which simkit has no files"):
        value_of("$(find gazebo_plugins)/launch/x.launch")


def test_a_package_of_which_the_kit_has_files_has_a_folder():
    assert Path(value_of("$(find gazebo_ros)/launch/empty_world.launch")).is_file()


def test_names_for_anonymous_nodes_can_be_given_from_outside():
    text = "<launch><param name='v' value='$(anon a) $(anon b) $(anon a)'/></launch>"
    found = evaluate(text, packages=NOWHERE, anonymous=lambda identity: f"{identity}_of_ours")
    assert found.params["/v"] == "a_of_ours b_of_ours a_of_ours"


WORDS = st.text("abc $()\n _/.-", max_size=40)
PLAIN = st.text(
    st.characters(min_codepoint=32, max_codepoint=0x2FF, exclude_characters="$"), max_size=40
)


@given(PLAIN)
def test_a_text_without_a_dollar_is_itself(text):
    assert value_of(text) == text.strip()


@given(PLAIN, PLAIN, st.sampled_from(["a", "long_name"]))
def test_an_argument_is_replaced_by_its_value(before, value, name):
    plan = evaluate(
        f"<launch><arg name='{name}'/><param name='v' type='str' value='|$(arg {name})|'/></launch>",
        packages=NOWHERE,
        arguments={name: value},
    )
    assert plan.params["/v"] == f"|{value}|"


@settings(max_examples=300)
@given(WORDS)
def test_any_text_has_a_value_or_a_clear_error(text):
    told = ""
    try:
        told = "value " + value_of(text, NOWHERE, {"abc": "1"}, "<arg name='a' value='b'/>")
    except LaunchError as error:
        told = error.remedy
    assert told
