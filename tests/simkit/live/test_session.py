"""How commands find a simulation that another terminal hosts, or is about to."""

import os
import threading
import time

import pytest

from simkit.live.session import Session, announced, coming_up, find_session, session_file

SESSION = Session(port=1, token="t", pid=os.getpid())
PATIENCE = 30.0


@pytest.fixture(autouse=True)
def own_folder(monkeypatch, tmp_path):
    monkeypatch.setenv("SIMKIT_SESSION", str(tmp_path / "session.json"))


def test_one_that_is_coming_up_is_waited_for():
    with coming_up():
        announcing = announced(SESSION)
        later = threading.Timer(0.2, announcing.__enter__)
        later.start()
        assert find_session(PATIENCE) == SESSION
        later.join()
        announcing.__exit__(None, None, None)
    assert find_session(PATIENCE) is None


def test_one_that_fails_to_come_up_is_waited_for_no_longer():
    starting = coming_up()
    starting.__enter__()
    threading.Timer(0.2, lambda: starting.__exit__(None, None, None)).start()
    assert find_session(PATIENCE) is None


def test_what_a_killed_terminal_has_left_is_no_reason_to_wait():
    with coming_up():
        old = time.time() - 2 * PATIENCE
        os.utime(session_file().with_suffix(".starting"), (old, old))
        assert find_session(PATIENCE) is None


def test_without_one_nobody_waits():
    assert find_session(PATIENCE) is None
