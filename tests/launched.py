"""Launch files of ROS 1 and ROS 2 in a package of their own, for the tests of the rules LAU."""

from collections.abc import Mapping
from pathlib import Path

from tests.workspaces import add_files
from urdfkit import Diagnostic, check

MANIFEST = """<?xml version="1.0"?>
<package format="3">
  <name>arm</name>
  <version>1.0.0</version>
  <description>An arm.</description>
  <maintainer email="arm@example.org">Arm</maintainer>
  <license>Apache-2.0</license>
</package>
"""

#: The rules about launch files in Python.
PYTHON = "LAU033 LAU034 LAU035 LAU036 LAU037 LAU038"


def reported(
    directory: Path, code: str, name: str, text: str, files: Mapping[str, str] | None = None
) -> list[Diagnostic]:
    """What a rule says of ``launch/<name>``.

    Args:
        directory: becomes the package ``arm``.
        code: of the rule, or several ones.
        name: of the launch file.
        text: of it; what stands in ``<launch>``, or the program.
        files: further ones, by path.
    """
    directory.mkdir(parents=True, exist_ok=True)
    (directory / "package.xml").write_text(MANIFEST)
    (directory / "launch").mkdir(exist_ok=True)
    add_files(directory, files or {})
    (directory / "launch" / name).write_text(text if name.endswith(".py") else launch(text))
    report = check(directory / "launch" / name, select=code.split())
    assert report.crashed == ()
    return list(report.diagnostics)


def launch(text: str) -> str:
    """A launch file in XML; its content begins on the second line."""
    return f"<launch>\n{text}\n</launch>\n"
