"""Directories of robots for tests."""

from pathlib import Path

from tests.workspaces import add_file
from tests.xacros import HEAD
from urdfkit.lint.entry_points import DirectoryContents

ROOT_ROBOT = '<robot name="box"><link name="box"/></robot>\n'
CART = """<link name="base"/><link name="wheel"/>
<joint name="axle" type="continuous"><parent link="base"/><child link="wheel"/></joint>"""


def write(directory: Path, name: str, body: str) -> str:
    """Write a description and give its path."""
    return str(add_file(directory / name, f"{HEAD}\n{body}\n</robot>\n"))


def include(name: str) -> str:
    return f'<xacro:include filename="{name}"/>'


def names(found: DirectoryContents) -> list[str]:
    """The names of the files of the robots."""
    return [Path(robot.file).name for robot in found.robots]
