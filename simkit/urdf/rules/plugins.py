"""Rules on plugins: which one it is, where it stands, what its tag says."""

from __future__ import annotations

import itertools
from collections.abc import Iterator

from simkit.diagnostics import Find, Part, Severity, rule
from simkit.plugins.registry import NOT_HERE, Names, PluginEntry, TagField, plugins
from simkit.urdf.rules.entries import PluginElement
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.vocabulary import SENSOR_TYPES, nearest
from simkit.urdf.rules.wording import listed, quoted, read_number, shown
from simkit.xml import Element

_NEW_GAZEBO = ("gz-sim", "gz_", "ignition", "ign_", "gazebo_ros2_control")
"Words in the names of plugins that belong to ROS 2 or to the newer Gazebo."
_BOOLS = ("true", "false", "1", "0")
_SILENT, _IGNORED = ("robotNamespace",), ("alwaysOn",)
"Words that any tag may have: read elsewhere, and without effect."
_REAL = ("wheelTorque", "torque", "wheelSeparation", "wheelDiameter")
"Parameters whose default hardly ever fits a robot."


@rule("GZ-E08", "a plugin that simkit does not have, or nobody has", Severity.ERROR)
def unknown_plugin(sheet: Sheet) -> Iterator[Find]:
    """A plugin that simkit does not have, or that nobody has.

    Symptom: The robot does not drive, the topic does not appear. Gazebo says `Failed to load plugin` among a hundred other
    lines.

    Cause: A misspelt `filename`, a plugin of another version of ROS, or one that simkit does not simulate.

    Remedy: The full name of the library: `lib` in front, `.so` behind.

    Right:

        <gazebo>
          <plugin name="drive" filename="libgazebo_ros_diff_drive.so"> ... </plugin>
        </gazebo>
    """
    for plugin in sheet.plugins:
        if not plugin.filename:
            yield _no_filename(plugin)
            continue
        if plugin.filename in plugins():
            continue
        known = plugin.filename in NOT_HERE
        near = None if known else _meant_library(plugin.filename)
        is_new = not known and any(word in plugin.filename for word in _NEW_GAZEBO)
        severity = Severity.WARNING if near is not None and not is_new else Severity.NOTE
        gazebo = "Gazebo loads it if it is installed, else it says: Failed to load plugin."
        remedy = f"simkit has: {listed((one[3:-3] for one in plugins()), 9)}."
        if is_new:
            gazebo = (
                "It belongs to ROS 2 or to the newer Gazebo; the Gazebo of ROS 1 cannot load it."
            )
            remedy = "In ROS 1 take one of the libgazebo_ros_... plugins. " + remedy
        elif near is not None:
            gazebo = "Gazebo says: Failed to load plugin, and goes on without it."
            remedy = f"Did you mean {quoted(near)}?"
        yield Find(
            Part(plugin.element, "filename"),
            severity=severity,
            what=f"simkit has no plugin {quoted(plugin.filename)}",
            here="The plugin is not simulated.",
            gazebo=gazebo,
            remedy=remedy,
        )


@rule(
    "GZ-E11",
    "a plugin where it is not loaded",
    Severity.ERROR,
    here="simkit does not load it there.",
    gazebo="Gazebo does not run it there.",
)
def plugin_in_wrong_place(sheet: Sheet) -> Iterator[Find]:
    """A plugin stands where it is not loaded.

    Symptom: Gazebo says that the plugin is of another type than it should be, or says nothing, and the plugin does not run.

    Cause: There are plugins for a whole robot, which stand in a `<gazebo>` without reference, and plugins for a sensor,
    which stand in its `<sensor>`, which stands in the `<gazebo>` of a link.

    Remedy: Move it.

    Right:

        <gazebo>
          <plugin name="drive" filename="libgazebo_ros_diff_drive.so"> ... </plugin>
        </gazebo>
        <gazebo reference="sensor_laser">
          <sensor type="ray" name="laser">
            <plugin name="scan" filename="libgazebo_ros_laser.so"> ... </plugin>
          </sensor>
        </gazebo>
    """
    for plugin in sheet.plugins:
        kind = plugins().get(plugin.filename or "")
        if kind is None or _is_in_place(plugin, kind.sensor):
            continue
        yield Find(
            plugin.element,
            what=f"the plugin {quoted(kind.filename)} stands {_place_of(plugin)}",
            remedy=f"It belongs {_home(kind.sensor)}.",
        )


@rule("GZ-W10", "a parameter that a plugin does not read, or cannot use", Severity.WARNING)
def plugin_parameter(sheet: Sheet) -> Iterator[Find]:
    """A parameter that a plugin does not read, or cannot use.

    Symptom: The setting has no effect, and the plugin goes on with its default.

    Cause: A misspelt name, the name of another version (`torque` was `wheelTorque`'s name before 2014, `wheel_separation`
    is ROS 2's), or a value that is not a number. Gazebo does not complain about words it does not know.

    Remedy: The name that the plugin reads.

    Right:

        <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
          <wheelSeparation>0.3</wheelSeparation>
          <wheelDiameter>0.2</wheelDiameter>
          <wheelTorque>5</wheelTorque>
        </plugin>
    """
    for plugin in sheet.plugins:
        kind = plugins().get(plugin.filename or "")
        if kind is None:
            continue
        for element in plugin.element.children:
            if element.name in kind.tags:
                yield from _bad_value(element, kind.tags[element.name])
            elif element.name not in (*_SILENT, *kind.silent):
                yield from _unread(kind, element)
        for tag in kind.tags.values():
            if tag.required and plugin.parameter(tag.name) is None:
                yield _missing(sheet, plugin, tag)


