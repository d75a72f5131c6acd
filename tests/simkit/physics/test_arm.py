"""The arm of exercise 3.9 swings as mechanics says."""

from __future__ import annotations

import math

import pytest

SECOND = 1_000_000_000

# Hip and shoulder [rad] of the free arm, from rest at 0: a Runge-Kutta solution of its equations of
# motion, of the fourth order, which keeps the energy to 1e-8.
SWING = {
    0.1: (0.005109, 0.181554),
    0.2: (0.095970, 0.723872),
    0.25: (0.316361, 1.137432),
    0.3: (1.114691, 1.729059),
    0.4: (1.688605, 2.583245),
    0.5: (1.739964, 3.037881),
    0.75: (1.690103, 2.590435),
    1.0: (0.027825, 0.414187),
    1.5: (1.561819, 2.211020),
    2.0: (1.153384, 1.756643),
}
# What the arm exchanges between height and motion [J]: 1 kg, 0.2 m from the shoulder.
SWUNG_ENERGY = 2 * 1.0 * 9.8 * 0.2


def energy(model) -> float:
    return model.kinetic_energy + model.potential_energy


def test_the_free_arm_is_where_the_equations_of_motion_say(new_world, robot_plan):
    world = new_world()
    arm = world.add(robot_plan("arm"))
    for t, (hip, shoulder) in SWING.items():
        world.run_until(round(t * SECOND))
        assert arm.joint("hip").position == pytest.approx(hip, abs=3e-4)
        assert arm.joint("shoulder").position == pytest.approx(shoulder, abs=3e-4)


def test_the_free_arm_keeps_its_energy(new_world, robot_plan):
    world = new_world()
    arm = world.add(robot_plan("arm"))
    before, worst = energy(arm), 0.0
    for _ in range(2000):
        world.step()
        worst = max(worst, abs(energy(arm) - before))
    assert worst < 0.001 * SWUNG_ENERGY


def test_the_pendulum_has_its_period(new_world, robot_plan):
    world = new_world()
    arm = world.add(robot_plan("arm"))
    shoulder = arm.joint("shoulder")
    arm.joint("hip").command_position(0.0)
    turns, last = [], 0.0
    for _ in range(4000):
        world.step()
        if last < 0.0 <= shoulder.velocity:
            turns.append(world.time_ns)
        last = shoulder.velocity
    assert arm.joint("hip").position == 0.0
    # back where it began after one period, and after two
    assert turns[0] * 1e-9 == pytest.approx(1.230537, abs=2e-3)
    assert (turns[1] - turns[0]) * 1e-9 == pytest.approx(1.230537, abs=2e-3)


def test_the_base_stands_on_the_world(new_world, robot_plan, at):
    world = new_world()
    arm = world.add(robot_plan("arm"), pose=at(x=1.0, z=0.2, angle=0.5))
    base = arm.link_pose("base_link")
    world.run(SECOND)
    assert arm.link_pose("base_link") == base
    assert base.translation == (1.0, 0.0, 0.2)
    assert arm.pose.rotation == pytest.approx(at(angle=0.5).rotation)
    assert not arm.is_free


def test_damping_takes_energy_and_friction_stops_it(new_world, plan_text, robot_plan):
    arm = """<link name="world"/><joint name="j" type="continuous"><parent link="world"/><child link="a"/>
      <axis xyz="0 1 0"/><dynamics {}/></joint>
      <link name="a"><inertial><mass value="1"/><origin xyz="0 0 -0.2"/>
      <inertia ixx="0.01" iyy="0.01" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>"""
    world = new_world(ground=False)
    damped = world.add(plan_text(arm.format('damping="0.02"')), name="damped")
    rubbed = world.add(plan_text(arm.format('friction="0.1"')), name="rubbed")
    free = world.add(plan_text(arm.format('damping="0"')), name="free")
    for model in (damped, rubbed, free):
        model.joint("j").set_position(1.0)
    world.run(10 * SECOND)
    assert energy(free) == pytest.approx(-1 * 9.8 * 0.2 * math.cos(1.0), abs=1e-3)
    assert damped.joint("j").position == pytest.approx(0.0, abs=0.2)
    assert rubbed.joint("j").velocity == pytest.approx(0.0, abs=1e-6)
    assert abs(math.sin(rubbed.joint("j").position)) * 1 * 9.8 * 0.2 <= 0.1 + 1e-6


