"""The book's arm, let go from level, here, in MuJoCo and in PyBullet: how fast, how right; and the car with a laser.

The peers are no dependency of the course: `make bench` installs them from `benchmarks/peers.lock`.
"""

import importlib
import math
import time
from collections.abc import Callable
from pathlib import Path

from figures import Figure, median_of, show

from simkit import Simulation

ROOT = Path(__file__).resolve().parents[1]
ARM, ROBOTS = ROOT / "tests/simkit/physics/robots/arm.urdf", ROOT / "robots"
STEPS, STEP = 2000, 1e-3
HIP, SHOULDER = 1.153384, 1.756643  # at 2 s, by a method of the fourth order
ROUNDS = 5
G = 9.8

Run = tuple[float, float, float]
"""Time of the processor [s], hip and shoulder at the end [rad]."""


def simkit() -> Run:
    """A simulation with a world, clock and graph, as a notebook has it."""
    with Simulation(screen=None) as sim:
        arm = sim.spawn(ARM, name="arm").model
        start = time.process_time()
        sim.run(STEPS * STEP)
        took = time.process_time() - start
        return took, arm.joint("hip").position, arm.joint("shoulder").position


def mujoco() -> Run:
    """MuJoCo with its default integrator, a semi-implicit one of the first order."""
    return _mujoco("mjINT_EULER")


def mujoco_rk4() -> Run:
    """MuJoCo with Runge and Kutta's method."""
    return _mujoco("mjINT_RK4")


def _mujoco(integrator: str) -> Run:
    engine = importlib.import_module("mujoco")
    model = engine.MjModel.from_xml_path(str(ARM))
    model.opt.integrator = getattr(engine.mjtIntegrator, integrator)
    model.opt.timestep = STEP
    model.opt.gravity[:] = (0.0, 0.0, -G)
    model.opt.disableflags |= engine.mjtDisableBit.mjDSBL_CONTACT
    data = engine.MjData(model)
    start = time.process_time()
    for _ in range(STEPS):
        engine.mj_step(model, data)
    took = time.process_time() - start
    return took, float(data.qpos[0]), float(data.qpos[1])


def pybullet() -> Run:
    """PyBullet without the damping and the motors that it adds to every robot."""
    engine = importlib.import_module("pybullet")
    client = engine.connect(engine.DIRECT)
    try:
        engine.setGravity(0.0, 0.0, -G)
        engine.setTimeStep(STEP)
        body = engine.loadURDF(str(ARM), useFixedBase=True)
        moving = []
        for joint in range(engine.getNumJoints(body)):
            engine.changeDynamics(
                body, joint, linearDamping=0.0, angularDamping=0.0, jointDamping=0.0
            )
            if engine.getJointInfo(body, joint)[2] == engine.JOINT_REVOLUTE:
                engine.setJointMotorControl2(body, joint, engine.VELOCITY_CONTROL, force=0.0)
                moving.append(joint)
        start = time.process_time()
        for _ in range(STEPS):
            engine.stepSimulation()
        took = time.process_time() - start
        hip, shoulder = (engine.getJointState(body, joint)[0] for joint in moving)
        return took, hip, shoulder
    finally:
        engine.disconnect(client)


def scanning_car() -> float:
    """Simulated seconds per second of the two-wheeled robot, which drives and scans 720 beams at 20 Hz."""
    with Simulation(screen=None, package_path=[ROBOTS]) as sim:
        sim.roslaunch("my_robot_urdf", "spawn_urdf.launch")
        sim.run(0.5)
        sim.rostopic_pub("/cmd_vel", "geometry_msgs/Twist", "{linear: {x: 0.3}, angular: {z: 0.2}}")
        scans = sim.record({"/m2wr/laser/scan": "sensor_msgs/LaserScan"})
        start = time.process_time()
        sim.run(5.0)
        took = time.process_time() - start
        assert len(scans["/m2wr/laser/scan"]) >= 99
        return 5.0 / took


def measure(run: Callable[[], Run]) -> tuple[float, float]:
    """Median time of the processor [s], and the error at the end [rad]."""
    runs = [run() for _ in range(ROUNDS)]
    _, hip, shoulder = runs[0]
    return median_of([took for took, _, _ in runs]), math.hypot(hip - HIP, shoulder - SHOULDER)


def main() -> None:
    """Print the figures."""
    ours, off = measure(simkit)
    show(Figure("arm let go: simulated seconds per second, simkit", STEPS * STEP / ours, "x"))
    show(Figure("arm let go: off after 2 s, simkit", off * 1e3, "mrad", 1.0))
    for name, run in (
        ("MuJoCo", mujoco),
        ("MuJoCo with RK4", mujoco_rk4),
        ("PyBullet", pybullet),
    ):
        try:
            took, error = measure(run)
        except ImportError:
            print(f"{name}: not installed here, so it is not measured (make bench installs it)")
            continue
        show(Figure(f"arm let go: simulated seconds per second, {name}", STEPS * STEP / took, "x"))
        show(Figure(f"arm let go: off after 2 s, {name}", error * 1e3, "mrad"))
        show(Figure(f"arm let go: time of ours in that of {name}", ours / took, "x"))
    show(Figure("car with a laser of 20 Hz: simulated seconds per second", scanning_car(), "x"))


if __name__ == "__main__":
    main()
