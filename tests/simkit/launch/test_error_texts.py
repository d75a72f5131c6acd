"""What roslaunch says of each fault, word for word, and where ours says it is."""

import re

import pytest

from simkit.launch import LaunchError, evaluate

NODE = 'name="t" pkg="p" type="x"'
INVALID = "RLException: Invalid {0} tag: {1}. \n\n{2} xml is "

# What stands in the <launch>, the words of roslaunch, and the column that the fault begins at.
TEXTS = [
    # attributes of any tag
    ('<param name="a" value="1" if="maybe"/>', "Value error: maybe is not a 'bool' type", 39),
    (
        '<param name="a" value="1" if="1" unless="1"/>',
        "RLException: cannot set both 'if' and 'unless' on the same tag",
        50,
    ),
    # substitution
    (
        '<param name="a" value="$(arg x)"/>',
        "RLException: [{file}] requires the 'x' arg to be set",
        32,
    ),
    (
        '<arg name="x"/><param name="a" value="$(arg x)"/>',
        "RLException: [{file}] requires the 'x' arg to be set",
        47,
    ),
    (
        '<param name="a" value="$(foo bar)"/>',
        "RLException: Unknown substitution command [foo bar]. Valid commands are "
        "['find', 'env', 'optenv', 'dirname', 'anon', 'arg']",
        32,
    ),
    (
        '<param name="a" value="$(find nope)"/>',
        "Resource not found: nope\nROS path [0]={path}",
        32,
    ),
    ('<param name="a" value="$(env X)"/>', "RLException: environment variable 'X' is not set", 32),
    (
        '<param name="a" value="$(eval a__b)"/>',
        "RLException: $(eval ...) may not contain double underscore expressions",
        32,
    ),
    ('<param name="a" value="$(eval 1/0)"/>', "ZeroDivisionError: division by zero", 32),
    (
        '<param name="a" value="$(eval x)"/>',
        "NameError: name 'x' is not defined",
        32,
    ),
    (
        '<param name="a" value="$(find a b)"/>',
        "RLException: $(find pkg) command only accepts one argument [find a b]",
        32,
    ),
    (
        '<param name="a" value="$(arg $(arg b))"/>',
        "RLException: Dollar signs '$' cannot be inside of substitution args [$(arg $(arg b))]",
        32,
    ),
    (
        '<param name="a" value="$(arg (b))"/>',
        "RLException: Invalid left parenthesis '(' in substitution args [$(arg (b))]",
        32,
    ),
    # arg
    (
        '<arg name="a" value="1" default="2"/>',
        "RLException: Invalid <arg> tag: <arg> tag must have one and only one of value/default.. "
        "\n\nArg xml is {xml}",
        42,
    ),
    (
        '<arg name="a"/><arg name="a"/>',
        "RLException: Invalid <arg> tag: arg 'a' has already been declared. \n\n"
        'Arg xml is <arg name="a"/>',
        25,
    ),
    (
        '<arg name="b" value="$(arg a)"/>',
        "RLException: arg 'a' is not defined. \n\nArg xml is {xml}",
        30,
    ),
    (
        '<arg nam="b"/>',
        "RLException: Invalid <arg> tag: 'name'. \n\nArg xml is {xml}",
        10,
    ),
    (
        '<arg name="b" value="$(eval 1/0)"/>',
        "RLException: Invalid <arg> tag: division by zero. \n\nArg xml is {xml}",
        30,
    ),
    # param
    (
        '<param name="a"/>',
        "RLException: <param> tag must have one and only one of value/textfile/binfile.",
        10,
    ),
    (
        '<param name="a" value="1" textfile="x"/>',
        "RLException: <param> tag must have one and only one of value/textfile/binfile.",
        10,
    ),
    (
        '<param value="1"/>',
        "RLException: <param> tag is missing required attribute: 'name'. \n\nParam xml is {xml}",
        10,
    ),
    (
        '<param name="a" type="int" value="x"/>',
        "RLException: Invalid <param> tag: invalid literal for int() with base 10: 'x'. \n\n"
        "Param xml is {xml}",
        43,
    ),
    (
        '<param name="a" type="bool" value="x"/>',
        "RLException: Invalid <param> tag: x is not a 'bool' type. \n\nParam xml is {xml}",
        44,
    ),
    (
        '<param name="a" type="foo" value="x"/>',
        "RLException: Invalid <param> tag: Unknown type 'foo'. \n\nParam xml is {xml}",
        31,
    ),
    (
        '<param name="a" textfile="/nope.urdf"/>',
        "FileNotFoundError: [Errno 2] No such file or directory: '/nope.urdf'",
        35,
    ),
    (
        '<param name="a" command="false"/>',
        "RLException: Invalid <param> tag: Cannot load command parameter [a]: "
        "command [['false']] returned with code [1]. \n\nParam xml is {xml}",
        34,
    ),
    (
        '<param name="a" command="x"/>',
        "RLException: Invalid <param> tag: Cannot load command parameter [a]: "
        "no such command [['x']]. \n\nParam xml is {xml}",
        34,
    ),
    # rosparam
    (
        "<rosparam>[1, 2]</rosparam>",
        "RLException: error loading <rosparam> tag: \n\t'param' attribute must be set for "
        "non-dictionary values\nXML is {xml}",
        10,
    ),
    (
        '<rosparam file="/nope.yaml"/>',
        "RLException: error loading <rosparam> tag: \n\tfile does not exist [/nope.yaml]\nXML is {xml}",
        25,
    ),
    (
        '<rosparam command="lod"/>',
        "RLException: error loading <rosparam> tag: \n\tcommand must be 'load', 'dump', or 'delete'\n"
        "XML is {xml}",
        28,
    ),
    (
        '<rosparam command="delete" file="x"/>',
        "RLException: error loading <rosparam> tag: \n\t'file' attribute is invalid with 'delete' "
        "command.\nXML is {xml}",
        42,
    ),
    (
        '<rosparam subst_value="maybe">a: 1</rosparam>',
        "RLException: invalid bool value for subst_value: maybe",
        32,
    ),
    # node
    (
        '<node pkg="p" type="x"/>',
        "RLException: <node> tag is missing required attribute: 'name'. Node xml is {xml}",
        10,
    ),
    (
        '<node name="t" type="x"/>',
        "RLException: <node> tag is missing required attribute: 'pkg'. Node xml is {xml}",
        10,
    ),
    (
        '<node name="a/b" pkg="p" type="x"/>',
        INVALID.format("<node>", "node name cannot contain a namespace", "Node") + "{xml}",
        21,
    ),
    (
        f'<node {NODE} output="both"/>',
        INVALID.format("<node>", "output must be one of 'log', 'screen'", "Node") + "{xml}",
        49,
    ),
    (
        f'<node {NODE} respawn="foo"/>',
        INVALID.format("<node>", "invalid bool value for respawn: foo", "Node") + "{xml}",
        50,
    ),
    (
        f'<node {NODE} respawn_delay="foo"/>',
        INVALID.format("<node>", "invalid float value for respawn_delay: foo", "Node") + "{xml}",
        56,
    ),
    (
        f'<node {NODE} respawn="true" required="true"/>',
        INVALID.format("<node>", "respawn and required cannot both be set to true", "Node")
        + "{xml}",
        66,
    ),
    (
        f"<node {NODE}/><node {NODE}/>",
        "RLException: roslaunch file contains multiple nodes named [/t].\nPlease check all <node> "
        "'name' attributes to make sure they are unique.\nAlso check that $(anon id) use "
        "different ids.",
        54,
    ),
    (
        f'<node {NODE} ns=""/>',
        INVALID.format("<node>", "<node> tag has an empty 'ns' attribute", "Node") + "{xml}",
        None,
    ),
    # remap, env, machine
    (
        '<remap from="a"/>',
        "RLException: Invalid <remap> tag: <remap> tag is missing required from/to attributes: "
        '<remap from="a"/>.\nXML is <remap from="a"/>',
        10,
    ),
    (
        '<remap from="a" to=""/>',
        "RLException: Invalid <remap> tag: remap from/to attributes cannot be empty.\nXML is {xml}",
        10,
    ),
    (
        '<remap from="a" to="b c"/>',
        "RLException: Invalid <remap> tag: remap to [b c] is not a valid ROS name.\nXML is {xml}",
        10,
    ),
    (
        '<env name="a"/>',
        "RLException: <env> tag is missing required name/value attributes: {xml}",
        10,
    ),
    (
        '<machine name="a"/>',
        "RLException: <machine> tag is missing required attribute: 'address'",
        10,
    ),
    # group, include
    (
        '<group ns=""/>',
        "RLException: <group> tag has an empty 'ns' attribute",
        None,
    ),
    (
        '<group clear_params="true"/>',
        "RLException: 'ns' attribute must be set in order to use 'clear_params'",
        30,
    ),
    ("<include/>", "KeyError: 'file'", 10),
    (
        '<include file="/nope.launch"/>',
        "RLException: while processing /nope.launch:\nInvalid roslaunch XML syntax: [Errno 2] No such "
        "file or directory: '/nope.launch'",
        24,
    ),
    (
        '<include file="$(find play)/b.launch"><arg name="a"/></include>',
        "RLException: include args must have declared values",
        None,
    ),
    (
        '<include file="$(find play)/b.launch"><arg name="zz" value="1"/></include>',
        "RLException: unused args [zz] for include of [{folder}/b.launch]",
        48,
    ),
    (
        '<include file="$(find play)/fixed.launch"><arg name="a" value="1"/></include>',
        "RLException: while processing {folder}/fixed.launch:\nInvalid <arg> tag: cannot override arg "
        "'a', which has already been set. \n\nArg xml is "
        '<arg name="a" value="2"/>',
        None,
    ),
    (
        '<include file="$(find play)/needs.launch"/>',
        "RLException: included file [{folder}/needs.launch] requires the 'a' arg to be set",
        None,
    ),
]


