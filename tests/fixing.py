"""Robots that are fixed, and settings with which they are."""

from functools import partial
from pathlib import Path

from tests.workspaces import add_file
from urdfkit.lint.config import Config
from urdfkit.lint.fix import fix as fix_as_configured
from urdfkit.text.diagnostic import Severity

#: An axis on a fixed joint is an info otherwise, whose fix nobody applies unasked.
SEVERITIES = {"JNT020": Severity.WARNING}
fix = partial(fix_as_configured, config=Config(severities=SEVERITIES))

FIXED_JOINT = """\
  <link name="a"/>
  <link name="b"/>
  <joint name="j" type="fixed">
    <parent link="a"/><child link="b"/> <!-- stays -->
    <axis xyz='0 1 0'/>
  </joint>
"""


def write(directory: Path, name: str, body: str, attributes: str = "") -> Path:
    """A description with a body, written to a directory."""
    head = f'<?xml version="1.0"?>\n<robot name="r" {attributes}>'
    return add_file(directory / name, f"{head}\n{body}</robot>\n")
