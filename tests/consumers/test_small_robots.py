"""What a program rejects has an error with ``--target``, and what it takes has a warning."""

from pathlib import Path

import pytest

from tests.consumers.reading import is_installed, read
from urdfkit import check

INERTIAL = (
    '<inertial><mass value="1"/>'
    '<inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>'
)
RED, GREEN = '<color rgba="1 0 0 1"/>', '<color rgba="0 1 0 1"/>'
ALL = {"drake", "genesis", "mujoco", "newton", "pinocchio", "pybullet", "yourdfpy"}
URDFDOM = {"pinocchio"}


def link(name: str, color: str = "") -> str:
    material = f'<material name="m">{color}</material>'
    visual = f'<visual><geometry><box size="1 1 1"/></geometry>{material}</visual>'
    return f'<link name="{name}">{INERTIAL}{visual if color else ""}</link>'


def joint(name: str, parent: str, child: str, limit: str = "-1 1", more: str = "") -> str:
    lower, upper = limit.split()
    return (
        f'<joint name="{name}" type="revolute"><parent link="{parent}"/><child link="{child}"/>'
        f'<axis xyz="0 0 1"/><limit lower="{lower}" upper="{upper}" effort="1" velocity="1"/>'
        f"{more}</joint>"
    )


PAIR = link("a") + link("b")
MATERIAL = f'<material name="m">{RED}</material>'

#: A robot, the rule that reports it, and the programs that reject it.
CASES = {
    "a material twice": (MATERIAL * 2 + link("a"), "NAM001", {"drake", "genesis"} | URDFDOM),
    "two joints of one name": (
        PAIR + link("c") + joint("j", "a", "b") + joint("j", "b", "c"),
        "NAM001",
        {"drake", "genesis", "pybullet"} | URDFDOM,
    ),
    "two colours of one material": (
        link("a", RED) + link("b", GREEN) + joint("j", "a", "b"),
        "NAM001",
        {"drake"},
    ),
    "a mimic of nothing": (
        PAIR + joint("j", "a", "b", more='<mimic joint="k"/>'),
        "REF001",
        {"drake", "genesis"},
    ),
    "two roots": (PAIR, "TRE002", {"genesis", "pybullet"} | URDFDOM),
}


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("target", sorted(ALL))
def test_severity(case: str, target: str, tmp_path: Path) -> None:
    robot, code, rejecting = CASES[case]
    path = tmp_path / "robot.urdf"
    path.write_text(f'<robot name="r">{robot}</robot>')
    if target == "yourdfpy" and case == "two joints of one name":
        pytest.skip("yourdfpy takes the robot and loses a joint")
    (found,) = check(path, targets=[target], select=[code]).diagnostics
    assert found.severity.value == ("error" if target in rejecting else "warning")
    if is_installed(target):
        refusal = read(target, path.read_bytes(), tmp_path)
        assert isinstance(refusal, str) is (target in rejecting)


def test_one_target_that_rejects_is_enough(tmp_path: Path) -> None:
    path = tmp_path / "robot.urdf"
    path.write_text(f'<robot name="r">{MATERIAL * 2}{link("a")}</robot>')
    for targets in (["mujoco", "drake"], ["mujoco", "ros2"], []):
        (found,) = check(path, targets=targets, select=["NAM001"]).diagnostics
        assert found.severity.value == "error"


@pytest.mark.parametrize(
    ("before", "severity"),
    [
        ('<?xml verison="1.0"?>', "error"),
        ('<!-- a --><?xml version="1.0"?>', "error"),
        ('<?xml version="1.2"?>', "warning"),
    ],
)
def test_parsers_of_python_need_a_strict_declaration(
    before: str, severity: str, tmp_path: Path
) -> None:
    path = tmp_path / "robot.urdf"
    path.write_text(f'{before}<robot name="r">{link("a")}</robot>')
    (found,) = check(path, targets=["pinocchio"], select=["XML007"]).diagnostics
    assert found.severity.value == "warning"
    for target in ("genesis", "newton"):
        (found,) = check(path, targets=[target], select=["XML007"]).diagnostics
        assert found.severity.value == severity
        if is_installed(target):
            refusal = read(target, path.read_bytes(), tmp_path)
            assert isinstance(refusal, str) is (severity == "error")
