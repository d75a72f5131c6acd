from __future__ import annotations

import math
import re

import pytest

from simkit.commands.topic_statistics import bandwidth_text
from simkit.msgs import Duration, message_class

TWIST = "geometry_msgs/Twist"


def test_list(command):
    assert command("rostopic", "list") == (
        "/turtle1/cmd_vel\n/turtle1/color_sensor\n/turtle1/pose\n"
    )
    assert command("rostopic", "list", "-p").split() == ["/turtle1/color_sensor", "/turtle1/pose"]
    assert command("rostopic", "list", "-s").split() == ["/turtle1/cmd_vel"]
    assert command("rostopic", "list", "/turtle1/pose").split() == ["/turtle1/pose"]
    assert command("rostopic", "list", "/turtle").split() == []


def test_list_with_types_and_numbers(sim, command):
    for _ in range(2):
        sim.rostopic_pub("/turtle1/cmd_vel", TWIST, "{}", rate=1.0)
    assert command("rostopic", "list", "-v") == (
        "\n"
        "Published topics:\n"
        " * /turtle1/cmd_vel [geometry_msgs/Twist] 2 publishers\n"
        " * /turtle1/color_sensor [turtlesim/Color] 1 publisher\n"
        " * /turtle1/pose [turtlesim/Pose] 1 publisher\n"
        "\n"
        "Subscribed topics:\n"
        " * /turtle1/cmd_vel [geometry_msgs/Twist] 1 subscriber\n"
        "\n"
    )
    assert "Subscribed" not in command("rostopic", "list", "-v", "-p")


def test_info(command):
    assert command("rostopic", "info", "/turtle1/pose") == (
        "Type: turtlesim/Pose\n"
        "\n"
        "Publishers: \n"
        " * /turtlesim (simkit://turtlesim)\n"
        "\n"
        "Subscribers: None\n"
        "\n"
        "\n"
    )
    assert "Publishers: None\n\nSubscribers: \n * /turtlesim" in command(
        "rostopic", "info", "turtle1/cmd_vel"
    )


def test_the_ears_of_the_simulation_are_not_shown(sim, rosrun, command):
    rosrun("tf2_ros static_transform_publisher 0 0 0 0 0 0 world a")
    sim.run(0.1)
    assert "Subscribers: None" in command("rostopic", "info", "/tf_static")
    assert "/tf\n" not in command("rostopic", "list")


def test_type_and_find(command):
    assert command("rostopic", "type", "/turtle1/pose") == "turtlesim/Pose\n"
    assert command("rostopic", "type", "/turtle1/pose/x") == "turtlesim/Pose x float32\n"
    assert command("rostopic", "find", "turtlesim/Pose") == "/turtle1/pose\n"


@pytest.mark.parametrize(
    ("words", "text", "code"),
    [
        (["info", "/nope"], "ERROR: Unknown topic /nope", 1),
        (["type", "/nope"], "unknown topic type [/nope]", 1),
        (
            ["info", "/turtle1/pos"],
            "ERROR: Unknown topic /turtle1/pos\nhint: did you mean /turtle1/pose?",
            1,
        ),
        (
            ["type", "/turtle1/pose/X"],
            "no field named [/X]; did you mean x? "
            "Fields: x, y, theta, linear_velocity, angular_velocity",
            1,
        ),
        (["list", "-p", "-s"], "you may only specify one of -p, -s", 2),
        (["info"], "the following arguments are required: topic", 2),
        (["info", "bad name"], "ERROR: 'bad name' is not a legal name", 1),
        (["ech", "/x"], "rostopic has no command 'ech'; did you mean echo?", 64),
        ([], "rostopic needs a command: hz, bw, delay, echo, find, info, list, pub, type", 64),
    ],
)
def test_what_is_wrong(refusal, words, text, code):
    said, exit_code = refusal("rostopic", *words)
    assert text in said
    assert exit_code == code


def test_help_is_no_error(command):
    assert "rostopic echo" in command("rostopic", "--help")
    assert "usage: rostopic echo" in command("rostopic", "echo", "-h")


# -- echo


