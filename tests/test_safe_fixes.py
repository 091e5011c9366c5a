"""A safe fix gives back the robot as it was before a mistake, or changes nothing that is read."""

from __future__ import annotations

import re
import shutil
from itertools import islice
from pathlib import Path

import pytest

from tests.conftest import MODELS
from tests.test_planted import CARRIERS
from urdfkit.lint.engine import contexts
from urdfkit.lint.fix import fix
from urdfkit.lint.options import Options
from urdfkit.text.document import Element

ROBOTS = {
    "xacro": (MODELS / "good" / "mobile_base", "urdf/mobile_base.urdf.xacro"),
    "urdf": (CARRIERS / "picker", "urdf/picker.urdf"),
}

#: What people write instead, as a pattern and its replacement; most have a safe fix.
SLIPS = {
    "copy": (r"<\w+ [^<>]*/>", r"\g<0>\n\g<0>"),
    "copy of a part": (r"(?s)<(inertial|visual|collision)>.*?</\1>", r"\g<0>\n\g<0>"),
    "empty element": (r"</(?:link|joint)>", r"<test/>\g<0>"),
    "comment without its end": (r" -->", " ->"),
    "space in the end": (r"-->", "-- >"),
    "hyphen in the end": (r"-->", "--->"),
    "hyphens": (r"<!-- ", "<!-- -- "),
    "comment in a comment": (r"<!-- ", "<!-- <!-- "),
    "comment around elements": (r"<(?:link|joint) ", r"<!-- \g<0>"),
    "first line": (r"<\?xml", "\n<?xml"),
    "comment in the first line": (r"<\?xml", "<!-- a robot -->\n<?xml"),
    "version": (r'version="1\.0"', 'version="1,0"'),
    "namespace": (r' xmlns:xacro="[^"]*"', ""),
    "prefix of the namespace": ("xmlns:xacro", "xmlns:xarco"),
    "prefix": (r"<xacro:(?=[a-z_]+ )", "<"),
    "end of a tag": (r"/>", ">"),
    "quote": (r'="([^"]*)"', r'="\1'),
    "type": (r'type="(?:revolute|continuous|prismatic)"', 'type="fixed"'),
    "dollar": (r"\$\{", "{"),
}
#: Places of each mistake that are tried.
PLACES = 6


def _elements(file: Path) -> list[tuple[object, ...]] | None:
    """All that a program reads of a robot; None if it cannot be read."""
    (context,) = contexts(Options(), [file])
    assert context is not None
    if context.reading.document is None:
        return None
    return [
        (element.path, element.text.strip(), *_attributes(element))
        for element in context.document.root.walk()
    ]


def _attributes(element: Element) -> list[tuple[str, str]]:
    """Names and values, without namespaces, which say nothing of the robot."""
    every = ((one.name, one.value) for one in element.attributes.values())
    return [(name, value) for name, value in every if not name.startswith("xmlns")]


@pytest.mark.parametrize("slip", SLIPS)
@pytest.mark.parametrize("robot", ROBOTS)
def test_a_safe_fix_makes_no_other_robot(robot: str, slip: str, tmp_path: Path) -> None:
    directory, name = ROBOTS[robot]
    shutil.copytree(directory, tmp_path, dirs_exist_ok=True)
    file = tmp_path / name
    text = re.sub(r"<(?:link|joint) ", r"<!-- next --> \g<0>", file.read_text(encoding="utf-8"))
    file.write_text(text, encoding="utf-8")
    original = _elements(file)
    pattern, replacement = SLIPS[slip]
    for found in islice(re.finditer(pattern, text), PLACES):
        file.write_text(
            text[: found.start()] + found.expand(replacement) + text[found.end() :],
            encoding="utf-8",
        )
        damaged = _elements(file)
        fix(file).write()
        assert _elements(file) in (original, damaged), found
