from __future__ import annotations

import pytest

from simkit.nodes.robot_state_publisher.segments import prefixed


@pytest.mark.parametrize(
    ("frame", "prefix", "sent"),
    [
        ("arm", "", "arm"),
        ("arm", "left", "left/arm"),
        ("arm", "/left", "left/arm"),
        ("/arm", "left", "arm"),
        ("/arm", "", "arm"),
    ],
)
def test_a_prefix_stands_before_a_frame_that_has_no_slash(frame, prefix, sent):
    assert prefixed(frame, prefix) == sent


def joint(name, kind, parent, child, inside=""):
    return (
        f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
        f'<origin xyz="1 2 3"/><limit effort="1" velocity="1"/>{inside}</joint>'
    )


def robot(*joints, inside=""):
    links = "".join(f'<link name="{name}"/>' for name in "bcde")
    return f'<robot name="r"><link name="a">{inside}</link>{links}{"".join(joints)}</robot>'


def test_every_kind_of_joint_goes_where_it_belongs(stage):
    stage.load(
        robot(
            joint("j4", "planar", "a", "b"),
            joint("j3", "floating", "a", "c"),
            joint("j2", "fixed", "c", "d"),
            joint("j1", "prismatic", "d", "e"),
        )
    )
    stage.start()
    stage.sim.run(0.1)
    (static,) = stage.heard("/tf_static")
    assert [(t.header.frame_id, t.child_frame_id) for t in static] == [("c", "d"), ("a", "b")]
    assert stage.said("WARN") == [
        "Converting unknown joint type of joint 'j3' into a fixed joint",
        "Converting unknown joint type of joint 'j4' into a fixed joint",
    ]
    assert stage.said("INFO") == [
        "Floating joint. Not adding segment from a to c. "
        "This TF can not be published based on joint_states info"
    ]
    stage.tell(j1=0.5)
    ((moving,),) = stage.heard()
    assert (moving.header.frame_id, moving.child_frame_id) == ("d", "e")
    assert moving.transform.translation.x == 1.5


def test_a_root_with_a_mass_is_not_what_kdl_wants(stage):
    inertia = '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'
    joints = [joint(f"j{child}", "fixed", "a", child) for child in "bcde"]
    stage.load(robot(*joints, inside=f'<inertial><mass value="1"/>{inertia}</inertial>'))
    assert stage.start().alive
    (warning,) = stage.said("WARN")
    assert warning.startswith("The root link a has an inertia specified in the URDF, but KDL")