def test_echo_prints_messages_with_dashes_between(sim, command):
    start = sim.now
    text = command("rostopic", "echo", "/turtle1/pose", "-n", "2")
    assert text == 2 * (
        "x: 5.544444561004639\n"
        "y: 5.544444561004639\n"
        "theta: 0.0\n"
        "linear_velocity: 0.0\n"
        "angular_velocity: 0.0\n"
        "---\n"
    )
    assert (sim.now - start).to_sec() < 0.05
    assert not [name for name in sim.nodes() if "rostopic" in name]


def test_echo_of_a_field(command):
    assert command("rostopic", "echo", "-n", "1", "/turtle1/pose/x") == "5.544444561004639\n---\n"


def test_echo_stops_where_it_is_told(command):
    assert command("rostopic", "echo", "/turtle1/pose/x", messages=3).splitlines()[-1] == (
        "(3 messages; -n COUNT shows so many)"
    )
    assert command("rostopic", "echo", "/turtle1/pose/x", seconds=1.0).count("---") in (62, 63)


@pytest.fixture
def scan(sim):
    """Publishes a laser scan with three ranges, ten times a second."""
    made = message_class("sensor_msgs/LaserScan")
    scan = made(ranges=[1.0, 2.0, 3.0])
    scan.header.frame_id = "laser"
    scan.header.stamp.secs = 7
    sim.rostopic_pub("/scan", "sensor_msgs/LaserScan", scan, rate=10)


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["/scan/ranges[1]"], "2.0\n---\n"),
        (["/scan/ranges[1:]"], "[2.0, 3.0]\n---\n"),
        (["/scan/header/frame_id"], '"laser"\n---\n'),
        (["/scan/header/stamp", "-p"], "%time,field\n"),
        (["--noarr", "/scan"], 'ranges: "<array type: float32, length: 3>"\n'),
        (["--nostr", "/scan"], 'frame_id: "<string length: 5>"\n'),
    ],
)
def test_echo_of_parts(scan, command, words, text):
    assert text in command("rostopic", "echo", "-n", "1", *words)


def test_echo_for_a_plot(scan, command):
    header, first, second = command("rostopic", "echo", "-p", "-n", "2", "/scan").splitlines()
    assert header.startswith("%time,field.header.seq,field.header.stamp,field.header.frame_id,")
    assert header.endswith("field.ranges0,field.ranges1,field.ranges2")
    assert first.startswith("7000000000,")
    assert first.endswith("laser,0.0,0.0,0.0,0.0,0.0,0.0,0.0,1.0,2.0,3.0")
    assert len(header.split(",")) == len(second.split(","))


def test_echo_waits_for_a_topic(sim, rosrun, command):
    rosrun("tf static_transform_publisher 0 0 0 0 0 0 world a 100")
    text = command("rostopic", "echo", "/tf/transforms[0]/child_frame_id", "-n", "1")
    assert text == '"a"\n---\n'
    node = sim.graph.create_node("/late")
    made = message_class("std_msgs/Bool")
    sim.graph.executor.call_at(
        sim.now.to_nsec() + 2 * 10**9,
        lambda: node.advertise("/late", made, latch=True).publish(made(True)),
    )
    assert command("rostopic", "echo", "/late", "-n", "1") == (
        "WARNING: topic [/late] does not appear to be published yet\ndata: True\n---\n"
    )


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["/turtle1/pose/z"], "no field named [/z]"),
        (["/turtle1/cmd_vel"], "nothing was said on /turtle1/cmd_vel within 0.5 s: nobody"),
        (["/turtle1/poze"], "there is no such topic\nhint: did you mean /turtle1/pose?"),
        (["/scan/ranges[9]"], "ranges[9]: the array has 3 elements"),
        (["-n", "0", "/turtle1/pose"], "COUNT must be at least 1"),
        (["-n", "x", "/turtle1/pose"], "argument -n: invalid int value: 'x'"),
    ],
)
def test_echo_says_why_it_prints_nothing(scan, refusal, words, text):
    assert text in refusal("rostopic", "echo", *words, seconds=0.5)[0]


# -- hz


def test_hz(command):
    lines = command("rostopic", "hz", "/turtle1/pose", seconds=2.05).splitlines()
    assert lines == [
        "subscribed to [/turtle1/pose]",
        "average rate: 62.500",
        "\tmin: 0.016s max: 0.016s std dev: 0.00000s window: 62",
        "average rate: 62.500",
        "\tmin: 0.016s max: 0.016s std dev: 0.00000s window: 125",
    ]


