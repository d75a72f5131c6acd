"""What only a browser can tell of the view in 3D: that it draws, where, in which colours, and that it obeys."""

from __future__ import annotations

from dataclasses import replace

import meshcat.geometry
import numpy as np
import pytest
from matplotlib.image import imread

from simkit.graph.params import ParameterServer
from simkit.packages import PackagePath
from simkit.viz import LiveRviz, RvizReplay, RvizSettings, RvizView, SceneSource
from simkit.viz.stage.parts import Role
from simkit.viz.stage.scene import Displays, make_scene
from simkit.viz.stage.style import AXIS_COLORS, rgb
from simkit.viz.still.scene_raster import scene_pixels

pytestmark = pytest.mark.slow

LOOK = """
await started;
const found = [];
const pixels = () => {
  view.draw();
  const copy = document.createElement("canvas"), picture = element("picture");
  [copy.width, copy.height] = [picture.width, picture.height];
  const paint = copy.getContext("2d");
  paint.drawImage(picture, 0, 0);
  return paint.getImageData(0, 0, copy.width, copy.height).data;
};
// Sums over all pixels: a fingerprint of the picture.
const print = (data, part) => data.reduce((sum, value, i) => sum + (i % 4 === part) * value * (i % 997), 0);
const look = () => { const data = pixels(); found.push([0, 1, 2, 3].map((part) => print(data, part))); };
const letters = () => {
  view.draw();
  const paper = element("labels");
  const { data } = paper.getContext("2d").getImageData(0, 0, paper.width, paper.height);
  return data.filter((value, i) => i % 4 === 3 && value > 200).length;
};
const place = element("scene");
place.setPointerCapture = () => {};
const key = (key, more) => place.dispatchEvent(new KeyboardEvent("keydown", { key, ...more }));
const mouse = (type, clientX, clientY, more) =>
  place.dispatchEvent(new PointerEvent(type, { pointerId: 1, clientX, clientY, buttons: 1, ...more }));
"""


def view(buffer, fixed_frame="world", **options):
    return RvizView(make_scene(buffer, fixed_frame=fixed_frame, **options))


@pytest.fixture
def photograph(browse, tmp_path):
    """The part of a page that is drawn in 3D, as it looks when it is opened from a file."""

    def photograph(shown):
        shown.save(tmp_path / "view.html")
        picture = tmp_path / "picture.png"
        browse((tmp_path / "view.html").as_uri(), f"--screenshot={picture}")
        image = imread(picture)[:, :, :3]
        # The page has a margin of 8 px, the view a border of 1 px and a height of 400 px.
        return image[9:407, 9 : image.shape[1] - 9]

    return photograph


def differs(image, *, by=0.06):
    """Which pixels are not the ground."""
    ground = image[5, 5]
    return np.abs(image - ground).max(axis=2) > by


def test_the_picture_is_the_one_that_is_drawn_without_a_browser(arm_frames, arm, photograph):
    displays = Displays(grid=False, tf=False)
    shown = view(arm_frames, robot=arm, displays=displays)
    image = photograph(shown)
    height, width, _ = image.shape
    still = scene_pixels(shown.scene, size=(width, height))
    ours, theirs = still[:, :, 3] > 60, differs(image)
    assert ours.sum() > 5000
    assert (ours & theirs).sum() / (ours | theirs).sum() > 0.97
    solid = (still[:, :, 3] == 255) & theirs
    error = np.abs(image[solid] - still[solid][:, :3] / 255.0)
    assert np.median(error) < 0.02


def test_a_cylinder_stands_upright(arm_frames, arm, photograph):
    torso = tuple(s for s in arm.solids if s.link == "torso" and s.role is Role.VISUAL)
    robot = replace(arm, solids=torso)
    image = photograph(view(arm_frames, robot=robot, displays=Displays(grid=False, tf=False)))
    rows, columns = np.nonzero(differs(image)[4:370, 100:800])  # without the words in the corner
    assert np.ptp(rows) > 3.5 * np.ptp(columns)


def test_axes_names_and_grid_are_on_the_picture(turtles, photograph):
    image = photograph(view(turtles))
    for color in AXIS_COLORS:
        shares = image / np.maximum(image.sum(axis=2, keepdims=True), 0.01)
        wanted = np.array(rgb(color)) / sum(rgb(color))
        assert (np.abs(shares - wanted) < 0.04).all(axis=2).sum() > 100
    ink = np.array([0x1D, 0x27, 0x33]) / 255
    assert (np.abs(image - ink) < 0.1).all(axis=2).sum() > 100


