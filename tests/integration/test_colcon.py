"""The example of a ROS 2 package, configured and tested as colcon does it, without ROS.

In place of ``ament_cmake`` stands what the package uses of it: CTest, and a macro that ends it.
"""

import os
import shutil
import subprocess
import sys
import sysconfig
from pathlib import Path
from xml.etree import ElementTree

import pytest

from tests.conftest import ROOT

pytestmark = pytest.mark.skipif(
    sys.platform == "win32" or not all(map(shutil.which, ("cmake", "ctest", "make", "cc", "c++"))),
    reason="CMake, make and a compiler are not installed",
)

AMENT = """
include(CTest)
macro(ament_package)
endmacro()
"""


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """A copy of the example."""
    return shutil.copytree(ROOT / "examples" / "ros_package", tmp_path / "arm_description")


def test_ctest_fails_with_the_findings_of_the_package(package: Path, tmp_path: Path) -> None:
    ament, build = tmp_path / "ament", tmp_path / "build"
    ament.mkdir()
    (ament / "ament_cmakeConfig.cmake").write_text(AMENT)
    scripts = sysconfig.get_path("scripts")
    environment = {**os.environ, "PATH": f"{scripts}{os.pathsep}{os.environ['PATH']}"}

    def run(*words: str | Path) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            words, check=False, cwd=tmp_path, env=environment, capture_output=True, text=True
        )

    configured = run("cmake", "-S", package, "-B", build, f"-Dament_cmake_DIR={ament}")
    assert configured.returncode == 0, configured.stderr
    tested = run("ctest", "--test-dir", build, "--output-on-failure")
    assert tested.returncode == 0, tested.stdout

    model = package / "urdf" / "arm.urdf.xacro"
    model.write_text(model.read_text().replace('<mass value="${mass}"/>', '<mass value="-1"/>'))
    tested = run("ctest", "--test-dir", build, "--output-on-failure")
    assert tested.returncode != 0
    assert "error INE001" in tested.stdout
    results = ElementTree.parse(build / "urdfkit.xunit.xml").getroot()
    assert [case.get("name") for case in results.iter("testcase")] == ["INE001 mass-not-positive"]