@pytest.fixture(autouse=True)
def included(write):
    write("b.launch", '<launch><arg name="a" default="0"/></launch>')
    write("fixed.launch", '<launch><arg name="a" value="2"/></launch>')
    write("needs.launch", '<launch><arg name="a"/><param name="a" value="$(arg a)"/></launch>')


@pytest.mark.parametrize(("inner", "words", "column"), TEXTS, ids=[text for text, *_ in TEXTS])
def test_the_words_are_those_of_roslaunch(refusal, write, inner, words, column):
    error = refusal(inner)
    file = write.folder / "a.launch"
    known = {
        "{file}": file,
        "{folder}": write.folder,
        "{path}": write.folder.parent,
        "{xml}": inner,
    }
    for name, value in known.items():
        words = words.replace(name, str(value))
    assert error.said == words
    if column is not None:
        assert (error.file, error.line, error.column) == ("play/a.launch", 1, column)
    assert error.remedy
    assert error.remedy in str(error)
    assert re.match(r"LCH-E\d\d", error.diagnostic.rule)


ATTRIBUTES = [
    (f'<node {NODE} respawn="foo"/>', "foo"),
    (f'<node {NODE} required="1"/>', "1"),
    (f'<node {NODE} respawn_delay="soon"/>', "soon"),
    (f'<node {NODE} clear_params="foo"/>', "foo"),
    (f'<node {NODE} machine="m"/>', "m"),
    ('<include file="$(find play)/b.launch" pass_all_args="foo"/>', "foo"),
    ('<group ns="a" clear_params="foo"/>', "foo"),
    ('<rosparam subst_value="foo">a: 1</rosparam>', "foo"),
    ('<rosparam command="delete" param="a" file="b.yaml"/>', "b.yaml"),
    ('<param name="a" type="foo" value="x"/>', "foo"),
]


