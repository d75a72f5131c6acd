"""`Simulation`: time, nodes, topics, services and parameters, asked from Python."""

import gc
import io
import math

import pytest

from simkit import SimkitError, Simulation, UnknownNameError
from simkit.commands.table import run_command
from simkit.graph import GraphError, LogLevel, ServiceFailed
from simkit.graph.log import StreamScreen
from simkit.msgs import Time, message_class

START = 1_600_088_400


@pytest.fixture
def turtle(sim):
    """A simulation with a turtle in it."""
    sim.rosrun("turtlesim", "turtlesim_node")
    sim.run(0.1)
    return sim


def test_time_begins_at_the_hour_of_the_lecture_and_passes_exactly(sim):
    assert sim.now == Time(START)
    sim.run(0.1)
    sim.run(0.2)
    sim.run(0)
    assert sim.now == Time(START, 300_000_000)


@pytest.mark.parametrize("seconds", [-1, -1e-9, math.nan, math.inf])
def test_time_that_cannot_pass_is_refused(sim, seconds):
    with pytest.raises(SimkitError, match="cannot pass"):
        sim.run(seconds)
    with pytest.raises(SimkitError, match="cannot pass"):
        sim.run_until(lambda: False, timeout=seconds)


def test_run_until_stops_at_the_event_that_makes_it_true(turtle):
    turtle.rostopic_pub("/turtle1/cmd_vel", "geometry_msgs/Twist", "{linear: {x: 1.0}}", rate=10)
    reached = turtle.run_until(lambda: turtle.latest("/turtle1/pose").x > 7.0, timeout=10)
    assert reached
    assert turtle.latest("/turtle1/pose").x == pytest.approx(7.0, abs=0.02)
    before = turtle.now
    assert not turtle.run_until(lambda: turtle.latest("/turtle1/pose").x > 100, timeout=0.5)
    assert (turtle.now - before).to_sec() == 0.5


def test_a_predicate_that_holds_already_costs_no_time(sim):
    assert sim.run_until(lambda: True, timeout=10)
    assert sim.now == Time(START)


def test_step_runs_one_event(sim):
    times = []
    sim.graph.executor.call_at(sim.graph.executor.now_ns + 5, lambda: times.append(sim.now))
    while sim.step():
        pass
    assert times == [Time(START, 5)]
    assert not sim.step()


def test_a_closed_simulation_says_so(package):
    sim = Simulation(package_path=[package.folder], screen=None)
    sim.close()
    sim.close()
    for deed in (
        lambda: sim.run(1),
        lambda: sim.run_until(lambda: True, timeout=1),
        sim.step,
        lambda: sim.rosrun("turtlesim", "turtlesim_node"),
        lambda: sim.rostopic_pub("/x", "std_msgs/String", "x"),
        lambda: sim.call("/x"),
        lambda: sim.wait_for_message("/tf"),
    ):
        with pytest.raises(GraphError, match="this simulation is closed; make a new one"):
            deed()


def test_a_dropped_simulation_ends_its_nodes_when_the_next_one_begins(package):
    package("wait.py", "import rospy\nrospy.init_node('wait')\nrospy.spin()\n")
    first = Simulation(package_path=[package.folder], screen=None)
    node = first.rosrun("play", "wait.py")
    first.run(0.1)
    assert node.alive
    del first
    gc.collect()
    with Simulation(screen=None):
        assert not node.alive


# -- topics


def test_the_latest_message_of_a_topic(turtle):
    pose = turtle.latest("/turtle1/pose")
    assert (round(pose.x, 3), pose.theta) == (5.544, 0.0)
    assert turtle.latest("turtle1/pose") == pose
    assert turtle.latest("/turtle1/cmd_vel") is None
    with pytest.raises(UnknownNameError, match="did you mean '/turtle1/pose'"):
        turtle.latest("/turtle1/poes")


def test_what_is_published_for_listeners_only_is_listened_to_from_the_first_question_on(sim):
    sim.rosrun("gazebo_ros", "gzserver", "worlds/empty.world")
    sim.run(0.1)
    assert sim.latest("/clock") is None
    assert "nobody has listened to /clock" in sim.log[-1].text
    sim.run(0.1)
    assert sim.latest("/clock").clock == sim.now


def test_a_latest_message_is_a_copy(turtle):
    turtle.latest("/turtle1/pose").x = 100
    assert turtle.latest("/turtle1/pose").x < 6


