"""A comment holds a colon and a space, which ROS 2 launch files may read as YAML.

A launch file that passes the output of xacro as a parameter without saying that it is text
(`ParameterValue(..., value_type=str)`) has it parsed as YAML. A `: ` in a comment then ends the
launch with "mapping values are not allowed here", far from the comment that caused it. Only
packages built with ament are judged.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.diagnostic import Confidence, Severity
from urdfkit.rules import Finding, Need, Written, rule
from urdfkit.source import Source, Span

if TYPE_CHECKING:
    from urdfkit.subject import Subject

FILES = {"package.xml": b"<package><name>a</name><build_type>ament_cmake</build_type></package>"}
BAD = '<robot name="r"><!-- units: metres --><link name="a"/></robot>'
GOOD = '<robot name="r"><!-- units are metres --><link name="a"/></robot>'


@rule(
    "XML005",
    "colon-in-comment",
    Severity.INFO,
    needs=(Need.FILES,),
    help="write the comment without ': ', or set value_type=str in the launch file",
)
def check(subject: Subject) -> Iterator[Finding]:
    source = subject.source
    found = re.search(rb"<!--(?:(?!-->).)*?(: )", source.data, re.DOTALL)
    if found and _is_ament(subject):
        yield Finding(
            Written(Span(source, *found.span(1))),
            "': ' in a comment: a ROS 2 launch file may take the description for YAML",
            confidence=Confidence.INFERRED,
        )


def _is_ament(subject: Subject) -> bool:
    """True if the package of the file is built with ament, that is, for ROS 2."""
    package = subject.resolver.packages.enclosing(subject.source.path)
    if package is None:
        return False
    manifest = Source.read(os.path.join(package[1], "package.xml"))
    return b"<build_type>ament" in manifest.data