def test_lost_links_are_white_at_the_origin(buffer, arm, photograph):
    image = photograph(view(buffer, "map", robot=arm, displays=Displays(grid=False)))
    seen = image[differs(image, by=0.02)]
    assert len(seen) > 5000
    assert (seen.max(axis=1) - seen.min(axis=1) < 0.06).mean() > 0.95
    assert seen.max() > 0.95


def test_it_is_turned_by_keys_and_mouse(turtles, run_in_page):
    pictures = run_in_page(
        view(turtles).to_html(),
        LOOK
        + """
        look();
        key("ArrowLeft"); look();
        key("Home"); look();
        key("t"); look();
        key("+"); look();
        key("ArrowUp", { shiftKey: true }); look();
        element("reset").click(); look();
        mouse("pointerdown", 300, 200); mouse("pointermove", 360, 180); mouse("pointerup", 360, 180); look();
        element("reset").click(); look();
        element("top").click(); look();
        return found;
        """,
    )
    first, turned, home, top, near, moved, reset, dragged, again, above = map(tuple, pictures)
    assert first == home == reset == again
    assert top == above
    assert len({first, turned, top, near, moved, dragged}) == 6


def test_each_checkbox_shows_and_hides_what_it_says(arm_frames, arm, run_in_page):
    script = """
    const filled = () => pixels().reduce((sum, value, i) => sum + (i % 4 === 3 && value > 0), 0);
    const boxes = ["grid", "tf", "names", "visual", "collision"];
    for (const name of boxes) element(name).checked = false;
    found.push([filled(), letters()]);
    for (const name of boxes) {
      element(name).click();
      found.push([filled(), letters()]);
      if (name !== "tf") element(name).click();
    }
    return found;
    """
    nothing, grid, tf, names, visual, collision = run_in_page(
        view(arm_frames, robot=arm).to_html(), LOOK + script
    )
    assert nothing == [0, 0]
    assert grid[0] > 500
    assert tf[0] > 300
    assert tf[1] == 0
    assert names[1] > 300
    assert names[0] == tf[0]
    assert visual[0] > 5000
    assert tf[0] < collision[0] != visual[0]


def test_a_view_that_gets_its_room_late_is_drawn_in_it(turtles, run_in_page):
    # A notebook loads the page without room and tells of no resize of the window when it gives it some.
    sizes = run_in_page(
        view(turtles).to_html(),
        LOOK
        + """
        for (const shown of ["none", "block"]) {
          place.style.display = shown;
          const roomy = shown === "block";
          for (let i = 0; i < 100 && view.camera.size[0] > 0 !== roomy; i++) await frame();
          await frame(); await frame();
          found.push([view.camera.size[0], element("picture").width, element("labels").width]);
        }
        return found;
        """,
    )
    assert sizes[0][0] == 0
    assert len(set(sizes[1])) == 1
    assert sizes[1][0] > 100


def test_without_frames_and_without_a_robot_it_is_drawn_too(buffer, run_in_page):
    assert run_in_page(view(buffer).to_html(), LOOK + "look(); return found.length;") == 1


