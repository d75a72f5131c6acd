"""Light and dark: a page alone is as the browser prefers, one in a notebook as the notebook."""

from __future__ import annotations

import pytest

from simkit.viz import RvizView
from simkit.viz.page.html import inline_frame
from simkit.viz.stage.scene import make_scene

pytestmark = pytest.mark.slow

ASK = """
const ground = () => getComputedStyle(document.body).backgroundColor;
const told = (theme, source = window) => {
  dispatchEvent(new MessageEvent("message", { data: { theme }, source }));
  return ground();
};
return [ground(), told("dark"), view.colors.sky, told("blue"), told("light", null), told("light"), view.colors.sky];
"""
# Stands for the page in the frame, which is a process of its own and answers when it likes.
INSIDE = """
window.heard = [];
const inside = { postMessage: ({ theme }) => heard.push(theme) };
Object.defineProperty(HTMLIFrameElement.prototype, "contentWindow", { get: () => inside });
"""
CHANGE = """
const later = (milliseconds) => new Promise((go) => setTimeout(go, milliseconds));
while (!heard.length) await later(20);
const first = heard.at(-1);
document.body.style.background = "#fafafa";
await later(500);
return [first, heard.at(-1)];
"""


def test_a_page_takes_the_colours_that_it_is_told(turtles, run_in_page):
    page = RvizView(make_scene(turtles, fixed_frame="world")).to_html()
    light, dark = "rgb(255, 255, 255)", "rgb(21, 25, 30)"
    answer = run_in_page(page, ASK, three_d=False)
    assert answer == [light, dark, "#22282f", dark, dark, light, "#e9edf2"]


def test_a_frame_is_told_what_is_around_it_and_when_that_changes(run_in_page):
    frame = inline_frame("<p>in it</p>", title="t", height=100)
    page = f'<body><style>body{{background:#101010}}</style><div style="background:transparent">{frame}</div></body>'
    assert run_in_page(page, CHANGE, before=INSIDE) == ["dark", "light"]