def test_wait_for_message(turtle):
    before = turtle.now
    pose = turtle.wait_for_message("/turtle1/pose")
    assert pose.x == pytest.approx(5.544445)
    assert 0 < (turtle.now - before).to_sec() <= 0.016
    with pytest.raises(SimkitError, match=r"no message on /turtle1/cmd_vel within 0\.5 s"):
        turtle.wait_for_message("/turtle1/cmd_vel", timeout=0.5)
    with pytest.raises(UnknownNameError, match="/turtle1/pose"):
        turtle.wait_for_message("/turtle1/posse")


TWIST = message_class("geometry_msgs/Twist")
VECTOR = message_class("geometry_msgs/Vector3")


@pytest.mark.parametrize(
    "value",
    [
        "{linear: {x: 1.5}, angular: {z: -0.5}}",
        "linear: {x: 1.5}\nangular:\n  z: -0.5\n",
        "[[1.5, 0, 0], [0, 0, -0.5]]",
        {"linear": {"x": 1.5}, "angular": {"z": -0.5}},
        [[1.5, 0, 0], [0, 0, -0.5]],
        TWIST(linear=VECTOR(1.5, 0, 0), angular=VECTOR(0, 0, -0.5)),
    ],
    ids=["flow", "block", "list text", "dict", "list", "message"],
)
def test_publishing_takes_yaml_values_and_messages(sim, value):
    node = sim.rostopic_pub("/cmd_vel", "geometry_msgs/Twist", value)
    sim.run(0)
    twist = sim.latest("/cmd_vel")
    assert (twist.linear.x, twist.angular.z) == (1.5, -0.5)
    assert sim.topics()["/cmd_vel"] == "geometry_msgs/Twist"
    node.shutdown()
    assert "/cmd_vel" not in sim.topics()


def test_publishing_once_is_latched_and_at_a_rate_repeats(sim):
    record = sim.record({"/once": "std_msgs/String", "/often": "std_msgs/String"})
    sim.rostopic_pub("/once", "std_msgs/String", "hello")
    often = sim.rostopic_pub("/often", "std_msgs/String", "hello", rate=4)
    sim.run(1)
    assert [message.data for _, message in record["/once"]] == ["hello"]
    assert [(time - Time(START)).to_sec() for time, _ in record["/often"]] == [
        0,
        0.25,
        0.5,
        0.75,
        1,
    ]
    often.shutdown()
    sim.run(1)
    assert len(record["/often"]) == 5
    late = sim.record(["/once"])
    sim.run(0)
    assert len(late["/once"]) == 1


@pytest.mark.parametrize(
    ("arguments", "words", "text"),
    [
        (("/x", "geometry_msgs/Twst"), None, "did you mean geometry_msgs/Twist"),
        (("/x", "geometry_msgs/Twist", "{liner: {x: 1}}"), None, "did you mean linear"),
        (("/x", "geometry_msgs/Twist", "{linear: ["), None, "Argument error"),
        (("/x", "geometry_msgs/Twist", {"linear": {"x": "fast"}}), "{linear: {x: fast}}", "'fast'"),
        (("two words", "std_msgs/String", "x"), None, "not a legal name"),
    ],
)
def test_publishing_what_is_wrong_is_refused_as_rostopic_does(sim, arguments, words, text):
    with pytest.raises(SimkitError, match=text) as of_method:
        sim.rostopic_pub(*arguments)
    line = list(arguments) if words is None else [*arguments[:2], words]
    with pytest.raises(SimkitError) as of_command:
        run_command(sim, "rostopic", ["pub", *line, *([] if len(line) > 2 else ["{}"])])
    assert str(of_command.value).removeprefix("ERROR: ") == str(of_method.value).removeprefix(
        "ERROR: "
    )
    assert sim.nodes() == ["/simkit"]


@pytest.mark.parametrize("rate", [0, -1, math.nan, math.inf])
def test_a_rate_that_cannot_be_is_refused_as_rostopic_does(sim, rate):
    with pytest.raises(SimkitError) as of_method:
        sim.rostopic_pub("/x", "std_msgs/String", "x", rate=rate)
    with pytest.raises(SimkitError) as of_command:
        run_command(sim, "rostopic", ["pub", f"--rate={rate}", "/x", "std_msgs/String", "x"])
    assert str(of_command.value).endswith(str(of_method.value))


def test_a_message_is_published_as_the_type_that_it_has(sim):
    with pytest.raises(SimkitError, match="is a geometry_msgs/Twist, not a std_msgs/String"):
        sim.rostopic_pub("/x", "std_msgs/String", TWIST())


