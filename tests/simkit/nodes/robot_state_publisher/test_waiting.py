from __future__ import annotations

from simkit.nodes.robot_state_publisher.waiting import Waiting


def test_who_speaks_and_who_is_missing_decides_what_the_hint_says():
    waiting = Waiting(["elbow", "hip"])
    assert waiting.hint("/joint_states", []) == (
        "hint: nobody publishes /joint_states, so elbow, hip have no position, and no transform: "
        "start joint_state_publisher, or joint_state_publisher_gui for sliders"
    )
    assert waiting.hint("/joint_states", ["/me"]) == (
        "hint: /me has not said anything on /joint_states yet, "
        "so elbow, hip have no position, and no transform"
    )
    waiting.heard(stamped=False)
    assert "no time stamp" in waiting.hint("/joint_states", ["/me"])
    waiting.heard(stamped=True)
    waiting.moved(["hip", "other"])
    assert waiting.hint("/joint_states", ["/me"]) == (
        "hint: /me on /joint_states gives no position for some joints: "
        "elbow has no position, and no transform"
    )
    waiting.moved(["elbow"])
    assert waiting.hint("/joint_states", []) is None
