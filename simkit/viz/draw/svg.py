"""A drawing as SVG text: the same bytes for the same drawing, with titles to be read out."""

from __future__ import annotations

import html
from functools import singledispatch

from simkit.viz.draw.drawing import (
    SANS,
    Area,
    Curve,
    Drawing,
    Ellipse,
    Group,
    Label,
    Point,
    Polyline,
    RoundedBox,
    Shape,
)
from simkit.viz.draw.letters import printable


def svg_text(drawing: Drawing) -> str:
    """The drawing as a complete SVG document; it shrinks where the page is narrower."""
    width, height = (number(value) for value in drawing.size)
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" role="img" width="{width}" height="{height}" '
        f'viewBox="0 0 {width} {height}" font-family="{SANS}" '
        'style="max-width:100%;height:auto">',
        f"<title>{_escaped(drawing.title)}</title>",
        f"<desc>{_escaped(drawing.description)}</desc>",
        f'<rect width="{width}" height="{height}" fill="{drawing.background}"/>',
        *(svg_element(shape) for shape in drawing.shapes),
        "</svg>",
    ]
    return "\n".join(lines) + "\n"


def number(value: float) -> str:
    """A number with two decimals, without zeros that say nothing."""
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


@singledispatch
def svg_element(shape: Shape) -> str:
    """One shape as an SVG element."""
    raise NotImplementedError(f"no SVG for {type(shape).__name__}")


@svg_element.register
def _(shape: Polyline) -> str:
    points = " ".join(_pair(point) for point in shape.points)
    return f'<polyline points="{points}" {_stroke(shape)} stroke-linejoin="round"/>'


@svg_element.register
def _(shape: Curve) -> str:
    start, first, second, end = (_pair(point) for point in shape.points)
    return f'<path d="M{start} C{first} {second} {end}" {_stroke(shape)}/>'


@svg_element.register
def _(shape: Area) -> str:
    points = " ".join(_pair(point) for point in shape.points)
    return f'<polygon points="{points}" fill="{shape.fill}"/>'


@svg_element.register
def _(shape: Ellipse) -> str:
    (x, y), (rx, ry) = shape.center, shape.radii
    turn = f" rotate({number(shape.angle)})" if shape.angle else ""
    return (
        f'<ellipse rx="{number(rx)}" ry="{number(ry)}" fill="{shape.fill}" '
        f'transform="translate({number(x)} {number(y)}){turn}"/>'
    )


@svg_element.register
def _(shape: RoundedBox) -> str:
    (x, y), (width, height) = shape.corner, shape.size
    return (
        f'<rect x="{number(x)}" y="{number(y)}" width="{number(width)}" height="{number(height)}" '
        f'rx="{number(shape.radius)}" fill="{shape.fill or "none"}" '
        f'stroke="{shape.edge or "none"}"{_dashes(dashed=shape.dashed)}/>'
    )


@svg_element.register
def _(shape: Label) -> str:
    x, y = shape.place
    looks = [f'font-size="{number(shape.size)}"', f'fill="{shape.color}"']
    if shape.align != "start":
        looks.append(f'text-anchor="{shape.align}"')
    if shape.bold:
        looks.append('font-weight="bold"')
    if shape.halo:
        looks.append(
            f'stroke="{shape.halo}" stroke-width="3" stroke-linejoin="round" paint-order="stroke"'
        )
    return f'<text x="{number(x)}" y="{number(y)}" {" ".join(looks)}>{_escaped(shape.text)}</text>'


@svg_element.register
def _(shape: Group) -> str:
    inner = "\n".join(svg_element(part) for part in shape.shapes)
    place = (
        "" if shape.origin is None else f' transform="{svg_transform(shape.origin, shape.angle)}"'
    )
    return f"<g{place}>\n<title>{_escaped(shape.title)}</title>\n{inner}\n</g>"


def svg_transform(origin: Point, angle: float) -> str:
    """The value of a `transform` that turns by an angle [degrees] and moves to a point [px]."""
    x, y = origin
    return f"translate({number(x)} {number(y)}) rotate({number(angle)})"


def _escaped(text: str) -> str:
    return html.escape(printable(text), quote=False)


def _pair(point: Point) -> str:
    return f"{number(point[0])},{number(point[1])}"


def _stroke(shape: Polyline | Curve) -> str:
    return (
        f'fill="none" stroke="{shape.color}" stroke-width="{number(shape.width)}" '
        f'stroke-linecap="round"{_dashes(dashed=shape.dashed)}'
    )


def _dashes(*, dashed: bool) -> str:
    return ' stroke-dasharray="5 4"' if dashed else ""
