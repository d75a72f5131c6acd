"""What only a browser can tell: that the scripts of our pages run, draw and obey."""

from __future__ import annotations

import pytest

from simkit.viz import TurtleReplay

pytestmark = pytest.mark.slow


def test_a_replay_shows_every_moment(window, run_in_page):
    window.drive(1.0, 0.5)
    window.run(2.0)
    window.call("/spawn", "turtlesim/Spawn", x=2, y=3, theta=1, name="ann")
    window.run(2.0)
    window.call("/clear", "std_srvs/Empty")
    window.run(2.0)
    replay = TurtleReplay(window.frame)
    moments = run_in_page(
        replay.to_html(),
        """
        const slider = document.getElementById("time"), found = [];
        for (const time of [0, 1, 3, 5]) {
          slider.value = time;
          slider.dispatchEvent(new Event("input"));
          found.push({
            clock: document.getElementById("clock").value,
            rows: [...document.querySelectorAll("#poses tr")].slice(1).map((row) => row.innerText.split("\\t")),
            shown: [...document.querySelectorAll(".turtle")].map((turtle) => turtle.style.display !== "none"),
            points: [...document.querySelectorAll("polyline[stroke='#b3b8ff']")].map((line) => line.getAttribute("points")),
          });
        }
        return found;
        """,
    )
    history = window.frame.turtle("turtle1").history
    for time, moment in zip((0, 1, 3, 5), moments, strict=True):
        assert moment["clock"] == f"{time:.2f} s"
        assert moment["shown"] == [time > 2, True]
        sample = [s for s in history if s.time_ns <= replay.tape.start_ns + time * 10**9][-1]
        name, x, y, _ = moment["rows"][1]
        assert name == "turtle1"
        assert (float(x), float(y)) == pytest.approx((sample.pose.x, sample.pose.y), abs=0.02)
        (points,) = moment["points"]
        if time:
            tip = [float(value) for value in points.split()[-1].split(",")]
            assert (tip[0] - 0.5) / 45 == pytest.approx(sample.pose.x, abs=0.03)


def test_a_replay_plays_and_pauses(window, run_in_page):
    window.drive(1.0)
    window.run(1.0)
    found = run_in_page(
        TurtleReplay(window.frame).to_html(),
        """
        const play = document.getElementById("play"), slider = document.getElementById("time"), found = [];
        const note = () => found.push([play.textContent, Number(slider.value)]);
        note();
        play.click(); await frame(); await frame(); await frame(); note();
        play.click(); note(); await frame(); await frame(); note();
        play.click();
        await new Promise((go) => setTimeout(go, 1500)); note();
        return found;
        """,
    )
    start, playing, paused, later, ended = found
    assert start == ["Play", pytest.approx(0.96)]
    assert playing[0] == "Pause"
    assert 0 < playing[1] < 0.5
    assert paused == ["Play", playing[1]]
    assert later == paused
    assert ended == start
