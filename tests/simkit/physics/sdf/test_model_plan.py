"""An SDF model becomes the model that Gazebo makes of it."""

from __future__ import annotations

import math

import pytest

from simkit.physics import JointKind, ModelError, WorldFileError
from simkit.physics.sdf import plan_model, read_model_text

SECOND = 1_000_000_000
MASS = "<inertial><mass>{}</mass><inertia><ixx>0.1</ixx><iyy>0.1</iyy><izz>0.1</izz></inertia></inertial>"


def model(inside: str, version: str = "1.6"):
    text = f'<sdf version="{version}"><model name="m">{inside}</model></sdf>'
    return read_model_text(text, file="m.sdf")[0]


def link(name: str, pose: str = "0 0 0 0 0 0", inside: str = "") -> str:
    return f'<link name="{name}"><pose>{pose}</pose>{MASS.format(1)}{inside}</link>'


def joint(parent: str, child: str, inside: str = "", kind: str = "revolute") -> str:
    return (
        f'<joint name="{parent}_{child}" type="{kind}"><parent>{parent}</parent><child>{child}</child>'
        f"{inside}</joint>"
    )


AXIS = "<axis><xyz>{}</xyz>{}</axis>"


def test_each_link_is_a_body():
    plan = plan_model(model(link("a") + link("b", "1 0 0 0 0 0")))
    assert list(plan.bodies) == ["a", "b"]
    assert [one.kind for one in plan.joints.values()] == [JointKind.FREE, JointKind.FREE]
    assert plan.joints["b (free)"].frame.translation == (1.0, 0.0, 0.0)


def test_a_static_model_is_fixed():
    plan = plan_model(model("<static>true</static>" + link("a")))
    assert plan.is_static
    assert plan.joints["a (fixed)"].kind is JointKind.FIXED


def test_without_inertial_a_link_weighs_a_kilogram():
    body = plan_model(model('<link name="a"/>')).bodies["a"].body
    assert (body.mass, body.tensor[0][0]) == (1.0, 1.0)


def test_links_hang_on_each_other_whatever_their_order():
    text = link("c", "2 0 0 0 0 0") + link("b", "1 0 0 0 0 0") + link("a")
    axis = AXIS.format("0 1 0", "")
    plan = plan_model(model(text + joint("b", "c", axis) + joint("a", "b", axis)))
    assert list(plan.bodies) == ["a", "b", "c"]
    assert plan.joints["b_c"].frame.translation == pytest.approx((1.0, 0.0, 0.0))


@pytest.mark.parametrize(
    ("version", "axis", "expected"),
    [
        ("1.4", AXIS.format("0 0 1", ""), (0, 0, 1)),  # in the model
        ("1.5", AXIS.format("0 0 1", ""), (0, -1, 0)),  # in the joint, which lies on its side
        (
            "1.6",
            AXIS.format("0 0 1", "<use_parent_model_frame>1</use_parent_model_frame>"),
            (0, 0, 1),
        ),
        ("1.7", "<axis><xyz expressed_in='__model__'>0 0 1</xyz></axis>", (0, 0, 1)),
    ],
)
def test_an_axis_is_in_the_joint_or_in_the_model(version, axis, expected):
    text = link("a") + link("b", f"1 0 0 {math.pi / 2} 0 0") + joint("a", "b", axis)
    plan = plan_model(model(text, version))

    in_model = plan.joints["a_b"].frame.rotate(plan.joints["a_b"].axis)
    assert in_model == pytest.approx(expected)


def test_limits_and_dynamics_of_a_joint():
    inside = AXIS.format(
        "0 2 0",
        "<limit><lower>-1</lower><upper>1e16</upper><effort>5</effort><velocity>-1</velocity></limit>"
        "<dynamics><damping>0.1</damping><friction>0.2</friction><spring_stiffness>3</spring_stiffness>"
        "<spring_reference>0.5</spring_reference></dynamics>",
    )
    one = plan_model(model(link("a") + link("b") + joint("a", "b", inside))).joints["a_b"]
    assert one.axis == (0.0, 1.0, 0.0)
    assert (one.lower, one.upper, one.effort, one.velocity) == (-1.0, math.inf, 5.0, math.inf)
    assert (one.damping, one.friction, one.stiffness, one.rest) == (0.1, 0.2, 3.0, 0.5)


