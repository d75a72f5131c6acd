"""A real JupyterLab in a real browser: what a student sees and touches.

The browser is told what to do over its own debugging protocol, so nothing has to be installed for
it. Screenshots are kept in `SIMKIT_SCREENSHOTS`, if that names a folder.
"""

from __future__ import annotations

import asyncio
import base64
import json
import os
import shutil
import subprocess
import sys
import time
import urllib.request
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import nbformat
import pytest
from tornado.httpclient import HTTPRequest
from tornado.websocket import websocket_connect

BROWSER = next(
    filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None
)
OPTIONS = (
    *("--headless", "--no-sandbox", "--disable-gpu", "--disable-background-networking"),
    *("--disable-component-update", "--no-first-run", "--window-size=1200,1000"),
    *("--remote-debugging-port=0", "about:blank"),
)
PATIENCE = 60.0  # [s]


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        if Path(__file__).parent in item.path.parents:
            item.add_marker(pytest.mark.slow)
            item.add_marker(
                pytest.mark.skipif(BROWSER is None, reason="no chromium on this machine")
            )


class Page:
    """A tab of the browser."""

    def __init__(self, address: str) -> None:
        self._loop = asyncio.new_event_loop()
        self._number = 0
        self._socket: Any = self._do(self._connect(address))
        self.call("Page.enable")

    async def _connect(self, address: str) -> Any:
        return await websocket_connect(HTTPRequest(address), max_message_size=1 << 28)

    def _do(self, work: Any) -> Any:
        return self._loop.run_until_complete(asyncio.wait_for(work, PATIENCE))

    def call(self, method: str, **parameters: Any) -> Any:
        """Call a method of the protocol."""
        answer = self._do(self._ask(method, parameters))
        assert "error" not in answer, answer
        return answer["result"]

    async def _ask(self, method: str, parameters: dict[str, Any]) -> Any:
        self._number += 1
        request = {"id": self._number, "method": method, "params": parameters}
        await self._socket.write_message(json.dumps(request))
        while True:
            answer = json.loads(await self._socket.read_message())
            if answer.get("id") == self._number:
                return answer

    def open(self, url: str) -> None:
        self.call("Page.navigate", url=url)

    def run(self, script: str) -> Any:
        """The value of an expression in the page; a promise is waited for."""
        result = self.call(
            "Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True
        )
        assert "exceptionDetails" not in result, result
        return result["result"].get("value")

    def wait(self, script: str) -> Any:
        """The value of an expression in the page, as soon as it is true."""
        end = time.monotonic() + PATIENCE
        while not (value := self.run(script)):
            if time.monotonic() > end:
                self.screenshot("never_true")
                pytest.fail(f"never true: {script}")
            time.sleep(0.1)
        return value

    def click(self, element: str) -> None:
        """Click with the mouse on what an expression gives."""
        x, y = self._middle(element)
        self._mouse("mousePressed", x, y)
        self._mouse("mouseReleased", x, y)

    def drag(self, selector: str, number: int, right_px: float) -> None:
        """Press the mouse on an element, pull it to the right, and let go."""
        x, y = self._middle(f"document.querySelectorAll({json.dumps(selector)})[{number}]")
        self._mouse("mousePressed", x, y)
        steps = 20
        for step in range(1, steps + 1):
            self._mouse("mouseMoved", x + right_px * step / steps, y)
        self._mouse("mouseReleased", x + right_px, y)

    def _middle(self, element: str) -> tuple[float, float]:
        """The middle of what an expression gives, when it has come to rest: what is above it may still load."""
        middle = (
            f"(() => {{ const one = {element}; one.scrollIntoView({{block: 'center'}});"
            "const box = one.getBoundingClientRect(); return [box.x + box.width / 2, box.y + box.height / 2]; })()"
        )
        before, now = None, self.run(middle)
        while now != before:
            time.sleep(0.5)
            before, now = now, self.run(middle)
        x, y = now
        return x, y

    def _mouse(self, kind: str, x: float, y: float) -> None:
        self.call(
            "Input.dispatchMouseEvent",
            type=kind,
            x=x,
            y=y,
            button="left",
            buttons=0 if kind == "mouseReleased" else 1,
            clickCount=1,
        )

    def screenshot(self, name: str) -> bytes:
        picture = base64.b64decode(self.call("Page.captureScreenshot")["data"])
        folder = os.environ.get("SIMKIT_SCREENSHOTS")
        if folder:
            Path(folder, f"{name}.png").write_bytes(picture)
        return picture

    def close(self) -> None:
        self._socket.close()
        self._loop.run_until_complete(asyncio.sleep(0.05))
        self._loop.close()


