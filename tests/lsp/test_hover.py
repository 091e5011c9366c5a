"""What is reported about a place."""

import sys
from pathlib import Path

import pytest

from tests.conftest import ARM, GRIPPER, MISSION, MODELS
from tests.lsp.edited import XACRO, Edited, mission
from tests.lsp.test_navigation import MACRO, edited
from urdfkit.lint import rule_index
from urdfkit.lsp.hover import hover


def reported(file: Edited, *, checked: bool = False) -> str:
    diagnostics = []
    if checked:
        file.workspace.check(file.path)
        diagnostics = file.workspace.diagnostics(file.path)
    return hover(file.robot, file.markup, file.offset, diagnostics)


def test_a_link_has_mass_and_inertia() -> None:
    text = reported(Edited(MISSION, mission('<parent link="base_', 'link"')))
    assert text.splitlines() == [
        "**link** `base_link`",
        "- 8.2 kg, centre of mass at 0 0 0 m",
        "- ixx 0.1, iyy 0.1, izz 0.1 kg·m²",
        "- principal moments 0.1, 0.1, 0.1 kg·m²",
        "- visual: box",
        "- collision: box",
        "- child of `base_footprint` by the fixed joint `base_footprint_joint`",
    ]


def test_a_joint_has_its_ends_axis_and_limits() -> None:
    text = GRIPPER.read_text()
    name = 'joint name="left_finger_joint"'
    assert name in text
    shown = reported(Edited(GRIPPER, text.replace(name, name[:14] + "|" + name[14:])))
    lines = shown.splitlines()
    assert lines[0].startswith("**prismatic joint** `left_finger_joint`: `palm` to ")
    assert any(line.startswith("- axis ") for line in lines)
    assert any(line.startswith("- from ") and line.endswith(" m") for line in lines)
    assert any(line.startswith("- at most ") and line.endswith(" m/s") for line in lines)


def test_an_expression_has_its_values_and_where_they_come_from(tmp_path: Path) -> None:
    text = reported(edited(tmp_path, 'mass value="${ma', "s"))
    first, *origins = text.splitlines()
    assert first == "**value** = `3`, `1` in 2 calls"
    assert origins[0] == "- `mass` = `3`, argument at `r.xacro:12:32`"
    text = reported(edited(tmp_path, "2 * ma", "ss")).partition("\n\n---")[0]
    assert text.splitlines() == [
        "**value** = `4`",
        "- `mass` = `2`, property at `r.xacro:2:36`",
    ]


def test_origins_of_origins_are_indented(tmp_path: Path) -> None:
    body = (
        '<xacro:property name="r" value="0.1"/><xacro:property name="d" value="${2 * r}"/>\n'
        '<link name="a"><visual><geometry><sphere radius="${d|}"/></geometry></visual></link>'
    )
    lines = reported(Edited(tmp_path / "r.xacro", XACRO.format(body))).splitlines()
    assert lines[:3] == [
        "**radius** = `0.2`",
        "- `d` = `0.2`, property `${2 * r}` at `r.xacro:2:71`",
        "  - `r` = `0.1`, property at `r.xacro:2:33`",
    ]


def test_a_macro_and_a_property(tmp_path: Path) -> None:
    assert reported(edited(tmp_path, "<xacro:le", 'g prefix="left"')) == (
        "**macro** `leg`(prefix mass:=1 *block), defined at `r.xacro:4:2`"
    )
    assert "**property** `mass` = `2`, `r.xacro:2:23`" in reported(edited(tmp_path, "2 * ma", "ss"))
    assert reported(edited(tmp_path, "$(arg si", "de")).endswith(
        "**arg** `side` = `left`, `r.xacro:3:18`"
    )


