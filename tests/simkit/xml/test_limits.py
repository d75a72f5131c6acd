"""Large and deep texts: time in proportion to the size, no recursion, a bounded number of faults."""

from __future__ import annotations

import resource
import time
from collections.abc import Callable

import pytest

from simkit.xml import FaultKind, parse_xml
from simkit.xml.source import MAX_FAULTS
from simkit.xml.tree import MAX_DEPTH

SMALL, LARGE = 10_000, 160_000
LINE = '<link name="base"><visual><origin xyz="0 0 0" rpy="0 0 0"/></visual></link>\n'

# pieces that a careless parser reads again and again
ANNOYING = {
    "tags": lambda size: "<r>" + LINE * (size // len(LINE)) + "</r>",
    "one line": lambda size: "<r>" + '<b c="1"/>' * (size // 10) + "</r>",
    "attributes": lambda size: "<a " + " ".join(f'b{n}="1"' for n in range(size // 11)) + "/>",
    "attributes of one name": lambda size: "<a " + 'b="1" ' * (size // 6) + "/>",
    "comments in comments": lambda size: "<a>" + "<!--\n" * (size // 5) + "-->",
    "comments without line": lambda size: "<a>" + "<!--" * (size // 4),
    "brackets": lambda size: "<" * size,
    "names": lambda size: "<a" * (size // 2),
    "quotation marks": lambda size: '<a b="\n' * (size // 7),
    "a value of spaces": lambda size: '<a b="' + " " * size,
    "a value of letters": lambda size: '<a b="' + " c" * (size // 2),
    "spaces in a tag": lambda size: "<a" + " " * size,
    "spaces behind <": lambda size: "<a>< " + " " * size + "</a>",
    "entities": lambda size: "<a>" + "&" * size,
    "a long number": lambda size: "<a>&#" + "1" * size + ";</a>",
    "end tags": lambda size: "<a>" + "</b>" * (size // 4),
    "wrong end tags": lambda size: "<r>" + "<a></b>" * (size // 7) + "</r>",
    "unclosed elements": lambda size: "<r>" + "<a><c></a>" * (size // 10) + "</r>",
    "roots": lambda size: "<a/>" * (size // 4),
    "early ends of the root": lambda size: "<a>" + "<b/></a>" * (size // 8),
    "declarations": lambda size: '<?xml version="1.0"?>' * (size // 21),
    "instructions": lambda size: "<?" * (size // 2),
    "sections": lambda size: "<a>" + "<![CDATA[" * (size // 9),
    "definitions": lambda size: "<!DOCTYPE a [" + '<!ENTITY a "b">' * (size // 15),
    "comments in definitions": lambda size: "<!DOCTYPE a [" + "<!--" * (size // 4),
    "control characters": lambda size: "\x00" * size,
    "newlines": lambda size: "\n" * size,
    "texts between": lambda size: "<a>" + "x<b/>" * (size // 5) + "</q>" * 50 + "</a>",
    "a text with a name": lambda size: "<r>" + "v a " * (size // 4) + "</v>" * 100 + "</r>",
    "deep": lambda size: "<a>" * (size // 3),
    "deep and closed": lambda size: "<a>" * (size // 7) + "</a>" * (size // 7),
}


def seconds(text: str) -> float:
    """Time of the processor to read a text."""
    before = time.process_time()
    parse_xml(text, file="big.urdf")
    return time.process_time() - before


@pytest.mark.slow
@pytest.mark.parametrize("name", ANNOYING)
def test_time_is_in_proportion_to_the_size(name):
    make: Callable[[int], str] = ANNOYING[name]
    small = max(0.002, min(seconds(make(SMALL)) for _ in range(3)))
    large = min(seconds(make(LARGE)) for _ in range(2))
    assert large / small < 4 * LARGE / SMALL, f"{small:.3f} s, then {large:.3f} s"


def test_a_hundred_thousand_elements_in_each_other():
    depth = 100_000
    document = parse_xml("<a>" * depth + "</a>" * depth, file="deep.urdf")
    assert [(fault.kind, fault.span.column) for fault in document.faults] == [
        (FaultKind.TOO_DEEP, 3 * MAX_DEPTH + 2)
    ]
    assert document.root is not None
    kept = list(document.root.walk())
    assert len(kept) == MAX_DEPTH
    assert kept[-1].path == "/".join(["a"] * MAX_DEPTH)


def test_elements_that_are_just_not_too_deep():
    assert parse_xml("<a>" * MAX_DEPTH + "</a>" * MAX_DEPTH, file="deep.urdf").faults == ()


def test_faults_are_bounded():
    document = parse_xml("<r>" + "<a b=1/>\n" * 1000 + "</r>", file="many.urdf")
    assert len(document.faults) == MAX_FAULTS
    assert not document.is_well_formed


def test_entities_do_not_grow():
    names = "".join(f'<!ENTITY a{n + 1} "{f"&a{n};" * 10}">' for n in range(30))
    text = f'<!DOCTYPE r [<!ENTITY a0 "boom">{names}]><r name="&a30;">&a30;</r>'
    document = parse_xml(text, file="bomb.urdf")
    assert [fault.kind for fault in document.faults] == [FaultKind.ENTITY]
    assert document.root is not None
    assert (document.root.get("name"), document.root.text) == ("&a30;", "&a30;")


@pytest.mark.slow
def test_a_file_of_five_megabytes():
    text = ANNOYING["tags"](5_000_000)
    before = time.process_time()
    document = parse_xml(text.encode(), file="big.urdf")
    print(f"{time.process_time() - before:.1f} s for 5 MB", end=", ")
    print(f"{resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024:.0f} MB resident")
    assert document.is_well_formed
    assert document.root is not None
    assert sum(1 for _ in document.root.walk()) == 1 + 3 * text.count("<link")
