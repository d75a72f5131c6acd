"""How long the first robot of a launch file takes from a cold start; and which public robots spawn.

Public robots of simple shapes, from the data that PyBullet's package brings: each spawns, or is refused with a reason.
Each one gets a process of its own, so that a crash of the engine would be seen.
"""

import importlib.util
import multiprocessing
import subprocess
import sys
from multiprocessing.connection import Connection
from pathlib import Path

from figures import Figure, median_of, show

from simkit import SimkitError, Simulation
from simkit.graph import LogLevel

PATIENCE = 120.0  # [s] of the wall, for one robot
ROOT = Path(__file__).parents[1]
RUNS = 7
MODULES_TARGET = 300.0
COLD = """
import sys, time
start = time.process_time()
import numpy, dartpy
libraries = time.process_time()
import simkit
sim = simkit.Simulation(package_path=["robots"], screen=None)
sim.roslaunch("my_robot_urdf", "spawn_urdf.launch")
while len(sim.gazebo.spawned) < 2:
    sim.run(0.05)
own = sum(name.startswith("simkit") for name in sys.modules)
print(time.process_time() - start, libraries - start, own)
"""  # a process that spawns a robot by its launch file, headless: seconds of the processor, and modules


def robots() -> list[Path]:
    """URDF files without meshes; none if the package is not there."""
    found = importlib.util.find_spec("pybullet_data")
    if found is None or found.origin is None:
        return []
    files = sorted(Path(found.origin).parent.rglob("*.urdf"))
    return [file for file in files if b"<mesh" not in file.read_bytes()]


def try_one(file: Path, answer: Connection) -> None:
    """Spawn a robot 0.5 m above the ground and let it fall for half a second; tell what became of it."""
    with Simulation(screen=None) as sim:
        try:
            name = sim.spawn(file, name="it", xyz=(0.0, 0.0, 0.5)).name
            sim.run(0.5)
        except SimkitError as error:
            answer.send(("refused", str(error)))
            return
        said = [record.text for record in sim.log if record.level >= LogLevel.ERROR]
        answer.send(("spawned", "") if name in sim.gazebo.spawned else ("refused", said[-1]))


def outcome(file: Path) -> tuple[str, str]:
    """What became of a robot, in a process of its own."""
    context = multiprocessing.get_context("fork")
    ours, theirs = context.Pipe(duplex=False)
    process = context.Process(target=try_one, args=(file, theirs))
    process.start()
    theirs.close()
    try:
        told = ours.recv() if ours.poll(PATIENCE) else ("hung", "")
    except EOFError:
        told = ("crashed", "")
    if told[0] == "hung":
        process.kill()
    process.join()
    return told[0], told[1]


def show_cold_start() -> None:
    """Print how long the first robot takes, the libraries apart."""
    runs = []
    for _ in range(RUNS):
        done = subprocess.run(
            [sys.executable, "-c", COLD], cwd=ROOT, check=True, capture_output=True, text=True
        )
        runs.append([float(number) for number in done.stdout.split()])
    whole, libraries, modules = (median_of(list(column)) for column in zip(*runs, strict=True))
    show(
        Figure("cold: a robot spawned by its launch file, headless", whole * 1e3, "ms"),
        Figure("... of it to import numpy and dartpy", libraries * 1e3, "ms"),
        Figure("... modules of simkit loaded", modules, "", MODULES_TARGET),
    )


def main() -> None:
    """Print what became of each, and the figures."""
    show_cold_start()
    files = robots()
    if not files:
        print("pybullet_data is not installed here (make bench installs it): nothing to spawn")
        return
    ends: dict[str, int] = {}
    for file in files:
        end, why = outcome(file)
        ends[end] = ends.get(end, 0) + 1
        if end != "spawned":
            print(f"  {end}: {file.parent.name}/{file.name}: {why[:200]}")
    show(Figure("public robots of simple shapes that spawn", ends.get("spawned", 0), "robots"))
    show(Figure("public robots refused with a reason", ends.get("refused", 0), "robots"))
    lost = ends.get("crashed", 0) + ends.get("hung", 0)
    show(Figure("public robots that crash or hang the engine", lost, "robots", 0.0))


if __name__ == "__main__":
    main()
