"""A live view in a notebook: it follows the simulation, and its page asks no other port."""

from __future__ import annotations

import base64
import json

import nbformat

BEGIN = """
from simkit import Simulation
sim = Simulation(screen=None)
sim.rosrun("tf2_ros", "static_transform_publisher", *"1 0 0 0 0 0 world one".split())
sim.run(0.5)
view = sim.rviz(live=True)
view
"""
MORE = 'sim.rosrun("tf2_ros", "static_transform_publisher", *"0 2 0 0 0 0 world two".split()); sim.run(0.5)'
FRAME = "document.querySelector('.jp-OutputArea-output iframe[sandbox]')"


def test_a_live_view_is_a_widget_that_opens_no_port(lab):
    lab.page.call("Network.enable")
    lab.page.call("Page.setBypassCSP", enabled=False)
    lab.open(BEGIN, MORE, "print(view.widget.scene[:40], view._server)")
    lab.page.run(
        "window.asked = new Set(); new PerformanceObserver((list) => list.getEntries()"
        ".forEach((one) => asked.add(new URL(one.name).host)))"
        ".observe({type: 'resource', buffered: true}); true"
    )
    lab.run_cell(0)
    lab.page.wait(f"!!{FRAME}")
    lab.run_cell(1)
    lab.run_cell(2)
    assert '{"number":' in lab.output(2)
    assert "None" in lab.output(2)
    hosts = lab.page.run("[...asked].filter((host) => host && host !== location.host)")
    assert hosts == []
    lab.page.run(f"{FRAME}.scrollIntoView(); true")
    lab.page.screenshot("live_scene")
    policy = lab.page.run(f"{FRAME}.srcdoc.match(/Content-Security-Policy[^>]*/)[0]")
    assert "connect-src" not in policy
    assert "default-src 'none'" in policy


def test_what_is_saved_has_a_picture(lab):
    lab.open(BEGIN)
    lab.run_cell(0)
    lab.page.wait(f"!!{FRAME}")
    lab.page.run("panel.context.save().then(() => true)")
    notebook = nbformat.read(lab.folder / "lab.ipynb", as_version=4)
    saved = json.dumps(notebook.cells[0].outputs)
    start = saved.index("data:image/png;base64,") + len("data:image/png;base64,")
    assert base64.b64decode(saved[start : start + 40])[:4] == b"\x89PNG"
