"""The graph's end of the line: frames, output, patience."""

import os
import socket
import time

import pytest
from hypothesis import given
from hypothesis import strategies as st

from simkit.graph.process.link import (
    STARVING,
    Ended,
    Flooded,
    NodeLink,
    Printout,
    Stuck,
    most_telling_stack,
)
from simkit.graph.process.process_tree import Usage
from simkit.graph.process.protocol import Op, Outbox, ProtocolError
from simkit.graph.process.starters import StartedProcess


class Wire:
    """A link and the other ends of its lines."""

    def __init__(self, allowance=2.0, output_bytes=1000):
        connection, self.node = socket.socketpair()
        output, self.printer = os.pipe()
        trace, self.tracer = os.pipe()
        self.asked = 0
        self.used = lambda: None
        process = StartedProcess(connection, output, trace, 1, self)
        self.link = NodeLink(process, allowance, output_bytes)
        self.link.begin_turn()

    def signal(self, _pid, _number):
        """What a starter does for `ask_stack`."""
        self.asked += 1
        os.write(self.tracer, STACK.encode())

    def usage(self, _pid):
        """What a starter does for `usage`."""
        return self.used()

    def close(self):
        self.link.close()
        self.node.close()
        os.close(self.printer)
        os.close(self.tracer)


@pytest.fixture
def make_wire():
    wires = []

    def make(**options):
        wires.append(Wire(**options))
        return wires[-1]

    yield make
    for wire in wires:
        wire.close()


@pytest.fixture
def wire(make_wire):
    return make_wire()


def _frame(*bodies):
    outbox = Outbox()
    for body in bodies:
        outbox.add(Op.LOG, body)
    return outbox.take()


def test_frames_come_one_by_one_however_they_arrive(wire):
    first, second = _frame(b"one"), _frame(b"two", b"three")
    wire.node.sendall(first + second[:3])
    assert wire.link.receive() == first[4:]
    wire.node.sendall(second[3:])
    assert wire.link.receive() == second[4:]


def test_what_is_sent_arrives_whole(wire):
    frame = _frame(b"x" * 1000)
    wire.link.send(frame)
    assert wire.node.recv(2000) == frame


def test_what_was_printed_before_a_frame_is_there_with_it(wire):
    os.write(wire.printer, b"hello ")
    os.write(wire.printer, b"world")
    wire.node.sendall(_frame(b""))
    wire.link.receive()
    assert bytes(wire.link.output) == b"hello world"


def test_a_long_output_is_collected_whole_and_too_long_a_one_is_cut(make_wire):
    wire = make_wire(output_bytes=50_000)
    os.write(wire.printer, b"x" * 50_000)
    wire.link.drain()
    assert len(wire.link.output) == 50_000
    os.write(wire.printer, b"y")
    with pytest.raises(Flooded):
        wire.link.drain()
    assert len(wire.link.output) == 50_000
    wire.link.drain()  # and nothing more is read


def test_a_node_that_closes_its_output_can_still_speak(wire):
    os.close(wire.printer)
    wire.printer = os.dup(wire.tracer)
    wire.node.sendall(_frame(b"x"))
    assert wire.link.receive()


def test_silence_is_a_stuck_node_after_its_allowance(make_wire):
    wire = make_wire(allowance=0.1)
    start = time.monotonic()
    with pytest.raises(Stuck):
        wire.link.receive()
    assert time.monotonic() - start >= 0.1


def test_a_node_that_the_machine_kept_from_computing_gets_more_time(make_wire):
    wire = make_wire(allowance=0.1)
    looks = []

    def used():
        looks.append(time.monotonic())
        if len(looks) == 2:
            wire.node.sendall(_frame(b"at last"))
        return Usage(cpu_s=0.01, is_computing=True)

    wire.used = used
    assert wire.link.receive() == _frame(b"at last")[4:]


def test_it_does_not_get_time_for_ever(make_wire):
    wire = make_wire(allowance=0.1)
    wire.used = lambda: Usage(cpu_s=0.0, is_computing=True)
    start = time.monotonic()
    with pytest.raises(Stuck):
        wire.link.receive()
    assert time.monotonic() - start >= STARVING * 0.1


@pytest.mark.parametrize(
    "usage", [Usage(cpu_s=0.1, is_computing=True), Usage(cpu_s=0.0, is_computing=False), None]
)
def test_one_that_has_computed_enough_or_does_not_compute_is_stuck(make_wire, usage):
    wire = make_wire(allowance=0.1)
    looks = []

    def used():
        looks.append(usage)
        return usage

    wire.used = used
    with pytest.raises(Stuck):
        wire.link.receive()
    assert looks == [usage]


def test_the_allowance_is_for_the_turn_not_for_each_frame(make_wire):
    wire = make_wire(allowance=0.2)

    def talk_on():
        for _ in range(100):
            wire.node.sendall(_frame(b"still here"))
            wire.link.receive()
            time.sleep(0.01)

    with pytest.raises(Stuck):
        talk_on()
    wire.link.begin_turn()
    wire.node.sendall(_frame(b"x"))
    assert wire.link.receive()


def test_a_node_that_does_not_read_is_stuck(make_wire):
    wire = make_wire(allowance=0.1)
    with pytest.raises(Stuck):
        wire.link.send(bytes(20_000_000))


def test_the_end_of_the_line_is_an_end(wire):
    wire.node.close()
    with pytest.raises(Ended):
        wire.link.receive()
    with pytest.raises(Ended):
        wire.link.send(bytes(10_000_000))


def test_a_frame_that_is_none_is_refused(wire):
    wire.node.sendall(b"\xff" * 8)
    with pytest.raises(ProtocolError):
        wire.link.receive()


STACK = """\
Thread 0x0000000000000001 (most recent call first):
  File "/usr/lib/python3/threading.py", line 10 in wait

Current thread 0x0000000000000002 (most recent call first):
  File "play/scripts/stuck.py", line 5 in loop
  File "play/scripts/stuck.py", line 8 in <module>
"""


def test_a_stuck_process_is_asked_where_it_is(wire):
    assert wire.link.stack() == [
        ("play/scripts/stuck.py", 5, "loop"),
        ("play/scripts/stuck.py", 8, "<module>"),
    ]
    assert wire.asked == 1


def test_without_a_current_thread_the_first_one_tells():
    text = STACK.replace("Current thread", "Thread")
    assert most_telling_stack(text)[0][0] == "/usr/lib/python3/threading.py"
    assert most_telling_stack("") == []


@given(st.text(max_size=80) | st.just('Thread 0x1\n  File "x", line ' + "9" * 5000 + " in f"))
def test_any_text_for_a_stack_is_borne(text):
    for file, line, function in most_telling_stack("Current thread 0x1\n" + text):
        assert isinstance(file + function, str)
        assert line >= 0


# -- what a script prints, and how much of it was shown


@given(st.text(), st.integers(1, 5))
def test_what_comes_in_any_pieces_is_shown_once_and_whole(text, size):
    shown = []
    printout = Printout(shown.append)
    data = text.encode()
    for start in range(0, len(data), size):
        printout.data += data[start : start + size]
        printout.show_new_text()
        printout.show_new_text()
    assert "".join(shown) == text == printout.text
    assert all(shown)


def test_what_is_no_text_is_shown_nevertheless():
    shown = []
    printout = Printout(shown.append)
    printout.data += b"a\xffb"
    printout.show_new_text()
    assert shown == ["a\ufffdb"]
    assert printout.text == "a\ufffdb"