@pytest.mark.parametrize(("inner", "value"), ATTRIBUTES, ids=[inner for inner, _ in ATTRIBUTES])
def test_a_wrong_attribute_is_underlined(refusal, inner, value):
    error = refusal(inner)
    assert error.column == len("<launch>") + inner.index(f'"{value}"') + 2


@pytest.mark.parametrize(
    "inner", ['<group ns="~"/>', '<node ns="~" name="t" pkg="p" type="x"/>', '<param name=""/>']
)
def test_each_fault_has_a_line(refusal, inner):
    error = refusal(f"\n{inner}")
    assert (error.file, error.line) == ("play/a.launch", 2)
    assert error.diagnostic.source.startswith(inner)


@pytest.mark.parametrize("name", ["", "/"])
def test_the_root_is_no_parameter(refusal, name):
    error = refusal(f'<param name="{name}" value="1"/>')
    assert error.said == ""
    assert "would be the root of all parameters" in str(error)


def test_a_machine_may_stand_behind_its_nodes(plan, refusal):
    node = f'<node {NODE} machine="m"/>'
    assert plan(f'{node}<machine name="m" address="x"/>').nodes
    assert refusal(node).said == "RLException: ERROR: unknown machine [m]"
    empty = f'<node {NODE} machine=" "/>'
    assert "<node> 'machine' must be non-empty: [ ]" in refusal(empty).said


