from __future__ import annotations

import pytest

from simkit.errors import SimkitError
from simkit.viz import RvizSettings
from simkit.viz.robot_description import RobotDisplay
from simkit.viz.rviz_config import read_config

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
