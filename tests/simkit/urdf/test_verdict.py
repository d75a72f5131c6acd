"""What check_urdf prints: ours against the texts that are known, and against urdfdom's own program."""

from __future__ import annotations

import gc
import itertools
import random
import re
import time
from pathlib import Path

import pytest

from simkit.urdf import check_urdf_text, read_robot
from simkit.xml import parse_xml

STRANGE = 0.03
"""So few of all accidents make broken XML that urdfdom reads on in, against all expectation, or not, and we differ."""
FAILED = "ERROR: Model Parsing the xml failed"
A = '<link name="a"/>'
AB = '<link name="a"/><link name="b"/>'
ENDS = '<parent link="a"/><child link="b"/>'
EFFORT = 'effort="1" velocity="1"'
NO_JOINT = "joint xml is not initialized correctly"
BALL = '<geometry><sphere radius="1"/></geometry>'


def robot(inner: str, attributes: str = 'name="r"') -> str:
    return f"<robot {attributes}>{inner}</robot>"


def joint(inner: str = "", attributes: str = 'name="j" type="continuous"', ends: str = ENDS) -> str:
    return robot(f"{AB}<joint {attributes}>{ends}{inner}</joint>")


def tensor(**changed: str | None) -> str:
    values = dict.fromkeys(("ixx", "ixy", "ixz", "iyy", "iyz", "izz"), "1") | changed
    return " ".join(f'{name}="{value}"' for name, value in values.items() if value is not None)


def inertial(inner: str) -> str:
    return robot(f'<link name="a"><inertial>{inner}</inertial></link>')


def visual(inner: str, kind: str = "visual") -> str:
    return robot(f'<link name="a"><{kind}>{inner}</{kind}></link>')


def shape(inner: str) -> str:
    return visual(f"<geometry>{inner}</geometry>")


LOST_VISUAL = "Could not parse visual element for Link [a]"
LOST_INERTIAL = "Could not parse inertial element for Link [a]"

BROKEN = {
    "tags cross": robot("<link name='a'></joint>"),
    "a tag is not closed": robot("<link name='a'>"),
    "an end tag is doubled": robot("<link name='a'></link></link>"),
    "the text ends in a tag": "<robot name='r'",
    "the text ends in words": "<robot name='r'> words",
    "the text ends in a comment": f"<robot name='r'>{A}<!-- ",
    "the text ends in a value": "<robot name='r",
    "an attribute is doubled": robot('<link name="a" name="a"/>'),
    "an attribute without a value": robot("<link name/>"),
    "a value with a lonely quote": robot('<link name=a"/>'),
    "a slash that ends nothing": robot('<link name="a"/ >'),
    "a number that is no letter": robot('<link name="&#zz;"/>'),
    "an open declaration": "<?xml version='1.0' <robot name='r'/>",
}
"""Texts that urdfdom gives up at, with words that name neither the place nor the fault."""

