"""The tag `<sensor>`: what every sensor says, and how numbers are read from it.

Source: SDF 1.4 to 1.6, `sensor.sdf` and `noise.sdf`, for names and defaults.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from simkit.errors import near_names
from simkit.geometry import Transform
from simkit.plugins.site import PluginError, Site
from simkit.xml import Element

_COMMON = ("pose", "update_rate", "always_on", "visualize", "topic", "plugin")
_NOISE = ("type", "mean", "stddev", "bias_mean", "bias_stddev", "precision")


@dataclass(frozen=True, slots=True, kw_only=True)
class SensorTag:
    """What every sensor says."""

    element: Element
    """The tag itself."""
    name: str
    """Its name."""
    link: str
    """Link that it is on; one that is simulated."""
    pose: Transform
    """T_link_sensor."""
    update_rate: float
    """Measurements per second; 0: one each step [Hz]."""


@dataclass(frozen=True, slots=True, kw_only=True)
class NoiseTag:
    """Gaussian noise."""

    mean: float = 0.0
    """Mean of what is added to each value."""
    stddev: float = 0.0
    """Its standard deviation."""
    bias_mean: float = 0.0
    """Mean of an offset that is drawn once."""
    bias_stddev: float = 0.0
    """Its standard deviation."""
    precision: float = 0.0
    """Values are rounded to multiples of it; 0: not at all."""


def read_sensor(site: Site, kind: str) -> SensorTag:
    """The sensor that a plugin stands in.

    Args:
        site: Where the plugin works.
        kind: Type of sensor that it wants; the tag of its details has this name.

    Raises:
        PluginError: It stands in no such sensor, the link is not simulated, or a value makes no sense.
    """
    element = site.sensor
    if element is None or element.get("type") != kind:
        raise PluginError(
            f"{site.place(site.element)}: the plugin {site.name} belongs into a "
            f'<sensor type="{kind}"> in a <gazebo reference="LINK">'
        )
    name = element.get("name") or kind
    link = _link(site, element, name)
    warn_of_strangers(site, element, (*_COMMON, kind))
    return SensorTag(
        element=element,
        name=name,
        link=link,
        pose=_pose(site, element.child("pose")),
        update_rate=read_float(site, element, "update_rate", 0.0, at_least=0.0),
    )


def sensor_pose(site: Site, tag: SensorTag) -> Transform:
    """T_world_sensor, now."""
    return site.model.link_pose(tag.link) @ tag.pose


def read_float(
    site: Site,
    parent: Element | None,
    name: str,
    default: float,
    *,
    at_least: float = -math.inf,
    or_infinite: bool = False,
) -> float:
    """The number in a tag; the default if there is no such tag.

    Args:
        site: Where the plugin works.
        parent: What the tag stands in; None if that is not there itself.
        name: Name of the tag.
        default: Its value if it is not there.
        at_least: Smallest value.
        or_infinite: Whether `inf` is a number, too.

    Raises:
        PluginError: What stands there is no such number.
    """
    element = None if parent is None else parent.child(name)
    if element is None:
        return default
    text = element.text.strip()
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if math.isnan(value) or (math.isinf(value) and not or_infinite) or "_" in text:
        raise PluginError(f"{site.place(element)}: <{name}> is a number, not {text!r}")
    if value < at_least:
        raise PluginError(
            f"{site.place(element)}: <{name}> is {text}, and must be at least {at_least:g}"
        )
    return value


def read_count(site: Site, parent: Element | None, name: str, default: int) -> int:
    """The whole number in a tag, from 1 on; see `read_float`."""
    value = read_float(site, parent, name, default, at_least=1.0)
    element = None if parent is None else parent.child(name)
    if element is not None and value != int(value):
        raise PluginError(
            f"{site.place(element)}: <{name}> is a whole number, not {element.text.strip()!r}"
        )
    return int(value)


def read_noise(site: Site, parent: Element | None) -> NoiseTag | None:
    """The tag `<noise>` in another one; None if there is none, or if it says `none`.

    Its type is an attribute, or a tag in it, as up to SDF 1.4.

    Raises:
        PluginError: A value makes no sense.
    """
    element = None if parent is None else parent.child("noise")
    if element is None:
        return None
    inner = element.child("type")
    kind = (element.get("type") or ("gaussian" if inner is None else inner.text)).strip()
    if kind == "none":
        return None
    if not kind.startswith("gaussian"):
        raise PluginError(
            f"{site.place(inner or element)}: there is no noise of type {kind!r}; write gaussian, or none"
        )
    warn_of_strangers(site, element, _NOISE)
    return NoiseTag(
        mean=read_float(site, element, "mean", 0.0),
        stddev=read_float(site, element, "stddev", 0.0, at_least=0.0),
        bias_mean=read_float(site, element, "bias_mean", 0.0),
        bias_stddev=read_float(site, element, "bias_stddev", 0.0, at_least=0.0),
        precision=read_float(site, element, "precision", 0.0, at_least=0.0),
    )


def warn_of_strangers(site: Site, element: Element, known: Sequence[str]) -> None:
    """Name the tags in an element that nobody reads, each with the nearest one that is read."""
    for child in element.children:
        if child.name not in known:
            near = near_names(child.name, known)
            hint = f"; did you mean <{near[0]}>?" if near else f"; it reads: {', '.join(known)}"
            site.node.warn(
                f"{site.place(child)}: <{element.name}> does not read <{child.name}>{hint}"
            )


def _link(site: Site, element: Element, name: str) -> str:
    link = site.link
    if link is not None and link in site.model.links:
        return link
    where = f"{site.place(element)}: the sensor {name!r}"
    if link is None:
        raise PluginError(
            f'{where} is on no link: put it into a <gazebo reference="LINK"> that names its link'
        )
    if site.robot is not None and link not in site.robot.links:
        near = near_names(link, site.robot.links)
        hint = f"; did you mean {near[0]!r}?" if near else ""
        raise PluginError(f"{where} is on the link {link!r}, and there is no such link{hint}")
    raise PluginError(
        f"{where} is on the link {link!r}, which is not simulated, as it has no mass: "
        "give it an <inertial>, or hold it on a link that has one by a joint of type fixed"
    )


def _pose(site: Site, element: Element | None) -> Transform:
    if element is None:
        return Transform()
    frame = element.get("relative_to") or element.get("frame") or site.link
    if frame != site.link:
        raise PluginError(
            f"{site.place(element)}: the pose of a sensor is seen from its link {site.link!r}, "
            f"not from {frame!r}"
        )
    try:
        x, y, z, roll, pitch, yaw = (float(word) for word in element.text.split())
    except ValueError:
        x = y = z = roll = pitch = yaw = math.nan
    if not all(abs(value) <= 1e6 for value in (x, y, z, roll, pitch, yaw)):
        raise PluginError(
            f"{site.place(element)}: a <pose> is six numbers, x y z [m] roll pitch yaw [rad], "
            f"not {element.text.strip()!r}"
        )
    return Transform.from_rpy((x, y, z), (roll, pitch, yaw))
