"""Reading robots, where their links are, and `simkit check_urdf` from a cold start."""

from __future__ import annotations

import io
import itertools
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from figures import Figure, median_of, show

from simkit.urdf import Robot, load_robot
from simkit.urdf.kinematics import forward_kinematics
from simkit.urdf.rules import check_robot
from simkit.xml import parse_xml

RUNS = 15
COMMAND = (
    "import sys; from simkit.cli import main; sys.exit(main())"  # what the installed script does
)
CHECK_URDF_TARGET = 200.0
READ_TARGET = 2.0


def chain(links: int) -> str:
    """The text of an arm: each link hangs on the one before it and has shape, mass and inertia."""
    parts = ['<?xml version="1.0"?>', '<robot name="chain">']
    for number in range(links):
        parts.append(
            f'  <link name="link_{number}">\n'
            '    <visual>\n      <origin xyz="0 0 0.2" rpy="0 0 0"/>\n      <geometry>\n'
            '        <cylinder radius="0.05" length="0.4"/>\n      </geometry>\n'
            '      <material name="silver">\n        <color rgba="0.75 0.75 0.75 1"/>\n'
            "      </material>\n    </visual>\n"
            '    <collision>\n      <origin xyz="0 0 0.2" rpy="0 0 0"/>\n      <geometry>\n'
            '        <cylinder radius="0.05" length="0.4"/>\n      </geometry>\n    </collision>\n'
            '    <inertial>\n      <origin xyz="0 0 0.2" rpy="0 0 0"/>\n      <mass value="1.0"/>\n'
            '      <inertia ixx="0.01396" ixy="0" ixz="0" iyy="0.01396" iyz="0" izz="0.00125"/>\n'
            "    </inertial>\n  </link>"
        )
        if number:
            parts.append(
                f'  <joint name="joint_{number}" type="continuous">\n'
                f'    <parent link="link_{number - 1}"/>\n    <child link="link_{number}"/>\n'
                '    <origin xyz="0 0 0.4" rpy="0 0.1 0"/>\n    <axis xyz="0 1 0"/>\n  </joint>'
            )
    return "\n".join([*parts, "</robot>\n"])


def per_call(work: Callable[[], object], calls: int) -> float:
    """Median time of one call over several rounds [ms]."""

    def one_round() -> float:
        start = time.perf_counter()
        for _ in range(calls):
            work()
        return (time.perf_counter() - start) / calls * 1e3

    return median_of([one_round() for _ in range(7)])


def positions_of(robot: Robot) -> dict[str, float]:
    """Some position of each joint [rad]."""
    return {name: 0.01 * number for number, name in enumerate(robot.joints)}


def cold(command: list[str]) -> float:
    """Wall time of one process [ms]."""
    start = time.perf_counter()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return (time.perf_counter() - start) * 1e3


def show_cold_starts() -> None:
    """Print how long a person waits for `check_urdf`, ours and urdfdom's, each in turn."""
    peer = shutil.which("check_urdf")
    with tempfile.TemporaryDirectory() as folder:
        path = str(Path(folder) / "chain.urdf")
        Path(path).write_text(chain(3), encoding="utf-8")
        commands = {
            "cold: python that does nothing": [sys.executable, "-c", "pass"],
            "cold: simkit check_urdf, 3 links": [sys.executable, "-c", COMMAND, "check_urdf", path],
        }
        if peer is not None:
            commands["cold: urdfdom's check_urdf, 3 links"] = [peer, path]
        times: dict[str, list[float]] = {name: [] for name in commands}
        for _ in range(RUNS):
            for name, command in commands.items():
                times[name].append(cold(command))
    for name, values in times.items():
        target = CHECK_URDF_TARGET if "simkit" in name else None
        show(Figure(name, median_of(values), "ms", target))
    if peer is None:
        print("urdfdom's check_urdf is not installed here: nothing to compare with")


def read_ratio(links: int) -> float:
    """Time to read a robot, over that of yourdfpy without its scene graph; each text is new, so that nothing is remembered."""
    import yourdfpy

    def ours(text: str) -> object:
        return load_robot(text, file="chain.urdf")

    def theirs(text: str) -> object:
        scenes = {"build_scene_graph": False, "build_collision_scene_graph": False}
        meshes = {"load_meshes": False, "load_collision_meshes": False}
        return yourdfpy.URDF.load(io.StringIO(text), **scenes, **meshes)

    def seconds(read: Callable[[str], object], number: int) -> float:
        text = chain(links).replace('name="chain"', f'name="chain_{number}"')
        start = time.process_time()
        read(text)
        return time.process_time() - start

    pairs = [(seconds(ours, number), seconds(theirs, number)) for number in range(RUNS)]
    own, other = zip(*pairs, strict=True)
    return median_of(list(own)) / median_of(list(other))


def main() -> None:
    """Print the figures."""
    show(Figure("URDF of 100 links, read, over yourdfpy's", read_ratio(100), "x", READ_TARGET))
    for links in (3, 100):
        text, calls = chain(links), 300 // links
        robot = load_robot(text, file="chain.urdf")
        document = parse_xml(text, file="chain.urdf")
        positions = positions_of(robot)
        numbers = itertools.count()
        reading = per_call(
            lambda t=text, n=numbers: load_robot(f"{t}<!-- {next(n)} -->", file="chain.urdf"), calls
        )
        rules = per_call(lambda d=document: check_robot(d), calls)
        kinematics = per_call(lambda r=robot, p=positions: forward_kinematics(r, p), calls)
        show(
            Figure(f"URDF of {links} links, read", reading, "ms"),
            Figure(f"URDF of {links} links, all rules", rules, "ms"),
            Figure(f"forward kinematics, {links} links", kinematics, "ms"),
        )
    show_cold_starts()


if __name__ == "__main__":
    main()
