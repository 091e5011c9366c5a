"""MSH039: see the rule."""

from pathlib import Path

import pytest

from tests.meshed import SOUND
from urdfkit import Diagnostic, Options, check

PACKAGE = "package://arm_description/meshes/arm.stl"


def reported(
    directory: Path, name: str, tag: str = "collision", compiler: str = "", target: str = "mujoco"
) -> list[Diagnostic]:
    """What is said of a mesh in ``meshes``, of a robot in ``urdf``."""
    for folder in ("meshes", "urdf"):
        (directory / folder).mkdir()
    manifest = "<package><name>arm_description</name></package>"
    (directory / "package.xml").write_text(manifest)
    (directory / "meshes/arm.stl").write_bytes(SOUND)
    settings = f"<mujoco><compiler {compiler}/></mujoco>" if compiler else ""
    (directory / "urdf/arm.urdf").write_text(
        f'<robot name="arm">{settings}<link name="arm"><{tag}><geometry>'
        f'<mesh filename="{name}"/></geometry></{tag}></link></robot>'
    )
    options = Options(targets=(target,))
    report = check(directory / "urdf/arm.urdf", select=["MSH039"], options=options)
    return list(report.diagnostics)


def test_a_package_is_no_directory(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, PACKAGE)
    assert found.message == (
        f"link 'arm': the collision mesh '{PACKAGE}' is not found by MuJoCo, which looks for "
        f"'{PACKAGE}' in {tmp_path}/urdf"
    )
    assert found.span.text == PACKAGE
    assert 'meshdir="../meshes" strippath="true"' in found.help


@pytest.mark.parametrize(
    ("name", "tag", "compiler", "count"),
    [
        ("../meshes/arm.stl", "collision", "", 0),
        (PACKAGE, "collision", 'meshdir="../meshes" strippath="true"', 0),
        (PACKAGE, "collision", 'meshdir="meshes" strippath="true"', 1),
        (PACKAGE, "visual", "", 0),
        (PACKAGE, "visual", 'discardvisual="false"', 1),
        ("package://arm_description/meshes/leg.stl", "collision", "", 0),  # MSH001
    ],
)
def test_where_mujoco_looks(tmp_path: Path, name: str, tag: str, compiler: str, count: int) -> None:
    assert len(reported(tmp_path, name, tag, compiler)) == count


def test_another_target_finds_it(tmp_path: Path) -> None:
    assert reported(tmp_path, PACKAGE, target="ros2") == []
