"""`<param>` and `<rosparam>`: values and names."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from simkit.launch.errors import LaunchRefused
from simkit.launch.values import convert

NODE = '<node name="t" pkg="p" type="x">{}</node>'


@pytest.mark.parametrize(
    ("text", "type_name", "value"),
    [
        ("1", "auto", 1),
        ("-12", "auto", -12),
        ("1.", "auto", 1.0),
        ("1.5e3", "auto", 1500.0),
        ("1e3", "auto", "1e3"),
        ("1_000", "auto", "1_000"),
        ("1_0.5", "auto", "1_0.5"),
        ("True", "auto", True),
        ("fAlse", "auto", False),
        ("yes", "auto", "yes"),
        ("", "auto", ""),
        ("1.2.3", "auto", "1.2.3"),
        ("7", "str", "7"),
        ("7", "string", "7"),
        ("7", "double", 7.0),
        ("1e3", "double", 1000.0),
        ("1", "bool", True),
        ("0", "boolean", False),
        ("[1, two, {x: 3.0}]", "yaml", [1, "two", {"x": 3.0}]),
        ("7", "INT", 7),
    ],
)
def test_a_text_becomes_a_value(text, type_name, value):
    found = convert(text, type_name)
    assert (found, type(found)) == (value, type(value))


@given(st.text(max_size=30))
def test_any_text_is_a_value_and_text_stays_text(text):
    assert convert(text, "str") == text
    value = convert(text, "auto")
    assert isinstance(value, bool | int | float | str)
    if isinstance(value, str):
        assert value == text


@given(st.integers(-(10**9), 10**9), st.floats(allow_nan=False, allow_infinity=False))
def test_numbers_survive(whole, real):
    assert convert(str(whole), "auto") == whole
    text = f"{real:.17f}"
    assert convert(text, "auto") == float(text)


@given(st.text(max_size=20), st.sampled_from(["int", "double", "bool", "yaml", "nonsense"]))
def test_a_wrong_value_is_refused_and_nothing_else(text, type_name):
    told = ""
    try:
        told = f"value {convert(text, type_name)}"
    except LaunchRefused as refused:
        told = refused.lesson.remedy
    assert told


def test_the_value_is_stripped_and_the_later_one_wins(plan):
    found = plan(
        '<param name="a" value=" 1 "/><param name="a" value=" x "/><param name="b" value=""/>'
    )
    assert dict(found.params) == {"/a": "x", "/b": ""}


def test_names_are_relative_global_or_private(plan):
    found = plan(
        """
        <param name="a" value="1"/> <param name="/b" value="2"/> <param name="c/d//e/" value="3"/>
        <group ns="g"> <param name="a" value="4"/> <param name="/f" value="5"/> </group>
        <param name="~p" value="6"/>
        <node name="t" pkg="p" type="x" ns="n"> <param name="q" value="7"/>
          <param name="~r" value="8"/> <param name="/s" value="9"/> </node>
        """
    )
    assert dict(found.params) == {
        "/a": 1,
        "/b": 2,
        "/c/d/e": 3,
        "/g/a": 4,
        "/f": 5,
        "/n/t/p": 6,
        "/n/t/q": 7,
        "/n/t/r": 8,
        "/n/t/s": 9,
    }


def test_private_parameters_count_for_the_nodes_behind_them_in_their_group(plan):
    found = plan(
        f"""{NODE.format("").replace('"t"', '"first"')}
        <param name="~p" value="1"/>
        <group> <param name="~q" value="2"/> {NODE.format("").replace('"t"', '"inner"')} </group>
        {NODE.format("").replace('"t"', '"last"')}"""
    )
    assert dict(found.params) == {"/inner/p": 1, "/inner/q": 2, "/last/p": 1}


def test_texts_of_files_and_commands(plan, write):
    write("robot.urdf", "<robot>\n</robot>\n")
    write("number.txt", "42\n")
    write("blob.bin", "\x01")
    found = plan(
        """
        <param name="robot" textfile="$(find play)/robot.urdf"/>
        <param name="text" type="str" textfile="$(find play)/number.txt"/>
        <param name="number" textfile="$(find play)/number.txt"/>
        <param name="cat" command="cat '$(find play)/robot.urdf'"/>
        <param name="two" command="cat $(find play)/robot.urdf $(find play)/number.txt"/>
        <param name="echo" command="echo a  'b c'"/>
        <param name="bare" command="echo -n 1.5"/>
        <param name="xacro" command="$(find xacro)/xacro --inorder $(find play)/robot.urdf"/>
        <param name="binary" binfile="$(find play)/blob.bin"/>
        """
    )
    robot = "<robot>\n</robot>\n"
    assert dict(found.params) == {
        "/robot": robot,
        "/text": "42\n",
        "/number": 42,
        "/cat": robot,
        "/two": f"{robot}42\n",
        "/echo": "a b c\n",
        "/bare": 1.5,
        "/xacro": robot,
        "/binary": b"\x01",
    }
    sources = {name: origin.source.name for name, origin in found.origins.items() if origin.source}
    assert sources == {
        "/robot": "robot.urdf",
        "/text": "number.txt",
        "/number": "number.txt",
        "/cat": "robot.urdf",
        "/xacro": "robot.urdf",
        "/binary": "blob.bin",
    }


XACRO = "<robot name='arm' xmlns:xacro='http://ros.org/wiki/xacro'>{}</robot>"


def test_xacro_makes_a_urdf_whatever_folder_it_is_in(plan, write):
    write("sizes.xacro", XACRO.format("<xacro:property name='length' value='${0.2 * 2}'/>"))
    write(
        "robot.xacro",
        XACRO.format(
            "<xacro:arg name='name' default='none'/><xacro:include filename='$(find play)/sizes.xacro'/>"
            "<link name='$(arg name)_${length}'/>"
        ),
    )
    found = plan('<param name="a" command="xacro --inorder $(find play)/robot.xacro name:=tip"/>')
    assert dict(found.params) == {
        "/a": '<?xml version="1.0" ?>\n<robot name="arm">\n  <link name="tip_0.4"/>\n</robot>\n'
    }


@pytest.mark.parametrize(
    ("body", "what"),
    [
        ("<link name='${prefix}_base'/>", "name 'prefix' is not defined"),
        ("<link name='$(arg x)'/>", "Undefined substitution argument x"),
        ("<xacro:arm/>", "unknown macro name: xacro:arm"),
        ("<xacro:include filename='$(find paly)/x'/>", "there is no package 'paly'"),
        ("<xacro:property name='a' value='1'>", "mismatched tag: line 1"),
    ],
)
def test_what_xacro_refuses_is_told(refusal, write, body, what):
    write("robot.xacro", XACRO.format(body))
    error = refusal('<param name="a" command="xacro $(find play)/robot.xacro"/>')
    assert error.diagnostic.rule == "LCH-E02"
    assert "returned with code [2]" in str(error)
    assert what in error.diagnostic.what
    assert "\n" not in error.diagnostic.what


@pytest.mark.parametrize(
    ("command", "what"),
    [
        ("cat", "cat without a file would wait for ever"),
        ("cat $(find play)/a.txt | grep x", "| is for a shell"),
        ("cat $(find play)/a.txt > b", "> is for a shell"),
    ],
)
def test_what_only_a_shell_understands_is_told(refusal, write, command, what):
    write("a.txt", "x")
    error = refusal(f"<param name='a' command='{command.replace('>', '&gt;')}'/>")
    assert error.diagnostic.what.startswith(what)
    assert "returned with code [1]" in error.said


def test_a_long_text_that_is_no_number_is_not_told_whole(refusal, write):
    write("a.txt", "word " * 1000)
    error = refusal('<param name="a" type="int" textfile="$(find play)/a.txt"/>')
    assert len(error.diagnostic.what) < 80


def test_no_program_is_run(refusal, tmp_path):
    trap = tmp_path / "trap"
    for command in (f"touch {trap}", f"cat /dev/null; touch {trap}", f"sh -c 'touch {trap}'"):
        refusal(f'<param name="a" command="{command}"/>')
    assert not trap.exists()


def test_rosparam_fills_namespaces(plan, write):
    write("all.yaml", "arm:\n  joints: [hip, shoulder]\n  gain: 1.5\n/global: 1\n")
    found = plan(
        """
        <rosparam file="$(find play)/all.yaml" command="load"/>
        <rosparam param="list">[1, 2]</rosparam>
        <rosparam ns="n">x: 1</rosparam>
        <group ns="g"> <rosparam>y: {z: true}</rosparam> </group>
        <node name="t" pkg="p" type="x"> <rosparam>rate: 10</rosparam> </node>
        <rosparam/>
        """
    )
    assert dict(found.params) == {
        "/arm/joints": ["hip", "shoulder"],
        "/arm/gain": 1.5,
        "/global": 1,
        "/list": [1, 2],
        "/n/x": 1,
        "/g/y/z": True,
        "/t/rate": 10,
    }


def test_angles_and_yaml_of_1_1(plan):
    found = plan(
        """<rosparam>
        a: deg(90)
        b: rad(pi/2)
        c: !degrees 180
        d: !radians 2*pi
        e: yes
        f: 0x10
        g: 1e3
        h: 1.0e+3
        i: '12'
        </rosparam>"""
    )
    assert dict(found.params) == {
        "/a": pytest.approx(math.pi / 2),
        "/b": pytest.approx(math.pi / 2),
        "/c": pytest.approx(math.pi),
        "/d": pytest.approx(2 * math.pi),
        "/e": True,
        "/f": 16,
        "/g": "1e3",
        "/h": 1000.0,
        "/i": "12",
    }


def test_substitution_in_yaml_is_asked_for(plan):
    inner = '<arg name="v" default="7"/><rosparam {}>a: $(arg v)</rosparam>'
    assert dict(plan(inner.format("")).params) == {"/a": "$(arg v)"}
    assert dict(plan(inner.format('subst_value="true"')).params) == {"/a": 7}


def test_delete_dump_and_clear_are_planned(plan):
    found = plan(
        """
        <rosparam command="delete" param="old"/>
        <rosparam command="dump" file="x.yaml" ns="g"/>
        <group ns="g" clear_params="true"/>
        <node name="t" pkg="p" type="x" clear_params="true"/>
        """
    )
    assert [(step.command, step.name, step.file) for step in found.steps] == [
        ("delete", "/old", None),
        ("dump", "/g", "x.yaml"),
    ]
    assert found.clear_params == ("/g/", "/t/")


@pytest.mark.parametrize(
    ("yaml", "words"),
    [
        ("a: ", "[/a=None]): cannot marshal None unless allow_none is enabled"),
        ("a: 3000000000", "[/a=3000000000]): int exceeds XML-RPC limits"),
        ("a: 2020-09-14", "[/a=2020-09-14]): cannot marshal <class 'datetime.date'> objects"),
        ("a: [1, ]\nb: [[null]]", "[/b=[[None]]]): cannot marshal None"),
    ],
)
def test_what_ros_cannot_send_is_refused(refusal, yaml, words):
    error = refusal(f"<rosparam>\n{yaml}\n</rosparam>")
    assert error.said.startswith("RLException: load_parameters: unable to set params (last param")
    assert words in error.said
    assert error.diagnostic.rule == "LCH-E09"


def test_a_key_that_is_no_text_is_refused(refusal):
    error = refusal("<rosparam>1: x</rosparam>")
    assert error.said == "TypeError: 'int' object is not subscriptable"
    assert error.remedy == 'Put it in quotation marks: "1".'


TREES = st.recursive(
    st.booleans() | st.integers(-1000, 1000) | st.text("abc xyz", max_size=8),
    lambda inner: st.dictionaries(st.text("abcdef", min_size=1, max_size=4), inner, max_size=4),
    max_leaves=12,
)


def leaves(tree, name=""):
    if not isinstance(tree, dict):
        return {name: tree}
    found = {}
    for key, part in tree.items():
        found.update(leaves(part, f"{name}/{key}"))
    return found


@settings(max_examples=60)
@given(st.dictionaries(st.text("abcdef", min_size=1, max_size=4), TREES, max_size=4))
def test_a_tree_of_yaml_unrolls_into_its_leaves(tree):
    import yaml

    from simkit.launch import evaluate
    from simkit.packages import PackagePath

    text = yaml.safe_dump(tree)
    found = evaluate(
        f"<launch><rosparam>{text}</rosparam></launch>", packages=PackagePath([]), environment={}
    )
    assert dict(found.params) == leaves(tree)
