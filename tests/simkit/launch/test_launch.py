"""A launch at work: parameters, nodes in order, ends, respawn, required."""

import pytest

from simkit import Simulation
from simkit.graph.process import Permissions
from simkit.launch import LaunchError

SLEEPER = """
    import rospy
    rospy.init_node("sleeper")
    print("awake", rospy.get_name(), rospy.get_param("~mood", None))
    rospy.loginfo("logged")
    rospy.logwarn("warned")
    rospy.spin()
    """
ENDER = """
    import rospy, sys
    rospy.init_node("ender")
    print("begin at", rospy.get_time() - 1600088400)
    rospy.sleep(float(rospy.get_param("~life", 1.0)))
    sys.exit(int(rospy.get_param("~code", 0)))
    """
TALKER = """
    import rospy
    from std_msgs.msg import String
    rospy.init_node("talker")
    publisher = rospy.Publisher("chatter", String, queue_size=1)
    while not rospy.is_shutdown():
        publisher.publish("hello")
        rospy.sleep(0.1)
    """


@pytest.fixture
def launch(sim, package, write):
    """A function that launches what stands in a `<launch>`."""
    for name, text in (("sleeper.py", SLEEPER), ("ender.py", ENDER), ("talker.py", TALKER)):
        package(name, text)

    def launch(inner, *arguments, seconds=0.0, **options):
        write("launch/a.launch", f"<launch>{inner}</launch>")
        started = sim.roslaunch("play", "a.launch", *arguments, **options)
        sim.run(seconds)
        return started

    return launch


def node(name, script="sleeper.py", inner="", **attributes):
    written = " ".join(f'{key}="{value}"' for key, value in attributes.items())
    return f'<node name="{name}" pkg="play" type="{script}" {written}>{inner}</node>'


def test_parameters_are_set_before_the_nodes_start(sim, launch):
    started = launch(
        '<param name="a" value="1"/>'
        + node("one", inner='<param name="mood" value="fine"/>')
        + node("two", ns="robots"),
        seconds=0.1,
    )
    assert sim.params.get("/a") == 1
    assert sim.params.get("/one/mood") == "fine"
    assert list(started.nodes) == ["/one", "/robots/two"]
    assert started.nodes["/one"].output == "awake /one fine\n"
    assert started.nodes["/robots/two"].output == "awake /robots/two None\n"
    assert started.alive
    assert started.exit_code is None
    assert [line for line in started.lines if line.startswith("process")] == [
        "process[one-1]: started play/sleeper.py",
        "process[two-2]: started play/sleeper.py",
    ]


def test_arguments_and_remappings_reach_the_nodes(sim, launch):
    launch(
        '<arg name="to" default="x"/>'
        + node("one", "talker.py", '<remap from="chatter" to="/$(arg to)"/>')
        + node("two", args="_mood:='so so'"),
        "to:=gossip",
        seconds=0.2,
    )
    assert sim.latest("/gossip").data == "hello"
    assert sim.params.get("/two/mood") == "so so"


def test_built_in_nodes_and_scripts_start_in_the_order_of_the_file(sim, launch):
    launch(
        node("b") + '<node name="turtle" pkg="turtlesim" type="turtlesim_node"/>' + node("a"),
        seconds=0.1,
    )
    assert [record.node for record in sim.log if record.node != "/simkit"][:2] == ["/turtle"] * 2
    spoken = [record.node for record in sim.log if record.text == "logged"]
    assert spoken == ["/b", "/a"]


