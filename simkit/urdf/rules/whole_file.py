"""Rules about the file as a whole: not a URDF at all, of another version, or one for xacro."""

from __future__ import annotations

from collections.abc import Iterator

from simkit.diagnostics import Find, Severity, rule
from simkit.urdf.rules.sheet import Sheet, is_for_xacro
from simkit.urdf.rules.values import shown
from simkit.urdf.rules.wording import REFUSED
from simkit.urdf.urdfdom.numbers import MalformedError, check_version

_SDF = "This is SDF, Gazebo's other language. Spawn it with spawn_model -sdf, or write it anew as URDF."
_OTHER_FILES = {
    **dict.fromkeys(("sdf", "gazebo", "world", "model"), _SDF),
    "launch": "This is a launch file: start it with roslaunch, and check the URDF that it loads.",
    "package": "This is the package.xml of a package; its URDF files mostly lie in a folder urdf/.",
    "mujoco": "This is a model for MuJoCo, another simulator.",
    "html": "This is a web page: download the file itself (on GitHub: Raw).",
    "COLLADA": 'This is a mesh; a URDF names it in <mesh filename="..."/>.',
}


@rule("URDF-E27", "the outermost element is not <robot>", Severity.ERROR)
def no_robot(sheet: Sheet) -> Iterator[Find]:
    """The outermost element is not `<robot>`.

    ROS says `Could not find the 'robot' element in the xml file`. Either the file is something else (a world, a launch file),
    or the word is written in another way; it stands in small letters.

    Wrong:

        <Robot name="my_robot">

    Right:

        <robot name="my_robot">
    """
    root = sheet.document.root
    if root is None or root.name == "robot" or sheet.is_closed_otherwise(root):
        return
    inner = root.child("robot")
    remedy = _OTHER_FILES.get(
        root.name, 'A URDF is one <robot name="..."> with links and joints in it.'
    )
    if sheet.robot is not None:
        remedy = "Write <robot>" + (", in small letters." if root.name.lower() == "robot" else ".")
    elif inner is not None:
        remedy = f"Take <{shown(root.name)}> out: the <robot> in line {inner.span.line} must be outermost."
    yield Find(
        root,
        what=f"the outermost element is <{shown(root.name)}>, not <robot>",
        remedy=remedy,
        loss=REFUSED,
    )


@rule(
    "URDF-E28",
    "a version of URDF that does not exist",
    Severity.ERROR,
    remedy='Take the attribute out, or write version="1.0": it is the version of the language, not of your robot.',
)
def bad_version(sheet: Sheet) -> Iterator[Find]:
    """A version other than 1.0.

    ROS says `Invalid 'version' specified; only version 1.0 is currently supported`. The attribute is not the version of your
    robot but that of the language URDF, and there is only one. Leave it out.

    Wrong:

        <robot name="my_robot" version="2.1">

    Right:

        <robot name="my_robot">
    """
    version = None if sheet.robot is None else sheet.robot.attribute("version")
    if version is None or _is_known(version.value):
        return
    yield Find(
        version,
        element=sheet.robot,
        what=f"version {shown(version.value)!r} of URDF does not exist",
        loss=REFUSED,
    )


def _is_known(version: str) -> bool:
    try:
        check_version(version)
    except MalformedError:
        return False
    return True


@rule(
    "URDF-E29",
    "a file for xacro, which has not been run on it",
    Severity.ERROR,
    here="No other rule looks at this file.",
    gazebo="ROS ignores xacro's elements, and takes ${...} and $(...) as they are: for names, and for numbers that are none.",
)
def unexpanded_xacro(sheet: Sheet) -> Iterator[Find]:
    """A file for xacro, given where a URDF is needed.

    Parts are missing, or numbers are said to be none. xacro is a language of macros: `xacro:macro`, `${width / 2}`. The program
    xacro makes a URDF of such a file; ROS itself reads only the result. No other rule looks at such a file.

    Wrong, in a launch file:

        <param name="robot_description" textfile="$(find my_robot)/urdf/my_robot.urdf.xacro"/>

    Right:

        <param name="robot_description" command="xacro $(find my_robot)/urdf/my_robot.urdf.xacro"/>
    """
    found = sheet.xacro
    if not found:
        return
    element = found[0]
    attribute = next((one for one in element.attributes if is_for_xacro(one.value)), None)
    what = (
        f"<{shown(element.name)}>"
        if attribute is None
        else f'{attribute.name}="{shown(attribute.value)}"'
    )
    more = f", and {len(found) - 1} more such places" if len(found) > 1 else ""
    name = sheet.document.file.rpartition("/")[2]
    stem = name.removesuffix(".xacro").removesuffix(".urdf")
    urdf = f"{stem}.urdf" if name != f"{stem}.urdf" else f"{stem}_made.urdf"
    yield Find(
        attribute or element,
        element=element,
        what=f"{what} is for xacro, which has not been run on this file{more}",
        remedy=f'Make a URDF of it: simkit xacro {shown(name)} > {shown(urdf)}; in a launch file command="xacro ...".',
    )