def test_a_mesh_that_is_there_and_one_that_is_not(monkeypatch: pytest.MonkeyPatch) -> None:
    text = ARM.read_text()
    mesh = text.partition("package://")[2].partition('"')[0]
    shown = reported(Edited(ARM, text.replace(mesh, f"{mesh[:-3]}|{mesh[-3:]}", 1)))
    path = ARM.parents[1] / mesh.partition("/")[2]
    assert f"**mesh** `{path}`" in shown
    assert f", {path.stat().st_size / 1024:.1f} KiB" in shown
    trimesh = pytest.importorskip("trimesh")
    loaded = trimesh.load(path, force="mesh")
    size = " x ".join(f"{edge:.4g}" for edge in loaded.extents)
    assert f"- {len(loaded.faces)} triangles, {size} m" in shown
    assert f"- {'a' if loaded.is_watertight else 'not a'} closed solid" in shown
    monkeypatch.setitem(sys.modules, "urdfkit.mesh.io.load_stl", None)  # as without its library
    lines = reported(Edited(ARM, text.replace(mesh, f"{mesh[:-3]}|{mesh[-3:]}", 1))).splitlines()
    assert [line for line in lines if "KiB" in line or "triangles" in line] == [
        f"- binary STL, {path.stat().st_size / 1024:.1f} KiB"
    ]
    shown = reported(Edited(MISSION, mission("package://gazebo_pkg/meshes/hok", "uyo")))
    assert shown.splitlines() == [
        "**mesh** `package://gazebo_pkg/meshes/hokuyo.dae`: no such file",
        f"- tried `{MISSION.parents[1] / 'meshes' / 'hokuyo.dae'}`",
    ]


def test_a_finding_is_explained_where_it_is() -> None:
    text = reported(Edited(MISSION, mission('<xacro:property name="P', 'I"')), checked=True)
    assert f"**XAC007** own-pi\n\n{rule_index.get('XAC007').explanation}" in text
    elsewhere = reported(Edited(MISSION, mission("<robot n", "ame")), checked=True)
    assert "XAC007" not in elsewhere


@pytest.mark.parametrize(
    ("before", "after", "shown"),
    [
        ("<comm", "andTopic>", "**commandTopic** (classic-ros1): topic"),
        ("libgazebo_ros_pla", "nar", "**plugin** of gazebo_plugins, classic-ros1"),
        ("<turnGrav", "ityOff>", "**turnGravityOff** for a link: bool"),
        ('<limit eff', 'ort="100"', "**effort**: number"),
        ("<joint na", 'me="imu_joint"', "**name**: name, required"),
    ],
)  # fmt: skip
def test_what_tags_and_attributes_hold(before: str, after: str, shown: str) -> None:
    assert reported(Edited(MISSION, mission(before, after))).startswith(shown)


def test_an_ignore_comment_is_explained(tmp_path: Path) -> None:
    text = '<robot name="r"><!-- urdfkit: ignore[TRE0|01] --><link name="a"/></robot>'
    assert reported(Edited(tmp_path / "r.urdf", text)).startswith("**TRE001** no-link\n")
    text = '<robot name="r"><!-- urdfkit: ignore[ABC0|01] --><link name="a"/></robot>'
    assert reported(Edited(tmp_path / "r.urdf", text)) == ""


def test_a_broken_text_tells_what_was_known_before(tmp_path: Path) -> None:
    file = edited(tmp_path, 'link="ba', "se")
    assert "**link** `base`" in reported(file)
    file.type(MACRO.replace('link="base"', 'link="ba|se"').replace("</robot>", "<jo"))
    assert file.robot.document is None
    assert reported(file).startswith("**link** `base`\n- 4 kg")


@pytest.mark.parametrize("place", ["<rob|ot name='r'/>", "|", "<robot>|</robot>", "<a>${|}</a>"])
def test_nothing_to_say(tmp_path: Path, place: str) -> None:
    assert reported(Edited(tmp_path / "r.urdf", place)) == ""


def test_names_cannot_break_out_of_their_frame(tmp_path: Path) -> None:
    text = '<robot name="r"><link name="a`**x**&#10;# b|"/></robot>'
    assert "`" not in reported(Edited(tmp_path / "r.urdf", text)).splitlines()[0][12:-1]


def test_a_package_has_its_directory() -> None:
    shown = reported(Edited(MISSION, mission("package://gazebo_", "pkg/meshes")))
    assert shown.startswith(f"**package** `gazebo_pkg`: `{MODELS / 'gazebo_pkg'}`")
