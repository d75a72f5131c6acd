from __future__ import annotations

import urllib.request

from simkit import Simulation
from simkit.live.windows import open_windows


def test_each_rviz_prints_the_address_of_a_page_that_is_there():
    with Simulation(screen=None) as sim:
        rviz, turtles = sim.rosrun("rviz", "rviz"), sim.rosrun("turtlesim", "turtlesim_node")
        open_windows(sim, [rviz, turtles])
        (address,) = [word for word in rviz.output.split() if word.startswith("http://127.0.0.1:")]
        assert "http" not in turtles.output
        with urllib.request.urlopen(address, timeout=10) as answer:
            assert b'id="scene"' in answer.read()
