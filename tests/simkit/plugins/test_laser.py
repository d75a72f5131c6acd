"""The laser: what it sees agrees with geometry, and is told as Gazebo tells it."""

from __future__ import annotations

import math

import numpy as np
import pytest

from simkit.graph import LogLevel
from tests.simkit.plugins.samples import END_OF_SENSOR, PENDULUM, RAY, Sample, in_sensor

SAMPLE = Sample(
    robot=PENDULUM,
    tags={"topicName": "scan", "frameName": "bob"},
    before=in_sensor("ray", RAY),
    after=END_OF_SENSOR,
)

SCAN = "sensor_msgs/LaserScan"
STILL = "<gazebo><static>true</static></gazebo>"


@pytest.fixture
def laser(link):
    """Writes a robot that stands still, with a laser in the frame of its link."""

    def make(
        *,
        samples: int = 5,
        angles: tuple[float, float] = (-0.1, 0.1),
        reach: str = "<min>0.1</min><max>10</max>",
        more: str = "",
        vertical: str = "",
        resolution: float = 1,
        rate: float = 20,
        shape: str = "",
        pose: str = "0 0 0 0 0 0",
        plugin: str = "<topicName>scan</topicName><frameName>base</frameName>",
    ) -> str:
        return f"""{link("base", shape)}{STILL}
        <gazebo reference="base"><sensor name="eye" type="ray">
          <pose>{pose}</pose><update_rate>{rate}</update_rate>
          <ray><scan><horizontal><samples>{samples}</samples><resolution>{resolution}</resolution>
              <min_angle>{angles[0]}</min_angle><max_angle>{angles[1]}</max_angle></horizontal>{vertical}</scan>
            <range>{reach}</range>{more}</ray>
          <plugin name="laser" filename="libgazebo_ros_laser.so">{plugin}</plugin>
        </sensor></gazebo>"""

    return make


@pytest.fixture
def thing(link):
    """Writes a thing that stands still."""

    def make(shape: str) -> str:
        return link("thing", shape) + STILL

    return make


def scan_of(stage, text, at=(0.0, 0.0, 1.0), **options):
    """One scan of a robot."""
    stage.spawn(text, pose=stage.at(*at), **options)
    heard = stage.listen("/scan", SCAN)
    stage.run(0.06)
    return heard[-1]


def test_a_sphere_is_as_far_as_geometry_says(stage, laser, thing):
    stage.spawn(thing('<sphere radius="0.5"/>'), name="ball", pose=stage.at(3, 0.1, 1))
    scan = scan_of(stage, laser(samples=41, angles=(-0.2, 0.2)))
    angles = np.linspace(-0.2, 0.2, 41)
    along = 3 * np.cos(angles) + 0.1 * np.sin(angles)
    under = along**2 - (3**2 + 0.1**2 - 0.5**2)
    hits = under > 0
    expected = np.where(hits, along - np.sqrt(np.where(hits, under, 0)), np.inf)
    assert 0 < hits.sum() < 41
    np.testing.assert_allclose(scan.ranges, expected, atol=1e-6)


def test_a_box_is_as_far_as_geometry_says(stage, laser, thing):
    stage.spawn(thing('<box size="1 8 2"/>'), name="wall", pose=stage.at(2.5, 0, 1))
    scan = scan_of(stage, laser(samples=31, angles=(-1.0, 1.0)))
    angles = np.linspace(-1.0, 1.0, 31)
    np.testing.assert_allclose(scan.ranges, 2 / np.cos(angles), atol=1e-6)


def test_a_cylinder_is_as_far_as_geometry_says(stage, laser, thing):
    stage.spawn(thing('<cylinder radius="0.4" length="3"/>'), name="post", pose=stage.at(2, 0, 1))
    scan = scan_of(stage, laser(samples=21, angles=(-0.15, 0.15)))
    angles = np.linspace(-0.15, 0.15, 21)
    under = 0.4**2 - (2 * np.sin(angles)) ** 2
    np.testing.assert_allclose(scan.ranges, 2 * np.cos(angles) - np.sqrt(under), atol=1e-6)


def test_the_ground_is_seen_by_a_laser_that_looks_down(stage, laser):
    scan = scan_of(stage, laser(samples=1, pose="0.2 0 0.3 0 0.5 0"))
    assert scan.ranges == (pytest.approx(1.3 / math.sin(0.5), abs=1e-6),)


