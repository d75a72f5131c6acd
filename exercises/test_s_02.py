"""Exercise S.2, public checks: a world with a crate, and a car that falls, lands, stands and drives."""

import math

import pytest

from grader.checks import after, expect, expect_close, points
from grader.checks.answers import given_answer
from grader.checks.personal import crate_of, name_of
from grader.checks.robots import RobotFiles, expect_chain, link_of
from grader.checks.worlds import (
    inertia_of,
    place_of,
    point_of,
    solid_of,
    spawned_robot,
    started_world,
    turned_inertia,
)
from grader.errors import CheckFailed
from simkit.xml import parse_xml

WORLD = "practice.world"
LAUNCH = "practice_world.launch"
ROBOT = "practice_car.urdf"
CAR = "practice_car"

# Link: kind of shape, where its middle is in base_link, how much room it takes along x, y, z [m].
SHAPES = {
    "chassis": ("box", (0.0, 0.0, 0.2), (0.6, 0.4, 0.2)),
    "right_wheel": ("cylinder", (-0.15, -0.23, 0.1), (0.2, 0.05, 0.2)),
    "left_wheel": ("cylinder", (-0.15, 0.23, 0.1), (0.2, 0.05, 0.2)),
    "front_wheel": ("sphere", (0.2, 0.0, 0.1), (0.2, 0.2, 0.2)),
}
# The book has its wheels 5 mm farther inside, which is as good.
NEAR = 0.006

# Link: mass [kg], and its inertia about the axes of base_link [kg m^2].
WEIGHTS = {
    "chassis": (1.0, ((0.4**2 + 0.2**2) / 12, (0.6**2 + 0.2**2) / 12, (0.6**2 + 0.4**2) / 12)),
    "right_wheel": (0.5, (0.5 * 0.0325 / 12, 0.5 * 0.1**2 / 2, 0.5 * 0.0325 / 12)),
    "left_wheel": (0.5, (0.5 * 0.0325 / 12, 0.5 * 0.1**2 / 2, 0.5 * 0.0325 / 12)),
    "front_wheel": (0.5, (0.002, 0.002, 0.002)),
}

FALL = math.sqrt(2 * 1.0 / 9.8)
"""Time of a fall of 1 m [s]."""


@pytest.fixture
def robots(exercise, submission, package_path):
    """The student's URDF files."""
    return RobotFiles(exercise, submission, package_path)


@pytest.fixture
def spawn(sim, robots):
    """A function that spawns the student's car somewhere in an empty world."""

    def spawn_car(**where):
        return spawned_robot(sim, robots.text(ROBOT), name=CAR, **where).model

    return spawn_car


def has_light(world):
    """Whether a world file has a lamp, or includes the sun."""
    root = parse_xml(world, file=WORLD).root
    found = [] if root is None else list(root.walk())
    return any(
        one.name == "light" or (one.name == "uri" and one.text.strip() == "model://sun")
        for one in found
    )


def speed_of(model):
    """How fast a model moves [m/s]."""
    return math.hypot(*model.twist[0])


@points(1)
def test_the_launch_file_starts_your_world(sim, roslaunch, submission):
    """practice_world.launch starts the world of practice.world: ground, sun and crate are in it."""
    gazebo = started_world(sim, roslaunch, LAUNCH)
    names = ", ".join(gazebo.spawned) or "none"
    expect(
        "ground_plane" in gazebo.spawned,
        f"there is no ground in the world; models in it: {names}",
        hint=f"Include model://ground_plane in {WORLD}. Without it everything falls for ever.",
    )
    expect(
        "crate" in gazebo.spawned,
        f"there is no crate in the world that {LAUNCH} starts; models in it: {names}",
        hint=f"If this is not your world: does the argument world_name have the path of {WORLD}? "
        'If it is your world: the model must be named "crate".',
    )
    expect(
        has_light(submission.files.get(f"gazebo_car/worlds/{WORLD}", "")),
        "there is no sun in the world",
        hint=f"Include model://sun in {WORLD}. Without it Gazebo shows everything dim and flat.",
    )