def test_a_joint_beside_the_origin_of_its_link_turns_about_itself(new_world):
    pose = "<pose>0 0 0.5 0 0 0</pose>"  # the joint sits at the upper end of the rod
    text = link("rod", "0 0 1 0 0 0") + joint("world", "rod", pose + AXIS.format("0 1 0", ""))
    world = new_world(ground=False)
    rod = world.add(plan_model(model(text)))
    turning = rod.joint("world_rod")
    turning.set_position(math.pi / 2)
    # hanging down from z = 1.5; turned about y by 90 degrees, down becomes -x
    assert rod.link_pose("rod").translation == pytest.approx((-0.5, 0.0, 1.5))
    world.run(SECOND // 10)
    assert turning.velocity < -0.5
    speed = turning.velocity
    assert rod.link_twist("rod")[0][2] == pytest.approx(
        0.5 * speed * math.sin(turning.position), rel=0.02
    )


def test_self_collide_of_the_model_and_of_a_link():
    text = (
        "<self_collide>1</self_collide>"
        + link("a")
        + link("b", inside="<self_collide>0</self_collide>")
    )
    plan = plan_model(model(text))
    assert (plan.bodies["a"].self_collide, plan.bodies["b"].self_collide) == (True, False)


def test_gravity_and_decay_of_a_link():
    inside = "<gravity>0</gravity><velocity_decay><linear>0.01</linear></velocity_decay>"
    body = plan_model(model(link("a", inside=inside))).bodies["a"]
    assert (body.gravity, body.decay) == (False, 0.01)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (link("a") + link("b") + joint("a", "b") + joint("b", "a"), "circle"),
        (link("a") + link("b") + link("c") + joint("a", "c") + joint("b", "c"), "loops"),
        (f'<link name="a">{MASS.format(0)}</link>', "mass of 0 kg"),
        (f'<link name="a">{MASS.format(-2)}</link>', "mass of -2 kg"),
        (link("a") + link("b") + joint("a", "b", AXIS.format("0 0 0", "")), "points nowhere"),
    ],
)
def test_models_that_cannot_be_are_refused(text, words):
    with pytest.raises(ModelError, match=words):
        plan_model(model(text))


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (link("a") + joint("a", "b"), "child of joint a_b is 'b'"),
        (link("a") + joint("x", "a"), "parent of joint x_a is 'x'"),
        (link("a") + link("a"), "two of <link"),
        ("<link/>", "a <link> has no name"),
    ],
)
def test_models_with_wrong_names_are_refused_with_their_place(text, words):
    with pytest.raises(WorldFileError, match=words) as caught:
        model(text)
    assert str(caught.value).startswith("m.sdf:1:")


def test_a_joint_of_a_type_that_is_not_simulated_lets_go():
    text = f'<sdf version="1.6"><model name="m">{link("a")}{link("b")}{joint("a", "b", kind="ball")}</model></sdf>'
    found, diagnostics = read_model_text(text, file="m.sdf")
    assert found.joints == ()
    assert "of type 'ball', which is not supported: b is not held by it" in diagnostics[0].what


def test_a_file_without_a_model_is_refused():
    with pytest.raises(WorldFileError, match="no <model>"):
        read_model_text("<sdf version='1.6'/>", file="m.sdf")


def test_a_car_of_sdf_drives(new_world, at):
    wheel = (
        '<link name="{0}"><pose>0 {1} 0.1 -1.5707963 0 0</pose><inertial><mass>0.5</mass><inertia><ixx>0.0014</ixx>'
        "<iyy>0.0014</iyy><izz>0.0025</izz></inertia></inertial><collision name='c'><geometry><cylinder>"
        "<radius>0.1</radius><length>0.05</length></cylinder></geometry></collision></link>"
        '<joint name="{0}" type="revolute"><parent>body</parent><child>{0}</child><axis><xyz>0 0 1</xyz></axis></joint>'
    )
    text = (
        '<link name="body"><pose>0.1 0 0.15 0 0 0</pose><inertial><mass>2</mass><inertia><ixx>0.02</ixx><iyy>0.02</iyy>'
        "<izz>0.02</izz></inertia></inertial><collision name='hull'><geometry><box><size>0.4 0.2 0.1</size></box></geometry>"
        "</collision><collision name='ball'><pose>0.15 0 -0.1 0 0 0</pose><geometry><sphere><radius>0.05</radius></sphere>"
        "</geometry><surface><friction><ode><mu>0</mu><mu2>0</mu2></ode></friction></surface></collision></link>"
    )
    world = new_world()
    car = world.add(
        plan_model(model(text + wheel.format("left", 0.15) + wheel.format("right", -0.15)))
    )
    for name in ("left", "right"):
        car.joint(name).command_velocity(2.0, effort=5.0)
    world.run(5 * SECOND)
    x, y, _ = car.pose.translation
    assert x == pytest.approx(0.2 * 5, abs=0.02)
    assert y == pytest.approx(0.0, abs=1e-3)