def test_an_included_file_is_given_its_argument_by_the_include(refusal):
    include = '<include file="$(find play)/needs.launch">{}</include>'
    assert '<arg name="a" value="..."/> in the <include>' in refusal(include.format("")).remedy
    slip = refusal(include.format('<arg name="A" value="1"/>'))
    assert slip.remedy == "Write 'a' where 'A' is given, which nobody declares."


def test_a_torn_tag_is_what_is_wrong_not_what_follows_from_it(packages):
    text = '<launch>\n<node name="t" pkg="p" type="x>\n</launch>'
    with pytest.raises(LaunchError) as caught:
        evaluate(text, packages=packages)
    assert caught.value.remedy == 'Write type="x".'


SYNTAX = [
    ("<launch>\n<node></launch>", "mismatched tag: line 2, column 8", 2),
    (
        '<launch>\n<param name="a" value="1>\n</launch>',
        "not well-formed (invalid token): line 3, column 0",
        2,
    ),
    ("<launch><!-- a -- b --></launch>", "not well-formed (invalid token): line 1, column 17", 1),
    ('<launch>\n<a b="1" b="2"/></launch>', "duplicate attribute: line 2, column 9", 2),
    ("<launch>", "no element found: line 1, column 8", 1),
    ("<launch/>\n<launch/>", "junk after document element: line 2, column 0", 2),
    ("<launch><x:y/></launch>", "unbound prefix: line 1, column 8", 1),
]


@pytest.mark.parametrize(("text", "words", "line"), SYNTAX)
def test_what_is_not_xml_has_the_words_of_expat(packages, text, words, line):
    with pytest.raises(LaunchError) as caught:
        evaluate(text, packages=packages)
    assert caught.value.said == f"RLException: Invalid roslaunch XML syntax: {words}"
    assert caught.value.line == line
    assert caught.value.diagnostic.rule == "LCH-E04"


@pytest.mark.parametrize("text", ["<robot/>", "<launch><group><launch/></group></launch>"])
def test_a_file_without_one_launch(packages, text):
    with pytest.raises(LaunchError) as caught:
        evaluate(text, packages=packages)
    assert caught.value.said == "RLException: Invalid roslaunch XML syntax: no root <launch> tag"


