"""doctor: what is here, and what is lost without the rest."""

import shutil

import pytest

from simkit.commands import doctor
from simkit.commands.doctor import LOOKS, Finding


def test_this_machine_is_sound_enough_to_run_these_tests(simkit):
    code, out, err = simkit("doctor")
    assert (code, err) == (0, "")
    lines = out.splitlines()
    assert lines[0].startswith("simkit ")
    assert len(lines) == 1 + len(LOOKS)
    assert "numpy " in out
    assert "ms" in next(line for line in lines if " nodes " in line)


@pytest.mark.parametrize("look", [doctor.look_at_bubblewrap, doctor.look_at_browser])
def test_what_is_not_installed_says_what_is_lost(monkeypatch, look):
    monkeypatch.setattr(shutil, "which", lambda _name: None)
    finding = look()
    assert not finding.works
    assert not finding.needed
    assert str(finding).startswith("missing")


@pytest.mark.parametrize("failure", ["no permission", None])
def test_bubblewrap_is_tried_not_believed(monkeypatch, failure):
    monkeypatch.setattr(shutil, "which", lambda name: f"/bin/{name}")
    monkeypatch.setattr(doctor, "_failure_of", lambda _command: failure)
    monkeypatch.setattr("sys.platform", "linux")
    finding = doctor.look_at_bubblewrap()
    assert finding.works is (failure is None)
    assert "does not run (no permission)" in finding.text or finding.works


def test_a_broken_need_is_an_exit_code(simkit, monkeypatch):
    broken = Finding(what="nodes", works=False, text="no forks today", needed=True)
    monkeypatch.setattr(doctor, "LOOKS", (lambda: broken,))
    code, out, _ = simkit("doctor")
    assert code == 1
    assert "FAILS    nodes            no forks today" in out
