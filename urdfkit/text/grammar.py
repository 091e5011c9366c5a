"""Deviations of a document from URDF's grammar, found in one walk that the rules URD share.

Each deviation belongs to one rule, so nothing is reported twice: a misspelt required element is not
also missing, and an unknown shape is not also an unknown element.
"""

from __future__ import annotations

import re
from collections.abc import Collection
from math import inf, isfinite

from urdfkit.core.record import Record
from urdfkit.core.suggest import CLOSE_TYPO, TYPO, nearest
from urdfkit.text import schema
from urdfkit.text import urdf_extensions as extensions
from urdfkit.text.document import Attribute, Document, Element
from urdfkit.text.schema import AttributeRule, Grammar

#: Most unknown names of one document that are compared with known names.
MAX_UNKNOWN = 1000

#: Elements that the grammar does not require, but simulators do: they drop a link without inertia.
_EXPECTED = {"link": ("inertial",)}

#: Elements whose name must not be empty.
_ELEMENTS_WITH_NAME = ("link", "joint")

#: A tab or a line break between two numbers: only then are values compared as they were typed.
_BREAK = rb"[\t\r\n](?<=[\d.][\t\r\n])\s*[-+.\d]"


class Deviation(Record):
    """One deviation; which fields are set depends on the rule that reports it."""

    element: Element  # the element that is wrong or incomplete
    attribute: Attribute | None = None  # the wrong attribute
    name: str = ""  # the missing or expected name
    #: The intended name, or the required version of URDF; empty if unknown.
    suggested: str = ""


def deviations(
    document: Document, *, plain: bool, claimed: Collection[str] = ()
) -> dict[str, list[Deviation]]:
    """All deviations of a document, by the code of the rule that reports them.

    Args:
        document: after expansion.
        plain: True for a file that is not expanded, so that URDF parsers read the white space in a
            value as it was typed.
        claimed: tags that another rule reports.
    """
    root = document.root
    if root.tag != "robot":
        return {"URD015": [Deviation(root)]}
    walk = _Walk(root, claimed, plain and bool(re.search(_BREAK, document.sources[0].data)))
    walk.version_number()
    stack = [(root, schema.ROBOT)]
    while stack:
        element, grammar = stack.pop()
        walk.attributes(element, grammar)
        stack += reversed(walk.children(element, grammar))
    return walk.deviations


def calling_macro(element: Element) -> str:
    """Name of the macro that inserted the element, which was passed as a block; empty if none."""
    frame = element.parent.frame if element.parent else None
    return frame.name if frame and frame.kind == "macro" and element.frame is not frame else ""


def places_of(element: Element) -> list[str]:
    """Tags of the elements that may contain a misplaced element."""
    if places := schema.places_of(element.tag):
        return sorted(places)
    place = extensions.place_of(element)
    return [place] if place else []


def owner(element: Element) -> str:
    """The link, joint or material that contains an element, such as ``link 'arm'``.

    The root has no name here: robots that share a file have one finding in it.
    """
    if element.parent is None:
        return "the robot"
    while element.parent is not None and element.parent.parent is not None:
        element = element.parent
    name = element.get("name")
    return f"{element.tag} '{name}'" if name else f"<{element.tag}>"


def version_of(root: Element) -> str:
    """The version of URDF that a robot declares; 1.0 if it declares none."""
    text = root.get("version")
    if text is None:
        return schema.VERSIONS[0]
    numbers = re.fullmatch(r"0*(\d+)\.0*(\d+)", text, re.ASCII)  # urdfdom compares numbers
    return f"{numbers[1]}.{numbers[2]}" if numbers else text


def is_number(text: str) -> bool:
    """True if urdfdom reads a number: finite, and nothing after it."""
    try:
        value = float(text)
    except ValueError:
        return False
    # Python alone reads 1_000, digits of other scripts, and white space at the end.
    return -inf < value < inf and text.isascii() and "_" not in text and not text[-1].isspace()


def _is_plain_vector(text: str, length: int) -> bool:
    """True if a value certainly is ``length`` numbers; a fast test for the common case."""
    try:
        values = list(map(float, text.split()))
    except ValueError:
        return False
    return (
        len(values) == length
        and isfinite(sum(values))
        and text.isascii()
        and text.isprintable()
        and "_" not in text
        and (length > 1 or not text.endswith(" "))
    )


def has_break(text: str) -> bool:
    """True if a tab or a line break follows a number; urdfdom requires a space."""
    return re.search(r"\S[\t\r\n]", text) is not None


