from __future__ import annotations

import asyncio
import json
import socket
import threading
import time
import urllib.error
import urllib.request

import pytest
from tornado.httpclient import HTTPClientError, HTTPRequest
from tornado.websocket import websocket_connect

from simkit.viz.page import live_server
from simkit.viz.page.live_server import ENDED, FULL, LiveServer
from simkit.viz.page.scene_data import SceneState

WAIT = 10.0


def state(x=0.0, number=0):
    return SceneState(number=number, scene='{"frames":[]}', poses=((x, 0.0, 0.0),))


@pytest.fixture
def server():
    server = LiveServer(state())
    server.page = "<p>the page</p>"
    yield server
    server.close()


def listen(server, *, until, changes=lambda: None):
    """Messages that a viewer hears until one fits; `changes` happens after the first."""

    async def run():
        viewer = await websocket_connect(server.socket_url)
        heard = []
        while not heard or not until(heard[-1]):
            text = await asyncio.wait_for(viewer.read_message(), WAIT)
            heard.append(json.loads(text))
            if len(heard) == 1:
                changes()
        await leave(viewer)
        return heard

    return asyncio.run(run())


async def leave(viewer):
    """Close a web socket, and wait until it is closed: what is left open is a warning later."""
    viewer.close()
    while await asyncio.wait_for(viewer.read_message(), WAIT) is not None:
        pass


def eventually(holds):
    end = time.monotonic() + WAIT
    while not holds() and time.monotonic() < end:
        time.sleep(0.01)
    return holds()


def test_it_listens_on_this_computer_only(server):
    with socket.socket() as other:
        other.settimeout(1.0)
        # Another address of the loopback interface: open only if it listened on all of them.
        assert other.connect_ex(("127.0.0.2", server.port)) != 0
    assert server.url.startswith(f"http://127.0.0.1:{server.port}/")


def test_the_page_is_for_those_who_know_the_secret(server):
    with urllib.request.urlopen(server.url, timeout=WAIT) as answer:
        assert answer.read() == b"<p>the page</p>"
    for path in ("/", "/wrong/", "/favicon.ico"):
        with pytest.raises(urllib.error.HTTPError, match="404") as refused:
            urllib.request.urlopen(f"http://127.0.0.1:{server.port}{path}", timeout=WAIT)
        refused.value.close()


def test_a_name_that_was_made_to_lead_here_is_not_answered(server):
    def ask(host):
        headers = {"Host": f"{host}:{server.port}"}
        asked = urllib.request.Request(server.url, headers=headers)
        with urllib.request.urlopen(asked, timeout=WAIT) as answer:
            return answer.status

    assert ask("LOCALHOST") == ask("127.0.0.1") == 200
    with pytest.raises(urllib.error.HTTPError, match="404") as refused:
        ask("evil.example")
    refused.value.close()


@pytest.mark.parametrize(
    ("change", "status"),
    [("token", 404), ("origin", 403), ("host", 404)],
    ids=["no secret", "a foreign page", "a name from elsewhere"],
)
def test_the_socket_is_for_them_too(server, change, status):
    url, headers = server.socket_url, {}
    if change == "token":
        url = f"ws://127.0.0.1:{server.port}/wrong/socket"
    elif change == "origin":
        headers["Origin"] = "http://evil.example"
    else:
        headers["Host"] = f"evil.example:{server.port}"
    with pytest.raises(HTTPClientError) as refused:
        asyncio.run(_connect(HTTPRequest(url, headers=headers)))
    assert refused.value.code == status


async def _connect(request):
    await asyncio.wait_for(websocket_connect(request), WAIT)


def test_a_viewer_hears_everything_and_then_what_moves(server):
    heard = listen(
        server,
        until=lambda found: found["changes"]["poses"]["0"][0] == 3.0,
        changes=lambda: server.update(state(3.0)),
    )
    assert heard[0] == {"scene": {"frames": []}, "changes": {"poses": {"0": [0, 0, 0]}}}
    assert heard[-1] == {"changes": {"poses": {"0": [3, 0, 0]}}}


def test_of_many_changes_a_viewer_hears_some_and_the_last(server):
    def changes():
        for step in range(1, 2001):
            server.update(state(float(step)))

    heard = listen(
        server, until=lambda found: found["changes"]["poses"]["0"][0] == 2000.0, changes=changes
    )
    assert len(heard) < 200


def test_one_that_comes_back_hears_everything_again(server):
    for _ in range(2):
        (first, *_) = listen(server, until=lambda _: True)
        assert "scene" in first


def test_a_viewer_that_reads_nothing_holds_nobody_up(server):
    request = (
        f"GET {server.socket_url.partition(str(server.port))[2]} HTTP/1.1\r\nHost: 127.0.0.1\r\n"
        "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
        "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n"
    )
    big = '{"frames":[' + ",".join(["0"] * 2_000_000) + "]}"
    with socket.create_connection(("127.0.0.1", server.port)) as stale:
        stale.sendall(request.encode())
        assert eventually(lambda: server.viewer_count == 1)
        for number in range(50):
            server.update(SceneState(number=number, scene=big, poses=()))
        server.update(state(7.0, number=60))
        heard = listen(server, until=lambda _: True)
        assert heard[0]["changes"]["poses"] == {"0": [7, 0, 0]}
    assert eventually(lambda: server.viewer_count == 0)


def test_there_is_an_end_to_hospitality(server, monkeypatch):
    monkeypatch.setattr(live_server, "MOST_VIEWERS", 2)

    async def crowd():
        viewers = [await websocket_connect(server.socket_url) for _ in range(3)]
        while await asyncio.wait_for(viewers[2].read_message(), WAIT) is not None:
            pass
        code = viewers[2].close_code
        viewers.pop().close()
        for viewer in viewers:
            await leave(viewer)
        return code

    assert asyncio.run(crowd()) == FULL


def test_at_the_end_viewers_are_told_and_the_port_is_free(server):
    async def stay():
        viewer = await websocket_connect(server.socket_url)
        await asyncio.wait_for(viewer.read_message(), WAIT)
        threading.Thread(target=server.close).start()
        while await asyncio.wait_for(viewer.read_message(), WAIT) is not None:
            pass
        viewer.close()
        return viewer.close_code, viewer.close_reason

    assert asyncio.run(stay()) == (ENDED, "the simulation is over")
    assert eventually(lambda: not server.alive)
    server.close()
    server.update(state(1.0))
    with socket.socket() as late:
        assert eventually(lambda: late.connect_ex(("127.0.0.1", server.port)) != 0)
    assert not [t for t in threading.enumerate() if t.name == "simkit-rviz" and t.is_alive()]