REFUSED = {
    "nothing": ("", ["Error document empty."]),
    "white space only": (" \n\t", ["Error document empty."]),
    "no XML": ("hello", ["Error document empty."]),
    "text before the declaration": (
        f"hello <?xml version='1.0'?>{robot(A)}",
        ["Error document empty."],
    ),
    "no robot": ('<sdf version="1.6"/>', ["Could not find the 'robot' element in the xml file"]),
    "only a comment": ("<!-- robot -->", ["Could not find the 'robot' element in the xml file"]),
    "no name": (robot(A, ""), ["No name given for the robot."]),
    "version 2": (
        robot(A, 'name="r" version="2.0"'),
        ["Invalid 'version' specified; only version 1.0 is currently supported"],
    ),
    "version 1": (
        robot(A, 'name="r" version="1"'),
        ["The version attribute should be in the form 'x.y'"],
    ),
    "half a version": (
        robot(A, 'name="r" version=".0"'),
        ["One of the fields of the version attribute is blank"],
    ),
    "version x": (robot(A, 'name="r" version="x.0"'), ["Version attribute is not an integer"]),
    "version 1.0b": (
        robot(A, 'name="r" version="1.0b"'),
        ["Extra characters after the version number"],
    ),
    "version -1": (robot(A, 'name="r" version="-1.0"'), ["Version number must be positive"]),
    "no link": (robot(""), ["No link elements found in urdf file"]),
    "a link twice": (robot(A + A), ["link 'a' is not unique."]),
    "two links without a name": (
        robot("<link/><link/>"),
        ["No name given for the link.", "No name given for the link.", "link '' is not unique."],
    ),
    "a joint twice": (
        robot(AB + f'<joint name="j" type="fixed">{ENDS}</joint>' * 2),
        ["joint 'j' is not unique."],
    ),
    "a material twice": (
        robot('<material name="m"><color rgba="1 1 1 1"/></material>' * 2 + A),
        ["material 'm' is not unique."],
    ),
    "two roots": (
        robot('<link name="b"/><link name="a"/>'),
        ["Failed to find root link: Two root links found: [a] and [b]"],
    ),
    "a circle": (
        robot(
            f'{AB}<joint name="j" type="fixed">{ENDS}</joint>'
            '<joint name="k" type="fixed"><parent link="b"/><child link="a"/></joint>'
        ),
        ["Failed to find root link: No root link found. The robot xml is not a valid tree."],
    ),
    "a joint to itself": (
        robot(f'{A}<joint name="j" type="fixed"><parent link="a"/><child link="a"/></joint>'),
        ["Failed to find root link: No root link found. The robot xml is not a valid tree."],
    ),
    "an unknown child": (
        joint(ends='<parent link="a"/><child link="zz"/>'),
        ["Failed to build tree: child link [zz] of joint [j] not found"],
    ),
    "an unknown parent": (
        joint(ends='<parent link="zz"/><child link="b"/>'),
        [
            "Failed to build tree: parent link [zz] of joint [j] not found.  This is not valid "
            "according to the URDF spec. Every link you refer to from a joint needs to be "
            "explicitly defined in the robot description. To fix this problem you can either "
            'remove this joint [j] from your urdf file, or add "<link name="zz" />" to your urdf '
            "file."
        ],
    ),
    "no child": (
        joint(ends='<parent link="a"/>'),
        ["Failed to build tree: Joint [j] is missing a parent and/or child link specification."],
    ),
    "a parent without a link": (
        joint(ends='<parent/><child link="b"/>'),
        ["Failed to build tree: Joint [j] is missing a parent and/or child link specification."],
    ),
    "a joint without a name": (
        joint(attributes='type="fixed"'),
        ["unnamed joint found", NO_JOINT],
    ),
    "a joint without a type": (
        joint(attributes='name="j"'),
        ["joint [j] has no type, check to see if it's a reference.", NO_JOINT],
    ),
    "an unknown type": (
        joint(attributes='name="j" type="ball"'),
        ["Joint [j] has no known type [ball]", NO_JOINT],
    ),
    "revolute without a limit": (
        joint(attributes='name="j" type="revolute"'),
        ["Joint [j] is of type REVOLUTE but it does not specify limits", NO_JOINT],
    ),
    "prismatic without a limit": (
        joint(attributes='name="j" type="prismatic"'),
        ["Joint [j] is of type PRISMATIC without limits", NO_JOINT],
    ),
    "a limit without effort": (
        joint('<limit velocity="1"/>'),
        ["joint limit: no effort", "Could not parse limit element for joint [j]", NO_JOINT],
    ),
    "a limit without velocity": (
        joint('<limit effort="1"/>'),
        ["joint limit: no velocity", "Could not parse limit element for joint [j]", NO_JOINT],
    ),
    "a limit of letters": (
        joint(f'<limit lower="x" {EFFORT}/>'),
        [
            "lower value (x) is not a valid float",
            "Could not parse limit element for joint [j]",
            NO_JOINT,
        ],
    ),
    "an axis of two": (
        joint('<axis xyz="1 0"/>'),
        [
            "Malformed axis element for joint [j]: Parser found 2 elements but 3 expected while "
            "parsing vector [1 0]",
            NO_JOINT,
        ],
    ),
    "an origin of four": (
        joint('<origin xyz="0 0 0 0"/>'),
        [
            "Parser found 4 elements but 3 expected while parsing vector [0 0 0 0]",
            "Malformed parent origin element for joint [j]",
            NO_JOINT,
        ],
    ),
    "commas": (
        joint('<origin rpy="0,0,0"/>'),
        [
            "Unable to parse component [0,0,0] to a double (while parsing a vector value)",
            "Malformed parent origin element for joint [j]",
            NO_JOINT,
        ],
    ),
    "dynamics that say nothing": (
        joint("<dynamics/>"),
        [
            "joint dynamics element specified with no damping and no friction",
            "Could not parse joint_dynamics element for joint [j]",
            NO_JOINT,
        ],
    ),
    "mimic without a joint": (
        joint("<mimic/>"),
        [
            "joint mimic: no mimic joint specified",
            "Could not parse mimic element for joint  [j]",
            NO_JOINT,
        ],
    ),
    "a safety controller without k_velocity": (
        joint("<safety_controller/>"),
        ["joint safety: no k_velocity", "Could not parse safety element for joint [j]", NO_JOINT],
    ),
    "calibration by letters": (
        joint('<calibration rising="x"/>'),
        [
            "rising value (x) is not a valid float",
            "Could not parse calibration element for joint  [j]",
            NO_JOINT,
        ],
    ),
}

