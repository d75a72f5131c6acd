"""What only a browser can tell: that the scripts of our pages run, draw and obey."""

from __future__ import annotations

import html
import json
import re
import shutil
import subprocess

import pytest

from simkit.viz import FramesView, TurtleReplay

BROWSER = next(
    filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None
)
OPTIONS = (
    *("--headless", "--no-sandbox", "--disable-gpu", "--disable-background-networking"),
    *("--disable-component-update", "--no-first-run", "--window-size=900,700"),
    *("--virtual-time-budget=3000", "--dump-dom"),
)

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(BROWSER is None, reason="no chromium on this machine"),
]


@pytest.fixture
def run_in_page(tmp_path):
    """Opens a page, runs the body of an async function in it, and returns its answer."""

    def run(page, script):
        # Errors are collected from before the page's own script on. A browser without a screen
        # paints when it likes; timers follow its virtual time.
        collect = (
            "<script>window.faults=[];onerror=(text)=>{faults.push(text)};"
            "requestAnimationFrame=(draw)=>setTimeout(()=>draw(performance.now()),16)</script>"
        )
        ask = (
            "<script>(async()=>{const frame=()=>new Promise((go)=>requestAnimationFrame(go));"
            f"const answer=await(async()=>{{{script}}})().catch((error)=>faults.push(String(error)));"
            "document.body.setAttribute('data-answer',JSON.stringify({answer,faults}))})()</script>"
        )
        file = tmp_path / "page.html"
        text = page.replace("<body>", f"<body>{collect}", 1).replace("</body>", f"{ask}</body>")
        file.write_text(text, encoding="utf-8")
        command = [BROWSER, *OPTIONS, f"--user-data-dir={tmp_path / 'profile'}", file.as_uri()]
        done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=True)
        (answer,) = re.findall(r'data-answer="([^"]*)"', done.stdout)
        found = json.loads(html.unescape(answer))
        assert found["faults"] == []
        return found["answer"]

    return run


def test_frames_are_drawn_and_turned_by_keys_and_mouse(turtles, run_in_page):
    pictures = run_in_page(
        FramesView(turtles).to_html(),
        """
        const canvas = document.getElementById("scene"), found = [];
        const look = async () => { await frame(); await frame(); found.push(canvas.toDataURL()); };
        const key = (key, more) => canvas.dispatchEvent(new KeyboardEvent("keydown", { key, ...more }));
        const mouse = (type, clientX, clientY, more) =>
          canvas.dispatchEvent(new PointerEvent(type, { pointerId: 1, clientX, clientY, buttons: 1, ...more }));
        canvas.setPointerCapture = () => {};
        await look();
        key("ArrowLeft"); await look();
        key("Home"); await look();
        key("t"); await look();
        key("+"); await look();
        key("ArrowUp", { shiftKey: true }); await look();
        document.getElementById("reset").click(); await look();
        mouse("pointerdown", 300, 200); mouse("pointermove", 360, 180); mouse("pointerup", 360, 180); await look();
        document.getElementById("reset").click(); await look();
        document.getElementById("names").click(); await look();
        return found;
        """,
    )
    first, turned, home, top, near, moved, reset, dragged, again, nameless = pictures
    assert first == home == reset == again
    assert len({first, turned, top, near, moved, dragged, nameless}) == 7


def test_every_axis_colour_is_on_the_canvas(turtles, run_in_page):
    counts = run_in_page(
        FramesView(turtles).to_html(),
        """
        await frame(); await frame();
        const canvas = document.getElementById("scene");
        const data = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
        const wanted = [[224, 59, 59], [43, 168, 74], [63, 130, 242]];
        return wanted.map(([r, g, b]) => {
          let count = 0;
          for (let i = 0; i < data.length; i += 4) count += data[i] === r && data[i + 1] === g && data[i + 2] === b;
          return count;
        });
        """,
    )
    assert min(counts) > 30


def test_a_canvas_that_gets_its_room_late_is_drawn_in_it(turtles, run_in_page):
    # A notebook loads the page without room and tells of no resize of the window when it gives it some.
    sizes = run_in_page(
        FramesView(turtles).to_html(),
        """
        const canvas = document.getElementById("scene"), found = [];
        for (const shown of ["none", "block"]) {
          canvas.style.display = shown;
          const roomy = shown === "block";
          for (let i = 0; i < 100 && canvas.width > 0 !== roomy; i++) await frame();
          found.push(canvas.width);
        }
        return found;
        """,
    )
    assert sizes[0] == 0
    assert sizes[1] > 100


def test_an_empty_view_is_drawn_too(buffer, run_in_page):
    assert run_in_page(FramesView(buffer).to_html(), "await frame(); return 1;") == 1


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