def test_hz_of_uneven_gaps_and_a_window(sim, command):
    node = sim.graph.create_node("/uneven")
    made = message_class("std_msgs/Empty")
    publisher = node.advertise("/uneven", made)
    start = sim.now.to_nsec()
    for at in (0.1, 0.2, 0.5, 0.7):
        sim.graph.executor.call_at(start + round(at * 1e9), lambda: publisher.publish(made()))
    lines = command("rostopic", "hz", "/uneven", seconds=2.05).splitlines()
    gaps = [0.1, 0.3, 0.2]
    deviation = math.sqrt(sum((gap - 0.2) ** 2 for gap in gaps) / 3)
    assert lines[1:] == [
        "average rate: 5.000",
        f"\tmin: 0.100s max: 0.300s std dev: {deviation:.5f}s window: 4",
        "no new messages",
    ]
    assert "window: 10\n" in command("rostopic", "hz", "-w", "10", "/turtle1/pose", seconds=1.05)


def test_bandwidth_counts_the_bytes_of_the_wire(command):
    lines = command("rostopic", "bw", "/turtle1/pose", seconds=1.05).splitlines()
    assert lines[0] == "subscribed to [/turtle1/pose]"
    # A pose is five float32, 62.5 times a second.
    assert re.fullmatch(r"average: 1\.2\dKB/s", lines[1])
    assert re.fullmatch(r"\tmean: 0\.02KB min: 0\.02KB max: 0\.02KB window: 6\d", lines[2])


@pytest.mark.parametrize(
    ("sizes", "span", "text"),
    [
        ([8.0, 8.0], 2.0, "average: 8.00B/s\n\tmean: 8.00B min: 8.00B max: 8.00B window: 2\n"),
        ([1e6, 3e6], 1.0, "average: 4.00MB/s\n\tmean: 2.00MB min: 1.00MB max: 3.00MB window: 2\n"),
    ],
)
def test_bandwidth_in_one_unit(sizes, span, text):
    assert bandwidth_text(sizes, span) == text


def test_delay_is_the_age_of_the_header(sim, command):
    node = sim.graph.create_node("/late")
    publisher = node.advertise("/late", message_class("geometry_msgs/PoseStamped"))

    def publish():
        message = message_class("geometry_msgs/PoseStamped")()
        message.header.stamp = sim.now - Duration.from_nsec(250_000_000)
        publisher.publish(message)

    node.create_timer(Duration.from_nsec(100_000_000), publish)
    lines = command("rostopic", "delay", "/late", seconds=1.05).splitlines()
    assert lines[1:] == [
        "average delay: 0.250",
        "\tmin: 0.250s max: 0.250s std dev: 0.00000s window: 9",
    ]


def test_delay_needs_a_header(refusal):
    assert "msg does not have header" in refusal("rostopic", "delay", "/turtle1/pose")[0]


# -- pub


def pub(command, *words, **settings):
    return command("rostopic", "pub", *words, **settings)


@pytest.mark.parametrize(
    "words",
    [
        ["{linear: {x: 1.0}, angular: {z: 2.0}}"],
        ["linear: {x: 1}\nangular: {z: 2}"],
        ["[1, 0, 0]", "[0, 0, 2]"],
        ["[1.0, 0.0, 0.0]", "{z: 2}"],
        ["{x: 1}", "z: 2"],
    ],
)
def test_pub_takes_yaml_in_every_form(sim, command, words):
    assert pub(command, "/turtle1/cmd_vel", TWIST, *words) == (
        "publishing and latching message. Press ctrl-C to terminate\n"
    )
    sim.run(0.1)
    message = sim.latest("/turtle1/cmd_vel")
    assert (message.linear.x, message.angular.z) == (1.0, 2.0)
    assert "/rostopic_1" in sim.nodes()


def test_pub_once_lasts_three_seconds(sim, command):
    start = sim.now
    text = pub(command, "-1", "/chatter", "std_msgs/String", "hello")
    assert text == "publishing and latching message for 3.0 seconds\n"
    assert (sim.now - start).to_sec() == 3.0
    assert "/rostopic_1" not in sim.nodes()