TAKEN_WITH_WORDS = {
    "no mass": (
        inertial(f"<inertia {tensor()}/>"),
        ["Inertial element must have a mass element", LOST_INERTIAL],
    ),
    "a mass without a value": (
        inertial(f"<mass/><inertia {tensor()}/>"),
        ["Inertial: mass element must have value attribute", LOST_INERTIAL],
    ),
    "a mass of letters": (
        inertial(f'<mass value="abc"/><inertia {tensor()}/>'),
        ["Inertial: mass [abc] is not a float", LOST_INERTIAL],
    ),
    "no inertia": (
        inertial('<mass value="1"/>'),
        ["Inertial element must have inertia element", LOST_INERTIAL],
    ),
    "no iyz": (
        inertial(f'<mass value="1"/><inertia {tensor(iyz=None)}/>'),
        ["Inertial: inertia element missing iyz attribute", LOST_INERTIAL],
    ),
    "an ixy of letters": (
        inertial(f'<mass value="1"/><inertia {tensor(ixy="1,0")}/>'),
        ["Inertial: inertia element ixy is not a valid double", LOST_INERTIAL],
    ),
    "no geometry": (visual(""), [LOST_VISUAL]),
    "no shape": (shape(""), ["Geometry tag contains no child element.", LOST_VISUAL]),
    "a cone": (shape("<cone/>"), ["Unknown geometry type 'cone'", LOST_VISUAL]),
    "a box without a size": (
        shape("<box/>"),
        ["Box shape has no size attribute", LOST_VISUAL],
    ),
    "a box of two": (
        shape('<box size="1 2"/>'),
        [
            "Parser found 2 elements but 3 expected while parsing vector [1 2]",
            LOST_VISUAL,
        ],
    ),
    "a sphere without a radius": (
        shape("<sphere/>"),
        ["Sphere shape must have a radius attribute", LOST_VISUAL],
    ),
    "a space behind a number": (
        shape('<sphere radius="1 "/>'),
        ["radius [1 ] is not a valid float", LOST_VISUAL],
    ),
    "a cylinder without a length": (
        shape('<cylinder radius="1"/>'),
        ["Cylinder shape must have both length and radius attributes", LOST_VISUAL],
    ),
    "a mesh without a file": (
        shape("<mesh/>"),
        ["Mesh must contain a filename attribute", LOST_VISUAL],
    ),
    "a mesh with two factors": (
        shape('<mesh filename="a.stl" scale="1 1"/>'),
        [
            "Mesh scale was specified, but could not be parsed: Parser found 2 elements but 3 "
            "expected while parsing vector [1 1]",
            LOST_VISUAL,
        ],
    ),
    "a material without a name": (
        visual(f"{BALL}<material/>"),
        ["Visual material must contain a name attribute", LOST_VISUAL],
    ),
    "an origin with commas": (
        visual(f'<origin xyz="0, 0, 0"/>{BALL}', "collision"),
        [
            "Unable to parse component [0,] to a double (while parsing a vector value)",
            "Could not parse collision element for Link [a]",
        ],
    ),
    "a link without a name": (robot("<link/>"), ["No name given for the link."]),
    "a colour beyond 1": (
        robot(f'<material name="m"><color rgba="2 0 0 1"/></material>{A}'),
        [
            "Material [m] has malformed color rgba values: Unable to parse component [2] to a "
            "double (while parsing a color value)",
            "Material [m] color has no rgba",
            "Material [m] not defined in file",
        ],
    ),
    "a material of the robot without a name": (
        robot(f"<material/>{A}"),
        ["Material must contain a name attribute"],
    ),
}

