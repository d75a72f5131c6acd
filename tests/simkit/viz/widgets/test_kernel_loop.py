from __future__ import annotations

from types import SimpleNamespace

from simkit.viz.widgets import kernel_loop
from simkit.viz.widgets.kernel_loop import KernelLoop


class Loop:
    """An event loop that notes what it is given."""

    def __init__(self):
        self.calls = []

    def add_callback(self, work):
        self.calls.append(work)

    def call_later(self, seconds, work):
        self.calls.append((seconds, work))


def test_without_a_kernel_work_is_done_at_once_or_never():
    done = []
    KernelLoop().soon(lambda: done.append("soon"))
    KernelLoop().after(0.0, lambda: done.append("after"))
    assert done == ["soon"]


def test_in_a_kernel_all_waits_in_its_loop(monkeypatch):
    loop, done = Loop(), []
    shell = SimpleNamespace(kernel=SimpleNamespace(io_loop=loop))
    monkeypatch.setattr(kernel_loop, "running_notebook", lambda: shell)
    KernelLoop().soon(lambda: done.append("soon"))
    KernelLoop().after(0.5, lambda: done.append("after"))
    assert done == []
    soon, begin_to_wait = loop.calls
    soon()
    begin_to_wait()
    seconds, later = loop.calls[-1]
    assert (done, seconds) == (["soon"], 0.5)
    later()
    assert done == ["soon", "after"]
