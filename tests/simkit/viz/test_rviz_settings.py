from __future__ import annotations

import pytest

from simkit.errors import SimkitError, UnknownNameError
from simkit.viz import RvizSettings
from simkit.viz.scene import Displays
from simkit.viz.solid import Role


def test_displays_follow_the_settings():
    assert RvizSettings().displays == Displays(grid=True, tf=True, robot=Role.VISUAL)
    shown = RvizSettings(robot_model="collision", show_tf=False, show_grid=False)
    assert shown.displays == Displays(grid=False, tf=False, robot=Role.COLLISION)
    assert RvizSettings(robot_model=None).displays.robot is None


def test_what_makes_no_sense_is_refused():
    with pytest.raises(UnknownNameError, match="no robot model 'visuel'; did you mean 'visual'"):
        RvizSettings(robot_model="visuel")
    for alpha in (-0.1, 1.5, float("nan")):
        with pytest.raises(SimkitError, match="alpha is an opacity from 0 to 1"):
            RvizSettings(alpha=alpha)