WARNINGS = [
    ("<foo/>", "WARNING: unrecognized tag foo"),
    ('<param name="a" value="1" zzz="2"/>', "WARNING: [{file}] unknown <param> attribute 'zzz'"),
    (
        f"<node {NODE}><prm/></node>",
        "WARNING: WARN: unrecognized 'prm' child tag in the parent tag element: {xml}",
    ),
    (
        '<include file="$(find play)/b.launch"><foo/></include>',
        "WARN: unrecognized 'foo' tag in <include> tag",
    ),
    (
        '<param name="/a/b" value="1"/><param name="/a/b/c" value="2"/>',
        "WARNING: parameter [/a/b/c] conflicts with parent parameter [/a/b]",
    ),
    ("<master/>", "WARNING: ignoring defunct <master /> tag"),
    (
        '<node name="1a" pkg="p" type="x"/>',
        "WARNING: WARN: illegal <node> name '1a'.\nhttp://ros.org/wiki/Names\nThis will likely cause "
        "problems with other ROS tools.\nNode xml is {xml}",
    ),
]


@pytest.mark.parametrize(("inner", "words"), WARNINGS)
def test_warnings_are_those_of_roslaunch(plan, write, inner, words):
    found = plan(inner).warnings
    file = str(write.folder / "a.launch")
    assert found == (words.replace("{file}", file).replace("{xml}", inner),)


@pytest.mark.parametrize(
    ("inner", "rule", "remedy"),
    [
        ('<nod name="t"/>', "LCH-W11", "Did you mean <node>?"),
        ('<param name="a" valu="1" value="2"/>', "LCH-W11", "Did you mean value?"),
        (f"<node {NODE}><rosparm/></node>", "LCH-W11", "Did you mean <rosparam>?"),
        ('<machine name="a" address="b"/>', "LCH-W12", "Remove it here."),
        ('<env name="A" value="b"/>', "LCH-W12", "Use a <param>."),
        (f'<node {NODE} launch-prefix="gdb"/>', "LCH-W12", "Remove it here."),
        (
            '<param name="a b" value="1"/>',
            "LCH-E07",
            "Use letters, digits, _ and / only, a letter first.",
        ),
        (
            '<param name="a" value="1"/>>',
            "LCH-W16",
            "Remove it, or make a comment of it: <!-- ... -->.",
        ),
    ],
)
def test_a_file_that_works_is_taught_too(plan, inner, rule, remedy):
    (found,) = plan(inner).diagnostics
    assert (found.rule, found.remedy, found.file) == (rule, remedy, "play/a.launch")


def test_an_argument_that_nobody_declares_is_told(plan):
    found = plan('<arg name="speed" default="1"/>', sped="2")
    assert [one.what for one in found.diagnostics] == [
        "the argument 'sped' is given, but this file declares no such"
    ]
    assert found.diagnostics[0].remedy == "Did you mean speed:=?"
    other = plan('<arg name="speed" default="1"/>', colour="red")
    assert other.diagnostics[0].remedy == "It declares: speed."


def test_a_fault_in_an_included_file_has_its_chain(refusal, write):
    write("launch/inner.launch", '<launch>\n  <param name="a" type="int" value="x"/>\n</launch>')
    write("launch/outer.launch", '<launch>\n <include file="$(dirname)/inner.launch"/>\n</launch>')
    error = refusal('<include file="$(find play)/launch/outer.launch"/>')
    assert (error.file, error.line, error.column) == ("play/launch/inner.launch", 2, 37)
    assert error.chain == ("play/launch/outer.launch:2:3", "play/a.launch:1:10")
    assert "play/launch/outer.launch:2:3" in str(error)
    folder = write.folder
    assert error.said.startswith(
        f"RLException: while processing {folder}/launch/outer.launch:\nwhile processing "
        f"{folder}/launch/inner.launch:\nInvalid <param> tag: invalid literal"
    )


def test_a_fault_in_yaml_has_its_place(refusal, write):
    inline = refusal("\n<rosparam>\na: 1\nb: [1\nc: 2\n</rosparam>")
    assert (inline.file, inline.line) == ("play/a.launch", 5)
    write("c.yaml", "a: 1\nb:\n\t- 2\n")
    error = refusal('<rosparam file="$(find play)/c.yaml"/>')
    assert (error.file, error.line, error.column) == ("play/c.yaml", 3, 1)
    assert error.diagnostic.source == "\t- 2"
    assert error.chain == ("play/a.launch:1:25",)
    assert f"file {write.folder}/c.yaml contains invalid YAML:\n" in error.said


