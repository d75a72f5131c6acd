"""Write the robots' part of robots/README.md and draw their pictures, or say what is stale.

Run it as `python docs/robots/make_pages.py [--check]`.
"""

from __future__ import annotations

import sys
from pathlib import Path

from facts import RobotFacts, facts_of
from page import section
from pictures import is_same, photograph, tree

from simkit.packages import PackagePath

ROOT = Path(__file__).resolve().parents[2]
ROBOTS = ROOT / "robots"
README = ROBOTS / "README.md"
BEGIN = "<!-- robots: written by docs/robots/make_pages.py -->\n"
END = "<!-- end of robots -->"
POSITIONS = {
    "hello_ros_robot_2": {"hip": 0.6},
    "hello_ros_robot_3": {"hip": 0.6, "shoulder": -0.7},
    "hello_gazebo_robot_1": {"hip": 0.6, "shoulder": 1.5708},
    "hello_gazebo_robot_2": {"hip": 0.1, "shoulder": -0.5},
}
"""Where joints are in the pictures, by robot and name [rad]; others are at 0."""


def main() -> int:
    """Write what is stale, or name it; the exit code is 1 if `--check` names anything."""
    files = pages()
    stale = [path for path, data in files.items() if not is_same(path, data)]
    if "--check" in sys.argv[1:]:
        for path in stale:
            shown = path.relative_to(ROOT).as_posix()
            print(f"{shown} is stale; run python docs/robots/make_pages.py")
        return int(bool(stale))
    for path in stale:
        path.parent.mkdir(exist_ok=True)
        path.write_bytes(files[path])
        print(f"wrote {path.relative_to(ROOT).as_posix()}")
    return 0


def pages() -> dict[Path, bytes]:
    """Path -> content of README and of every picture."""
    packages = PackagePath([ROBOTS])
    robots = [facts_of(path, packages) for path in sorted(ROBOTS.glob("*/urdf/*.urdf"))]
    robots.sort(key=lambda facts: facts.place_in_course)
    files = {README: _readme(robots).encode()}
    for facts in robots:
        picture = ROBOTS / "pictures" / facts.stem
        positions = POSITIONS.get(facts.stem, {})
        files[picture.with_suffix(".png")] = photograph(facts, positions, packages=ROBOTS)
        files[picture.with_name(f"{facts.stem}_tree.svg")] = tree(facts)
    return files


def _readme(robots: list[RobotFacts]) -> str:
    """README with the sections of these robots between its two markers."""
    before, _, rest = README.read_text(encoding="utf-8").partition(BEGIN)
    _, _, after = rest.partition(END)
    parts, package = [], ""
    for facts in robots:
        if facts.package != package:
            package = facts.package
            parts.append(f"### {package}\n")
        parts.append(section(facts, POSITIONS.get(facts.stem, {})))
    return "\n".join([f"{before}{BEGIN}", *parts, f"{END}{after}"])


if __name__ == "__main__":
    sys.exit(main())