def test_what_cannot_be_started_does_not_stop_the_rest(sim, launch, write):
    started = launch(
        node("a").replace("play", "plya") + node("b", "slepper.py") + node("c"), seconds=0.1
    )
    folder = write.folder.parent
    assert started.failures == [
        f"ERROR: cannot launch node of type [plya/sleeper.py]: plya\nROS path [0]={folder}",
        "ERROR: cannot launch node of type [play/slepper.py]: Cannot locate node of type [slepper.py] "
        "in package [play]. Make sure file exists in package path and permission is set to "
        "executable (chmod +x)",
    ]
    text = "\n".join(started.lines)
    assert "play/launch/a.launch:1:10: no package 'plya'; did you mean 'play'?" in text
    assert "did you mean 'sleeper.py'" in text
    assert list(started.nodes) == ["/c"]
    assert started.alive


def test_a_quotation_mark_that_is_not_closed_costs_one_node(launch):
    started = launch(node("a", args="it's") + node("b"), seconds=0.1)
    assert started.failures == [
        "ERROR: cannot launch node of type [play/sleeper.py]: No closing quotation"
    ]
    assert list(started.nodes) == ["/b"]


def test_a_node_that_ends_is_told_and_the_launch_with_the_last_one(sim, launch):
    started = launch(
        node("good", "ender.py")
        + node("bad", "ender.py", '<param name="code" value="3"/>', args="_life:=2"),
        seconds=1.5,
    )
    assert started.alive
    assert started.lines[-1] == "[good-1] process has finished cleanly"
    sim.run(1.0)
    assert not started.alive
    assert started.exit_code == 0
    assert started.lines[-3:] == [
        "[bad-2] process has died [exit code 3, cmd play/ender.py _life:=2 __name:=bad].",
        'what it printed last (its <node> has no output="screen"):\n    begin at 0.0',
        "all processes on machine have died, roslaunch will exit",
    ]


def test_respawn_on_virtual_time(sim, launch):
    started = launch(
        node("e", "ender.py", respawn="true", respawn_delay="0.5")
        + node("f", "ender.py", respawn="true", args="_life:=0.9"),
        seconds=0.0,
    )
    sim.run(4.0)
    begins = {}
    for planned, handle in started.handles:
        begins.setdefault(planned.name, []).append(float(handle.output.split()[-1]))
    assert begins["e"] == pytest.approx([0.0, 1.5, 3.0])
    assert begins["f"] == pytest.approx([0.0, 1.0, 2.0, 3.0, 4.0])
    assert "[e-1] restarting process" in started.lines
    started.shutdown()
    sim.run(5.0)
    assert not started.alive
    assert len(started.handles) == 8


def test_a_node_that_dies_at_once_does_not_stop_the_clock(sim, launch, package):
    package("broken.py", "1 / 0\n")
    started = launch(node("b", "broken.py", respawn="true"), seconds=1.0)
    assert len(started.handles) == 11
    assert started.handles[0][1].failure is not None


def test_required_ends_all(sim, launch):
    started = launch(node("a") + node("core", "ender.py", required="true", args="_code:=0"))
    sim.run(0.9)
    assert started.alive
    sim.run(1.0)
    assert not started.alive
    assert started.exit_code == 1
    assert sim.nodes() == ["/simkit"]
    line = "=" * 80
    assert (
        f"{line}REQUIRED process [core-2] has died!\nprocess has finished cleanly\n"
        f"Initiating shutdown!\n{line}"
    ) in started.lines
    assert started.lines[-1] == "[a-1] killing on exit"


def test_the_last_words_of_a_hidden_node_that_failed_are_told_once(sim, launch, package):
    package("fails.py", "print('usage: fails FILE')\nimport sys\nsys.exit('no FILE')")
    tag = '<node name="t" pkg="play" type="fails.py" {}/>'
    running = launch(tag.format('respawn="true"'))
    sim.run(1.0)
    text = "\n".join(running.lines)
    assert text.count("has died [exit code 1") > 1
    assert text.count('what it printed last (its <node> has no output="screen"):') == 1
    assert "\n    usage: fails FILE\n    no FILE" in text
    running.shutdown()
    shown = launch(tag.format('output="screen"'))
    sim.run(1.0)
    assert "what it printed last" not in "\n".join(shown.lines)


