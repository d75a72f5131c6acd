from __future__ import annotations

import math

import pytest

from simkit.graph import ServiceFailed

BACKGROUND = (69, 86, 255)


@pytest.fixture
def window(bench):
    return bench.start("turtlesim_node")


def test_start_log_and_parameters(bench, window) -> None:
    assert bench.said("INFO") == [
        "Starting turtlesim with node name /turtlesim",
        "Spawning turtle [turtle1] at x=[5.544445], y=[5.544445], theta=[0.000000]",
    ]
    names = [f"/turtlesim/background_{part}" for part in "rgb"]
    assert [bench.graph.params.get(name) for name in names] == list(BACKGROUND)


def test_topics_and_services_have_the_types_of_turtlesim(bench, window) -> None:
    types = bench.graph.topic_types()
    assert types["/turtle1/cmd_vel"] == "geometry_msgs/Twist"
    assert types["/turtle1/pose"] == "turtlesim/Pose"
    assert types["/turtle1/color_sensor"] == "turtlesim/Color"
    services = {name: server.service_class._type for name, server in bench.graph.services.items()}
    assert services == {
        "/clear": "std_srvs/Empty",
        "/kill": "turtlesim/Kill",
        "/reset": "std_srvs/Empty",
        "/spawn": "turtlesim/Spawn",
        "/turtle1/set_pen": "turtlesim/SetPen",
        "/turtle1/teleport_absolute": "turtlesim/TeleportAbsolute",
        "/turtle1/teleport_relative": "turtlesim/TeleportRelative",
    }


def test_a_namespace_holds_everything(bench) -> None:
    bench.start("turtlesim_node", name="/sim1/turtlesim")
    assert "/sim1/turtle1/pose" in bench.graph.topic_types()
    assert "/sim1/spawn" in bench.graph.services
    assert bench.graph.params.has("/sim1/turtlesim/background_r")


def test_pose_comes_every_16_ms_from_the_second_tick_on(bench, window) -> None:
    heard = bench.hear("/turtle1/pose", "turtlesim/Pose")
    bench.run(0.0319)
    assert heard == []
    bench.run(0.9681)
    assert len(heard) == 61
    assert heard[0].x == heard[0].y == pytest.approx(5.544444561, abs=1e-9)


def test_a_command_moves_the_turtle_for_a_second(bench, window) -> None:
    heard = bench.hear("/turtle1/pose", "turtlesim/Pose")
    bench.run(0.1)
    bench.command("/turtle1/cmd_vel", linear=2.0)
    bench.run(3.0)
    assert heard[-1].x == pytest.approx(5.5444446 + 63 * 0.016 * 2.0, abs=1e-5)
    assert heard[-1].linear_velocity == 0.0


def test_the_wall_is_warned_of_at_every_update(bench, window) -> None:
    bench.call("/turtle1/teleport_absolute", "turtlesim/TeleportAbsolute", x=11.0, y=2.0, theta=0.0)
    bench.command("/turtle1/cmd_vel", linear=2.0)
    bench.run(2.0)
    warnings = bench.said("WARN")
    assert warnings[0] == "Oh no! I hit the wall! (Clamping from [x=11.096000, y=9.088889])"
    assert warnings[1] == "Oh no! I hit the wall! (Clamping from [x=11.120889, y=9.088889])"
    assert len(warnings) == 61


def test_teleports_answer_at_once_and_act_at_the_next_tick(bench, window) -> None:
    bench.run(0.1)
    bench.call(
        "/turtle1/teleport_absolute", "turtlesim/TeleportAbsolute", x=2.0, y=3.0, theta=math.pi / 2
    )
    bench.call(
        "/turtle1/teleport_relative", "turtlesim/TeleportRelative", linear=1.0, angular=-math.pi / 2
    )
    heard = bench.hear("/turtle1/pose", "turtlesim/Pose")
    bench.run(0.02)
    assert (heard[0].x, heard[0].y, heard[0].theta) == pytest.approx((3.0, 3.0, 0.0), abs=1e-6)


def test_spawn_answers_with_the_name(bench, window) -> None:
    answer = bench.call("/spawn", "turtlesim/Spawn", x=2.0, y=4.0, theta=0.5, name="")
    assert answer.name == "turtle2"
    assert "/turtle2/cmd_vel" in bench.graph.topic_types()
    text = "Spawning turtle [turtle2] at x=[2.000000], y=[4.000000], theta=[0.500000]"
    assert bench.said("INFO")[-1] == text


def test_spawn_of_a_taken_name_fails_without_a_text(bench, window) -> None:
    with pytest.raises(ServiceFailed, match=r"^$"):
        bench.call("/spawn", "turtlesim/Spawn", name="turtle1")
    assert bench.said("ERROR") == ["A turtled named [turtle1] already exists"]


