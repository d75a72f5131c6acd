"""A scene as SVG text: small, the same bytes for the same scene, with titles to be read out."""

from __future__ import annotations

import html
from collections.abc import Iterable
from functools import singledispatch

from simkit.nodes.turtlesim.shapes import Ellipse, Group, Polygon, Polyline, Scene, Shape, Text
from simkit.nodes.turtlesim.window import Point

FONT = "DejaVu Sans, Verdana, sans-serif"


def svg_text(scene: Scene) -> str:
    """The scene as a complete SVG document."""
    side = scene.side
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" role="img" width="{side}" height="{side}" '
        f'viewBox="0 0 {side} {side}">',
        f"<title>{html.escape(scene.title)}</title>",
        f"<desc>{html.escape(scene.description)}</desc>",
        f'<rect width="{side}" height="{side}" fill="{scene.background}"/>',
        *(svg_element(shape) for shape in scene.shapes),
        "</svg>",
    ]
    return "\n".join(lines) + "\n"


@singledispatch
def svg_element(shape: Shape) -> str:
    """One shape as an SVG element."""
    raise NotImplementedError(f"no SVG for {type(shape).__name__}")


@svg_element.register
def _(shape: Polyline) -> str:
    return (
        f'<polyline points="{_points(shape.points)}" fill="none" stroke="{shape.color}" '
        f'stroke-width="{_number(shape.width)}" stroke-linecap="round" stroke-linejoin="round"/>'
    )


@svg_element.register
def _(shape: Polygon) -> str:
    return f'<polygon points="{_points(shape.points)}" fill="{shape.fill}"/>'


@svg_element.register
def _(shape: Ellipse) -> str:
    (x, y), (rx, ry) = shape.center, shape.radii
    turn = f" rotate({_number(shape.angle)})" if shape.angle else ""
    return (
        f'<ellipse rx="{_number(rx)}" ry="{_number(ry)}" fill="{shape.fill}" '
        f'transform="translate({_number(x)} {_number(y)}){turn}"/>'
    )


@svg_element.register
def _(shape: Text) -> str:
    x, y = shape.center
    return (
        f'<text x="{_number(x)}" y="{_number(y)}" text-anchor="middle" font-family="{FONT}" '
        f'font-size="{_number(shape.size)}" fill="{shape.color}" stroke="{shape.halo}" '
        f'stroke-width="3" stroke-linejoin="round" paint-order="stroke">'
        f"{html.escape(shape.text)}</text>"
    )


@svg_element.register
def _(shape: Group) -> str:
    x, y = shape.origin
    inner = "\n".join(svg_element(part) for part in shape.shapes)
    return (
        f'<g transform="translate({_number(x)} {_number(y)}) rotate({_number(shape.angle)})">\n'
        f"<title>{html.escape(shape.title)}</title>\n{inner}\n</g>"
    )


def _points(points: Iterable[Point]) -> str:
    return " ".join(f"{_number(x)},{_number(y)}" for x, y in points)


def _number(value: float) -> str:
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text
