"""The beams of a laser: what its tag `<ray>` says, and where they go.

Source: SDF `ray.sdf` for defaults; Gazebo's `MultiRayShape` for directions, `RaySensor` for ranges
between beams.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from simkit.plugins.sensor_tag import (
    NoiseTag,
    SensorTag,
    read_count,
    read_float,
    read_noise,
    warn_of_strangers,
)
from simkit.plugins.site import PluginError, Site
from simkit.xml import Element

Floats = NDArray[np.float64]
MOST_BEAMS = 1_000_000
"""No laser has more."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Row:
    """Beams, or rows of beams, side by side."""

    samples: int = 640
    """How many beams are cast."""
    resolution: float = 1.0
    """How many ranges are published for each beam that is cast."""
    min_angle: float = 0.0
    """Angle of the first [rad]."""
    max_angle: float = 0.0
    """Angle of the last [rad]."""

    @property
    def count(self) -> int:
        """How many ranges are published."""
        return int(self.samples * self.resolution)

    @property
    def step(self) -> float:
        """Angle from one range to the next [rad]; 0 of a single one."""
        return (self.max_angle - self.min_angle) / (self.count - 1) if self.count > 1 else 0.0

    @property
    def angles(self) -> Floats:
        """Angles of the beams [rad], (samples,); a single beam goes straight ahead, as in Gazebo."""
        if self.samples == 1:
            return np.zeros(1)
        return np.linspace(self.min_angle, self.max_angle, self.samples)


ONE_ROW = Row(samples=1)
"""No scan up and down."""


@dataclass(frozen=True, slots=True, kw_only=True)
class RayTag:
    """What `<ray>` says."""

    flat: Row
    """From right to left."""
    upright: Row
    """From below to above."""
    near: float
    """Beams begin so far from the sensor [m]."""
    far: float
    """They end there [m]."""
    noise: NoiseTag | None
    """What is added to each range."""

    @property
    def is_resampled(self) -> bool:
        """Whether the published ranges are not those of the beams."""
        return any(row.count != row.samples for row in (self.flat, self.upright))


def read_ray(site: Site, tag: SensorTag) -> RayTag:
    """The tag `<ray>` of a laser.

    Raises:
        PluginError: A value makes no sense.
    """
    ray = tag.element.child("ray")
    scan = None if ray is None else ray.child("scan")
    reach = None if ray is None else ray.child("range")
    for element, known in (
        (ray, ("scan", "range", "noise")),
        (scan, ("horizontal", "vertical")),
        (reach, ("min", "max", "resolution")),
    ):
        if element is not None:
            warn_of_strangers(site, element, known)
    read_float(site, reach, "resolution", 0.0, at_least=0.0)  # it has no effect in Gazebo either
    found = RayTag(
        flat=_row(site, scan, "horizontal", Row()),
        upright=_row(site, scan, "vertical", ONE_ROW),
        near=read_float(site, reach, "min", 0.0, at_least=0.0),
        far=read_float(site, reach, "max", 0.0, at_least=0.0, or_infinite=True),
        noise=read_noise(site, ray),
    )
    if found.flat.samples * found.upright.samples > MOST_BEAMS:
        raise PluginError(
            f"{site.place(scan or tag.element)}: no laser has more than {MOST_BEAMS} beams"
        )
    _warn(site, tag, found, reach or ray or tag.element)
    return found


def directions(tag: RayTag) -> Floats:
    """Unit vectors of all beams in the frame of the sensor, (n, 3): row by row, the lowest first.

    x is straight ahead, positive angles turn to the left and upward.
    """
    up, left = (
        grid.ravel() for grid in np.meshgrid(tag.upright.angles, tag.flat.angles, indexing="ij")
    )
    return np.column_stack([np.cos(up) * np.cos(left), np.cos(up) * np.sin(left), np.sin(up)])


def resampled(tag: RayTag, values: Floats, *, blend: bool) -> Floats:
    """What is published, interpolated between the beams.

    Args:
        tag: The beams.
        values: One for each beam, (n,).
        blend: Whether the four beams around are weighed by how near they are; else their mean is taken.

    Returns:
        One for each published range.
    """
    grid = values.reshape(tag.upright.samples, tag.flat.samples)
    below, above, up = _neighbours(tag.upright)
    right, left, aside = _neighbours(tag.flat)
    up, aside = (up, aside) if blend else (np.full_like(up, 0.5), np.full_like(aside, 0.5))
    lower = grid[below][:, right] * (1.0 - aside) + grid[below][:, left] * aside
    upper = grid[above][:, right] * (1.0 - aside) + grid[above][:, left] * aside
    mixed: Floats = lower * (1.0 - up)[:, None] + upper * up[:, None]
    return mixed.ravel()


def _neighbours(row: Row) -> tuple[NDArray[np.intp], NDArray[np.intp], Floats]:
    """For each published range: the beams on both sides, and how far it is from the first one (0 to 1)."""
    places = np.linspace(0.0, row.samples - 1.0, row.count) if row.count > 1 else np.zeros(1)
    first = np.floor(places).astype(np.intp)
    return first, np.minimum(first + 1, row.samples - 1), places - first


def _row(site: Site, scan: Element | None, name: str, default: Row) -> Row:
    element = None if scan is None else scan.child(name)
    if element is None:
        return default
    warn_of_strangers(site, element, ("samples", "resolution", "min_angle", "max_angle"))
    row = Row(
        samples=read_count(site, element, "samples", default.samples),
        resolution=read_float(site, element, "resolution", 1.0, at_least=0.0),
        min_angle=read_float(site, element, "min_angle", 0.0),
        max_angle=read_float(site, element, "max_angle", 0.0),
    )
    if row.count < 1 or row.count > MOST_BEAMS:
        raise PluginError(
            f"{site.place(element)}: <samples> times <resolution> is how many ranges are published, "
            f"and must be from 1 to {MOST_BEAMS}, not {row.samples * row.resolution:g}"
        )
    return row


def _warn(site: Site, tag: SensorTag, ray: RayTag, at: Element) -> None:
    if ray.far <= ray.near:
        site.node.warn(
            f"{site.place(at)}: the laser {tag.name!r} sees nothing: its <range> goes from {ray.near:g} m "
            f"to {ray.far:g} m. Write <min> and <max>, as in <min>0.1</min><max>10</max>"
        )
    if ray.upright.count > 1:
        site.node.warn(
            f"{site.place(at)}: the laser {tag.name!r} has {ray.upright.count} rows of {ray.flat.count}; "
            "a LaserScan has one, so its ranges hold them one behind the other, the lowest first"
        )
    if abs(ray.flat.max_angle - ray.flat.min_angle) > math.tau * 1.05:
        site.node.warn(
            f"{site.place(at)}: the laser {tag.name!r} turns round "
            f"{(ray.flat.max_angle - ray.flat.min_angle) / math.tau:.3g} times: angles are radians"
        )