def test_a_recording_has_the_times_the_bytes_and_the_messages(turtle):
    record = turtle.record(["/turtle1/pose"])
    before = turtle.now
    turtle.run(0.16)
    record.stop()
    turtle.run(1)
    times = [(time - before).to_sec() for time, _ in record["/turtle1/pose"]]
    assert len(times) == 10
    assert times == sorted(times)
    raw = record.raw("/turtle1/pose")
    assert [time_ns for time_ns, _ in raw] == [t.to_nsec() for t, _ in record["/turtle1/pose"]]
    assert all(
        data == m.to_bytes() for (_, data), (_, m) in zip(raw, record["/turtle1/pose"], strict=True)
    )
    assert record.topics() == ["/turtle1/pose"]
    with pytest.raises(UnknownNameError, match="did you mean '/turtle1/pose'"):
        record["/turtle1/pos"]


def test_a_topic_that_is_still_to_come_is_recorded_with_its_type(sim):
    with pytest.raises(UnknownNameError):
        sim.record(["/later"])
    record = sim.record({"/later": "std_msgs/Int32"})
    sim.rostopic_pub("/later", "std_msgs/Int32", "7")
    sim.run(0)
    assert [message.data for _, message in record["/later"]] == [7]


# -- services and parameters


def test_calling_a_service_lets_the_time_pass_that_it_takes(turtle, run_script):
    answer = turtle.call("/spawn", 1, 2, 0.5, "turtle2")
    assert answer.name == "turtle2"
    assert turtle.call("spawn", x=3, y=3, theta=0).name == "turtle3"
    run_script(
        """
        import rospy, std_srvs.srv
        rospy.init_node('slow')
        def handle(request):
            rospy.sleep(request.data * 2.0)
            return True, 'done'
        rospy.Service('slow', std_srvs.srv.SetBool, handle)
        rospy.spin()
        """,
        seconds=0.1,
    )
    before = turtle.now
    assert turtle.call("/slow", True).message == "done"
    assert (turtle.now - before).to_sec() == pytest.approx(2.0)
    with pytest.raises(ServiceFailed, match=r"did not answer within 0\.5 s"):
        turtle.call("/slow", True, timeout=0.5)


def test_a_call_that_cannot_be_is_refused(turtle):
    with pytest.raises(UnknownNameError, match="did you mean '/spawn'"):
        turtle.call("/spwan")
    with pytest.raises(TypeError, match="Invalid number of arguments"):
        turtle.call("/spawn", 1, 2)
    with pytest.raises(AttributeError, match="did you mean theta"):
        turtle.call("/spawn", teta=1)
    with pytest.raises(ServiceFailed, match="/kill"):
        turtle.call("/kill", "turtle9")


def test_services_parameters_and_nodes_can_be_listed(turtle):
    assert turtle.services()["/spawn"] == "turtlesim/Spawn"
    assert turtle.nodes() == ["/simkit", "/turtlesim"]
    assert turtle.params.get("/turtlesim/background_r") == 69
    assert turtle.topics()["/turtle1/pose"] == "turtlesim/Pose"


# -- nodes


def test_a_built_in_node_answers_as_a_script_does(sim):
    node = sim.rosrun("turtlesim", "turtlesim_node", "__name:=other", "_background_r:=0")
    assert (node.name, node.alive, node.exit_code, node.failure) == ("/other", True, None, None)
    assert (node.output, node.refusals) == ("", [])
    assert sim.params.get("/other/background_r") == 0
    node.shutdown()
    assert not node.alive
    assert sim.nodes() == ["/simkit"]


def test_what_a_built_in_node_prints_is_its_output(sim):
    assert "arrow keys" in sim.rosrun("turtlesim", "turtle_teleop_key").output


def test_a_built_in_node_that_cannot_start_is_not_half_there(sim):
    sim.params.set("/scale_linear", ["no", "number"])
    with pytest.raises(TypeError, match="float"):
        sim.rosrun("turtlesim", "turtle_teleop_key")
    assert sim.nodes() == ["/simkit"]


def test_unknown_packages_and_programs_name_near_ones(sim, package):
    package("listener.py", "pass")
    for arguments, text in [
        (("turtelsim", "turtlesim_node"), "no package 'turtelsim'; did you mean 'turtlesim'"),
        (("plya", "listener.py"), "did you mean 'play'"),
        (("turtlesim", "turtle_sim_node"), "did you mean 'turtlesim_node'"),
        (("play", "listner.py"), "did you mean 'listener.py'"),
    ]:
        with pytest.raises(UnknownNameError, match=text):
            sim.rosrun(*arguments)