READERS = [
    ('<node name="n" pkg="robot_state_publisher" type="robot_state_publisher"/>', ""),
    ('<node name="n" pkg="joint_state_publisher" type="joint_state_publisher"/>', ""),
    (
        '<node name="n" pkg="gazebo_ros" type="spawn_model" args="-urdf -param /a/arm -model r"/>',
        "",
    ),
    (
        '<param name="robot_descripton" value="x"/>'
        '<node name="n" pkg="robot_state_publisher" type="robot_state_publisher"/>',
        "Did you mean robot_descripton?",
    ),
    (
        '<param name="robot_description" value="x"/>'
        '<node name="n" pkg="robot_state_publisher" type="robot_state_publisher">'
        '<remap from="robot_description" to="arm"/></node>',
        "",
    ),
]


@pytest.mark.parametrize(("inner", "remedy"), READERS)
def test_a_robot_that_nobody_has_described_is_told_where_it_is_needed(launch, inner, remedy):
    (line,) = [line for line in launch(inner).lines if "[LCH-E03]" in line]
    assert line.startswith(f"play/launch/a.launch:1:{10 + inner.index('<node')}: warning ")
    assert remedy in line


@pytest.mark.parametrize(
    "inner",
    [
        '<param name="robot_description" value="x"/>'
        '<node name="n" pkg="robot_state_publisher" type="robot_state_publisher" ns="a"/>',
        '<node name="n" pkg="robot_state_publisher" type="robot_state_publisher">'
        '<param name="robot_description" value="x"/></node>',
        '<node name="n" pkg="gazebo_ros" type="spawn_model" args="-urdf -file x -model r"/>',
        '<node name="n" pkg="gazebo_ros" type="spawn_model" args="\'-param"/>',
        '<node name="n" pkg="play" type="robot.py"/>',
    ],
)
def test_a_robot_that_may_be_described_is_not_told(launch, inner):
    assert "LCH-E03" not in "\n".join(launch(inner).lines)


def test_a_robot_may_have_been_described_before(sim, launch):
    sim.params.set("/robot_description", "x")
    inner = '<node name="n" pkg="robot_state_publisher" type="robot_state_publisher"/>'
    assert "LCH-E03" not in "\n".join(launch(inner).lines)


def test_shutdown_ends_the_last_one_first(sim, launch):
    started = launch(node("a") + node("b"), seconds=0.1)
    started.shutdown()
    assert started.lines[-2:] == ["[b-2] killing on exit", "[a-1] killing on exit"]
    sim.run(3.0)
    assert sim.nodes() == ["/simkit"]
    assert (started.alive, started.exit_code) == (False, 0)
    started.shutdown()


def test_a_launch_before_time_passes_can_be_ended(sim, launch):
    started = launch(node("a", respawn="true"))
    started.shutdown()
    sim.run(1.0)
    assert sim.nodes() == ["/simkit"]
    assert not started.alive


def test_launching_again_replaces_and_says_so(sim, launch):
    inner = node("a", respawn="true") + node("$(anon b)")
    first = launch(inner, seconds=0.5)
    second = launch(inner, seconds=5.0)
    assert second.lines[0] == "play/launch/a.launch runs already: its nodes end, and start anew"
    assert list(first.nodes) == list(second.nodes) == ["/a", "/b_1"]
    assert (first.alive, second.alive) == (False, True)
    assert sim.nodes() == ["/a", "/b_1", "/simkit"]


def test_other_arguments_are_another_launch(sim, launch):
    inner = '<arg name="ns"/><group ns="$(arg ns)">' + node("$(anon a)") + "</group>"
    one = launch(inner, "ns:=x")
    sim.run(0.1)
    two = launch(inner, "ns:=y")
    sim.run(0.1)
    assert (one.alive, two.alive) == (True, True)
    assert sim.nodes() == ["/simkit", "/x/a_1", "/y/a_2"]