def _no_filename(plugin: PluginElement) -> Find:
    return Find(
        plugin.element,
        what=f"the plugin {quoted(plugin.name)} has no filename",
        here="The plugin is not simulated.",
        gazebo="Gazebo has nothing to load.",
        remedy='Name its library, as in filename="libgazebo_ros_diff_drive.so".',
    )


def _meant_library(filename: str) -> str | None:
    known = tuple(sorted({*plugins(), *NOT_HERE}))
    for guess in (
        f"lib{filename}.so",
        f"lib{filename}",
        f"{filename}.so",
        f"libgazebo_ros_{filename}.so",
    ):
        if guess in known:
            return guess
    body = filename.removeprefix("lib").removesuffix(".so").removeprefix("gazebo_ros_")
    names = tuple(one[len("libgazebo_ros_") : -len(".so")] for one in known)
    near = nearest(body, names) if "gazebo" in filename or filename.startswith("lib") else None
    is_near = near is not None and abs(len(near) - len(body)) <= 3
    return f"libgazebo_ros_{near}.so" if is_near else None


def _is_in_place(plugin: PluginElement, sensor: str | None) -> bool:
    parent = plugin.element.parent
    if sensor is None:
        return parent is plugin.gazebo.element and not plugin.gazebo.reference
    if parent is None or parent.name != "sensor":
        return False
    return parent.get("type") == sensor or parent.get("type") not in SENSOR_TYPES  # another find


def _home(sensor: str | None) -> str:
    """Where a plugin stands, of the model or of a type of sensor."""
    if sensor is None:
        return "in a <gazebo> without reference"
    return f'in a <sensor type="{sensor}"> in a <gazebo reference="...">'


def _place_of(plugin: PluginElement) -> str:
    parent = plugin.element.parent
    if parent is not None and parent.name == "sensor":
        return f'in a <sensor type="{shown(parent.get("type") or "")}">'
    if parent is not plugin.gazebo.element:
        return f"in a <{'' if parent is None else shown(parent.name)}>"
    return (
        f'in a <gazebo reference="{shown(plugin.gazebo.reference or "")}">'
        if plugin.gazebo.reference
        else "in a <gazebo> without reference"
    )


def _unread(kind: PluginEntry, element: Element) -> Iterator[Find]:
    name, tags = element.name, kind.tags
    is_ignored = name in (*_IGNORED, *kind.ignored)
    near = None if is_ignored else nearest(name, (*_SILENT, *kind.silent, *tags))
    meant = kind.spellings.get(name, near)
    taken = meant is not None and element.parent is not None and element.parent.child(meant)
    remedy = "Leave it out."
    if meant is not None and not taken:
        value = shown(element.text.strip()) or "..."
        remedy = f"Write <{meant}>{value}</{meant}> if that is meant."
    yield Find(
        element,
        severity=Severity.WARNING if meant is not None else Severity.NOTE,
        what=f"{quoted(kind.filename)} reads no parameter <{shown(name)}>",
        here="It has no effect.",
        gazebo=f"It has no effect{_default_of(tags.get(meant or ''))}.",
        remedy=remedy,
    )


def _default_of(tag: TagField | None) -> str:
    if tag is None or tag.name not in _REAL:
        return ""
    unit = "N m" if "orque" in tag.name else "m"
    return f": the default of <{tag.name}> stays, {tag.default:g} {unit}"


def _bad_value(element: Element, tag: TagField) -> Iterator[Find]:
    text, is_bool = element.text.strip(), isinstance(tag.default, bool)
    problem = ""
    if is_bool and text.lower() not in _BOOLS:
        problem = "is neither true nor false"
    elif isinstance(tag.default, float):
        problem = _bad_number(read_number(text), tag)
    if problem:
        yield Find(
            Part(element),
            what=f"<{element.name}> {problem}: {quoted(text)}",
            here="simkit refuses to start the plugin.",
            gazebo="The plugin goes on with its default, or with nonsense.",
            remedy="Write true or false." if is_bool else "Write a number, in SI units.",
        )


def _bad_number(number: float | None, tag: TagField) -> str:
    if number is None:
        return "is not a number"
    if number < tag.at_least:
        return "is negative" if tag.at_least == 0.0 else f"must be at least {tag.at_least:g}"
    return "" if number > tag.above else f"must be more than {tag.above:g}"


def _missing(sheet: Sheet, plugin: PluginElement, tag: TagField) -> Find:
    value = "..."
    if tag.names is Names.JOINTS:
        names = (joint.name for joint in sheet.joints if joint.moves and joint.name)
        value = shown(", ".join(itertools.islice(names, 20)))
    return Find(
        plugin.element,
        what=f"{quoted(plugin.filename)} needs a parameter <{tag.name}>",
        here="simkit refuses to start the plugin.",
        gazebo="The plugin does nothing.",
        remedy=f"Add <{tag.name}>{value}</{tag.name}>.",
    )
