"""MSH039: see the rule; what MuJoCo finds is asked of MuJoCo."""

from pathlib import Path

import pytest

from tests.workspaces import add_file, add_package
from urdfkit import check
from urdfkit.lint.fix import fix
from urdfkit.mesh import samples

INERTIAL = (
    '<inertial><mass value="1"/>'
    '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
)


def robot(directory: Path, name: str, *, role: str = "collision", more: str = "") -> Path:
    package = add_package(directory / "arm_description", "arm_description")
    add_file(package / "meshes" / "arm.stl", samples.stl(samples.box((0, 0, 0), (1, 1, 1))))
    text = (
        f'<robot name="r">\n  {more}<link name="arm">{INERTIAL}<{role}><geometry>'
        f'<mesh filename="{name}"/></geometry></{role}></link>\n</robot>'
    )
    return add_file(package / "urdf" / "arm.urdf", text.encode())


def is_found(path: Path) -> bool:
    """Whether MuJoCo loads a robot."""
    mujoco = pytest.importorskip("mujoco")
    try:
        mujoco.MjModel.from_xml_path(str(path))
    except ValueError:
        return False
    return True


@pytest.mark.parametrize(
    ("name", "more"),
    [
        ("package://arm_description/meshes/arm.stl", ""),
        ("../meshes/arm.stl", ""),
        ("arm.stl", '<mujoco><compiler meshdir="../meshes"/></mujoco>'),
        (
            "package://arm_description/meshes/arm.stl",
            '<mujoco><compiler meshdir="../meshes" strippath="true"/></mujoco>',
        ),
        ("../meshes/arm.stl", '<mujoco><compiler strippath="true"/></mujoco>'),
    ],
)
def test_what_mujoco_finds(tmp_path: Path, name: str, more: str) -> None:
    path = robot(tmp_path, name, more=more)
    found = check(path, select=["MSH001", "MSH039"], targets=["mujoco"]).diagnostics
    assert (found == ()) is (is_found(path) and name != "arm.stl")
    assert not [one for one in found if one.code == "MSH039"] or not is_found(path)


def test_the_fix_makes_mujoco_find_it(tmp_path: Path) -> None:
    path = robot(tmp_path, "package://arm_description/meshes/arm.stl")
    assert not is_found(path)
    fix(path, unsafe=True, select=["MSH039"], targets=["mujoco"]).write()
    assert is_found(path)


def test_visuals_are_not_loaded_unless_asked_for(tmp_path: Path) -> None:
    name = "package://arm_description/meshes/arm.stl"
    keep = '<mujoco><compiler discardvisual="false"/></mujoco>'
    for more, count in (("", 0), (keep, 1)):
        path = robot(tmp_path, name, role="visual", more=more)
        assert is_found(path) is (count == 0)
        assert len(check(path, select=["MSH039"], targets=["mujoco"]).diagnostics) == count


def test_other_programs_find_packages(tmp_path: Path) -> None:
    path = robot(tmp_path, "package://arm_description/meshes/arm.stl")
    assert check(path, select=["MSH039"]).diagnostics == ()
    assert check(path, select=["MSH039"], targets=["pinocchio"]).diagnostics == ()
