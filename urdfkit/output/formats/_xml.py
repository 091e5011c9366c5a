"""Texts and documents in XML reports."""

from xml.etree import ElementTree


def xml_text(text: str) -> str:
    """A text with ``?`` in place of characters that XML does not allow."""
    return "".join(
        char if char in "\t\n" or (char >= " " and not "\ud800" <= char <= "\udfff") else "?"
        for char in text
        if char not in "\ufffe\uffff"
    )


def document(root: ElementTree.Element) -> str:
    """An XML document, indented."""
    ElementTree.indent(root)
    text = ElementTree.tostring(root, encoding="unicode")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{text}\n'
