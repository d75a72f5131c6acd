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

from simkit.xml.document import Document, FaultKind
from simkit.xml.scanner import tokens_of
from simkit.xml.source import Decoded, Source, decode
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


_DANGEROUS = (FaultKind.ENTITY, FaultKind.TOO_DEEP)
"""What expat must not even see."""


def words_of_expat(document: Document) -> str | None:
    """Why expat refuses a text; None if it takes it, or if it was not asked.

    It is asked only where our own parser has found a fault, and where names are special: prefixes of namespaces must be
    declared, which XML itself does not ask for, and beyond ASCII expat knows only the letters of XML's fourth edition.
    """
    if any(fault.kind in _DANGEROUS for fault in document.faults):
        return None
    if not document.faults and not _has_special_names(document):
        return None
    from xml.parsers import expat

    parser = expat.ParserCreate("utf-8", namespace_separator=" ")
    parser.namespace_prefixes = True
    try:
        parser.Parse(document.text.encode("utf-8", "surrogatepass"), True)
    except expat.ExpatError as error:
        return str(error)
    return None


def _has_special_names(document: Document) -> bool:
    """Whether a name is not ASCII, or has a prefix other than `xml` and `xmlns`, which are always known."""
    elements = document.root.walk() if document.root is not None else ()
    return any(
        not name.isascii() or (":" in name and not name.startswith(("xmlns:", "xml:")))
        for element in elements
        for name in (element.name, *(one.name for one in element.attributes))
    )
