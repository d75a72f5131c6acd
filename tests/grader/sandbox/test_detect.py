import subprocess

import pytest

from grader.errors import SandboxError
from grader.sandbox import Sandbox, detect, find_sandbox


@pytest.fixture(autouse=True)
def forget():
    detect._strongest.cache_clear()
    yield
    detect._strongest.cache_clear()


def test_what_is_found_works_and_is_found_once(monkeypatch):
    first = find_sandbox()
    monkeypatch.setattr(subprocess, "run", None)
    assert find_sandbox() == first


def test_without_bubblewrap_it_is_a_plain_process_and_says_why(monkeypatch):
    monkeypatch.setattr(detect, "platform_has_sandbox", lambda: False)
    found = find_sandbox()
    assert found.name == "none"
    assert found.reason


def test_what_is_installed_may_be_forbidden(monkeypatch):
    def forbidden(command, **options):
        return subprocess.CompletedProcess(command, 1, b"", b"bwrap: No permissions\n")

    monkeypatch.setattr(detect, "platform_has_sandbox", lambda: True)
    monkeypatch.setattr(subprocess, "run", forbidden)
    found = find_sandbox()
    assert found.name == "none"
    assert not found.own_user
    assert "No permissions" in found.reason


def test_less_than_a_sandbox_is_refused_if_one_is_required(monkeypatch):
    monkeypatch.setattr(detect, "platform_has_sandbox", lambda: False)
    with pytest.raises(SandboxError, match="install bubblewrap"):
        find_sandbox(require=True)


def test_a_sandbox_goes_to_the_checker_and_back(tmp_path):
    for sandbox in (
        Sandbox(name="none"),
        Sandbox(name="bubblewrap", own_user=True, private=(tmp_path,)),
    ):
        assert Sandbox.from_json(sandbox.to_json()) == sandbox
