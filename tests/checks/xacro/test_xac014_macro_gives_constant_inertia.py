from __future__ import annotations

from pathlib import Path

import pytest

from tests.conftest import MODELS
from tests.xacros import reported, told_of, write
from urdfkit.lint import engine

TENSOR = '<inertia ixx="0.1" ixy="0" ixz="0" iyy="0.2" iyz="0" izz="0.3"/>'
MACRO = (
    '<xacro:macro name="inertial" params="mass"><inertial><mass value="${mass}"/>'
    f"{TENSOR}</inertial></xacro:macro>\n"
)


def links(*masses: float) -> str:
    return "\n".join(
        f'<link name="l{number}"><xacro:inertial mass="{mass}"/></link>'
        for number, mass in enumerate(masses)
    )


def test_links_of_different_mass() -> None:
    (found,) = reported("XAC014", MACRO + links(8, 0.5, 0.25))
    assert (found.span.line, found.span.text) == (
        2,
        '<xacro:macro name="inertial" params="mass">',
    )
    assert found.message == (
        "macro 'inertial' gives 3 links of 0.25 to 8 kg the same inertia tensor "
        "(0.1, 0.2, 0.3 kg m^2)"
    )
    assert [(one.span.line, one.message) for one in found.related] == [
        (3, "link 'l0' of 8 kg"),
        (4, "link 'l1' of 0.5 kg"),
        (5, "link 'l2' of 0.25 kg"),
    ]


@pytest.mark.parametrize(
    "body",
    [
        MACRO + links(8),
        MACRO + links(0.5, 0.5, 0.51),
        MACRO.replace('"0.1"', '"${mass/2}"') + links(8, 0.5),
        MACRO.replace("0.1", "0").replace("0.2", "0").replace("0.3", "0") + links(8, 0.5),
        (
            f'<link name="a"><inertial><mass value="1"/>{TENSOR}</inertial></link>'
            f'<link name="b"><inertial><mass value="9"/>{TENSOR}</inertial></link>'
        ),
    ],
    ids=["one call", "alike", "computed", "zero", "written out twice"],
)
def test_no_macro_gives_a_constant_to_different_masses(body: str) -> None:
    assert reported("XAC014", body) == []


def test_the_macro_of_an_included_file(tmp_path: Path) -> None:
    write(tmp_path, robot=f'<xacro:include filename="i.xacro"/>{links(1, 2)}', i=MACRO)
    (found,) = told_of("XAC014", tmp_path / "robot.xacro")
    assert Path(found.span.source.path).name == "i.xacro"


def test_the_models_mission() -> None:
    report = engine.check(
        MODELS / "gazebo_pkg" / "urdf" / "waking_robot_new.xacro", select=["XAC014"]
    )
    (found,) = report.diagnostics
    assert "gives 6 links of 0.0001 to 8.2 kg" in found.message
