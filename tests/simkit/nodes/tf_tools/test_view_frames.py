"""`rosrun tf view_frames`, and tf2's."""

import pytest

from simkit import Simulation


@pytest.mark.parametrize(
    ("package", "program", "words"),
    [
        ("tf", "view_frames", "frames.pdf generated"),
        ("tf2_tools", "view_frames.py", "Generating graph in frames.pdf"),
    ],
)
def test_after_five_seconds_the_files_are_there(tmp_path, monkeypatch, package, program, words):
    monkeypatch.chdir(tmp_path)
    with Simulation(screen=None) as sim:
        sim.rosrun(
            "tf2_ros",
            "static_transform_publisher",
            "1",
            "0",
            "0",
            "0",
            "0",
            "0",
            "world",
            "carrot1",
        )
        node = sim.rosrun(package, program)
        sim.run(4.9)
        assert node.alive
        assert not (tmp_path / "frames.pdf").exists()
        sim.run(0.2)
    assert not node.alive
    assert node.exit_code == 0
    assert words in node.output
    assert (tmp_path / "frames.pdf").read_bytes().startswith(b"%PDF")
    assert '"world" -> "carrot1"' in (tmp_path / "frames.gv").read_text()
