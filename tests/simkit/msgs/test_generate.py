from __future__ import annotations

from simkit.msgs import generate


def test_committed_definitions_are_fresh(capsys):
    assert generate.main(["--check"]) == 0
    assert capsys.readouterr().out == ""


def test_stale_ones_are_named_and_written(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr(generate, "DEFINITIONS", tmp_path)
    assert generate.main(["--check"]) == 1
    assert "stale: geometry_msgs/msg/Twist.msg; run python -m" in capsys.readouterr().out.replace(
        "\\", "/"
    )
    assert generate.main([]) == 0
    twist = tmp_path / "geometry_msgs" / "msg" / "Twist.msg"
    assert twist.read_text() == "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n"
    assert generate.main(["--check"]) == 0
