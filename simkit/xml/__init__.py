"""XML that knows where it stands: every element and attribute with line and column, every fault, not only the first.

Reading never raises and takes time in proportion to the text. It knows the five entities of XML
and no others, and reaches for nothing outside of the text.
"""

from simkit.xml.document import Attribute, Document, Element, Fault, FaultKind, Span
from simkit.xml.parser import parse_xml

__all__ = ["Attribute", "Document", "Element", "Fault", "FaultKind", "Span", "parse_xml"]
