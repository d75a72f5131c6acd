from __future__ import annotations

import html
import math
import re

import pytest

from simkit.errors import UnknownNameError
from simkit.nodes.turtlesim import Frame
from simkit.viz import TurtleReplay
from simkit.viz.turtlesim.replay import turtle_tape


@pytest.fixture
def replay(window):
    window.drive(1.0, 0.5)
    window.run(1.0)
    window.call("/spawn", "turtlesim/Spawn", x=2, y=3, theta=0, name="ann")
    window.run(2.0)
    window.call("/kill", "turtlesim/Kill", name="ann")
    window.run(1.0)
    return TurtleReplay(window.frame)


def test_it_has_a_window_a_button_a_slider_and_speeds(replay, read_page):
    page = read_page(replay.to_html())
    assert page.by_id("play")[0] == "button"
    _, slider = page.by_id("time")
    assert (slider["type"], slider["min"], slider["max"]) == ("range", "0", "3.968")
    assert slider["value"] == slider["max"]
    assert slider["aria-label"]
    assert [a["value"] for tag, a in page.tags if tag == "option"][2] == "1"
    assert page.by_id("window")[1]["aria-label"].startswith("turtlesim with 2 turtles")


def test_without_a_script_it_shows_the_end(replay, window, read_page):
    page = read_page(replay.to_html())
    (line,) = [a for tag, a in page.tags if tag == "polyline" and a["stroke"] == "#b3b8ff"]
    x, y = (float(value) for value in line["points"].split()[-1].split(","))
    pose = window.frame.turtle("turtle1").pose
    assert (x - 0.5) / 45 == pytest.approx(pose.x, abs=0.01)
    assert (499 + 0.5 - y) / 45 == pytest.approx(pose.y, abs=0.02)
    turtles = [a for tag, a in page.tags if a.get("class") == "turtle"]
    assert [a.get("style") for a in turtles] == ["display:none", None]


def test_data_for_the_script_are_the_tape(replay, read_page):
    data = read_page(replay.to_html()).data
    tape = replay.tape
    assert data["duration"] == tape.duration
    assert len(data["turtles"]) == len(tape.motions) == 2
    assert data["turtles"][0]["until"] == pytest.approx(2.96, abs=0.02)
    assert data["turtles"][1]["rows"][-1] == pytest.approx(
        tape.motions[1].track.rows[-1], abs=0.006
    )
    assert data["sheets"][0]["trails"][0]["rows"][0] == pytest.approx(
        tape.sheets[0].trails[0].track.rows[0], abs=0.006
    )


def test_a_minute_of_driving_is_a_small_file(window):
    window.drive(1.5, 0.6)
    window.run(60)
    assert len(TurtleReplay(window.frame).to_html()) < 60_000


def test_odd_names_are_only_names(read_page):
    frame = Frame()
    frame.spawn("</text><script>\x00", x=1, y=1)
    frame.update(16_000_000)
    page = read_page(TurtleReplay(frame).to_html())
    assert len(page.scripts) == 2
    assert page.texts.count("</text><script>\ufffd") == 2


def test_equal_runs_give_equal_text_and_later_moves_change_nothing(replay, window):
    text = replay.to_html()
    assert TurtleReplay(window.frame).to_html() == text
    window.run(1.0)
    assert replay.to_html() == text
    assert TurtleReplay(window.frame).to_html() != text


def test_before_the_first_update_it_is_an_empty_window(window, read_page):
    page = read_page(TurtleReplay(window.frame).to_html())
    assert page.data["turtles"] == []
    assert page.data["duration"] == 0.0


def test_notebooks_show_it_and_files_hold_it(replay, tmp_path):
    (source,) = re.findall(r'srcdoc="([^"]*)"', replay._repr_html_())
    assert html.unescape(source) == replay.to_html()
    assert repr(replay) == "TurtleReplay(3.97 s, 2 turtles)"
    replay.save(tmp_path / "run.html")
    assert (tmp_path / "run.html").read_text(encoding="utf-8") == replay.to_html()
    with pytest.raises(UnknownNameError, match=r"no replay format '\.gif'"):
        replay.save(str(tmp_path / "run.gif"))


def test_where_frames_are_stripped_the_end_is_seen(window):
    window.drive(1.0)
    window.run(1.0)
    replay = TurtleReplay(window.frame)
    svg, png = replay._repr_svg_(), replay._repr_png_()
    assert png.startswith(b"\x89PNG")
    before_the_frame = replay._repr_html_().partition("<iframe")[0]
    assert 'src="data:image/png;base64,' in before_the_frame
    assert "turtle1" in svg
    window.run(1.0)
    assert replay._repr_svg_() == svg


def at(rows, time):
    """Values at a time: the row that is not later, and the way to the next."""
    index = max(i for i, row in enumerate(rows) if row[0] <= time)
    before, after = rows[index], rows[min(index + 1, len(rows) - 1)]
    if after[0] == before[0]:
        return before[1:]
    ratio = (time - before[0]) / (after[0] - before[0])
    return tuple(a + ratio * (b - a) for a, b in zip(before[1:], after[1:], strict=True))


