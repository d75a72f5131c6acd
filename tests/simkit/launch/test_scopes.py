"""Groups, includes, conditions, remappings: what holds where."""

import pytest

from simkit.launch import LaunchError

NODE = '<node name="{}" pkg="p" type="x"/>'


def node(found, name):
    return next(one for one in found.nodes if one.name == name)


def test_nodes_have_all_their_attributes(plan):
    (found,) = plan(
        """<arg name="n" default="3"/>
        <node name="a$(arg n)" pkg="p" type="x.py" args="_x:=$(arg n) 'a b'" ns="robots/one"
          output="screen" respawn="True" respawn_delay="2.5" launch-prefix="nice" cwd="node"/>"""
    ).nodes
    assert found.resolved_name == "/robots/one/a3"
    assert (found.package, found.type, found.args) == ("p", "x.py", "_x:=3 'a b'")
    assert (found.output, found.respawn, found.respawn_delay) == ("screen", True, 2.5)
    assert (found.required, found.launch_prefix) == (False, "nice")
    assert (found.shown_file, found.span.line) == ("play/a.launch", 2)


def test_nodes_stand_in_the_order_of_the_file(plan):
    found = plan(f'{NODE.format("c")}<group ns="g">{NODE.format("b")}</group>{NODE.format("a")}')
    assert [one.resolved_name for one in found.nodes] == ["/c", "/g/b", "/a"]


@pytest.mark.parametrize(
    ("condition", "counts"),
    [
        ('if="1"', True),
        ('if="true"', True),
        ('if="FALSE"', False),
        ('if="0"', False),
        ('unless="0"', True),
        ('unless="True"', False),
        ('if="$(arg yes)"', True),
        ("unless=\"$(eval arg('yes'))\"", False),
        ("if=\"$(eval mode == 'sim')\"", True),
        ("", True),
    ],
)
@pytest.mark.parametrize(
    "tag",
    [
        '<param name="p" value="1" {}/>',
        "<rosparam {}>p: 1</rosparam>",
        '<node name="n" pkg="p" type="x" {}/>',
        '<group {}><param name="p" value="1"/></group>',
        '<include file="$(find play)/b.launch" {}/>',
    ],
)
def test_conditions(plan, write, condition, counts, tag):
    write("b.launch", '<launch><param name="p" value="1"/></launch>')
    arguments = '<arg name="yes" default="true"/><arg name="mode" default="sim"/>'
    found = plan(arguments + tag.format(condition))
    assert bool(found.params or found.nodes) is counts


def test_what_does_not_count_is_not_looked_at(plan):
    found = plan('<group if="0"><node/><param name="$(arg nope)"/></group>')
    assert found.nodes == ()
    assert found.warnings == ()


def test_a_condition_is_looked_at_before_all_else(plan, refusal):
    assert plan('<param if="0" value="$(arg nope)"/>').params == {}
    assert "is not a 'bool' type" in refusal('<param if="perhaps" value="$(arg nope)"/>').said


def test_arguments_of_a_group_stay_in_it(plan, refusal):
    group = '<group><arg name="a" value="2"/><param name="in" value="$(arg a)"/></group>'
    assert plan(group).params == {"/in": 2}
    assert "requires the 'a' arg" in refusal(f'{group}<param name="out" value="$(arg a)"/>').said


def test_the_command_line_wins_over_a_default_and_not_over_a_value(plan, refusal):
    default = '<arg name="a" default="1"/><param name="p" value="$(arg a)"/>'
    assert plan(default).params == {"/p": 1}
    assert plan(default, a="2").params == {"/p": 2}
    fixed = default.replace("default", "value")
    assert plan(fixed).params == {"/p": 1}
    with pytest.raises(LaunchError, match="cannot override arg 'a', which has already been set"):
        plan(fixed, a="2")


