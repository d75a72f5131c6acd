"""Serves a live view on 127.0.0.1: one page, and a web socket that sends what has moved.

It lives in a thread of its own, which is given states and never looks at the simulation: a viewer
that is slow or gone cannot hold the simulation up. Imported only when a live view is asked for.
"""

from __future__ import annotations

import asyncio
import contextlib
import secrets
import threading
from typing import Any, Final, Protocol

from tornado.httpserver import HTTPServer
from tornado.netutil import bind_sockets
from tornado.web import Application, HTTPError, RequestHandler
from tornado.websocket import WebSocketClosedError, WebSocketHandler

from simkit.errors import SimkitError

PAUSE: Final = 1 / 30
"""At most so often something is sent to a viewer [s of wall-clock time]."""
MOST_VIEWERS: Final = 20
"""So many pages may look at the same time."""
ENDED: Final = 4000
"""Code with which a web socket is closed when the simulation is over: no use to come back."""
FULL: Final = 4001
"""Code for a viewer too many."""
_OWN_NAMES: Final = ("127.0.0.1", "localhost")
_FAREWELL = 0.2
"So long a viewer may take to get the end of it [s of wall-clock time]."


class LiveState(Protocol):
    """What there is to see at one moment."""

    def changes(self, known: Any) -> str | None:
        """What a viewer does not know yet, as JSON; None if it knows everything.

        Args:
            known: The state that the viewer got last; None if none.
        """


class LiveServer:
    """One page for many viewers, which is there until `close`.

    Args:
        state: What they see at first.

    Attributes:
        page: The HTML that they are given.
        port: Port on the loopback interface.

    Raises:
        SimkitError: There is no port for it.
    """

    def __init__(self, state: LiveState) -> None:
        self.page = ""
        self._state = state
        self._token = secrets.token_urlsafe(16)
        self._viewers: set[_Viewer] = set()
        try:
            self._sockets = bind_sockets(0, "127.0.0.1")
        except OSError as error:
            raise SimkitError(f"a live view needs a port on 127.0.0.1: {error}") from error
        self.port: int = self._sockets[0].getsockname()[1]
        self._is_over = False
        self._loop = asyncio.new_event_loop()
        self._changed = asyncio.Event()
        self._thread = threading.Thread(target=self._run, name="simkit-rviz", daemon=True)
        self._thread.start()

    @property
    def url(self) -> str:
        """Address of the page, with a secret in it that keeps others away."""
        return f"http://127.0.0.1:{self.port}/{self._token}/"

    @property
    def socket_url(self) -> str:
        """Address of the web socket."""
        return f"ws://127.0.0.1:{self.port}/{self._token}/socket"

    @property
    def alive(self) -> bool:
        """Whether it serves."""
        return not self._is_over

    @property
    def viewer_count(self) -> int:
        """How many pages look."""
        return len(self._viewers)

    def update(self, state: LiveState) -> None:
        """There is something new to see; returns at once."""
        self._state = state
        self._wake()

    def close(self) -> None:
        """Take leave of the viewers, and end; harmless when it has ended."""
        self._is_over = True
        self._wake()
        if threading.current_thread() is not self._thread:
            self._thread.join(timeout=2.0)

    def is_secret(self, token: str) -> bool:
        """Whether somebody knows the secret."""
        return secrets.compare_digest(token.encode(), self._token.encode())

    def welcome(self, viewer: _Viewer) -> bool:
        """Take a viewer in; False if there are too many."""
        if len(self._viewers) >= MOST_VIEWERS:
            return False
        self._viewers.add(viewer)
        self._changed.set()
        return True

    def forget(self, viewer: _Viewer) -> None:
        """A viewer is gone."""
        self._viewers.discard(viewer)

    def _wake(self) -> None:
        if not self._changed.is_set():
            with contextlib.suppress(RuntimeError):  # the loop has ended
                self._loop.call_soon_threadsafe(self._changed.set)

    def _run(self) -> None:
        try:
            self._loop.run_until_complete(self._serve())
        finally:
            self._is_over = True
            self._loop.close()

    async def _serve(self) -> None:
        options: dict[str, Any] = {"server": self}
        rules: list[Any] = [(r"/([^/]+)/", _Page, options), (r"/([^/]+)/socket", _Viewer, options)]
        # Who asks for what is nobody's business, and a line on the screen would puzzle.
        application = Application(
            rules, log_function=lambda _: None, websocket_max_message_size=1024
        )
        http = HTTPServer(application)
        http.add_sockets(self._sockets)
        while not self._is_over:
            await self._changed.wait()
            self._changed.clear()
            sent = [viewer.send(self._state) for viewer in list(self._viewers)]
            if not all(sent):
                self._changed.set()  # one was still busy with the last message
            await asyncio.sleep(PAUSE)
        http.stop()
        for viewer in list(self._viewers):
            viewer.close(ENDED, "the simulation is over")
        if self._viewers:
            await asyncio.sleep(_FAREWELL)
        await http.close_all_connections()


class _Guarded(RequestHandler):
    """Answers only those who know the secret, and who call this computer by its own name.

    A page from elsewhere whose name was made to lead here ("DNS rebinding") calls it by another.
    """

    def initialize(self, server: LiveServer) -> None:
        self._server = server

    def prepare(self) -> None:
        is_own = self.request.host_name in _OWN_NAMES
        if not is_own or not self._server.is_secret(self.path_args[0]):
            raise HTTPError(404)


class _Page(_Guarded):
    def get(self, _token: str) -> None:
        self.set_header("Cache-Control", "no-store")
        self.set_header("Referrer-Policy", "no-referrer")
        self.finish(self._server.page)


class _Viewer(_Guarded, WebSocketHandler):
    def initialize(self, server: LiveServer) -> None:
        super().initialize(server)
        self._known: LiveState | None = None
        self._sending: asyncio.Task[None] | None = None

    def check_origin(self, origin: str) -> bool:
        # A view in a notebook is a frame of its own, whose origin is "null"; the secret decides.
        port = self._server.port
        return origin in ("null", f"http://127.0.0.1:{port}", f"http://localhost:{port}")

    def open(self, *_: str, **__: str) -> None:
        self.set_nodelay(True)
        if not self._server.welcome(self):
            self.close(FULL, f"{MOST_VIEWERS} pages look already")

    def on_message(self, _message: str | bytes) -> None:
        """A viewer has nothing to say."""

    def on_close(self) -> None:
        self._server.forget(self)

    def send(self, state: LiveState) -> bool:
        """Send what is new; False if the last message has not left yet."""
        if self._sending is not None and not self._sending.done():
            return False
        text = state.changes(self._known)
        if text is not None:
            self._known = state
            self._sending = asyncio.ensure_future(self._send(text))
        return True

    async def _send(self, text: str) -> None:
        with contextlib.suppress(WebSocketClosedError):
            await self.write_message(text)