def test_a_stranger_of_the_same_name_is_not_fought(sim, launch):
    started = launch(node("a", respawn="true"), seconds=0.5)
    sim.rosrun("play", "talker.py", "__name:=a")
    sim.run(5.0)
    assert len(started.handles) == 1
    assert "[a-1] another node took the name /a" in started.lines
    assert "/a" in sim.nodes()
    assert not started.alive


class Heard:
    """A screen that keeps what it is shown."""

    def __init__(self):
        self.shown = []

    def record(self, record):
        self.shown.append(record.text)

    def output(self, node, text):
        self.shown.append(text)


@pytest.mark.parametrize(("options", "shown"), [({}, False), ({"all_on_screen": True}, True)])
def test_what_a_node_prints_is_for_the_screen_only_if_it_says_so(sim, launch, options, shown):
    sim.graph.screen = Heard()
    started = launch(node("quiet") + node("loud", output="screen"), seconds=0.1, **options)
    text = "\n".join(sim.graph.screen.shown)
    assert "awake /loud" in text
    assert ("awake /quiet" in text) is shown
    assert text.count("warned") == 2
    assert text.count("logged") == (2 if shown else 1)
    note = 'note: what /quiet prints is not shown: its <node> has no output="screen"\n'
    assert sim.graph.screen.shown.count(note) == (not shown)
    assert started.nodes["/quiet"].output.startswith("awake")


def test_a_muted_name_is_free_again_afterwards(sim, launch):
    started = launch(node("a"), seconds=0.1)
    started.shutdown()
    sim.run(3.0)
    assert sim.graph.muted == {}
    assert sim.graph.departures == []


def test_a_relaunch_keeps_its_nodes_muted(sim, launch):
    launch(node("a"), seconds=0.1)
    launch(node("a"), seconds=3.0)
    assert list(sim.graph.muted) == ["/a"]


def test_without_nodes_it_is_over_at_once(sim, launch):
    started = launch('<param name="a" value="1"/>', seconds=0.1)
    assert (started.alive, started.exit_code, started.nodes) == (False, 0, {})
    assert sim.params.get("/a") == 1


def test_delete_clear_and_dump(sim, launch, tmp_path):
    for name in ("/old/x", "/g/y", "/keep"):
        sim.params.set(name, 1)
    file = tmp_path / "dumped.yaml"
    started = launch(
        f"""<rosparam command="dump" file="{file}"/>
        <rosparam command="delete" param="old"/> <rosparam command="delete" param="nope"/>
        <group ns="g" clear_params="true"><param name="z" value="2"/></group>"""
    )
    assert sim.params.names() == ["/g/z", "/keep"]
    assert file.read_text() == "g:\n  y: 1\nkeep: 1\nold:\n  x: 1\n"
    assert "running rosparam delete /old" in started.lines
    assert "ERROR: Parameter [/nope] is not set" in started.lines


def test_warnings_are_said(launch):
    started = launch("<nod/>")
    assert started.lines[0] == "WARNING: unrecognized tag nod"
    assert "play/launch/a.launch:1:10: warning [LCH-W11]" in started.lines[1]


def test_a_path_will_do(sim, write, monkeypatch):
    path = write("launch/b.launch", "<launch><param name='a' value='1'/></launch>")
    sim.roslaunch(path)
    monkeypatch.chdir(write.folder)
    started = sim.roslaunch("launch/b.launch")
    assert started.plan.file == "launch/b.launch"
    assert sim.params.get("/a") == 1


def test_a_text_will_do_and_is_not_the_next_one(sim):
    first = sim.roslaunch('<launch><node name="a" pkg="turtlesim" type="turtlesim_node"/></launch>')
    text = '<launch><arg name="n"/><node name="$(arg n)" pkg="turtlesim" type="turtlesim_node"/></launch>'
    plan = sim.launch_plan(text, "n:=b")
    assert (plan.file, plan.files, [node.name for node in plan.nodes]) == ("string", (), ["b"])
    sim.roslaunch(text, "n:=b")
    assert first.alive
    assert {"/a", "/b"} <= set(sim.nodes())