def test_an_included_file_sees_what_it_is_given(plan, write):
    write(
        "b.launch",
        """<launch>
        <arg name="speed" default="1"/> <arg name="name"/>
        <node name="$(arg name)" pkg="p" type="x" args="$(arg speed)"/>
        <param name="inner" value="$(arg speed)"/>
        </launch>""",
    )
    found = plan(
        """<arg name="speed" default="5"/>
        <include file="$(find play)/b.launch" ns="one"><arg name="name" value="a"/></include>
        <include file="$(find play)/b.launch"><arg name="name" value="b"/>
          <arg name="speed" value="$(arg speed)0"/></include>"""
    )
    assert [(one.resolved_name, one.args) for one in found.nodes] == [("/one/a", "1"), ("/b", "50")]
    assert dict(found.params) == {"/one/inner": 1, "/inner": 50}
    assert [name.rpartition("/")[2] for name in found.files] == [
        "a.launch",
        "b.launch",
        "b.launch",
    ]


def test_all_arguments_can_be_passed(plan, write):
    write(
        "b.launch",
        """<launch><arg name="a" default="0"/><arg name="fixed" value="here"/>
        <param name="a" value="$(arg a)"/><param name="fixed" value="$(arg fixed)"/></launch>""",
    )
    include = '<include file="$(find play)/b.launch" pass_all_args="{}">{}</include>'
    outer = '<arg name="a" value="1"/><arg name="fixed" value="there"/><arg name="more" value="x"/>'
    assert plan(outer + include.format("true", "")).params == {"/a": 1, "/fixed": "here"}
    replaced = include.format("true", '<arg name="a" value="2"/>')
    assert plan(outer + replaced).params["/a"] == 2
    assert plan(outer + include.format("false", "")).params["/a"] == 0


def test_remappings_hold_for_what_follows_and_inside(plan):
    found = plan(
        f"""{NODE.format("before")}
        <remap from="a" to="/b"/> <remap from="c" to="d"/>
        {NODE.format("after")}
        <group> <remap from="a" to="inner"/> {NODE.format("deep")} </group>
        <node name="own" pkg="p" type="x"> <remap from="~x" to="e/"/> </node>
        {NODE.format("last")}"""
    )
    assert node(found, "before").remappings == ()
    assert node(found, "after").remappings == (("a", "/b"), ("c", "d"))
    assert node(found, "deep").remappings == (("c", "d"), ("a", "inner"))
    assert node(found, "own").remappings == (("a", "/b"), ("c", "d"), ("~x", "e"))
    assert node(found, "last").remappings == (("a", "/b"), ("c", "d"))


def test_remappings_reach_into_an_included_file(plan, write):
    write("b.launch", f"<launch>{NODE.format('inner')}</launch>")
    found = plan('<remap from="a" to="b"/><include file="$(find play)/b.launch"/>')
    assert node(found, "inner").remappings == (("a", "b"),)


def test_namespaces_are_joined(plan, write):
    write("b.launch", f"<launch>{NODE.format('n')}</launch>")
    found = plan(
        """<group ns="a"> <group ns="b/c"> <include file="$(find play)/b.launch" ns="d"/> </group>
        <group ns="/top"> <node name="n" pkg="p" type="x" ns="e"/> </group> </group>"""
    )
    assert [one.resolved_name for one in found.nodes] == ["/a/b/c/d/n", "/top/e/n"]


def test_a_test_only_gives_its_parameters(plan):
    found = plan(
        '<test test-name="t" pkg="p" type="x" time-limit="5"><param name="q" value="1"/></test>'
    )
    assert found.nodes == ()
    assert dict(found.params) == {"/t/q": 1}


def test_arguments_are_listed_with_their_words(plan):
    found = plan(
        '<arg name="a" default="1" doc="how fast"/><arg name="b"/><arg name="c" value="x"/>', b="1"
    )
    listed = [(one.name, one.default, one.doc) for one in found.arguments]
    assert listed == [("a", "1", "how fast"), ("b", None, None)]


def test_the_same_file_gives_the_same_plan(plan, write):
    write("c.yaml", "z: 1\na: [1, 2]\nm: {k: 3}\n")
    inner = '<rosparam file="$(find play)/c.yaml"/><node name="$(anon n)" pkg="p" type="x"/><foo/>'
    assert plan(inner) == plan(inner)
    assert str(plan(inner)) == str(plan(inner))