def is_expression(text: str) -> bool:
    """True if xacro should have replaced the value, which XAC003 reports."""
    return "${" in text or "$(" in text


def _is_only_unknown(shape: Element, grammar: Grammar) -> bool:
    """True for a shape with one unknown attribute."""
    unknown = [name for name in shape.attributes if name not in grammar.attributes]
    is_shape = shape.parent is not None and shape.parent.tag == "geometry"
    return is_shape and len(unknown) == 1 and is_number(shape.attributes[unknown[0]].value)


def _is_attribute(child: Element, element: Element, grammar: Grammar) -> bool:
    """True for the ``<size>`` of a ``<box>``: URD003 reports the missing attribute instead."""
    rule = grammar.attributes.get(child.tag)
    return rule is not None and rule.required and child.tag not in element.attributes


class _Walk:
    """Collects deviations element by element."""

    def __init__(self, root: Element, claimed: Collection[str], breaks: bool) -> None:
        self.deviations: dict[str, list[Deviation]] = {}
        self._root = root
        self._claimed = claimed
        self._breaks = breaks
        #: Values that were parsed successfully, by their length; most occur often.
        self._valid: dict[int, set[str]] = {length: set() for length in schema.LENGTHS.values()}
        declared = version_of(root)
        # An unknown version is one finding, not one for every feature.
        self._version = declared if declared in schema.VERSIONS else schema.VERSIONS[-1]
        self._unknown = 0

    def _add(
        self,
        code: str,
        element: Element,
        attribute: Attribute | None = None,
        name: str = "",
        suggested: str = "",
    ) -> None:
        deviation = Deviation(element, attribute, name, suggested)
        self.deviations.setdefault(code, []).append(deviation)

    def attributes(self, element: Element, grammar: Grammar) -> None:
        """Report missing, unknown and invalid attributes of an element."""
        present = element.attributes
        known, missing = 0, []
        for name, rule in grammar.attributes.items():
            attribute = present.get(name)
            if attribute is not None:
                known += 1
                length = schema.LENGTHS.get(rule.type)
                if length is None:
                    self._text(attribute, rule)
                elif attribute.value not in self._valid[length] or rule.since > self._version:
                    self._value(attribute, rule, length)
            elif rule.required:
                missing.append(name)
        if known != len(present):
            missing = self._unknown_attributes(element, grammar, missing)
        for name in missing:
            self._add("URD003", element, name=name)
        if element.text and not element.text.isspace() and not missing:
            self._add("URD017", element)
        if grammar.any_of and not any(name in present for name in grammar.any_of):
            self._add("URD003", element, name="' or '".join(grammar.any_of))

    def _unknown_attributes(
        self, element: Element, grammar: Grammar, missing: list[str]
    ) -> list[str]:
        """Report unknown attributes; returns the names in ``missing`` that are not misspelt."""
        for name, attribute in element.attributes.items():
            if name in grammar.attributes or name == "xmlns" or ":" in name:
                if suggested := extensions.drake_suggestion(name, "attributes"):
                    self._add("URD002", element, attribute, suggested=suggested)
                continue
            foreign = extensions.read_in(element.tag, "attributes")
            if name in foreign:
                continue
            self._unknown += 1
            if self._unknown > MAX_UNKNOWN:
                break
            free = [key for key in grammar.attributes if element.get(key) is None]
            suggested = nearest(name, free) or nearest(name, foreign, CLOSE_TYPO) or ""
            # <parent value="base"/> has one attribute, <cylinder radius="1" height="2"/> one more.
            is_other = missing == list(grammar.attributes) or _is_only_unknown(element, grammar)
            if not suggested and len(missing) == 1 and is_other:
                suggested = missing[0]
            if suggested in missing:
                missing = [key for key in missing if key != suggested]
                self._add("URD003", element, attribute, suggested, suggested)
            else:
                self._add("URD002", element, attribute, suggested=suggested)
        return missing

    def version_number(self) -> None:
        """Report a version that not every parser supports."""
        attribute = self._root.attributes.get("version")
        version = version_of(self._root)
        if attribute is not None and version != schema.VERSIONS[0]:
            self._add("URD011", self._root, attribute)

    def _value(self, attribute: Attribute, rule: AttributeRule, length: int) -> None:
        """Report a value that is not a number, or has the wrong count of numbers."""
        text = attribute.value
        if rule.since > self._version:
            self._add("URD011", attribute.element, attribute, suggested=rule.since)
        elif _is_plain_vector(text, length) and not self._breaks:
            self._valid[length].add(text)
        elif not is_expression(text):
            parts = [part for part in text.split(" ") if part]
            if (
                len(parts) != length
                or not all(map(is_number, parts))
                or (length == 1 and not is_number(text))
                or (self._breaks and length > 1 and has_break(attribute.span.text))
            ):
                self._add("URD005", attribute.element, attribute, rule.type)

    def _text(self, attribute: Attribute, rule: AttributeRule) -> None:
        """Report an empty name of a link or joint, or a value that is not an allowed word."""
        element, text = attribute.element, attribute.value
        if attribute.name == "name" and element.tag in _ELEMENTS_WITH_NAME and not text.strip():
            self._add("URD003", element, attribute, attribute.name)
        elif "|" in rule.type and text not in rule.type.split("|") and not is_expression(text):
            self._add("URD005", element, attribute, rule.type)

    def children(self, element: Element, grammar: Grammar) -> list[tuple[Element, Grammar]]:
        """Report missing, unknown and repeated children; returns the children with a grammar."""
        first: dict[str, Element] = {}
        inner: list[tuple[Element, Grammar]] = []
        unknown: list[Element] = []
        for child in element.children:
            tag = child.tag
            known = grammar.children.get(tag)
            if known is None:
                if ":" in tag:
                    self._drake_elements(child)
                    continue
                if tag not in extensions.read_in(element.tag):
                    unknown.append(child)
                    continue
                known = extensions.grammar_of(element.tag, tag) or schema.ANYTHING
            if not known.open:
                if tag in first and tag not in grammar.many:
                    self._add("URD007", child)
                else:
                    inner.append((child, known))
            first.setdefault(tag, child)
        missing = [tag for tag in grammar.required if tag not in first]
        if grammar.choice:
            unknown = self._choice(element, grammar, unknown)
            del inner[1:]
        if unknown:
            missing = self._unknown_children(element, grammar, unknown, missing, first)
        for tag in missing:
            self._add("URD004", element, name=tag)
        return inner

    def _drake_elements(self, element: Element) -> None:
        """Report misspelt elements of Drake, which ignores them without a message."""
        for inner in element.walk() if element.tag.startswith("drake:") else ():
            if suggested := extensions.drake_suggestion(inner.tag):
                self._add("URD001", inner, suggested=suggested)

    def _unknown_children(
        self,
        element: Element,
        grammar: Grammar,
        unknown: list[Element],
        missing: list[str],
        present: Collection[str],
    ) -> list[str]:
        """Report unknown children; returns the tags in ``missing`` that are not misspelt."""
        unknown = [child for child in unknown if not _is_attribute(child, element, grammar)]
        free = [tag for tag in grammar.children if tag not in present or tag in grammar.many]
        expected = [*missing, *_EXPECTED.get(element.tag, ())]
        reported = {self._unknown_element(child, free, expected) for child in unknown}
        return [tag for tag in missing if tag not in reported]

    def _choice(self, element: Element, grammar: Grammar, unknown: list[Element]) -> list[Element]:
        """Report extra children, of which parsers read the first only; returns other unknowns."""
        first, *others = [child for child in element.children if ":" not in child.tag] or [element]
        if known := grammar.children.get(first.tag):
            if known.since > self._version:
                self._add("URD011", first, suggested=known.since)
            for child in others:
                if child.tag in grammar.children and child.tag != first.tag:
                    self._add("URD007", child)
            return unknown
        self._unknown += 1
        if self._unknown > MAX_UNKNOWN or (first is element and element.children):
            return unknown  # shapes of another dialect have a prefix
        if suggested := nearest(first.tag, grammar.children, TYPO):
            self._add("URD001", first, name=suggested, suggested=suggested)
        else:
            self._add("URD004", first)
        return [child for child in unknown if child is not first]

    def _unknown_element(self, child: Element, free: list[str], expected: list[str]) -> str:
        """Report an unknown element; returns the expected tag that it misspells, or nothing."""
        tag = child.tag
        self._unknown += 1
        if self._unknown > MAX_UNKNOWN or tag in self._claimed:
            return ""
        if tag in schema.GAZEBO_TAGS:
            self._add("URD008", child)
        elif places_of(child):
            self._add("URD001", child)
        else:
            assert child.parent is not None
            foreign = extensions.read_in(child.parent.tag)
            suggested = nearest(tag, free, TYPO) or nearest(tag, foreign, CLOSE_TYPO) or ""
            if not suggested and calling_macro(child):
                # A macro may name its blocks so, and inserts them under these names.
                suggested = next((word for word in tag.split("_") if word in free), "")
            name = suggested if suggested in expected else ""
            self._add("URD001", child, name=name, suggested=suggested)
            return name
        return ""