def test_pub_repeats(sim, command):
    recording = sim.record({"/chatter": "std_msgs/String"})
    assert pub(command, "/chatter", "std_msgs/String", "data: hi", "-r", "10") == ""
    sim.run(1.0)
    assert len(recording["/chatter"]) == 11


def test_pub_stamps(sim, command):
    pub(command, "/p", "geometry_msgs/PointStamped", "{header: auto, point: [1, 2, 3]}")
    sim.run(0.1)
    assert 0 < (sim.now - sim.latest("/p").header.stamp).to_sec() <= 0.1
    pub(command, "/t", "std_msgs/Header", "{stamp: now, frame_id: world}")
    sim.run(0.1)
    assert 0 < (sim.now - sim.latest("/t").stamp).to_sec() <= 0.1


def test_pub_of_an_empty_message_needs_no_values(sim, command):
    pub(command, "/go", "std_msgs/Empty")
    sim.run(0.1)
    assert sim.latest("/go") is not None


def test_a_negative_number_stands_behind_two_dashes(sim, command):
    pub(command, "/x", "std_msgs/Float64", "--", "-1.5")
    sim.run(0.1)
    assert sim.latest("/x").data == -1.5


@pytest.mark.parametrize(
    ("words", "text", "code"),
    [
        (
            ["/p", "geometry_msgs/Twst", "{}"],
            "ERROR: invalid message type: geometry_msgs/Twst.\n"
            "hint: did you mean geometry_msgs/Twist",
            1,
        ),
        (
            ["/p", TWIST, "{linear: {q: 1}}"],
            "Args are: [linear.x linear.y linear.z angular.x angular.y angular.z]",
            1,
        ),
        (["/p", TWIST, "{pointz: 1}"], "ERROR: No field name [pointz]", 1),
        (
            ["/p", "geometry_msgs/Vector3", "1", "2"],
            " * Expected: ['x', 'y', 'z']",
            1,
        ),
        (
            ["/p", "trajectory_msgs/JointTrajectoryPoint", "{time_from_start: 1.5}"],
            "invalid msg_args type: 1.5",
            1,
        ),
        (
            ["/p", TWIST, "{linear: {x: fast}}"],
            "\n\nmsg file:\ngeometry_msgs/Vector3 linear\n  float64 x\n",
            1,
        ),
        (["/p", TWIST], "Please specify message values", 2),
        (["/p", TWIST, "{linear: {"], "Argument error: ", 2),
        (["/p"], "the following arguments are required: type", 2),
        (["-1", "-r", "3", "/p", TWIST, "{}"], "You cannot select both -r and -1 (--once)", 2),
        (["-r", "0", "/p", TWIST, "{}"], "rate must be greater than zero", 2),
        (["-r", "often", "/p", TWIST, "{}"], "rate must be a number", 2),
    ],
)
def test_pub_says_what_is_wrong(sim, refusal, words, text, code):
    said, exit_code = refusal("rostopic", "pub", *words)
    assert text in said
    assert exit_code == code
    assert not [name for name in sim.nodes() if "rostopic" in name]


# -- as a node


def test_as_a_node_for_launch_files(sim):
    publisher = sim.rosrun("rostopic", "rostopic", "pub", "/x", "std_msgs/Float64", "3", "-r", "10")
    echo = sim.rosrun("rostopic", "rostopic", "echo", "/x", "-n", "2")
    hz = sim.rosrun("rostopic", "rostopic", "hz", "/x")
    once = sim.rosrun("rostopic", "rostopic", "pub", "-1", "/y", "std_msgs/Float64", "4")
    sim.run(3.5)
    assert publisher.alive
    assert hz.alive
    assert echo.output == "data: 3.0\n---\ndata: 3.0\n---\n"
    assert (echo.alive, echo.program.exit_code) == (False, 0)
    assert (once.alive, once.program.exit_code) == (False, 0)
    assert "average rate: 10.000" in hz.output


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["list"], "as a node, rostopic can pub, echo, hz, bw, delay"),
        (["pub", "/x"], "the following arguments are required: type"),
        (["echo", "/turtle1/pose/q"], "no field named [/q]"),
    ],
)
def test_a_node_that_cannot_do_it_ends(sim, words, text):
    node = sim.rosrun("rostopic", "rostopic", *words)
    sim.run(0.1)
    assert not node.alive
    assert node.program.exit_code > 0
    assert text in node.output