TAKEN_SILENTLY = {
    "unknown tags": robot('<gazebo reference="zz"/><link name="a"><pose>0</pose></link>'),
    "unknown attributes": joint('<axis xyz="0 1 0" rpy="0 0 0"/>'),
    "lower beyond upper": joint(f'<limit lower="1" upper="-1" {EFFORT}/>'),
    "an impossible inertia": inertial(f'<mass value="-1"/><inertia {tensor(izz="9")}/>'),
    "a negative box": shape('<box size="-1 -1 -1"/>'),
    "an axis of zeros": joint('<axis xyz="0 0 0"/>'),
    "an axis without numbers": joint("<axis/>"),
    "mimic of an unknown joint": joint('<mimic joint="zz"/>'),
    "a mesh that is missing": shape('<mesh filename="package://zz/a.stl"/>'),
    "three colours": robot(f'<material name="m"><color rgba="1 0 0"/></material>{A}'),
    "an empty name": robot('<link name=""/>', 'name=""'),
    "no quotation marks": robot("<link name=a />", "name=r"),
    "a stray ampersand": robot('<link name="a & b"/>'),
    "letters by number": "<?xml version='1.0'?>" + robot('<link name="&#228;&#x41;&lt;"/>'),
    "comments with two dashes": robot(f"<!-- -- -->{A}"),
    "blank lines before the declaration": f"\n\n<?xml version='1.0'?>{robot(A)}",
    "a mark before the declaration": f"\ufeff<?xml version='1.0'?>{robot(A)}",
    "a second robot": robot(A) + robot(AB),
    "rubbish behind the robot": robot(A) + "</robot> <<< &",
    "another element before the robot": f"<sdf/>{robot(A)}",
    "a newline in a name": robot('<link name="a\nb"/>'),
    "tabs before a number": joint('<origin xyz="\t1 +.5 -2e-3"/>'),
    "a link with two parents": robot(
        '<link name="a"/><link name="b"/><link name="c"/><joint name="j" type="fixed">'
        '<parent link="a"/><child link="b"/></joint><joint name="k" type="fixed">'
        '<parent link="b"/><child link="c"/></joint><joint name="l" type="fixed">'
        '<parent link="a"/><child link="c"/></joint>'
    ),
    "a circle beside the tree": robot(
        '<link name="x"/><link name="a"/><link name="b"/><joint name="j" type="fixed">'
        '<parent link="a"/><child link="b"/></joint><joint name="k" type="fixed">'
        '<parent link="b"/><child link="a"/></joint>'
    ),
    "CDATA": robot(f"<![CDATA[ <link> ]]>{A}"),
    "a document type": f"<!DOCTYPE robot>{robot(A)}",
    "a processing instruction": robot(f"<?go now?>{A}"),
    "version 1.0": robot(A, 'name="r" version="1.0"'),
}


def errors(texts: list[str]) -> list[str]:
    return [f"Error:   {text}" for text in texts]


@pytest.mark.parametrize("case", REFUSED)
def test_what_is_refused(case, check_urdf):
    text, words = REFUSED[case]
    assert check_urdf(text.encode()) == (b"", [*errors(words), FAILED], 255)


@pytest.mark.parametrize("case", TAKEN_WITH_WORDS)
def test_what_is_taken_with_words(case, check_urdf):
    text, words = TAKEN_WITH_WORDS[case]
    printed = check_urdf(text.encode())
    assert (printed.err, printed.code) == (errors(words), 0)
    assert b"Successfully Parsed XML" in printed.out


@pytest.mark.parametrize("case", TAKEN_SILENTLY)
def test_what_is_taken_silently(case, check_urdf):
    printed = check_urdf(TAKEN_SILENTLY[case].encode())
    assert (printed.err, printed.code) == ([], 0)