def test_an_angle_has_its_place_and_its_remedy(refusal, write):
    inline = refusal("\n<rosparam>\na: 1\nb: deg(pi)\n</rosparam>")
    assert (inline.line, inline.column) == (4, 4)
    assert "rad(pi/2)" in inline.remedy
    write("c.yaml", "a: 1\nb: {c: rad(x)}\n")
    error = refusal('<rosparam file="$(find play)/c.yaml"/>')
    assert (error.file, error.line, error.column) == ("play/c.yaml", 2, 8)


def test_a_substitution_in_yaml_has_its_place(refusal, write):
    text = "a: 1\nb: $(optenv X y)\nc: $(arg nope)\n"
    inline = refusal(f'<rosparam subst_value="true">\n{text}</rosparam>')
    assert (inline.file, inline.line, inline.column) == ("play/a.launch", 4, 4)
    write("c.yaml", text)
    error = refusal('<rosparam subst_value="true" file="$(find play)/c.yaml"/>')
    assert (error.file, error.line, error.column) == ("play/c.yaml", 3, 4)


def test_a_word_with_a_colon_in_it_is_no_mapping(refusal):
    assert refusal("<rosparam>speed:1</rosparam>").remedy == "Write speed: 1"
    assert "param=" in refusal("<rosparam>3</rosparam>").remedy


def test_near_names_are_offered(refusal, write):
    write("urdf/robot.urdf", "<robot/>")
    assert (
        "robot.urdf" in refusal('<param name="a" textfile="$(find play)/urdf/robt.urdf"/>').remedy
    )
    assert refusal('<node nam="t" pkg="p" type="x"/>').remedy == "Write name= where nam= stands."
    assert "did you mean 'play'" in str(refusal('<param name="a" value="$(find plya)"/>'))
    speed = '<arg name="speed" default="1"/><param name="a" value="$(arg sped)"/>'
    assert refusal(speed).remedy == "Did you mean $(arg speed)?"
    assert refusal('<param name="a" type="integer" value="1"/>').remedy == "Did you mean int?"
    assert refusal('<param name="a" value="$(findd play)"/>').remedy == "Did you mean $(find ...)?"


@pytest.mark.parametrize(
    ("inner", "remedy"),
    [
        ('<param name="a" valu="1"/>', "Write value= where valu= stands."),
        ('<param name="a"/>', 'Write value="...", or textfile=, binfile= or command=.'),
        ('<node pkg="p" exec="x" name="n"/>', "Write type= where exec= stands."),
        ("<rosparam>{'': 1}</rosparam>", "Write a name."),
        (
            '<param name="a" textfile="urdf/robot.urdf"/>',
            "Write $(find play)/urdf/robot.urdf: a relative path begins in the folder of the terminal.",
        ),
        (
            '<rosparam file="urdf/robot.urdf"/>',
            "Write $(find play)/urdf/robot.urdf: a relative path begins in the folder of the terminal.",
        ),
        (
            '<param name="a" textfile="package://play/urdf/r.urdf"/>',
            "Write $(find play)/urdf/r.urdf; package:// is for meshes of a URDF.",
        ),
    ],
)
def test_what_was_meant_is_proposed(refusal, write, inner, remedy):
    write("urdf/robot.urdf", "<robot/>")
    assert refusal(inner).remedy == remedy


@pytest.mark.parametrize("name", ["./nope.yaml", "package://play/a", "a//b"])
def test_a_path_is_quoted_as_it_is_written(refusal, name):
    said = refusal(f'<param name="a" textfile="{name}"/>').said
    assert said == f"FileNotFoundError: [Errno 2] No such file or directory: '{name}'"
