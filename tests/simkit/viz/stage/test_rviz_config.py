from __future__ import annotations

import pytest

from simkit.errors import SimkitError
from simkit.viz import RvizSettings, display_of
from simkit.viz.stage.rviz_config import MOST_DISPLAYS, read_config, topic_displays
from simkit.viz.stage.rviz_settings import (
    LaserScanDisplay,
    OdometryDisplay,
    PathDisplay,
    RobotDisplay,
)

WHOLE = """
Panels: []
Visualization Manager:
  Displays:
    - Class: rviz/Grid
      Enabled: {grid}
    - Class: rviz/RobotModel
      Alpha: 0.5
      Collision Enabled: {collision}
      Enabled: {robot}
      Robot Description: robot_description
      Visual Enabled: {visual}
    - Class: rviz/TF
      Enabled: {tf}
  Global Options:
    Fixed Frame: base_link
"""
ALL = {"grid": "true", "collision": "false", "robot": "true", "visual": "true", "tf": "true"}


def read(tmp_path, text=WHOLE, **changes):
    file = tmp_path / "view.rviz"
    file.write_text(text.format(**(ALL | changes)))
    return read_config(file)


def test_a_whole_file(tmp_path):
    expected = RvizSettings(fixed_frame="base_link", robot_model="visual", alpha=0.5)
    assert read(tmp_path) == expected


@pytest.mark.parametrize(
    ("changes", "role"),
    [
        ({"robot": "false"}, None),
        ({"visual": "false"}, None),
        ({"visual": "false", "collision": "true"}, "collision"),
        ({"collision": "true"}, "visual"),
    ],
)
def test_which_shapes_of_the_robot(tmp_path, changes, role):
    assert read(tmp_path, **changes).robot_model == role


def test_displays_that_are_off_or_not_there(tmp_path):
    off = read(tmp_path, grid="false", tf="false")
    assert not off.show_grid
    assert not off.show_tf
    bare = read(tmp_path, "Visualization Manager: {{Displays: [null, 7], Global Options: 3}}")
    assert bare == RvizSettings(fixed_frame="", robot_model=None, show_tf=False, show_grid=False)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("a:\n  [", r"view\.rviz:2:4 is no configuration of RViz, which is YAML: expected"),
        ("just words", "it has no 'Visualization Manager'"),
        ("!!python/object/apply:os.system [true]", "which is YAML: could not determine"),
    ],
)
def test_what_is_no_configuration_is_refused_in_one_line(tmp_path, text, words):
    with pytest.raises(SimkitError, match=words) as error:
        read(tmp_path, text)
    assert "\n" not in str(error.value)


def test_a_file_that_is_not_there(tmp_path):
    with pytest.raises(SimkitError, match=r"cannot read .*none\.rviz: No such file"):
        read_config(tmp_path / "none.rviz")


def test_each_robot_has_a_prefix_of_its_own(tmp_path):
    assert read(tmp_path).robots == (RobotDisplay(),)
    two = read(
        tmp_path,
        "Visualization Manager: {{Displays: [{{Class: rviz/RobotModel, TF Prefix: left, "
        "Robot Description: left/robot_description}}, {{Class: rviz/RobotModel}}]}}",
    )
    assert two.robots == (RobotDisplay("/left/robot_description", "left"), RobotDisplay())


FILE = """
Visualization Manager:
  Displays:
    - Class: rviz/LaserScan
      Color: 0; 255; 0
      Color Transformer: {transformer}
      Enabled: true
      Name: LaserScan
      Size (m): 0.01
      Topic: /m2wr/laser/scan
    - Class: rviz/Group
      Enabled: {group}
      Displays:
        - Angle Tolerance: 0.2
          Class: rviz/Odometry
          Keep: 50
          Position Tolerance: 0.05
          Shape:
            Color: 255; 25; 0
            Head Length: 0.1
            Shaft Length: 0.4
            Value: Arrow
          Topic: odom
        - Class: rviz/Path
          Color: 0; 0; 255
          Topic: /plan
          Enabled: false
    - Class: rviz/Path
      Color: 0; 0; 255
      Topic: /plan
    - Class: rviz/Path
      Topic: ""
  Global Options:
    Fixed Frame: odom
"""


def topics_of_file(tmp_path, **changes):
    file = tmp_path / "view.rviz"
    file.write_text(FILE.format(**({"transformer": "Intensity", "group": "true"} | changes)))
    return read_config(file).topics


def test_displays_of_topics_are_read_also_in_groups(tmp_path):
    scan, odometry, path = topics_of_file(tmp_path)
    assert scan == LaserScanDisplay(topic="/m2wr/laser/scan")
    assert odometry == OdometryDisplay(
        topic="/odom", keep=50, position_tolerance=0.05, angle_tolerance=0.2, length=0.5
    )
    assert path == PathDisplay(topic="/plan", color=(0.0, 0.0, 1.0))


def test_a_group_that_is_off_shows_nothing(tmp_path):
    assert [one.topic for one in topics_of_file(tmp_path, group="false")] == [
        "/m2wr/laser/scan",
        "/plan",
    ]


def test_a_scan_may_have_one_colour(tmp_path):
    assert topics_of_file(tmp_path, transformer="FlatColor")[0].color == (0.0, 1.0, 0.0)


def test_what_is_not_said_is_as_rviz_begins_with():
    (found,) = topic_displays([{"Class": "rviz/Odometry", "Topic": "/odom"}])
    assert found == OdometryDisplay(topic="/odom", length=1.3)


@pytest.mark.parametrize("nonsense", ["x", None, -1, float("nan"), [], True])
def test_nonsense_is_not_taken(nonsense):
    (found,) = topic_displays(
        [
            {
                "Class": "rviz/Odometry",
                "Topic": "/odom",
                "Keep": nonsense,
                "Angle Tolerance": nonsense,
                "Shape": {"Color": nonsense, "Shaft Length": nonsense},
            }
        ]
    )
    assert found == OdometryDisplay(topic="/odom", length=1.3)
    assert topic_displays([{"Class": "rviz/Path", "Topic": "/p", "Color": "1; 2; 999"}]) == (
        display_of("/p", "nav_msgs/Path"),
    )


def test_keep_0_keeps_all_that_can_be_kept():
    (found,) = topic_displays([{"Class": "rviz/Odometry", "Topic": "/odom", "Keep": 0}])
    assert found.keep == 10_000


def test_a_file_with_very_many_displays_is_cut():
    many = [{"Class": "rviz/Path", "Topic": f"/p{n}"} for n in range(100)]
    assert len(topic_displays(many)) == MOST_DISPLAYS


@pytest.mark.parametrize("topic", [{"Value": "/scan"}, 3, "", "/", "a b", "~scan", "/a//b"])
def test_what_is_no_name_of_a_topic_is_not_listened_to(topic):
    assert topic_displays([{"Class": "rviz/Path", "Topic": topic}]) == ()