def test_the_tree_of_the_book(robots, check_urdf):
    printed = check_urdf((robots / "hello_ros_robot_3.urdf").read_bytes())
    assert printed == (
        b"robot name is: hello_ros_robot\n"
        b"---------- Successfully Parsed XML ---------------\n"
        b"root Link: world has 1 child(ren)\n"
        b"    child(1):  base_link\n"
        b"        child(1):  torso\n"
        b"            child(1):  upper_arm\n",
        [],
        0,
    )


def test_children_come_by_the_names_of_their_joints(check_urdf):
    printed = check_urdf(
        b'<robot name="r"><link name="a"/><link name="b"/><link name="c"/>'
        b'<joint name="j2" type="fixed"><parent link="a"/><child link="b"/></joint>'
        b'<joint name="j1" type="fixed"><parent link="a"/><child link="c"/></joint></robot>'
    )
    assert printed.out.endswith(b"    child(1):  c\n    child(2):  b\n")


def test_a_material_that_is_only_a_name(check_urdf):
    warning = "Warning: link 'a' material 'silver' undefined."
    silver = f'<visual>{BALL}<material name="silver"/></visual>'
    first = check_urdf(robot(f'<link name="a">{silver}</link>').encode())
    assert (first.err, first.code) == ([warning, warning], 0)
    second = f'<link name="a"><visual>{BALL}</visual>{silver}</link>'
    assert check_urdf(robot(second).encode()).err == [warning]


def test_the_faults_of_the_book(printed_robots, check_urdf):
    def said(name):
        printed = check_urdf((printed_robots / "faulty" / f"{name}.urdf").read_bytes())
        return printed.err, printed.code

    doubled = (
        "line 46, column 5: </collision> stands here a second time; its element is closed already"
    )
    assert said("doubled_end_tag") == ([f"Error:   not well-formed XML: {doubled}", FAILED], 255)
    assert said("duplicate_attribute")[1] == 255
    assert said("missing_iyz") == (
        [
            "Error:   Inertial: inertia element missing iyz attribute",
            "Error:   Could not parse inertial element for Link [base_link]",
        ],
        0,
    )


@pytest.mark.parametrize("case", BROKEN)
def test_of_broken_xml_the_place_and_the_fault_are_named(case, check_urdf):
    fault = parse_xml(BROKEN[case], file="").faults[0]
    place = f"line {fault.span.line}, column {fault.span.column}"
    error = f"Error:   not well-formed XML: {place}: {fault.what}"
    assert check_urdf(BROKEN[case].encode()) == (b"", [error, FAILED], 255)


def agreed(ours, theirs, data: bytes) -> bool:
    """Whether the two say the same: of a text that is no well-formed XML only whether it is refused."""
    if parse_xml(data, file="").is_well_formed:
        return ours(data) == theirs(data)
    return ours(data).code == theirs(data).code


ALL_CASES = {
    **BROKEN,
    **{name: text for name, (text, _) in REFUSED.items()},
    **{name: text for name, (text, _) in TAKEN_WITH_WORDS.items()},
    **TAKEN_SILENTLY,
}


def test_the_real_program_says_the_same_to_each_case(check_urdf, real_check_urdf):
    different = [
        name
        for name, text in ALL_CASES.items()
        if not agreed(check_urdf, real_check_urdf, text.encode())
    ]
    assert different == []


def test_the_real_program_says_the_same_to_the_robots_of_the_book(
    all_robots, check_urdf, real_check_urdf
):
    for path in all_robots:
        assert agreed(check_urdf, real_check_urdf, path.read_bytes()), path.name


PIECES = [
    *"<>/\"'&= \n\t01.-ex;:",
    *("<!--", "-->", "<?xml", "?>", "<![CDATA[", "]]>", "&#228;", "&#x41;", "&amp;", "&foo;"),
    *(
        "</link>",
        '<link name="q"/>',
        "<joint>",
        "<visual/>",
        'name="a"',
        "0 0 0",
        "nan",
        '""',
        "&#",
    ),
    *('<robot name="z">', "</robot>", "\r\n", "é", "\x7f"),
]
TOKEN = re.compile(r'"[^"]*"|<[a-z_]+|[a-z_]+=')