def test_a_spring_pulls_to_its_rest(new_world, plan_text):
    world = new_world(gravity=(0.0, 0.0, 0.0), ground=False)
    sprung = world.add(
        plan_text("""<link name="world"/><joint name="j" type="continuous"><parent link="world"/><child link="a"/>
      <axis xyz="0 1 0"/></joint>
      <link name="a"><inertial><mass value="1"/><inertia ixx="0.04" iyy="0.04" izz="0.04" ixy="0" ixz="0" iyz="0"/>
      </inertial></link>
      <gazebo reference="j"><springStiffness>4.0</springStiffness><springReference>0.1</springReference></gazebo>""")
    )
    joint = sprung.joint("j")
    highest = 0.0
    for _ in range(round(2 * math.pi / 10 * 1000)):  # one period of sqrt(k / I) = 10 rad/s
        world.step()
        highest = max(highest, joint.position)
    # it keeps its energy; plain steps would take the spring where it will be, which damps it by 3 mrad
    assert highest == pytest.approx(0.2, abs=1e-5)
    assert joint.position == pytest.approx(0.2 * math.sin(0.0004) ** 2, abs=1e-4)


def motion(length_s: float, damping: float, stiffness: float) -> tuple[float, float]:
    """Angle and rate of a damped and sprung pendulum, 0.25 kg m^2 and 4.9 N m, by Runge and Kutta, from 1.2 rad."""

    def slope(angle: float, rate: float) -> tuple[float, float]:
        torque = -4.9 * math.sin(angle) - damping * rate - stiffness * angle
        return rate, torque / 0.25

    angle, rate, h = 1.2, 0.0, 1e-3
    for _ in range(round(length_s / h)):
        a1, r1 = slope(angle, rate)
        a2, r2 = slope(angle + h / 2 * a1, rate + h / 2 * r1)
        a3, r3 = slope(angle + h / 2 * a2, rate + h / 2 * r2)
        a4, r4 = slope(angle + h * a3, rate + h * r3)
        angle += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)
        rate += h / 6 * (r1 + 2 * r2 + 2 * r3 + r4)
    return angle, rate


@pytest.mark.parametrize("stiffness", [0.0, 20.0, 300.0])
@pytest.mark.parametrize("damping", [0.0, 0.1, 2.0])
def test_dampers_and_springs_act_as_equations_say(new_world, plan_text, damping, stiffness):
    world = new_world(ground=False)
    pendulum = world.add(
        plan_text(f"""<link name="world"/><joint name="j" type="continuous"><parent link="world"/><child link="a"/>
      <axis xyz="0 1 0"/><dynamics damping="{damping}"/></joint>
      <link name="a"><inertial><mass value="1"/><origin xyz="0 0 -0.5"/>
      <inertia ixx="0.01" iyy="1e-6" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>
      <gazebo reference="j"><springStiffness>{stiffness}</springStiffness></gazebo>""")
    )
    joint = pendulum.joint("j")
    joint.set_position(1.2)
    for t in (0.3, 1.0, 2.0):
        world.run_until(round(t * SECOND))
        angle, rate = motion(t, damping, stiffness)
        pace = math.sqrt((4.9 + stiffness) / 0.25) + damping / 0.25
        off = 1.2 * t * pace**3 * 0.001**2 / 3  # of the second order in the step
        assert joint.position == pytest.approx(angle, abs=off)
        assert joint.velocity == pytest.approx(rate, abs=off * pace)


def test_every_state_that_is_shown_is_one_of_the_motion(new_world, robot_plan):
    """Between two kicks as well: at each step the rates are those of the positions, to second order."""
    world = new_world()
    arm = world.add(robot_plan("arm"))
    shown = []
    for _ in range(600):
        world.step()
        shown.append([(j.position, j.velocity) for j in arm.joints.values()])
    for before, here, after in zip(shown, shown[1:], shown[2:], strict=False):
        for (q0, _), (_, v), (q2, _) in zip(before, here, after, strict=True):
            assert (q2 - q0) / 0.002 == pytest.approx(v, abs=0.05)
