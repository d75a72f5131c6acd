"""Physics: what a world adds to the engine's own loop, what second-order steps buy, rays, detectors of collisions."""

import math
import time
from collections.abc import Callable
from pathlib import Path

import dartpy
import numpy as np
from figures import Figure, median_of, show

from simkit import Simulation
from simkit.geometry import Transform
from simkit.physics import Model, World, plan_robot
from simkit.physics.sdf import plan_model, read_model_text
from simkit.urdf import load_robot

ROOT = Path(__file__).resolve().parents[1]
ROBOTS = ROOT / "tests/simkit/physics/robots"
SECOND, STEPS, ROUNDS = 1_000_000_000, 2000, 21
HIP, SHOULDER = 1.153384, 1.756643  # of the free arm at 2 s, by a method of the fourth order
BEAMS = 720


def robot(world: World, name: str, z: float = 0.0) -> Model:
    """A robot of the tests in a world."""
    text = (ROBOTS / f"{name}.urdf").read_text(encoding="utf-8")
    plan = plan_robot(load_robot(text, file=f"{name}.urdf"))
    return world.add(plan, name=name, pose=Transform((0.0, 0.0, z), (0.0, 0.0, 0.0, 1.0)))


def driving_car() -> World:
    """The car, on its way."""
    world = World()
    car = robot(world, "car")
    for name in ("left_wheel_joint", "right_wheel_joint"):
        car.joint(name).command_velocity(5.0, effort=5.0)
    world.run(2 * SECOND)
    return world


def held_arm() -> World:
    """The arm, held by its joints."""
    world = World()
    for joint in robot(world, "arm").joints.values():
        joint.command_position(0.3)
    world.run(2 * SECOND)
    return world


def swinging_arm() -> World:
    """The arm, let go."""
    world = World()
    robot(world, "arm")
    world.run(2 * SECOND)
    return world


def arm_and_ball() -> World:
    """The arm, let go, in a world with something that it might touch."""
    world = swinging_arm()
    ball = (
        "<sdf version='1.6'><model name='b'><link name='l'><collision name='c'>"
        "<geometry><sphere><radius>0.1</radius></sphere></geometry></collision></link></model></sdf>"
    )
    plan = plan_model(read_model_text(ball, file="ball")[0])
    world.add(plan, name="ball", pose=Transform((3.0, 0.0, 0.1), (0.0, 0.0, 0.0, 1.0)))
    world.run(2 * SECOND)
    return world


def seconds(work: Callable[[], object]) -> float:
    """Time of the processor that something takes [s]."""
    start = time.process_time()
    work()
    return time.process_time() - start


def cost(world: World) -> tuple[float, float]:
    """Time of a step in the engine's own loop [us], and ours in it, taken in turns on the same world.

    The engine's own loop looks for the contacts of all shapes; ours of those that can touch something. The pace of a
    shared machine changes; within one turn it hardly does, so the ratio is that of the median turn.
    """
    engine, filter_ = world._engine, world._stepper.collision_filter

    def bare() -> float:
        filter_._look_only(frozenset())
        return seconds(loop)

    def loop() -> None:
        for _ in range(STEPS):
            engine.step(False)

    def ours() -> float:
        filter_._look_only(filter_._left_out)
        return seconds(lambda: world.run(STEPS * 1_000_000))

    pairs = [(bare(), ours()) for _ in range(ROUNDS)]
    bare_s = median_of([one for one, _ in pairs])
    return bare_s / STEPS * 1e6, median_of([with_us / alone for alone, with_us in pairs])


def show_overhead() -> None:
    """What `World.run` adds to a bare loop."""
    for name, make in (
        ("car that drives", driving_car),
        ("arm that is held", held_arm),
        ("arm that swings", swinging_arm),
    ):
        bare, ours = cost(make())
        show(Figure(f"{name}: a step of the engine", bare, "us"))
        show(Figure(f"{name}: what World.run adds", (ours - 1) * 100, "%", 10.0))
    show(Figure("arm that swings: simulated seconds per second", 1000 / (ours * bare), "x"))
    _, ours = cost(arm_and_ball())
    show(Figure("arm beside a loose ball: what World.run adds", (ours - 1) * 100, "%"))