def mutated(text: str, rng: random.Random) -> str:
    """The text with one to six accidents."""
    for _ in range(rng.choice((1, 1, 1, 2, 3, 6))):
        start, length = rng.randrange(len(text) + 1), rng.choice((1, 1, 2, 5, 20, 100))
        before, after = text[:start], text[start:]
        match rng.randrange(6):
            case 0 | 1:
                text = before + rng.choice(PIECES) + after
            case 2:
                text = before + after[length:]
            case 3:
                other = rng.randrange(len(text) + 1)
                text = before + text[other : other + length] + after
            case 4:
                text = before if rng.random() < 0.3 else text
            case _:
                tokens = list(TOKEN.finditer(text))
                if tokens:
                    here, there = rng.choice(tokens), rng.choice(tokens)
                    text = text[: here.start()] + there.group() + text[here.end() :]
    return text


def differing(robots: list[Path], seed: int, count: int, ours, theirs) -> list[str]:
    rng = random.Random(seed)
    texts = [path.read_text(encoding="utf-8") for path in robots]
    found = []
    for _ in range(count):
        text = mutated(rng.choice(texts), rng).replace("\r\n", "\n")
        if not agreed(ours, theirs, text.encode()):
            found.append(text)
    return found


def is_sound(text: str) -> bool:
    return parse_xml(text, file="").is_well_formed


def test_the_real_program_says_the_same_to_accidents(all_robots, check_urdf, real_check_urdf):
    found = differing(all_robots, 1, 300, check_urdf, real_check_urdf)
    assert not [text for text in found if is_sound(text)]
    assert len(found) < 300 * STRANGE


@pytest.mark.slow
def test_the_real_program_says_the_same_to_many_accidents(all_robots, check_urdf, real_check_urdf):
    found = differing(all_robots, 2, 2_000, check_urdf, real_check_urdf)
    assert not [text for text in found if is_sound(text)]
    assert len(found) < 2_000 * STRANGE


@pytest.mark.slow
def test_no_accident_raises_or_hangs(all_robots, check_urdf):
    rng = random.Random(3)
    texts = [path.read_text(encoding="utf-8") for path in all_robots]
    longest = 0.0
    for _ in range(4_000):
        data = mutated(rng.choice(texts), rng).encode()
        start = time.process_time()
        assert check_urdf(data).code in (0, 255)
        longest = max(longest, time.process_time() - start)
    assert longest < 1.0


def test_a_circle_below_the_root_is_refused_where_the_original_prints_for_ever(read):
    ends = [("j1", "r", "a"), ("j2", "a", "b"), ("j3", "b", "a")]
    joints = "".join(
        f'<joint name="{name}" type="fixed"><parent link="{parent}"/><child link="{child}"/></joint>'
        for name, parent, child in ends
    )
    reading = read('<link name="r"/><link name="a"/><link name="b"/>' + joints)
    assert reading.robot is None
    assert reading.refusal.startswith("The links hang on each other in a circle: a -> b -> a")


def test_a_tree_beyond_all_use_ends(check_urdf):
    """Each link hangs twice on the one above it: the original prints 2^60 lines."""
    links = "".join(f'<link name="l{number}"/>' for number in range(61))
    joints = "".join(
        f'<joint name="{side}{number}" type="fixed"><parent link="l{number}"/>'
        f'<child link="l{number + 1}"/></joint>'
        for number in range(60)
        for side in "ab"
    )
    printed = check_urdf(robot(links + joints).encode())
    assert printed.code == 0
    assert printed.out.endswith(b"\n...\n")
    assert len(printed.out) < 5_000_000


def test_a_long_text_takes_time_in_proportion():
    names = itertools.count()

    def seconds(count: int) -> float:
        name = f'name="r{next(names)}"'
        links = "".join(f'<link name="l{number}"/>' for number in range(count))
        joints = "".join(
            f'<joint name="j{number}" type="fixed"><parent link="l0"/><child link="l{number}"/></joint>'
            for number in range(1, count)
        )
        text = robot(links + joints, name)
        gc.disable()  # what a collection costs depends on all that earlier tests have left behind
        try:
            start = time.process_time()
            assert check_urdf_text(read_robot(text, file="r.urdf"))[2] == 0
            return time.process_time() - start
        finally:
            gc.enable()

    seconds(100)
    small = min(seconds(500) for _ in range(3))
    assert min(seconds(4000) for _ in range(2)) < 8 * small * 3