def test_beams_count_counter_clockwise_in_the_frame_of_the_sensor(stage, laser, thing):
    stage.spawn(thing('<box size="1 1 1"/>'), name="left", pose=stage.at(0, 3, 1))
    ahead, left = scan_of(stage, laser(samples=2, angles=(0, math.pi / 2))).ranges
    assert (ahead, left) == (math.inf, pytest.approx(2.5, abs=1e-6))
    stage.gazebo.delete("r")
    turned = laser(samples=2, angles=(0, math.pi / 2), pose=f"0 0 0 0 0 {math.pi / 2}")
    ahead, left = scan_of(stage, turned).ranges
    assert (ahead, left) == (pytest.approx(2.5, abs=1e-6), math.inf)


def test_a_scan_says_how_it_was_made(stage, laser):
    plugin = "<topicName>scan</topicName><frameName>/eye</frameName>"
    scan = scan_of(stage, laser(samples=5, angles=(-0.5, 1.5), plugin=plugin))
    assert scan.header.frame_id == "eye"
    assert scan.header.stamp.to_nsec() == 50_000_000
    assert (scan.angle_min, scan.angle_max, scan.angle_increment) == (-0.5, 1.5, 0.5)
    assert (scan.range_min, scan.range_max) == (pytest.approx(0.1), 10.0)
    assert (scan.time_increment, scan.scan_time) == (0.0, 0.0)
    assert len(scan.ranges) == len(scan.intensities) == 5


def test_what_is_out_of_reach_is_inf_and_what_touches_the_beginning_is_minus_inf(
    stage, laser, thing
):
    stage.spawn(thing('<box size="1 1 1"/>'), name="wall", pose=stage.at(2.5, 0, 1))
    far = laser(samples=1, reach="<min>0.1</min><max>1.9</max>")
    assert scan_of(stage, far).ranges == (math.inf,)
    stage.gazebo.delete("r")
    touching = laser(samples=1, reach="<min>2.0</min><max>10</max>")
    assert scan_of(stage, touching).ranges == (-math.inf,)
    stage.gazebo.delete("r")
    beyond = laser(samples=1, reach="<min>3.5</min><max>10</max>")
    assert scan_of(stage, beyond).ranges == (math.inf,)


def test_a_laser_sees_its_own_robot(stage, laser):
    scan = scan_of(stage, laser(samples=1, shape='<box size="1 1 1"/>', pose="-0.8 0 0 0 0 0"))
    assert scan.ranges == (pytest.approx(0.3, abs=1e-6),)


def test_a_laser_inside_of_its_own_robot_sees_it_from_within(stage, laser):
    scan = scan_of(stage, laser(samples=1, shape='<sphere radius="0.5"/>'))
    assert scan.ranges == (pytest.approx(0.5, abs=1e-6),)


NOISE = "<noise><type>gaussian</type><mean>0.02</mean><stddev>0.01</stddev></noise>"


def test_noise_has_the_mean_and_the_deviation_that_it_should(stage, laser, thing):
    stage.spawn(thing('<box size="1 90 2"/>'), name="wall", pose=stage.at(2.5, 0, 1))
    scan = scan_of(stage, laser(samples=20_000, angles=(-0.001, 0.001), more=NOISE))
    errors = np.array(scan.ranges) - 2.0
    assert errors.mean() == pytest.approx(0.02, abs=4 * 0.01 / math.sqrt(20_000))
    assert errors.std() == pytest.approx(0.01, rel=0.03)


def test_noise_leads_never_beyond_the_reach(stage, laser, thing):
    stage.spawn(thing('<box size="1 90 2"/>'), name="wall", pose=stage.at(2.5, 0, 1))
    reach = "<min>0.1</min><max>2.01</max>"
    scan = scan_of(stage, laser(samples=500, angles=(-0.05, 0.05), more=NOISE, reach=reach))
    assert max(scan.ranges) == pytest.approx(2.01)


def test_equal_seeds_give_equal_scans_and_others_do_not(new_stage, laser, thing):
    def ranges(seed: int) -> list[float]:
        stage = new_stage(seed)
        stage.spawn(thing('<box size="1 9 2"/>'), name="wall", pose=stage.at(2.5, 0, 1))
        return scan_of(stage, laser(samples=50, more=NOISE)).ranges

    assert ranges(3) == ranges(3)
    assert ranges(3) != ranges(4)


