"""rosmsg and rossrv."""

import subprocess
import sys

import pytest

TWIST = """\
geometry_msgs/Vector3 linear
  float64 x
  float64 y
  float64 z
geometry_msgs/Vector3 angular
  float64 x
  float64 y
  float64 z

"""


@pytest.mark.parametrize("name", ["geometry_msgs/Twist", "geometry_msgs/Twist.msg"])
def test_fields_are_shown_with_those_of_nested_messages(simkit, name):
    assert simkit("rosmsg", "show", name) == (0, TWIST, "")


def test_constants_stand_first_and_headers_have_their_package(simkit):
    _, out, _ = simkit("rosmsg", "show", "rosgraph_msgs/Log")
    assert out.startswith("byte DEBUG=1\nbyte INFO=2\n")
    assert (
        "std_msgs/Header header\n  uint32 seq\n  time stamp\n  string frame_id\nbyte level\n" in out
    )


def test_a_name_without_package_shows_all_of_that_name(simkit):
    code, out, _ = simkit("rosmsg", "show", "Pose")
    assert code == 0
    assert out.startswith("[geometry_msgs/Pose]:\ngeometry_msgs/Point position\n")
    assert "\n[turtlesim/Pose]:\nfloat32 x\n" in out


def test_the_raw_text_is_the_definition_as_written(simkit):
    assert "float64" not in simkit("rosmsg", "show", "-r", "geometry_msgs/TwistStamped")[1]
    assert simkit("rossrv", "show", "--raw", "std_srvs/SetBool")[1].count("---") == 1


def test_services_have_two_parts(simkit):
    shown = "float32 x\nfloat32 y\nfloat32 theta\nstring name\n---\nstring name\n\n"
    assert simkit("rossrv", "show", "turtlesim/Spawn") == (0, shown, "")
    assert simkit("rossrv", "show", "std_srvs/Empty") == (0, "---\n\n", "")


def test_md5_sums_are_those_of_ros(simkit):
    md5 = "9f195f881246fdfa2798d1d3eebca84a"
    assert simkit("rosmsg", "md5", "geometry_msgs/Twist") == (0, f"{md5}\n", "")
    assert simkit("rosmsg", "md5", "Twist") == (0, f"[geometry_msgs/Twist]: {md5}\n", "")
    assert simkit("rossrv", "md5", "std_srvs/Empty")[1] == "d41d8cd98f00b204e9800998ecf8427e\n"


def test_lists(simkit):
    types = simkit("rosmsg", "list")[1].splitlines()
    assert types == sorted(types)
    assert "tf2_msgs/TFMessage" in types
    assert simkit("rosmsg", "package", "turtlesim")[1] == "turtlesim/Color\nturtlesim/Pose\n"
    assert simkit("rosmsg", "package", "-s", "turtlesim")[1] == "turtlesim/Color turtlesim/Pose\n"
    assert "turtlesim\n" in simkit("rossrv", "packages")[1]
    assert simkit("rossrv", "packages", "-s")[1].count("\n") == 1


@pytest.mark.parametrize(
    ("words", "code", "text"),
    [
        (("show", "geometry_msgs/Twst"), 1, "did you mean 'geometry_msgs/Twist'"),
        (("show", "Twst"), 1, "did you mean 'Twist'"),
        (("show", "geometry_msgs.msg.Twist"), 1, "package/Type"),
        (("show", "geometry_msgs::Twist"), 1, "package/Type"),
        (("md5", "no/Such"), 1, "no message type 'no/Such'"),
        (("package", "geometry_msg"), 1, "did you mean 'geometry_msgs'"),
        (("show",), 2, "TYPE"),
        (("shwo", "x"), 2, "shwo"),
        ((), 2, "COMMAND"),
    ],
)
def test_what_cannot_be_is_one_line_and_an_exit_code(simkit, words, code, text):
    found, out, err = simkit("rosmsg", *words)
    assert (found, out) == (code, "")
    assert text in err
    assert err.count("\n") == 1


def test_nothing_heavy_is_imported():
    code = (
        "import sys\nfrom simkit.cli import main\nmain(['rosmsg', 'show', 'geometry_msgs/Twist'])\n"
        "heavy = {'numpy', 'matplotlib', 'rosbags', 'simkit.simulation', 'asyncio', 'nbformat'}\n"
        "print(sorted(heavy & set(sys.modules)))"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == TWIST + "[]\n"


def test_info_is_show(simkit):
    assert simkit("rosmsg", "info", "Pose2D") == simkit("rosmsg", "show", "Pose2D")
