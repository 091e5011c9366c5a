"""MSH039: see the rule; what MuJoCo, PyBullet and Genesis find is asked of them."""

from pathlib import Path

import pytest

from tests.consumers.oracles import genesis
from tests.consumers.reading import is_installed
from tests.meshed import mesh
from tests.workspaces import add_file, add_package
from urdfkit import check
from urdfkit.lint.fix import fix
from urdfkit.mesh import samples

ARM = "package://arm_description/meshes/arm.stl"
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


@pytest.mark.parametrize("role", ["visual", "collision"])
@pytest.mark.parametrize(
    ("directory", "name", "count"),
    [
        ("arm_description", ARM, 0),
        ("src/arms/arm_description", ARM, 0),
        ("arms.git", ARM, 1),
        ("arms.git", "model://arm_description/meshes/arm.stl", 1),
        ("arms.git", "../meshes/arm.stl", 0),
    ],
)
def test_what_pybullet_finds(
    tmp_path: Path, directory: str, name: str, count: int, role: str
) -> None:
    package = add_package(tmp_path / directory, "arm_description")
    add_file(package / "meshes" / "arm.stl", samples.stl(samples.box((0, 0, 0), (1, 1, 1))))
    text = f'<robot name="r"><link name="arm">{INERTIAL}{mesh(name, role)}</link></robot>'
    path = add_file(package / "urdf" / "arm.urdf", text.encode())
    found = check(path, select=["MSH001", "MSH039"], targets=["pybullet"]).diagnostics
    assert [one.code for one in found] == ["MSH039"] * count


def test_pybullet_finds_what_is_above(tmp_path: Path) -> None:
    pybullet = pytest.importorskip("pybullet")
    pybullet.connect(pybullet.DIRECT)
    for directory, is_here in (("arm_description", True), ("arms.git", False)):
        package = add_package(tmp_path / directory, "arm_description")
        add_file(package / "meshes" / "arm.stl", samples.stl(samples.box((0, 0, 0), (1, 1, 1))))
        text = f'<robot name="r"><link name="arm">{mesh(ARM)}</link></robot>'
        path = add_file(package / "urdf" / f"{directory}.urdf", text.encode())
        if is_here:
            pybullet.loadURDF(str(path))
        else:
            with pytest.raises(pybullet.error):
                pybullet.loadURDF(str(path))


@pytest.mark.parametrize(
    ("directory", "of_urdf", "count"),
    [
        ("arm_description", "arm_description", 0),
        ("arms.git", "arms.git", 1),
        ("src/arm_description", "src/arm_bringup", 1),
        ("arm_description", "arm_description/robots/arms", 0),
    ],
)
def test_what_genesis_finds(tmp_path: Path, directory: str, of_urdf: str, count: int) -> None:
    package = add_package(tmp_path / directory, "arm_description")
    add_file(package / "meshes" / "arm.stl", samples.stl(samples.box((0, 0, 0), (1, 1, 1))))
    text = f'<robot name="r"><link name="arm">{INERTIAL}{mesh(ARM)}</link></robot>'
    path = add_file(tmp_path / of_urdf / "urdf" / "arm.urdf", text.encode())
    found = check(
        path,
        select=["MSH001", "MSH039"],
        targets=["genesis"],
        packages={"arm_description": str(package)},
    ).diagnostics
    assert [one.code for one in found] == ["MSH039"] * count
    if is_installed("genesis") and count:
        with pytest.raises(ValueError, match="Asset file not found"):
            genesis.read(str(path))
    elif is_installed("genesis"):
        genesis.read(str(path))
