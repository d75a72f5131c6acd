"""Rules on plugins: which one it is, where it stands, what it is told."""

from __future__ import annotations

import itertools
from collections.abc import Iterator

from simkit.diagnostics import Find, Severity, rule
from simkit.urdf.rules.entries import PluginEntry
from simkit.urdf.rules.plugin_words import (
    NEW_GAZEBO,
    NOT_HERE,
    PLUGINS,
    SENSOR_TYPES,
    Kind,
    Place,
    PluginWord,
)
from simkit.urdf.rules.sheet import Sheet
from simkit.urdf.rules.vocabulary import nearest
from simkit.urdf.rules.wording import listed, quoted, read_number, shown
from simkit.xml import Element

_BOOLS = ("true", "false", "1", "0")
_SENSOR_OF = {Place.RAY: "ray", Place.IMU: "imu", Place.CONTACT: "contact"}


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
        if plugin.filename in PLUGINS:
            continue
        known = plugin.filename in NOT_HERE
        near = None if known else _meant_library(plugin.filename)
        is_new = not known and any(word in plugin.filename for word in NEW_GAZEBO)
        severity = Severity.WARNING if near is not None and not is_new else Severity.NOTE
        gazebo = "Gazebo loads it if it is installed, else it says: Failed to load plugin."
        remedy = f"simkit has: {listed((one[3:-3] for one in PLUGINS), 9)}."
        if is_new:
            gazebo = (
                "It belongs to ROS 2 or to the newer Gazebo; the Gazebo of ROS 1 cannot load it."
            )
            remedy = "In ROS 1 take one of the libgazebo_ros_... plugins. " + remedy
        elif near is not None:
            gazebo = "Gazebo says: Failed to load plugin, and goes on without it."
            remedy = f"Did you mean {quoted(near)}?"
        yield Find(
            plugin.element.attribute("filename") or plugin.element,
            severity=severity,
            element=plugin.element,
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
        word = PLUGINS.get(plugin.filename or "")
        if word is None or _is_in_place(plugin, word):
            continue
        yield Find(
            plugin.element,
            what=f"the plugin {quoted(word.filename)} stands {_place_of(plugin)}",
            remedy=f"It belongs {word.place.value}.",
        )


@rule("GZ-W10", "a parameter that a plugin does not read, or cannot use", Severity.WARNING)
def plugin_parameter(sheet: Sheet) -> Iterator[Find]:
    """A parameter that a plugin does not read, or cannot use.

    Symptom: The setting has no effect, and the plugin goes on with its default.

    Cause: A misspelt name, the name of another version (`torque` was `wheelTorque`'s name before 2014, `wheel_separation`
    is ROS 2's), or a value that is no number. Gazebo does not complain about words it does not know.

    Remedy: The name that the plugin reads.

    Right:

        <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
          <wheelSeparation>0.3</wheelSeparation>
          <wheelDiameter>0.2</wheelDiameter>
          <wheelTorque>5</wheelTorque>
        </plugin>
    """
    for plugin in sheet.plugins:
        word = PLUGINS.get(plugin.filename or "")
        if word is None:
            continue
        for element in plugin.element.children:
            kind = word.parameters.get(element.name)
            if kind is None:
                yield from _unread(word, element)
            else:
                yield from _bad_value(element, kind)
        for name in word.required:
            if plugin.parameter(name) is None:
                yield _missing(sheet, plugin, word, name)


def _no_filename(plugin: PluginEntry) -> Find:
    return Find(
        plugin.element,
        what=f"the plugin {quoted(plugin.name)} has no filename",
        here="The plugin is not simulated.",
        gazebo="Gazebo has nothing to load.",
        remedy='Name its library, as in filename="libgazebo_ros_diff_drive.so".',
    )


def _meant_library(filename: str) -> str | None:
    known = tuple(sorted({*PLUGINS, *NOT_HERE}))
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


def _is_in_place(plugin: PluginEntry, word: PluginWord) -> bool:
    parent = plugin.element.parent
    in_block = parent is plugin.gazebo.element
    if word.place is Place.MODEL:
        return in_block and not plugin.gazebo.reference
    if parent is None or parent.name != "sensor":
        return False
    kind = parent.get("type")
    return kind == _SENSOR_OF[word.place] or kind not in SENSOR_TYPES  # which is told of the sensor


def _place_of(plugin: PluginEntry) -> str:
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


def _unread(word: PluginWord, element: Element) -> Iterator[Find]:
    name = element.name
    meant = word.other_spellings.get(name) or (
        None if name in word.unread else nearest(name, tuple(word.parameters))
    )
    taken = meant is not None and element.parent is not None and element.parent.child(meant)
    text = element.text.strip()
    remedy = "Leave it out."
    if meant is not None and not taken:
        value = shown(text) or "..."
        remedy = f"Write <{meant}>{value}</{meant}> if that is meant."
    yield Find(
        element,
        severity=Severity.WARNING if meant is not None else Severity.NOTE,
        what=f"{quoted(word.filename)} reads no parameter <{shown(name)}>",
        here="It has no effect.",
        gazebo=f"It has no effect{_default_of(meant)}.",
        remedy=remedy,
    )


def _default_of(meant: str | None) -> str:
    numbers = {
        "wheelTorque": "5 N m",
        "torque": "5 N m",
        "wheelSeparation": "0.34 m",
        "wheelDiameter": "0.15 m",
    }
    return f": the default of <{meant}> stays, {numbers[meant]}" if meant in numbers else ""


def _bad_value(element: Element, kind: Kind) -> Iterator[Find]:
    text = element.text.strip()
    number = read_number(text)
    problem = ""
    if kind is Kind.BOOL and text.lower() not in _BOOLS:
        problem = "is neither true nor false"
    elif kind in (Kind.NUMBER, Kind.NOT_NEGATIVE, Kind.POSITIVE) and number is None:
        problem = "is no number"
    elif kind is Kind.NOT_NEGATIVE and number is not None and number < 0.0:
        problem = "is negative"
    elif kind is Kind.POSITIVE and number is not None and number <= 0.0:
        problem = "must be more than 0"
    if problem:
        yield Find(
            element.text_span or element,
            element=element,
            what=f"<{element.name}> {problem}: {quoted(text)}",
            here="simkit refuses to start the plugin.",
            gazebo="The plugin goes on with its default, or with nonsense.",
            remedy="Write true or false." if kind is Kind.BOOL else "Write a number, in SI units.",
        )


def _missing(sheet: Sheet, plugin: PluginEntry, word: PluginWord, name: str) -> Find:
    remedy = f"Add <{name}>...</{name}>."
    if word.parameters[name] is Kind.JOINTS:
        names = (joint.name for joint in sheet.joints if joint.moves and joint.name)
        some = ", ".join(itertools.islice(names, 20))
        remedy = f"Add <{name}>{shown(some)}</{name}>."
    return Find(
        plugin.element,
        what=f"{quoted(word.filename)} needs a parameter <{name}>",
        here="simkit refuses to start the plugin.",
        gazebo="The plugin does nothing.",
        remedy=remedy,
    )
