"""What MuJoCo and Drake read well is no error where they are the only targets."""

from pathlib import Path

import pytest

from urdfkit import check

INERTIAL = (
    '<inertial><mass value="1"/>'
    '<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>'
)
CAPSULE = '<collision><geometry><capsule radius="0.1" length="0.3"/></geometry></collision>'


def robot(kind: str = "revolute", limit: str = "", more: str = "", shape: str = "") -> str:
    return (
        f'<robot name="r">{more}<link name="base">{INERTIAL}</link>'
        f'<link name="arm">{INERTIAL}{shape}</link>'
        f'<joint name="j" type="{kind}"><parent link="base"/><child link="arm"/>'
        f'<axis xyz="0 0 1"/>{limit}</joint></robot>'
    )


TO_WORLD = '<joint name="k" type="fixed"><parent link="world"/><child link="base"/></joint>'
LIMIT = '<limit lower="-1" upper="1"/>'
FULL = '<limit lower="-1" upper="1" effort="1" velocity="1"/>'
CASES = {
    "a capsule": (robot(limit=FULL, shape=CAPSULE), "URD011", {"mujoco", "drake"}),
    "a spherical joint": (robot("spherical"), "JNT001", {"mujoco"}),
    "a limit without effort": (robot(limit=LIMIT), "JNT002", {"mujoco", "drake"}),
    "no limit": (robot(), "JNT002", {"mujoco", "drake"}),
    "Drake's world": (robot(limit=FULL, more=TO_WORLD), "REF001", {"drake"}),
}


def errors(text: str, directory: Path, *targets: str) -> set[str]:
    file = directory / "r.urdf"
    file.write_text(text)
    found = check(file, targets=targets).diagnostics
    return {one.code for one in found if one.severity.value == "error"}


@pytest.mark.parametrize("case", CASES)
def test_who_reads_it(case: str, tmp_path: Path) -> None:
    text, code, readers = CASES[case]
    for target in ("mujoco", "drake", "ros2"):
        expected = set() if target in readers else {code}
        assert errors(text, tmp_path, target) == expected, target
    assert errors(text, tmp_path, "drake", "mujoco", "ros2") == {code}


@pytest.mark.parametrize("case", [case for case, (*_, by) in CASES.items() if "mujoco" in by])
def test_mujoco_reads_it(case: str) -> None:
    mujoco = pytest.importorskip("mujoco")
    model = mujoco.MjModel.from_xml_string(CASES[case][0])
    assert model.njnt == 1


@pytest.mark.parametrize(("kind", "is_error"), [("revolute", True), ("fixed", False)])
def test_a_link_world_that_a_joint_moves(tmp_path: Path, kind: str, is_error: bool) -> None:
    """MuJoCo rejects a joint in its world, and merges what a fixed joint holds."""
    text = robot(kind, FULL).replace('"arm"', '"world"')
    assert ("NAM004" in errors(text, tmp_path, "mujoco")) is is_error


@pytest.mark.parametrize(("directory", "count"), [("meshes", 0), ("/home/ana/meshes", 1)])
def test_a_directory_of_meshes_that_is_elsewhere(
    tmp_path: Path, directory: str, count: int
) -> None:
    (tmp_path / "meshes").mkdir()
    tags = f'<mujoco><compiler meshdir="{directory}"/></mujoco>'
    mesh = '<collision><geometry><mesh filename="a.stl"/></geometry></collision>'
    (tmp_path / "r.urdf").write_text(robot(limit=FULL, more=tags, shape=mesh))
    found = check(tmp_path / "r.urdf", select=["MSH039"], targets=["mujoco"]).diagnostics
    assert len(found) == count
