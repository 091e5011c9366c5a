"""PKG006: see the rule."""

from pathlib import Path

import pytest

from tests.launched import MANIFEST
from urdfkit import Diagnostic, check

TYPE = "<export><build_type>ament_python</build_type></export>"
PYTHON = MANIFEST.replace("</package>", f"{TYPE}</package>")
SETUP = """\
package_name = 'arm'
setup(data_files=[
    ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
])
"""


def reported(folder: Path, manifest: str, setup: str, *more: str) -> list[Diagnostic]:
    (folder / "package.xml").write_text(manifest)
    (folder / "setup.py").write_text(setup)
    for name in more:
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).touch()
    (folder / "a.launch").write_text("<launch/>")
    report = check(folder / "a.launch", select=["PKG006"])
    assert report.crashed == ()
    return list(report.diagnostics)


def test_without_the_index(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, PYTHON, "setup(data_files=[])", "resource/arm")
    assert found.message.endswith("ROS will not find the package 'arm'")
    assert Path(found.span.source.path).name == "setup.py"


def test_without_the_file_in_it(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, PYTHON, SETUP)
    assert found.message == "setup.py installs 'resource/arm', and there is no such file"
    assert found.span.line == 3


def test_without_a_build_type(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, MANIFEST, SETUP, "resource/arm")
    assert found.message == "no build type: colcon looks for a CMakeLists.txt"
    assert Path(found.span.source.path).name == "package.xml"


@pytest.mark.parametrize(
    ("manifest", "setup", "more"),
    [
        (PYTHON, SETUP, ["resource/arm"]),
        (PYTHON, SETUP.replace("'resource/' + package_name", "MARKER"), []),
        (MANIFEST, "setup()", []),
        (MANIFEST, SETUP, ["CMakeLists.txt"]),
        (PYTHON.replace("ament_python", "cmake"), "setup()", []),
    ],
)
def test_registered_or_unclear_is_calm(
    tmp_path: Path, manifest: str, setup: str, more: list[str]
) -> None:
    assert reported(tmp_path, manifest, setup, *more) == []
