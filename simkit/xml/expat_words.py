"""What Python's own XML parser, expat, says of a text that it refuses: ROS programs in Python print its words."""

from __future__ import annotations

from simkit.xml.document import Document, FaultKind

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