def test_a_plan_is_launched_as_it_is(sim, write):
    write("b.launch", "<launch><arg name='v'/><param name='a' value='$(arg v)'/></launch>")
    plan = sim.launch_plan("play", "b.launch", "v:=7")
    assert not sim.params.has("/a")
    sim.roslaunch(plan)
    assert sim.params.get("/a") == 7


def test_a_closed_simulation_launches_nothing(sim, launch):
    sim.close()
    with pytest.raises(Exception, match="closed"):
        launch(node("a"))


def test_the_robot_is_checked_once(sim, launch, write):
    write("r.urdf", '<robot name="r">\n<link name="a"/><link name="a"/></robot>')
    inner = '<param name="robot_description" textfile="$(find play)/r.urdf"/>'
    first = launch(inner)
    place, more = first.lines
    assert place.startswith("play/r.urdf:2:")
    assert "error [URDF-" in place
    assert more == "simkit check_urdf play/r.urdf says more"
    assert launch(inner).lines == []
    write("r.urdf", '<robot name="r"><link name="b"/><link name="b"/></robot>')
    assert len(launch(inner).lines) == 2


def test_permissions_hold_for_parameters_nodes_and_scripts(sim, launch):
    may = Permissions(
        publish=(), services=(), parameters=("/ok",), nodes=("turtlesim/turtlesim_node",)
    )
    started = launch(
        '<param name="ok" value="1"/><param name="other" value="2"/>'
        + '<rosparam command="delete" param="keep"/>'
        + '<node name="turtle" pkg="turtlesim" type="turtlesim_node"/>'
        + '<node name="cheat" pkg="rostopic" type="rostopic" args="pub /x std_msgs/String hi"/>'
        + node("t", "talker.py", '<param name="mine" value="3"/>'),
        seconds=0.5,
        permissions=may,
    )
    assert sim.params.get("/ok") == 1
    assert sim.params.get("/t/mine") == 3
    assert not sim.params.has("/other")
    assert list(started.nodes) == ["/turtle", "/t"]
    assert "/x" not in sim.topics()
    assert started.refusals == [
        "this launch file sets the parameter /keep, which this exercise does not allow (only /ok)",
        "this launch file sets the parameter /other, which this exercise does not allow (only /ok)",
        "this launch file starts rostopic/rostopic, which this exercise does not allow "
        "(only turtlesim/turtlesim_node)",
    ]
    assert "publishes on /chatter" in started.nodes["/t"].refusals[0]


def test_same_input_same_bytes(package, write):
    package("ender.py", ENDER)
    package("talker.py", TALKER)
    inner = (
        '<node name="turtle" pkg="turtlesim" type="turtlesim_node"/>'
        + node("$(anon t)", "talker.py")
        + node("e", "ender.py", respawn="true", output="screen")
    )
    write("launch/a.launch", f"<launch>{inner}</launch>")

    def run():
        with Simulation(package_path=[package.folder], screen=None, seed=5) as sim:
            started = sim.roslaunch("play", "a.launch")
            heard = sim.record({"/chatter": "std_msgs/String", "/turtle1/pose": "turtlesim/Pose"})
            sim.run(4.0)
            outputs = [(planned.name, handle.output) for planned, handle in started.handles]
            return [heard.raw(name) for name in heard.topics()], started.lines, outputs, sim.log

    assert run() == run()


def test_a_file_that_roslaunch_refuses_starts_nothing(sim, write):
    write("b.launch", "<launch><param name='a' value='1'/><node name='t'/></launch>")
    with pytest.raises(LaunchError, match="missing required attribute: 'pkg'"):
        sim.roslaunch("play", "b.launch")
    assert not sim.params.has("/a")
    assert sim.nodes() == ["/simkit"]