def metres(values):
    return ((values[0] - 0.5) / 45, 11.0888889 - (values[1] - 0.5) / 45)


def test_the_motion_is_the_history_with_fewer_rows(window):
    window.drive(1.0, 0.5)
    window.run(20)
    tape = turtle_tape(window.frame)
    (motion,) = tape.motions
    history = window.frame.turtle("turtle1").history
    assert len(history) > 1200
    assert len(motion.track.rows) < 200
    unwrapped = 0.0
    for before, sample in zip([history[0], *history], history, strict=False):
        unwrapped += math.remainder(sample.pose.theta - before.pose.theta, 2 * math.pi)
        x, y, heading = at(motion.track.rows, (sample.time_ns - tape.start_ns) / 1e9)
        assert metres((x, y)) == pytest.approx((sample.pose.x, sample.pose.y), abs=0.005)
        assert heading == pytest.approx(math.degrees(unwrapped), abs=1.0)


def test_times_count_from_the_first_update_to_the_last(window):
    window.run(2.0)
    tape = turtle_tape(window.frame)
    assert tape.start_ns == 1_600_088_400_032_000_000
    assert tape.duration == pytest.approx(2.0 - 0.032, abs=0.016)
    assert tape.motions[0].track.until is None


def test_a_rest_is_a_rest(window):
    window.run(3.0)
    window.drive(1.0)
    window.run(1.0)
    (motion,) = turtle_tape(window.frame).motions
    start = motion.track.rows[0][1]
    assert at(motion.track.rows, 2.9)[0] == start
    assert at(motion.track.rows, 3.9)[0] > start + 35


def test_a_teleport_is_a_jump_in_no_time(window):
    window.run(1.0)
    window.call("/turtle1/teleport_absolute", "turtlesim/TeleportAbsolute", x=1, y=2, theta=3)
    window.run(1.0)
    (motion,) = turtle_tape(window.frame).motions
    times = [row[0] for row in motion.track.rows]
    (jump,) = {time for time in times if times.count(time) == 2}
    assert metres(at(motion.track.rows, jump - 1e-6)) == pytest.approx((5.5444, 5.5444), abs=1e-3)
    assert metres(motion.track.rows[-1][1:3]) == pytest.approx((1, 2), abs=1e-3)


def test_a_turtle_that_is_killed_ends(window):
    window.call("/spawn", "turtlesim/Spawn", x=2, y=3, theta=0, name="ann")
    window.run(1.0)
    window.call("/kill", "turtlesim/Kill", name="ann")
    window.run(1.0)
    ann, turtle1 = turtle_tape(window.frame).motions
    assert (ann.name, turtle1.name) == ("ann", "turtle1")
    assert ann.track.until == pytest.approx(0.97, abs=0.02)
    assert (ann.number, turtle1.number) == (1, 0)


def test_trails_grow_with_the_turtle(window):
    window.drive(1.0, 0.5)
    window.run(6.0)
    tape = turtle_tape(window.frame)
    (motion,), (trail,) = tape.motions, tape.sheets[0].trails
    assert (trail.color, trail.width) == ("#b3b8ff", 3)
    for time in (1.0, 2.5, 5.9):
        assert at(trail.track.rows, time) == pytest.approx(at(motion.track.rows, time)[:2], abs=0.5)


def test_clearing_lays_a_new_sheet(window):
    window.drive(1.0)
    window.run(1.0)
    window.graph.params.set("/turtlesim/background_r", 200)
    window.call("/clear", "std_srvs/Empty")
    window.run(1.0)
    old, new = turtle_tape(window.frame).sheets
    assert (old.color, new.color) == ("#4556ff", "#c856ff")
    assert old.since == 0.0
    assert new.since == pytest.approx(0.97, abs=0.02)
    assert old.trails[0].track.rows[-1][0] <= new.since
    assert new.trails[0].track.rows[0][0] >= new.since - 0.001


def test_a_reset_begins_anew_and_keeps_the_past(window):
    window.drive(1.0)
    window.run(1.0)
    window.call("/reset", "std_srvs/Empty")
    window.run(1.0)
    tape = turtle_tape(window.frame)
    assert [motion.name for motion in tape.motions] == ["turtle1", "turtle1"]
    assert [motion.track.until is None for motion in tape.motions] == [False, True]
    assert len(tape.sheets) == 2


def test_before_the_first_update_nothing_is_on_the_tape(window):
    tape = turtle_tape(window.frame)
    assert tape.motions == ()
    assert tape.duration == 0.0


def test_a_turtle_that_is_nowhere_leaves_no_rows(window):
    window.run(0.1)
    nowhere = {"x": math.nan, "y": 1.0, "theta": 0.0}
    window.call("/turtle1/teleport_absolute", "turtlesim/TeleportAbsolute", **nowhere)
    window.run(0.1)
    (motion,) = turtle_tape(window.frame).motions
    assert all(math.isfinite(value) for row in motion.track.rows for value in row)
