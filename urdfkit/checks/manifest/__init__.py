"""The package.xml and setup.py around a robot or a launch file."""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.text.xml_reader import is_launch
from urdfkit.workspace.package_references import are_in

#: Former codes and names of rules.
REDIRECTS = {
    "PKG003": "PKG005",
    "PKG006": "PKG005",
    "manifest-refused": "PKG005",
    "name-differs": "PKG005",
    "not-registered": "PKG005",
}


def applies(subject: Subject) -> bool:
    """True for a launch file, and for a description that refers to packages."""
    return is_launch(subject.source.path) or are_in(subject.document.sources)