def test_spawn_of_an_illegal_name_fails_and_leaves_nothing(bench, window) -> None:
    with pytest.raises(ServiceFailed, match="not a legal name"):
        bench.call("/spawn", "turtlesim/Spawn", name="my turtle")
    assert len(bench.said("ERROR")) == 1
    assert [turtle.name for turtle in window.frame.turtles] == ["turtle1"]


def test_kill_ends_topics_and_services(bench, window) -> None:
    bench.call("/kill", "turtlesim/Kill", name="turtle1")
    assert not any(name.startswith("/turtle1") for name in bench.graph.topic_types())
    assert not any(name.startswith("/turtle1") for name in bench.graph.services)
    with pytest.raises(ServiceFailed, match=r"^$"):
        bench.call("/kill", "turtlesim/Kill", name="turtle1")
    assert bench.said("ERROR") == ["Tried to kill turtle [turtle1], which does not exist"]


def test_a_killed_turtle_can_be_spawned_again(bench, window) -> None:
    bench.call("/kill", "turtlesim/Kill", name="turtle1")
    bench.call("/spawn", "turtlesim/Spawn", x=1.0, y=1.0, theta=0.0, name="turtle1")
    heard = bench.hear("/turtle1/pose", "turtlesim/Pose")
    bench.run(0.1)
    assert heard[-1].x == 1.0


def test_reset_keeps_the_topics_of_turtle1_alive(bench, window) -> None:
    heard = bench.hear("/turtle1/pose", "turtlesim/Pose")
    bench.call("/spawn", "turtlesim/Spawn", name="zoe")
    bench.command("/turtle1/cmd_vel", linear=1.0)
    bench.run(0.5)
    bench.call("/reset", "std_srvs/Empty")
    assert bench.said("INFO")[-2:] == [
        "Resetting turtlesim.",
        "Spawning turtle [turtle1] at x=[5.544445], y=[5.544445], theta=[0.000000]",
    ]
    heard.clear()
    bench.run(0.1)
    assert heard[-1].x == pytest.approx(5.5444446)
    assert not any(name.startswith("/zoe") for name in bench.graph.topic_types())


def test_clear_takes_the_background_from_the_parameters(bench, window) -> None:
    bench.command("/turtle1/cmd_vel", linear=1.0)
    bench.run(0.5)
    bench.graph.params.set("/turtlesim/background_r", 200)
    bench.graph.params.set("/turtlesim/background_g", "green")
    bench.graph.params.set("/turtlesim/background_b", 255.6)
    heard = bench.hear("/turtle1/color_sensor", "turtlesim/Color")
    bench.run(0.1)
    assert (heard[-1].r, heard[-1].g, heard[-1].b) == (179, 184, 255)
    bench.call("/clear", "std_srvs/Empty")
    assert bench.said("INFO")[-1] == "Clearing turtlesim."
    assert window.frame.paper.strokes == ()
    assert window.frame.paper.background == (200, 86, 0)


def test_parameters_set_before_the_start_are_kept(bench) -> None:
    bench.graph.params.set("/turtlesim/background_b", 7)
    window = bench.start("turtlesim_node")
    assert window.frame.paper.background == (69, 86, 7)
    assert bench.graph.params.get("/turtlesim/background_b") == 7


def test_set_pen(bench, window) -> None:
    set_pen = ("/turtle1/set_pen", "turtlesim/SetPen")
    turtle = window.frame.turtle("turtle1")
    bench.call(*set_pen, r=1, g=2, b=3, width=0, off=0)
    assert (turtle.pen.color, turtle.pen.width, turtle.pen.is_down) == ((1, 2, 3), 1, True)
    bench.call(*set_pen, r=9, g=9, b=9, width=9, off=1)
    assert (turtle.pen.color, turtle.pen.width, turtle.pen.is_down) == ((1, 2, 3), 1, False)


def test_color_sensor_tells_the_trail_below(bench, window) -> None:
    heard = bench.hear("/turtle1/color_sensor", "turtlesim/Color")
    bench.command("/turtle1/cmd_vel", linear=1.0)
    bench.run(0.5)
    seen = [(color.r, color.g, color.b) for color in heard]
    assert seen[0] == BACKGROUND
    assert seen[-1] == (179, 184, 255)


def test_ending_the_node_ends_its_topics_and_ticks(bench, window) -> None:
    heard = bench.hear("/turtle1/pose", "turtlesim/Pose")
    bench.graph.nodes["/turtlesim"].shutdown()
    bench.run(1.0)
    assert heard == []
    assert bench.graph.services == {}


def test_two_windows_share_nothing(bench) -> None:
    one = bench.start("turtlesim_node", name="/a/turtlesim")
    two = bench.start("turtlesim_node", name="/b/turtlesim")
    bench.command("/a/turtle1/cmd_vel", linear=1.0)
    bench.run(0.5)
    assert len(one.frame.paper.strokes) == 1
    assert two.frame.paper.strokes == ()
