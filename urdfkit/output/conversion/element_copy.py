"""Copies elements of a robot to `xml.etree`, where they can be changed and written."""

from xml.etree.ElementTree import Element as Tag
from xml.etree.ElementTree import SubElement

from urdfkit.text.document import Element


def copied(element: Element) -> Tag:
    root = Tag("")
    stack = [(element, root)]
    while stack:
        element, parent = stack.pop()
        attributes = {name: at.value for name, at in element.attributes.items()}
        tag = SubElement(parent, element.tag, attributes)
        tag.text = element.text.strip() or None
        stack += [(child, tag) for child in reversed(element.children)]
    return root[0]
