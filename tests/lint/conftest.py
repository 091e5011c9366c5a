"""What tests of directories share."""

from pathlib import Path

import pytest

from tests.lint.directories import include, write


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """Two robots, a macro file that one includes through another, and a lonely library."""
    (tmp_path / "package.xml").write_text("<package><name>pkg</name></package>")
    write(tmp_path, "urdf/arm.xacro", include("$(find pkg)/urdf/parts/rod.xacro") + "<xacro:rod/>")
    write(tmp_path, "urdf/parts/rod.xacro", include("units.xacro") + '<xacro:macro name="rod"/>')
    write(tmp_path, "urdf/parts/units.xacro", '<xacro:property name="mm" value="0.001"/>')
    write(tmp_path, "urdf/base.urdf", '<link name="base"/>')
    write(tmp_path, "urdf/lonely.xacro", '<xacro:macro name="x"><link name="x"/></xacro:macro>')
    write(tmp_path, "build/copy.urdf", '<link name="copy"/>')
    (tmp_path / "urdf/notes.xacro").write_text("<notes/>")
    return tmp_path