class Lab:
    """A JupyterLab with a folder, and a page that shows one of its notebooks."""

    def __init__(self, page: Page, url: str, folder: Path) -> None:
        self.page = page
        self._url = url
        self._folder = folder

    @property
    def folder(self) -> Path:
        """Where the notebook is saved."""
        return self._folder

    def write(self, path: str, text: str) -> None:
        """Put a file beside the notebook."""
        file = self._folder / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8", newline="\n")

    def open(self, *cells: str) -> None:
        """Show a notebook with these cells, none of them run."""
        notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(c) for c in cells])
        notebook.metadata["kernelspec"] = {"name": "python3", "display_name": "Python 3"}
        nbformat.write(notebook, self._folder / "lab.ipynb")
        self.page.open(f"{self._url}lab/tree/lab.ipynb?token=t&reset")
        self.page.wait("!!window.jupyterapp && !!document.querySelector('.jp-Notebook .jp-Cell')")
        self.page.run(
            "window.panel = [...jupyterapp.shell.widgets('main')].find((one) => one.sessionContext);"
            "jupyterapp.shell.activateById(panel.id); true"
        )
        self.page.wait("panel.sessionContext.session?.kernel?.status === 'idle'")

    def start_cell(self, number: int) -> None:
        """Run one cell, and wait for nothing."""
        self.page.run(
            f"panel.content.activeCellIndex = {number};"
            "window.running = jupyterapp.commands.execute('notebook:run-cell'); true"
        )

    def run_cell(self, number: int) -> None:
        """Run one cell, and wait for its end."""
        self.start_cell(number)
        self.page.run("running.then(() => true)")

    def output(self, number: int) -> str:
        """Text below a cell."""
        text: str = self.page.run(
            f"panel.content.widgets[{number}].node.querySelector('.jp-Cell-outputArea').innerText"
        )
        return text


@pytest.fixture
def page(tmp_path: Path) -> Iterator[Page]:
    profile = tmp_path / "profile"
    process = subprocess.Popen(
        [str(BROWSER), f"--user-data-dir={profile}", *OPTIONS], stderr=subprocess.DEVNULL
    )
    try:
        port = _wait_for(profile / "DevToolsActivePort").splitlines()[0]
        with urllib.request.urlopen(f"http://127.0.0.1:{port}/json/list") as answer:
            (tab,) = [one for one in json.load(answer) if one["type"] == "page"]
        page = Page(tab["webSocketDebuggerUrl"])
        yield page
        page.close()
    finally:
        process.terminate()
        process.wait()


@pytest.fixture
def lab(tmp_path: Path, page: Page) -> Iterator[Lab]:
    folder = tmp_path / "work"
    folder.mkdir()
    private = {
        f"JUPYTER_{kind}_DIR": str(tmp_path / kind.lower())
        for kind in ("CONFIG", "DATA", "RUNTIME")
    }
    process = subprocess.Popen(
        [
            *(sys.executable, "-m", "jupyterlab", "--no-browser", "--allow-root"),
            *("--port=0", "--ServerApp.token=t", "--expose-app-in-browser"),
        ],
        cwd=folder,
        env={**os.environ, **private, "IPYTHONDIR": str(tmp_path / "ipython")},
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    try:
        server = json.loads(_wait_for(tmp_path / "runtime", f"jpserver-{process.pid}.json"))
        yield Lab(page, server["url"], folder)
    finally:
        process.terminate()
        process.wait()


def _wait_for(path: Path, name: str = "") -> str:
    """The text of a file that is about to be written."""
    path, end = path / name if name else path, time.monotonic() + PATIENCE
    while not (path.is_file() and path.read_text()):
        assert time.monotonic() < end, f"{path.name} was not written"
        time.sleep(0.05)
    return path.read_text()
