"""Reads XML: a strict parser that says where everything stands, and goes on behind a fault to find the next ones.

It is written for files that people write by hand. What is a fault is what XML 1.0 says; what a fault is called, where it is
reported and how it is got over follows from what learners do. It never raises, and takes time in proportion to the text.

Source:
    XML 1.0, fifth edition. Two things are refused on purpose: definitions in a document type (with them a small file can ask
    for gigabytes), and elements nested beyond `tree.MAX_DEPTH`.
"""

from __future__ import annotations

import functools
from dataclasses import replace

from simkit.xml.decoding import Decoded, decode
from simkit.xml.document import Document, FaultKind
from simkit.xml.scanner import tokens_of
from simkit.xml.source import Source
from simkit.xml.tree import build_tree

MOST_KEPT = 32
"""So many texts are remembered: whoever asks for one of them again gets the same elements."""
LONGEST_KEPT = 500_000
"""Longer texts are not remembered."""


def parse_xml(text: str | bytes, *, file: str) -> Document:
    """Read an XML text; never raises.

    A text is read once in a process, however often it is asked for: nobody may change its elements.

    Args:
        text: The text, or a file's bytes: in UTF-8, UTF-16, or what the XML declaration says. In a text that
            declaration's encoding has no meaning.
        file: Name to show for it.
    """
    if isinstance(text, str):
        decoded = Decoded(text=text.removeprefix("\ufeff"))
    else:
        decoded = decode(text)
    read = _read if len(decoded.text) > LONGEST_KEPT else _read_once
    return replace(read(decoded), file=file)


@functools.lru_cache(maxsize=MOST_KEPT)
def _read_once(decoded: Decoded) -> Document:
    return _read(decoded)


def _read(decoded: Decoded) -> Document:
    """The document of a text, without the name of its file."""
    source = Source(_with_newlines(decoded.text))
    if decoded.what:
        at = len(_with_newlines(decoded.text[: decoded.at]))
        source.fault(FaultKind.ENCODING, at, at + 1, what=decoded.what, remedy=decoded.remedy)
    tree = build_tree(source, tokens_of(source))
    return Document(
        file="",
        text=source.text,
        lines=source.lines,
        roots=tree.roots,
        root_end=tree.root_end,
        faults=tuple(sorted(source.faults, key=lambda fault: fault.span)),
        has_wide_letters=decoded.has_wide_letters,
    )


def _with_newlines(text: str) -> str:
    return text.replace("\r\n", "\n").replace("\r", "\n")
