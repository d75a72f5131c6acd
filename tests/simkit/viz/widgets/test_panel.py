"""What a saved notebook shows in place of widgets; how cells talk to it is in the tests of the widgets."""

from __future__ import annotations

import json

import pytest

from simkit.viz.widgets.panel import SavedStill

# An output as JupyterLab makes it: a panel with the widgets, then HTML.
OUTPUT = """
<div class="jp-OutputArea">
<div class="jp-OutputArea-child"><div class="lm-Panel jp-OutputArea-output" id="widgets">{}</div></div>
<div class="jp-OutputArea-child"><div class="jp-OutputArea-output" id="html">{}</div></div>
</div>"""
LOOK = """
const isSeen = (place) => getComputedStyle(place).display !== "none";
return [isSeen(document.getElementById("widgets")), isSeen(document.querySelector("#html > div"))];
"""


@pytest.fixture
def still(notebook):
    SavedStill(lambda: "<b>hip 0.5</b>", lambda: "hip 0.5").show(None)
    (bundle,) = notebook.shown
    return bundle["text/html"]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("widgets", "seen"),
    [
        ("<div>a slider</div>", [True, False]),
        ("Error displaying widget: model not found", [False, True]),
        ("Loading widget...", [False, True]),
    ],
)
def test_either_the_widgets_are_seen_or_the_still(run_in_page, still, widgets, seen):
    page = f"<body>{OUTPUT.format(widgets, still)}</body>"
    assert run_in_page(page, LOOK) == seen


def test_it_is_the_same_for_all_readers_of_notebooks(still):
    assert "<b>hip 0.5</b>" in still
    assert "http" not in still
    assert json.dumps(still)


def test_it_is_made_anew_only_if_its_text_is_another_one(notebook):
    made = []
    words = ["a"]
    shown = SavedStill(lambda: made.append(1) or f"<p>{words[0]}</p>", lambda: words[0])
    shown.refresh()
    assert made == []  # nobody looks at it yet
    shown.show(None)
    shown.refresh()
    notebook.end_cell()
    assert (len(made), notebook.updates) == (1, [])
    words[0] = "b"
    notebook.end_cell()
    assert [bundle["text/plain"] for bundle in notebook.updates] == ["b"]
    shown.show(None)
    assert len(notebook.shown) == 2