def plain_arm(divisor: int) -> tuple[float, float]:
    """Error of the arm after 2 s with plain steps [rad], and time of the processor [s]."""
    world = World(step_ns=1_000_000 // divisor)
    arm = robot(world, "arm")
    engine = world._engine

    def loop() -> None:
        for _ in range(2000 * divisor):
            engine.step(False)

    return seconds(loop), error(arm)


def error(arm: Model) -> float:
    """How far the joints are from where they should be after 2 s [rad]."""
    return math.hypot(arm.joint("hip").position - HIP, arm.joint("shoulder").position - SHOULDER)


def show_accuracy() -> None:
    """What second-order steps buy."""
    world = World()
    arm = robot(world, "arm")
    second_order = seconds(lambda: world.run(2 * SECOND))
    show(Figure("arm after 2 s: second-order steps are off by", error(arm) * 1e3, "mrad", 1.0))
    for divisor in (1, 8):
        took, off = plain_arm(divisor)
        name = "plain steps" if divisor == 1 else f"steps of 1/{divisor} ms"
        show(Figure(f"arm after 2 s: {name} are off by", off * 1e3, "mrad"))
        show(Figure(f"arm after 2 s: {name} take, of second-order ones", took / second_order, "x"))


def show_laser_car() -> None:
    """What a simulation with a driving car, its odometry and a laser adds to the engine's own steps in it."""
    simulation = Simulation(package_path=[ROOT / "robots"], screen=None)
    simulation.spawn(ROOT / "robots/my_robot_urdf/urdf/m2wr.urdf", name="m2wr")
    scans = simulation.record("/m2wr/laser/scan")
    simulation.run(0.5)
    simulation.rostopic_pub("/cmd_vel", "geometry_msgs/Twist", {"linear": {"x": 0.2}})
    simulation.run(2.0)
    world = simulation.gazebo.world
    engine = world._engine

    def bare() -> float:
        return seconds(loop)

    def loop() -> None:
        for _ in range(STEPS):
            engine.step(False)

    def ours() -> float:
        return seconds(lambda: simulation.run(STEPS / 1000.0))

    pairs = [(bare(), ours()) for _ in range(ROUNDS)]
    ratio = median_of([with_us / alone for alone, with_us in pairs])
    assert len(scans["/m2wr/laser/scan"]) > 20 * STEPS / 1000, "the laser is not heard"
    name = "car with a laser of 20 Hz: Simulation.run over the engine's own steps in it"
    show(Figure(name, ratio, "x", 1.4))
    simulation.close()


def show_rays() -> None:
    """A scan against as many single casts of the engine."""
    world = World()
    robot(world, "car")
    box = (
        "<sdf version='1.6'><model name='b'><static>1</static><link name='l'><collision name='c'>"
        "<geometry><box><size>0.5 0.5 1</size></box></geometry></collision></link></model></sdf>"
    )
    plan = plan_model(read_model_text(box, file="box")[0])
    for number in range(6):
        place = (3.0 * math.cos(number), 3.0 * math.sin(number), 0.5)
        world.add(plan, name=f"box{number}", pose=Transform(place, (0.0, 0.0, 0.0, 1.0)))
    angles = np.linspace(-math.pi / 2, math.pi / 2, BEAMS)
    directions = np.stack([np.cos(angles), np.sin(angles), np.zeros(BEAMS)], axis=1)
    start = np.array([0.4, 0.0, 0.3])
    group = dartpy.collision.DARTCollisionDetector().createCollisionGroup()
    for model in world.models.values():
        group.addShapeFramesOf(model.built.skeleton)
    ends = start + 10.0 * directions

    def engine_casts() -> list[float]:
        option, result = dartpy.collision.RaycastOption(), dartpy.collision.RaycastResult()
        found = []
        for end in ends:
            result.clear()
            group.raycast(start, end, option, result)
            found.append(result.mRayHits[0].mFraction * 10.0 if result.hasHit() else math.inf)
        return found

    ours = median_of([seconds(lambda: world.cast_rays(start, directions)) for _ in range(ROUNDS)])
    theirs = median_of([seconds(engine_casts) for _ in range(ROUNDS)])
    show(Figure(f"a scan of {BEAMS} beams, car and 6 boxes", ours * 1e3, "ms"))
    show(Figure("times faster than single casts", theirs / ours, "x", 3.0, more_is_better=True))


def drift(kind: str, shape: dartpy.dynamics.Shape, angle: float) -> float:
    """How far a solid moves in 10 s on the plane, once it has come to rest [mm]."""
    world = dartpy.simulation.World()
    world.setGravity([0.0, 0.0, -9.8])
    world.setCollisionDetector(getattr(dartpy.simulation.CollisionDetectorType, kind))
    sleep = world.getDeactivationOptions()
    sleep.mEnabled = False
    world.setDeactivationOptions(sleep)
    for name, creator, solid in (
        ("ground", "createWeldJointAndBodyNodePair", dartpy.dynamics.PlaneShape([0, 0, 1], 0.0)),
        ("thing", "createFreeJointAndBodyNodePair", shape),
    ):
        skeleton = dartpy.dynamics.Skeleton(name)
        joint, body = getattr(skeleton, creator)()
        node = body.createShapeNode(solid)
        node.createCollisionAspect()
        node.createDynamicsAspect()
        if name == "thing":
            body.setInertia(
                dartpy.dynamics.Inertia(1.0, np.zeros(3), solid.computeInertiaFromMass(1.0))
            )
            joint.setPositions([angle, 0.0, 0.3, 0.0, 0.0, 0.3])
        world.addSkeleton(skeleton)
    places = []
    for steps in (2000, 10_000):
        for _ in range(steps):
            world.step(False)
        places.append(body.getWorldTransform().translation())
    return float(np.linalg.norm(places[1] - places[0])) * 1e3


def show_detectors() -> None:
    """Why the detector of collisions is ODE's."""
    for kind in ("ODE", "BULLET", "FCL", "DART"):
        box = dartpy.dynamics.BoxShape([0.2, 0.3, 0.1])
        log = dartpy.dynamics.CylinderShape(0.1, 0.3)
        target = 1.0 if kind == "ODE" else None
        show(Figure(f"a box at rest moves in 10 s, {kind}", drift(kind, box, 0.0), "mm", target))
        show(Figure(f"a log at rest moves in 10 s, {kind}", drift(kind, log, 1.57), "mm", target))


def main() -> None:
    """Print the figures."""
    show_overhead()
    show_accuracy()
    show_laser_car()
    show_rays()
    show_detectors()


if __name__ == "__main__":
    main()