@points(1)
@after("test_the_launch_file_starts_your_world")
def test_your_crate_stands_in_it(sim, roslaunch, submission):
    """The crate has the size, mass, inertia and position that crate_of gives for your name."""
    task = crate_of(name_of(submission, "student"))
    a, b, c = task.size
    gazebo = started_world(sim, roslaunch, LAUNCH)
    crate = gazebo.spawned["crate"].model
    expect(
        crate.is_free,
        "nothing can move your crate",
        hint="A model with <static> never moves. Leave that tag out.",
    )
    expect_close(
        crate.mass,
        task.mass,
        tolerance=1e-3,
        what="the mass of your crate",
        unit="kg",
        hint="crate_of(...) gives the mass for your name. Without <mass> it would be 1 kg.",
    )
    expect_close(
        crate.centre_of_mass,
        (task.x, 0.0, c / 2),
        tolerance=2e-3,
        what="the middle of your crate",
        unit="m",
        frame="the world",
        hint="<pose> is that of its middle. The crate stands on the ground, so its middle is half its height above it.",
    )
    directions = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    walls = gazebo.world.cast_rays(crate.centre_of_mass, directions, reach=10.0).distances
    expect_close(
        walls,
        (a / 2, a / 2, b / 2, b / 2, c / 2, c / 2),
        tolerance=2e-3,
        what="the distance from its middle to its sides, in both directions along x, y and z,",
        unit="m",
        hint="<collision> contains <geometry> with a <box>, and its <size> is the three lengths along x, y, z. "
        "If the distance is inf, the crate has no <collision>.",
    )
    expect(
        len(crate.plan.bodies) == 1,
        f"your crate has {len(crate.plan.bodies)} links, not one",
        hint="A crate is one rigid body, so it has one <link>.",
    )
    (body,) = crate.plan.bodies.values()
    tensor = turned_inertia(body.body.tensor, place_of(crate, body.name).turn)
    expect_close(
        [tensor[i][i] for i in range(3)],
        [task.mass * part / 12 for part in (b * b + c * c, a * a + c * c, a * a + b * b)],
        tolerance=0.03 * task.mass * (a * a + b * b) / 12,
        what="ixx, iyy, izz of your crate",
        unit="kg m^2",
        hint="Each is m / 12 times the sum of the squares of the two sides across that axis.",
    )
    sim.run(0.3)
    expect(
        math.dist(crate.centre_of_mass, (task.x, 0.0, c / 2)) < 5e-3 and speed_of(crate) < 0.02,
        "your crate does not stay where it was put",
        hint="Does it start on the ground, and not in it or above it? The ground is at z = 0.",
    )


@points(1)
def test_check_urdf_takes_your_car(robots):
    """check_urdf finds nothing wrong with practice_car.urdf: base_link carries the chassis, which carries wheels and ball."""
    robots.expect_clean(ROBOT)
    robot = robots.robot(ROBOT)
    for part in ("right_wheel", "left_wheel", "front_wheel"):
        expect_chain(robot, "base_link", "chassis", part)


@points(1)
def test_each_part_has_its_shape_and_place(robots, spawn):
    """Each part has a visual and a collision shape of the right kind and size, in the right place."""
    robot, model = robots.robot(ROBOT), spawn()
    for name, (kind, middle, size) in SHAPES.items():
        link, place = link_of(robot, name), place_of(model, name)
        for tag, shapes in (("visual", link.visuals), ("collision", link.collisions)):
            expect(
                len(shapes) == 1,
                f"{name} has {len(shapes)} times <{tag}>, not once",
                hint="Each of the four parts needs one <visual> and one <collision>, with the same shape.",
            )
            solid = solid_of(shapes[0], place)
            expect(
                solid.kind == kind,
                f"the {tag} of {name} is a {solid.kind}, not a {kind}",
                hint="The table in the exercise lists the shape of each part.",
            )
            expect_close(
                solid.size,
                size,
                tolerance=3e-3,
                what=f"the extent of the {tag} of {name} along x, y, z",
                unit="m",
                frame="base_link",
                hint="A cylinder extends along the z axis of its frame, but a wheel lies along y: rotate it by a quarter "
                "turn about x, in <visual> and in <collision>.",
            )
            expect_close(
                solid.centre,
                middle,
                tolerance=NEAR,
                what=f"the middle of the {tag} of {name}",
                unit="m",
                frame="base_link",
                hint="The <origin> of the joint places the link in its parent, and the <origin> of the shape places the "
                "shape in its link. base_joint lifts everything by 0.1 m.",
            )