def test_a_second_node_of_a_name_takes_its_place(turtle):
    turtle.rosrun("turtlesim", "turtlesim_node")
    turtle.run(0.1)
    assert turtle.nodes() == ["/simkit", "/turtlesim"]
    assert turtle.turtlesim.picture()
    assert any("same name" in record.text for record in turtle.log)


def test_the_simulation_itself_cannot_be_replaced_by_a_node(sim, run_script):
    node = run_script("import rospy\nrospy.init_node('simkit')\n", seconds=0.1)
    assert "/simkit is taken by the simulation itself" in node.failure.text
    sim.rostopic_pub("/x", "std_msgs/String", "still here")
    assert sim.wait_for_message("/x").data == "still here"


def test_without_a_turtlesim_there_is_no_picture(sim):
    with pytest.raises(SimkitError, match=r"sim\.rosrun\('turtlesim', 'turtlesim_node'\)"):
        _ = sim.turtlesim


def test_the_log_has_who_when_and_what(turtle):
    record = turtle.log[0]
    assert (record.node, record.level) == ("/turtlesim", LogLevel.INFO)
    assert record.time == Time(START)
    assert "Starting turtlesim" in record.text


def test_a_screen_shows_logs_and_prints_as_they_come(package):
    package(
        "talk.py",
        "import rospy\nrospy.init_node('talk')\nprint('printed ä', flush=True)\nrospy.sleep(1)\n"
        "rospy.logwarn('logged')\nrospy.logdebug('hidden')\nprint('end')\n",
    )
    stream = io.StringIO()
    with Simulation(package_path=[package.folder], screen=StreamScreen(stream)) as sim:
        sim.rosrun("play", "talk.py")
        sim.run(0.5)
        assert stream.getvalue() == "printed ä\n"
        sim.run(1)
    assert stream.getvalue().splitlines() == [
        "printed ä",
        "end",
        f"[WARN] [{START + 1}.000000] /talk: logged",
    ]


def test_a_package_path_comes_from_the_environment_too(package, monkeypatch, tmp_path):
    package("node.py", "print('found')")
    monkeypatch.setenv("SIMKIT_PACKAGE_PATH", str(package.folder))
    monkeypatch.chdir(tmp_path)
    with Simulation(screen=None) as sim:
        node = sim.rosrun("play", "node.py")
        sim.run(0.1)
    assert node.output == "found\n"


def launched(package):
    """A simulation with a node, a launch file and a model, one second old; and what a recording of it has."""
    (package.folder / "play" / "one.launch").write_text(
        "<launch><node pkg='turtlesim' type='turtlesim_node' name='t'/>"
        "<node pkg='play' type='talk.py' name='talk' output='screen'/></launch>"
    )
    package(
        "talk.py",
        """
        import random, rospy
        rospy.init_node("talk")
        rospy.loginfo("says %s", random.random())
        rospy.spin()
        """,
    )
    sim = Simulation(7, package_path=[package.folder], screen=None)
    sim.rosrun("tf", "static_transform_publisher", "1", "0", "0", "0", "0", "0", "a", "b", "100")
    sim.roslaunch("play", "one.launch")
    sim.spawn(
        "<robot name='box'><link name='a'><inertial><mass value='1'/>"
        "<inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial></link></robot>",
        xyz=(0, 0, 5),
    )
    return sim


def test_reset_begins_the_same_simulation_anew(package):
    with launched(package) as sim:
        seen = []
        for _ in range(3):
            sim.run(1.0)
            seen.append(
                (
                    sim.now,
                    sim.nodes(),
                    [str(record) for record in sim.log],
                    sim.world.models["box"].pose,
                    sim.tf_echo("a", "b"),
                )
            )
            sim.reset()
        assert seen[0] == seen[1] == seen[2]
        assert seen[0][3].translation[2] < 1.0
    assert sim.closed


def test_reset_ends_the_processes_of_the_nodes_before(package):
    with launched(package) as sim:
        sim.run(0.1)
        old = sim.roslaunch("play", "one.launch").nodes["/talk"]
        sim.reset()
        assert not old.alive


def test_a_start_that_can_be_made_no_more_is_named_and_can_be_mended(package):
    with launched(package) as sim:
        launch = package.folder / "play" / "one.launch"
        whole = launch.read_text()
        launch.unlink()
        with pytest.raises(SimkitError, match=r"one\.launch"):
            sim.reset()
        launch.write_text(whole)
        sim.reset()
        sim.run(0.1)
        assert "/talk" in sim.nodes()