def test_a_storm_of_frames_is_drawn(buffer, run_in_page):
    for number in range(400):
        buffer.put("world", f"f{number}", xyz=(number % 20, number // 20, 0))
    assert run_in_page(view(buffer).to_html(), LOOK + "return letters();") > 1000


STILL = """
await started;
await frame(); await frame();
return [element("still").hidden, element("notice").hidden, element("notice").innerText.trim(), element("again").hidden,
  element("labels").getContext("2d").getImageData(0, 0, 800, 390).data.some((value) => value > 0)];
"""


def test_where_nothing_is_drawn_in_3d_the_still_picture_has_names(turtles, run_in_page):
    hidden, _, words, no_button, named = run_in_page(view(turtles).to_html(), STILL, three_d=False)
    assert not hidden
    assert (
        words == "This browser draws nothing in 3D here (WebGL is off): the picture stands still."
    )
    assert no_button
    assert named


def test_a_browser_that_cannot_unpack_says_so(turtles, run_in_page):
    hidden, quiet, words, *_ = run_in_page(
        view(turtles).to_html(), STILL, before="delete window.DecompressionStream;"
    )
    assert not hidden
    assert not quiet
    assert words == "This browser is too old for the 3D picture: it stands still."


def test_a_picture_that_the_browser_takes_away_can_be_drawn_again(turtles, run_in_page):
    found = run_in_page(
        view(turtles).to_html(),
        LOOK
        + """
        look();
        const state = () => found.push([element("still").hidden, element("again").hidden, !view.renderer]);
        view.renderer.forceContextLoss();
        for (let i = 0; i < 100 && view.renderer; i++) await frame();
        state();
        element("again").click();
        state();
        look();
        return found;
        """,
    )
    before, lost, back, after = found
    assert lost == [False, False, True]
    assert back[0]
    assert not back[2]
    assert after == before


def test_numbers_are_those_of_the_page_without_a_script(two_trees, run_in_page):
    found = run_in_page(
        view(two_trees, "map").to_html(),
        LOOK
        + """
        const rows = () => [...element("numbers").rows].map((row) => row.innerText);
        found.push(rows());
        tellNumbers(view.scene.frames);
        found.push(rows());
        return found;
        """,
    )
    assert found[0] == found[1]
    assert len(found[0]) == 5


@pytest.fixture
def source(turtles):
    return SceneSource(
        RvizSettings(), buffer=turtles, parameters=ParameterServer(), packages=PackagePath([])
    )


@pytest.mark.parametrize("where", ["page of the server", "frame in a notebook"])
def test_a_live_view_hears_of_a_frame_that_is_new(source, turtles, browse, tmp_path, where):
    live = LiveRviz(source)
    # A notebook's frame has no origin of its own; the page inside is opened as a file here.
    page = tmp_path / "live.html"
    page.write_text(live.to_html(), encoding="utf-8")
    turtles.put("world", "late")
    live.refresh()
    address = live.url if where == "page of the server" else page.as_uri()
    try:
        shown = browse(address, "--dump-dom")
    finally:
        live.close()
    assert "live: follows the simulation" in shown
    assert '<span id="summary">5 frames seen from world.' in shown


def test_a_live_view_that_reaches_nobody_says_so(source, browse, tmp_path):
    live = LiveRviz(source)
    live.close()
    (tmp_path / "live.html").write_text(live.to_html(), encoding="utf-8")
    shown = browse((tmp_path / "live.html").as_uri(), "--dump-dom")
    assert "Not live: this browser does not reach the computer" in shown
    assert '<span id="summary">4 frames seen from world.' in shown


def test_a_replay_moves_frames(drive, run_in_page):
    found = run_in_page(
        RvizReplay(drive).to_html(),
        LOOK
        + """
        const slider = element("time");
        for (const time of [0, 1, 2]) {
          slider.value = time;
          slider.dispatchEvent(new Event("input"));
          look();
          found.push([element("clock").value, view.scene.frames[1].p, view.scene.frames[1].isHidden]);
        }
        element("play").click(); await frame(); await frame(); await frame();
        found.push([element("play").textContent, view.scene.frames[1].p[0]]);
        element("play").click();
        found.push(element("play").textContent);
        return found;
        """,
    )
    start, middle, end = found[0], found[2], found[4]
    assert len({tuple(start), tuple(middle), tuple(end)}) == 3
    assert found[1] == ["0.00 s", [0, 0, 0], False]
    assert found[3] == ["1.00 s", [1, 0, 0], False]
    assert found[5] == ["2.00 s", [2, 0, 0], False]
    assert found[6][0] == "Pause"
    assert 0 < found[6][1] < 0.5
    assert found[7] == "Play"


def test_objects_of_meshcat_are_in_the_picture(turtles, run_in_page):
    picture = view(turtles)
    picture.meshcat["ball"].set_object(meshcat.geometry.Sphere(0.5))
    found = run_in_page(
        picture.to_html(),
        """
        await started;
        for (let i = 0; i < 20; i++) await frame();
        const spheres = [];
        view.objects.root.traverse(({ geometry }) => {
          if (geometry?.type === "SphereGeometry") spheres.push(geometry.parameters.radius);
        });
        return spheres;
        """,
    )
    assert found == [0.5]