def test_a_bias_is_the_same_for_all_beams_and_scans(stage, laser, thing):
    stage.spawn(thing('<sphere radius="0.5"/>'), name="ball", pose=stage.at(3, 0, 1))
    bias = "<noise type='gaussian'><bias_mean>0.3</bias_mean></noise>"
    stage.spawn(laser(samples=1, more=bias), pose=stage.at(z=1))
    heard = stage.listen("/scan", SCAN)
    stage.run(0.31)
    told = {round(one.ranges[0], 6) for one in heard}
    assert len(heard) > 4
    assert told in ({2.8}, {2.2})


def test_ranges_between_beams_are_interpolated(stage, laser, thing):
    stage.spawn(thing('<box size="1 90 2"/>'), name="wall", pose=stage.at(2.5, 0, 1))
    scan = scan_of(stage, laser(samples=3, angles=(-0.5, 0.5), resolution=2))
    side = 2 / math.cos(0.5)
    assert scan.angle_increment == pytest.approx(0.2)
    expected = np.interp(np.linspace(0, 2, 6), [0, 1, 2], [side, 2, side])
    np.testing.assert_allclose(scan.ranges, expected, atol=1e-6)


def test_the_rows_of_a_vertical_scan_follow_each_other_from_below(stage, laser, thing):
    vertical = "<vertical><samples>2</samples><min_angle>-0.5</min_angle><max_angle>0.5</max_angle></vertical>"
    scan = scan_of(stage, laser(samples=3, vertical=vertical))
    down = 1.0 / math.sin(0.5)
    assert scan.ranges == (*[pytest.approx(down, abs=1e-6)] * 3, *[math.inf] * 3)
    assert any("2 rows of 3" in text for text in stage.said())


def test_intensities_are_the_retro_of_what_is_hit(stage, laser, thing):
    shiny = thing('<box size="1 1 1"/>')
    shiny += '<gazebo reference="thing"><laserRetro>40</laserRetro></gazebo>'
    stage.spawn(shiny, name="wall", pose=stage.at(2.5, 0, 1))
    scan = scan_of(stage, laser(samples=2, angles=(0, 1.5)))
    assert scan.intensities == (40.0, 0.0)


def test_nothing_is_computed_while_nobody_listens(stage, laser, monkeypatch):
    (plugin,) = stage.spawn(laser(), pose=stage.at(z=1)).plugins
    casts = []
    cast = stage.gazebo.world.cast_rays
    monkeypatch.setattr(
        stage.gazebo.world, "cast_rays", lambda *a, **k: casts.append(1) or cast(*a, **k)
    )
    stage.run(0.3)
    assert casts == []
    heard = stage.listen("/scan", SCAN)
    stage.run(0.1)
    assert len(casts) == len(heard) == 2
    plugin.scan_points()
    assert len(casts) == 3


