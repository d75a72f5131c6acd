from __future__ import annotations

import io

import matplotlib
import matplotlib.image
import pytest

from simkit.errors import UnknownNameError
from simkit.viz.plots.plot import LEAST_HEIGHT, Plot, finish, line_color, panels


class Flat(Plot):
    """A line that only rounding errors bend."""

    @property
    def title(self):
        return "a $flat$ <line>"

    def figure(self):
        figure, axes = panels(self.title, (1, 2))
        for one in axes:
            one.plot([0, 1], [5.0, 5.0 + 1e-12], label="flat")
        finish(axes)
        self.axes = axes
        return figure


@pytest.fixture
def plot():
    return Flat()


def test_the_title_is_text_and_no_formula(plot, texts):
    assert "a $flat$ <line>" in texts(plot.to_svg())
    assert repr(plot) == "Flat('a $flat$ <line>')"
    assert plot._repr_svg_() == plot.to_svg()


def test_rounding_errors_are_not_shown_as_motion(plot):
    plot.to_svg()
    for axes in plot.axes:
        low, high = axes.get_ylim()
        assert high - low >= LEAST_HEIGHT * 0.999


@pytest.mark.parametrize("suffix", [".svg", ".png", ".pdf"])
def test_it_is_saved_by_its_suffix_with_the_same_bytes_each_time(plot, tmp_path, suffix):
    plot.save(tmp_path / f"a{suffix}")
    with matplotlib.rc_context({"font.size": 30}):
        plot.save(tmp_path / f"b{suffix}")
    assert (tmp_path / f"a{suffix}").read_bytes() == (tmp_path / f"b{suffix}").read_bytes()


def test_another_suffix_is_refused(plot, tmp_path):
    with pytest.raises(UnknownNameError, match=r"\.jpg"):
        plot.save(tmp_path / "a.jpg")


def test_more_panels_make_a_higher_picture():
    heights = []
    for count in (1, 3):
        figure, axes = panels("t", [1] * count)
        assert len(axes) == count
        heights.append(figure.get_figheight())
    assert heights[1] > 2 * heights[0]


def test_a_png_can_be_read(plot):
    assert matplotlib.image.imread(io.BytesIO(plot.to_png()), format="png").ndim == 3


def test_colours_begin_again_after_the_last():
    colors = [line_color(number) for number in range(11)]
    assert len(set(colors)) == 10
    assert colors[10] == colors[0]