@points(1)
def test_each_part_has_its_mass_and_inertia(robots, spawn):
    """Each part has the right mass, and the inertia of a solid body of its shape."""
    robot, model = robots.robot(ROBOT), spawn()
    for name, (mass, moments) in WEIGHTS.items():
        link, place = link_of(robot, name), place_of(model, name)
        if link.inertial is None:
            raise CheckFailed(f"{name} has no mass", hint="Mass and inertia belong in <inertial>.")
        expect_close(
            link.inertial.mass,
            mass,
            tolerance=1e-3,
            what=f"the mass of {name}",
            unit="kg",
            hint="The table in the exercise lists the mass of each part.",
        )
        expect_close(
            point_of(place, link.inertial.origin.xyz),
            SHAPES[name][1],
            tolerance=NEAR,
            what=f"the centre of mass of {name}",
            unit="m",
            frame="base_link",
            hint="It is in the middle of the shape: give <inertial> the same <origin> as <visual>.",
        )
        found = inertia_of(link, place)
        for row in range(3):
            right = [moments[row] if row == column else 0.0 for column in range(3)]
            expect_close(
                found[row],
                right,
                tolerance=0.05 * max(moments),
                what=f"row {'xyz'[row]} of the inertia of {name}",
                unit="kg m^2",
                frame="base_link",
                hint="The table of inertias has the formula for each shape. The wheels are rotated: rotate their "
                "<inertial> too, by the same rpy, or let iyy be the moment about the axle.",
            )


@points(1)
@after("test_each_part_has_its_shape_and_place")
def test_it_falls_and_comes_to_rest(sim, spawn):
    """Spawned at z = 1, the car touches the ground when it should, and then stands on wheels and ball."""
    model = spawn(xyz=(0.0, 0.0, 1.0))
    sim.run(FALL - 0.012)
    expect(
        not sim.world.contacts(),
        f"something touches the ground before the car has fallen for {FALL:.2f} s",
        hint="Does a part of the car reach lower than its wheels?",
    )
    sim.run(0.024)
    expect(
        bool(sim.world.contacts()),
        f"nothing touches the ground after a fall of {FALL:.2f} s",
        hint="Wheels and ball each need a <collision>, with the lowest point at z = 0 in base_link.",
    )
    sim.run(0.6)
    (x, y, z), turn = place_of(model, "base_link")
    expect_close(
        (x, y, z),
        (0.0, 0.0, 0.0),
        tolerance=2e-3,
        what="where base_link is, half a second after landing",
        unit="m",
        frame="the world",
        hint="The lowest points of wheels and ball must be at the same height: then the car lands on all of them, and stays.",
    )
    tilt = math.acos(min(1.0, turn[2][2]))
    expect_close(
        math.degrees(tilt),
        0.0,
        tolerance=0.5,
        what="how far the car tilts when it stands",
        unit="degrees",
        hint="The ball must have the radius of the wheels, and its middle must be as high as theirs.",
    )


@points(1)
@after("test_it_falls_and_comes_to_rest")
def test_it_drives_straight(sim, spawn):
    """Commanded to drive at 0.4 m/s, the car does so, straight ahead."""
    model = spawn()
    expect(
        "/cmd_vel" in sim.topics(),
        "nothing subscribes to /cmd_vel",
        hint="The plugin libgazebo_ros_diff_drive.so does. Write it as <plugin> into a <gazebo> at the end of the car's "
        "file, with the commandTopic cmd_vel.",
    )
    sim.run(0.2)
    sim.rostopic_pub("/cmd_vel", "geometry_msgs/Twist", {"linear": {"x": 0.4}})
    sim.run(0.8)
    before = model.pose.translation
    sim.run(0.5)
    velocity = [
        (now - then) / 0.5 for now, then in zip(model.pose.translation, before, strict=True)
    ]
    expect_close(
        velocity,
        (0.4, 0.0, 0.0),
        tolerance=0.02,
        what="the velocity of the car, commanded to drive at 0.4 m/s,",
        unit="m/s",
        frame="the world",
        hint="If the car drives backwards, look at the axes of the wheels. If it is too fast or too slow, remember that "
        "wheelDiameter is twice the radius. If it does not move, look at the names of the two joints.",
    )


@points(1)
def test_your_answers(submission):
    """The answers give the time of the fall, the number of bodies, and the share of the weight on the wheels."""
    name_of(submission, "student")
    expect_close(
        given_answer(submission, "fall_time"),
        FALL,
        tolerance=0.006,
        what="fall_time",
        unit="s",
        hint="After a time t, a body that falls from rest has dropped by g t^2 / 2. Solve that for t, and do not forget the "
        "root.",
    )
    expect_close(
        given_answer(submission, "bodies_in_gazebo"),
        3,
        tolerance=0.0,
        what="bodies_in_gazebo",
        hint="Links that are held together by fixed joints are one body. Which joints of the car are not fixed?",
    )
    expect_close(
        given_answer(submission, "weight_on_wheels"),
        100 * (1 - 9.1 / 24.5),
        tolerance=0.6,
        what="weight_on_wheels",
        unit="percent",
        hint="Take moments about the axle of the wheels: 0.35 m times the force on the ball is the sum of the weights "
        "of the links, each times its distance ahead of the axle. The rest of the weight is on the wheels.",
    )