@pytest.mark.parametrize(("rate", "stamps"), [(20, [50, 100, 150]), (30, [34, 67, 100, 134])])
def test_scans_keep_their_rate(stage, laser, rate, stamps):
    heard_at = laser(rate=rate)
    stage.spawn(heard_at, pose=stage.at(z=1))
    heard = stage.listen("/scan", SCAN)
    stage.run(0.16)
    assert [one.header.stamp.to_nsec() // 1_000_000 for one in heard] == stamps


def test_views_get_the_points_without_noise(stage, laser, thing):
    stage.spawn(thing('<box size="1 9 2"/>'), name="wall", pose=stage.at(2.5, 0, 1))
    text = laser(samples=3, angles=(0, math.pi), more=NOISE)
    (plugin,) = stage.spawn(text, pose=stage.at(0.5, 0.2, 1)).plugins
    sight = plugin.scan_points()
    np.testing.assert_allclose(sight.points[0], [2.0, 0.2, 1.0], atol=1e-12)
    assert np.isnan(sight.points[1:]).all()
    np.testing.assert_allclose(sight.ranges, [1.5, np.inf, np.inf], atol=1e-12)
    assert stage.gazebo.world.targets[sight.targets[0]].model == "wall"


def test_a_robot_takes_its_laser_along(stage, laser, thing):
    stage.spawn(thing('<box size="1 9 2"/>'), name="wall", pose=stage.at(2.5, 0, 1))
    spawned = stage.spawn(laser(samples=1), pose=stage.at(z=1))
    heard = stage.listen("/scan", SCAN)
    stage.run(0.06)
    spawned.model.set_pose(stage.at(0.5, 0, 1, yaw=0.3))
    stage.run(0.05)
    assert [one.ranges[0] for one in heard] == [
        pytest.approx(2.0, abs=1e-6),
        pytest.approx(1.5 / math.cos(0.3), abs=1e-6),
    ]


def test_names_are_resolved_in_the_namespace_of_the_robot(stage, laser):
    stage.spawn(laser(), namespace="/car")
    assert "/car/scan" in stage.graph.topics
    stage.spawn(laser(plugin="<topicName>/scan2</topicName>"), name="b", namespace="/car")
    assert "/scan2" in stage.graph.topics


def test_a_laser_that_says_nothing_publishes_world_and_tells(stage, laser):
    stage.spawn(laser(plugin=""))
    assert "/world" in stage.graph.topics
    assert "Laser plugin missing <topicName>, defaults to /world" in stage.said(LogLevel.INFO)


def test_deleting_the_robot_ends_the_topic(stage, laser):
    stage.spawn(laser())
    stage.gazebo.delete("r")
    assert stage.graph.topics["/scan"].publishers == []


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("<samples>5<", "<samples>none<", "<samples> is a number, not 'none'"),
        ("<samples>5<", "<samples>0<", "<samples> is 0, and must be at least 1"),
        ("<samples>5<", "<samples>2.5<", "<samples> is a whole number, not '2.5'"),
        ("<max>10<", "<max>-1<", "<max> is -1, and must be at least 0"),
        ("<update_rate>20<", "<update_rate>often<", "<update_rate> is a number"),
        ("0 0 0 0 0 0", "0 0 0", "a <pose> is six numbers"),
        ('type="ray"', 'type="camera"', 'it stands in a <sensor type="ray">'),
        ("<resolution>1<", "<resolution>0<", "must be from 1 to 1000000, not 0"),
        ("</ray>", "<noise><type>pink</type></noise></ray>", "there is no noise of type 'pink'"),
    ],
)  # fmt: skip
def test_a_value_that_makes_no_sense_is_refused_with_its_place(stage, laser, old, new, says):
    text = laser()
    assert old in text
    assert stage.spawn(text.replace(old, new)).plugins == ()
    (error,) = [one for one in stage.said(LogLevel.ERROR) if says in one]
    assert error.startswith("r.urdf:")


def test_a_tag_that_nobody_reads_is_named_with_the_nearest(stage, laser):
    stage.spawn(laser().replace("<max_angle>", "<maxangle>1</maxangle><max_angle>"))
    (warning,) = stage.said()
    assert "<horizontal> does not read <maxangle>; did you mean <max_angle>?" in warning


def test_a_laser_without_a_reach_is_told(stage, laser):
    scan = scan_of(stage, laser(samples=2, reach=""))
    assert scan.ranges == (math.inf, math.inf)
    assert "sees nothing: its <range> goes from 0 m to 0 m" in stage.said()[0]


def test_a_laser_on_a_link_without_mass_is_told(stage, laser):
    arm = """<link name="arm"/><joint name="hinge" type="continuous">
        <parent link="base"/><child link="arm"/></joint>"""
    text = laser().replace('<gazebo reference="base">', '<gazebo reference="arm">')
    assert stage.spawn(arm + text).plugins == ()
    (error,) = stage.said(LogLevel.ERROR)
    assert "'eye' is on the link 'arm', which is not simulated, as it has no mass" in error


def test_a_laser_on_a_link_that_a_fixed_joint_holds_sees(stage, laser, thing):
    stage.spawn(thing('<box size="1 9 2"/>'), name="wall", pose=stage.at(2.5, 0, 1))
    mast = """<link name="mast"/><joint name="hold" type="fixed"><origin xyz="0.4 0 0" rpy="0 0 0.2"/>
        <parent link="base"/><child link="mast"/></joint>"""
    text = laser(samples=1).replace('<gazebo reference="base">', '<gazebo reference="mast">')
    assert scan_of(stage, text + mast).ranges == (pytest.approx(1.6 / math.cos(0.2), abs=1e-6),)
