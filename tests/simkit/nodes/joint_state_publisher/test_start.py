from __future__ import annotations

import pytest

from simkit.nodes.joint_state_publisher import JointStatePublisherGui


@pytest.mark.parametrize("words", [["_use_gui:=true"], []])
def test_use_gui_brings_the_sliders_and_a_word_on_what_is_modern(stage, words):
    stage.load(stage.turning("hip"), **({} if words else {"use_gui": True}))
    node = stage.start(*words)
    assert isinstance(node.program, JointStatePublisherGui)
    assert node.program.title == "Node: /joint_state_publisher"
    (warning,) = stage.said("WARN")
    assert warning.startswith("The 'use_gui' parameter was specified, which is deprecated.")
    assert "joint_state_publisher_gui of the package joint_state_publisher_gui" in warning


def test_without_use_gui_there_are_no_sliders_and_no_word(stage):
    stage.load(stage.turning("hip"), use_gui=False)
    node = stage.start()
    assert not isinstance(node.program, JointStatePublisherGui)
    assert stage.said("WARN") == []
