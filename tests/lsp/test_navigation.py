"""Definitions, references and renaming, in texts that expand and in texts that do not."""

import re
from pathlib import Path

import pytest

import urdfkit
from tests.conftest import ARM, MISSION
from tests.lsp.edited import XACRO, Edited, mission
from urdfkit.lsp.navigation import CannotRename, definitions, references, rename
from urdfkit.lsp.workspace import Workspace
from urdfkit.text.editing.apply import apply_edits
from urdfkit.text.source import Span

MACRO = XACRO.format(
    """<xacro:property name="mass" value="2"/>
<xacro:arg name="side" default="left"/>
<xacro:macro name="leg" params="prefix mass:=1 *block">
  <link name="${prefix}_leg"><inertial><mass value="${mass}"/></inertial></link>
  <joint name="${prefix}_hip" type="fixed">
    <parent link="base"/><child link="${prefix}_leg"/>
    <xacro:insert_block name="block"/>
  </joint>
</xacro:macro>
<link name="base"><inertial><mass value="${2 * mass}"/></inertial></link>
<xacro:leg prefix="left" mass="3"><origin xyz="0 0 0"/></xacro:leg>
<xacro:leg prefix="right"><origin xyz="0 0 0"/></xacro:leg>
<gazebo reference="left_leg"><material>Gazebo/Red</material></gazebo>
<transmission name="t"><joint name="left_hip"/></transmission>
<material name="$(arg side)"/>"""
)


LEG = "${prefix}_leg"


def edited(tmp_path: Path, before: str, after: str = "", text: str = MACRO) -> Edited:
    assert before + after in text
    return Edited(tmp_path / "r.xacro", text.replace(before + after, f"{before}|{after}", 1))


def lines(spans: list[Span]) -> list[tuple[int, str]]:
    return sorted((span.line, span.text) for span in spans)


def found(file: Edited) -> tuple[list[tuple[int, str]], list[tuple[int, str]]]:
    """Definitions, and all places that are no definitions."""
    at = (file.robot, file.markup, file.offset)
    return lines(definitions(*at)), lines(references(*at, definitions=False))


@pytest.mark.parametrize(
    ("before", "after", "given", "used"),
    [
        ('link="ba', "se", [(11, "base")], [(7, "base")]),
        ("<xacro:le", 'g prefix="left"', [(4, "leg")], [(n, "leg") for n in (12, 12, 13, 13)]),
        ("<xac", 'ro:leg prefix="left"', [(4, "leg")], [(n, "leg") for n in (12, 12, 13, 13)]),
        # A parameter hides the property in its macro, and nowhere else.
        ('mass value="${ma', 's', [(4, "mass")], [(5, "mass"), (12, "mass")]),
        ("2 * ma", "ss", [(2, "mass")], [(11, "mass")]),
        ("pref", 'ix="right"', [(4, "prefix")], [(n, "prefix") for n in (5, 6, 7, 12, 13)]),
        ('insert_block name="blo', "ck", [(4, "block")], [(8, "block")]),
        ("$(arg si", "de", [(3, "side")], [(16, "side")]),
        # One call of the macro makes the link: its definition is in the macro.
        ('reference="left', "_leg", [(5, LEG)], [(7, LEG), (14, "left_leg")]),
        ('joint name="left', "_hip", [(6, "${prefix}_hip")], [(15, "left_hip")]),
    ],
)  # fmt: skip
def test_where_a_name_is_given_and_used(tmp_path, before, after, given, used) -> None:
    assert found(edited(tmp_path, before, after)) == (given, used)


def test_a_text_that_is_broken_still_has_names(tmp_path: Path) -> None:
    broken = MACRO.replace("</robot>", '<joint name="x"><parent link="ba').replace(
        "2 * mass", "2 *"
    )
    file = edited(tmp_path, 'link="ba', "se", text=broken)
    assert file.robot.document is None
    assert found(file)[0] == [(11, "base")]


def test_a_name_of_an_included_file(tmp_path: Path) -> None:
    (tmp_path / "legs.xacro").write_text(MACRO.replace("<xacro:leg ", "<xacro:leg_ "))
    text = XACRO.format('<xacro:include filename="legs.xacro"/>\n<xacro:leg prefix="a"/>')
    file = Edited(tmp_path / "r.xacro", text.replace("<xacro:leg ", "<xacro:l|eg "))
    (span,) = definitions(file.robot, file.markup, file.offset)
    assert (Path(span.source.path).name, span.line) == ("legs.xacro", 4)
    file.type(text.replace("legs.xacro", "legs|.xacro"))
    (span,) = definitions(file.robot, file.markup, file.offset)
    assert Path(span.source.path).name == "legs.xacro"


def test_the_mesh_and_its_package_can_be_opened() -> None:
    text = ARM.read_text()
    assert "package://two_link_arm/" in text
    file = Edited(ARM, text.replace("package://two", "package://tw|o", 1))
    (span,) = definitions(file.robot, file.markup, file.offset)
    assert Path(span.source.path) == ARM.parents[1] / "package.xml"
    mesh = text.partition("package://two_link_arm/")[2].partition('"')[0]
    file.type(text.replace(mesh, f"{mesh[:5]}|{mesh[5:]}", 1))
    (span,) = definitions(file.robot, file.markup, file.offset)
    assert Path(span.source.path) == ARM.parents[1] / mesh


def test_nothing_is_at_a_place_without_a_name(tmp_path: Path) -> None:
    assert found(edited(tmp_path, "<rob", "ot")) == ([], [])


@pytest.fixture
def with_srdf(tmp_path: Path) -> Edited:
    """A robot with its SRDF beside it; the cursor is on a link."""
    (tmp_path / "r.srdf").write_text(
        '<robot name="r">\n<group name="g"><chain base_link="base" tip_link="tip"/></group>\n'
        '<disable_collisions link1="base" link2="tip" reason="Adjacent"/>\n'
        '<group_state name="home" group="g"><joint name="hip" value="0"/></group_state>\n</robot>\n'
    )
    text = (
        '<robot name="r"><link name="ba|se"/><link name="tip"/>\n<joint name="hip" type="fixed">'
        '<parent link="base"/><child link="tip"/></joint></robot>'
    )
    (tmp_path / "r.urdf").write_text(text.replace("|", ""))
    (tmp_path / "package.xml").write_text("<package><name>r_description</name></package>")
    return Edited(tmp_path / "r.urdf", text)


def test_the_srdf_of_a_robot_uses_its_names(with_srdf: Edited) -> None:
    at = (with_srdf.robot, with_srdf.markup, with_srdf.offset)
    used = [
        (Path(span.source.path).suffix, span.line) for span in references(*at, definitions=False)
    ]
    assert sorted(used) == [(".srdf", 2), (".srdf", 3), (".urdf", 2)]
    edits = rename(*at, "root")
    assert len(edits) == 4
    srdf = next(edit.span.source for edit in edits if edit.span.source.path.endswith(".srdf"))
    text = apply_edits(srdf.data, [edit for edit in edits if edit.span.source is srdf]).decode()
    assert text.count('"root"') == 2
    assert '"base"' not in text


def test_a_name_in_the_srdf_leads_to_the_robot(with_srdf: Edited) -> None:
    workspace = with_srdf.workspace
    srdf = Path(with_srdf.path).with_suffix(".srdf")
    file = Edited(
        srdf, srdf.read_text().replace('joint name="hip"', 'joint name="h|ip"'), workspace
    )
    (span,) = definitions(file.robot, file.markup, file.offset)
    assert (Path(span.source.path).suffix, span.text) == (".urdf", "hip")


# --- renaming


def renamed(file: Edited, new: str) -> str:
    edits = rename(file.robot, file.markup, file.offset, new)
    assert {edit.span.source.path for edit in edits} == {file.path}
    return apply_edits(file.markup.source.data, edits).decode()


@pytest.mark.parametrize(
    ("before", "after", "new"),
    [
        ('link="ba', "se", "trunk"),
        ("<xacro:le", 'g prefix="left"', "limb"),
        ('mass value="${ma', "s", "weight"),
        ("2 * ma", "ss", "kilos"),
        ("params=", '"prefix', "name_of"),
        ("$(arg si", "de", "hand"),
    ],
)
def test_renaming_changes_no_robot(tmp_path: Path, before: str, after: str, new: str) -> None:
    """The names of links aside, what it expands to stays the same."""
    file = edited(tmp_path, before, after)
    if after == '"prefix':
        file = edited(tmp_path, 'params="', "prefix")
    before_text = _expanded(tmp_path, MACRO)
    text = renamed(file, new)
    assert text != MACRO
    assert _expanded(tmp_path, text) == before_text.replace(
        '"base"', f'"{new}"' if new == "trunk" else '"base"'
    )


LENGTH = '<xacro:property name="length" value="2"/>'
ARG = '<xacro:arg name="si|de" default="true"/>'


@pytest.mark.parametrize(
    "text",
    [
        # The default of a parameter is evaluated where the macro is called.
        LENGTH.replace("th", "|th")
        + '<xacro:macro name="m" params="length:=${length}"><link name="a${length}"/></xacro:macro>'
        "<xacro:m/>",
        LENGTH + '<xacro:macro name="m" params="le|ngth:=${2 * length} b">'
        '<link name="${length}${b}"/></xacro:macro><xacro:m b="1"/>',
        # A word of a quoted default is no parameter.
        LENGTH + '<xacro:macro name="m" params="a:=\'big length\' b">'
        '<link name="${a}${b}${len|gth}"/></xacro:macro><xacro:m b="1"/>',
        '<xacro:macro name="m|m" params="c"/><xacro:call macro="mm" c="1"/>',
        '<xacro:macro name="mm" params="c|d"/><xacro:call macro="mm" cd="1"/>',
        ARG + '<link name="$(eval side)"/>',
        ARG + "<link name=\"${xacro.arg('side')}\"/>",
        LENGTH.replace("th", "|th") + "<link name=\"${dict(length=1)['length']}${length}\"/>",
    ],
)
def test_renaming_reaches_all_uses_and_nothing_else(tmp_path: Path, text: str) -> None:
    text = XACRO.replace("{}", text)
    file = Edited(tmp_path / "r.xacro", text)
    new = renamed(file, "other")
    assert new != text.replace("|", "")
    assert _expanded(tmp_path, new) == _expanded(tmp_path, text.replace("|", ""))


@pytest.mark.parametrize(("before", "after"), [("le", "ngth"), ("ar", "m")])
def test_renaming_reaches_uses_of_a_namespace(tmp_path: Path, before: str, after: str) -> None:
    part = LENGTH + '<xacro:macro name="arm" params="a"><link name="${a}"/></xacro:macro>'
    text = XACRO.replace(
        "{}",
        '<xacro:include filename="part.xacro" ns="p"/><link name="l${p.length}"/>'
        '<xacro:p.arm a="x"/>',
    )
    (tmp_path / "r.xacro").write_text(text)
    place = tmp_path / "part.xacro"
    place.write_text(XACRO.replace("{}", part))
    file = Edited(
        place, XACRO.replace("{}", part.replace(f'"{before}{after}"', f'"{before}|{after}"'))
    )
    edits = rename(file.robot, file.markup, file.offset, "other")
    expected = _expanded(tmp_path, text)
    for path in (place, tmp_path / "r.xacro"):
        own = [edit for edit in edits if Path(edit.span.source.path).name == path.name]
        assert len(own) == 1
        path.write_bytes(apply_edits(own[0].span.source.data, own))
    assert _expanded(tmp_path, (tmp_path / "r.xacro").read_text()) == expected


ROBOT = """<robot name="r"><link name="base"/><link name="cam"/>
<joint name="pan" type="revolute"><parent link="base"/><child link="cam"/></joint>
<gazebo reference="cam"><sensor name="s" type="camera"><gz_frame_id>cam</gz_frame_id>
<ignition_frame_id> cam </ignition_frame_id></sensor></gazebo>
<gazebo><joint name="loop" type="ball"><parent>base</parent><child>cam</child></joint></gazebo>
<ros2_control name="c" type="sensor"><sensor name="f"><param name="frame_id">cam</param></sensor>
<joint name="tilt"><param name="mimic">pan</param></joint></ros2_control></robot>"""


@pytest.mark.parametrize(("name", "count"), [("cam", 7), ("pan", 2)])
def test_renaming_reaches_the_texts_of_elements(tmp_path: Path, name: str, count: int) -> None:
    """The frame of a sensor, the ends of a joint of Gazebo, and parameters of ros2_control."""
    assert len(re.findall(rf"\b{name}\b", ROBOT)) == count
    file = Edited(tmp_path / "r.urdf", ROBOT.replace(f'"{name}', f'"|{name}', 1))
    assert renamed(file, "other") == re.sub(rf"\b{name}\b", "other", ROBOT)


@pytest.mark.parametrize("name", ["property", "params"])
def test_a_property_that_a_macro_forwards_is_not_renamed(tmp_path: Path, name: str) -> None:
    """``length:=^`` passes the property of the parameter's name."""
    text = XACRO.replace(
        "{}",
        LENGTH
        + '<xacro:macro name="m" params="length:=^|1"><link name="a${length}"/></xacro:macro>'
        "<xacro:m/>",
    )
    file = Edited(tmp_path / "r.xacro", text)
    file.offset = text.index("length", text.index(name))
    with pytest.raises(CannotRename, match=r"the macro at r\.xacro:2 forwards 'length'"):
        rename(file.robot, file.markup, file.offset, "other")


def _expanded(directory: Path, text: str) -> str:
    (directory / "x.xacro").write_text(text)
    return urdfkit.expand(directory / "x.xacro").text().replace("x.xacro", "")


def test_renaming_a_link_of_the_mission_renames_it_everywhere() -> None:
    file = Edited(MISSION, mission('<link name="base_', 'link"'))
    text = renamed(file, "chassis")
    file.type(text)
    assert file.robot.model is not None
    assert "chassis" in file.robot.model.links_by_name
    codes = [d.code for d in file.workspace.check(file.path).diagnostics[file.path]]
    untouched = Workspace()
    untouched.set_text(file.path, MISSION.read_bytes())
    assert codes == [d.code for d in untouched.check(file.path).diagnostics[file.path]]


@pytest.mark.parametrize(
    ("before", "after", "new", "why"),
    [
        ('reference="left', "_leg", "x", "_leg' at r.xacro:5 comes from an expression"),
        ('link="ba', "se", "left_leg", "there is already a link 'left_leg'"),
        ('link="ba', "se", "<a>", "is not a valid name"),
        ('link="ba', "se", " ", "is not a valid name"),
        ("2 * ma", "ss", "a b", "not a valid name for a property"),
        ("<rob", "ot", "x", "no name to rename here"),
    ],
)  # fmt: skip
def test_what_cannot_be_renamed_is_refused(tmp_path, before, after, new, why) -> None:
    file = edited(tmp_path, before, after)
    with pytest.raises(CannotRename, match=why):
        rename(file.robot, file.markup, file.offset, new)


def test_a_name_that_is_given_nowhere_is_not_renamed(tmp_path: Path) -> None:
    file = edited(tmp_path, "sq", "rt", text=MACRO.replace("2 * mass", "sqrt(mass)"))
    with pytest.raises(CannotRename, match="'sqrt' is not defined"):
        rename(file.robot, file.markup, file.offset, "x")


LAUNCH = """\
<launch>
  <param name="robot_description"
    command="$(find xacro)/xacro $(find arm)/robots/arm.xacro side:=left"/>
  <include file="$(find arm)/launch/other.launch"/>
</launch>
"""
PYTHON_LAUNCH = """\
from launch.substitutions import Command
package = FindPackageShare("arm")
content = Command(["xacro ", PathJoinSubstitution([package, "robots", "arm.xacro"]), " side:=left"])
rviz = Node(package="rviz2", arguments=["-d", PathJoinSubstitution([package, "view.rviz"])])
"""


@pytest.mark.parametrize(
    ("file", "text", "before", "after", "expected"),
    [
        ("arm.launch", LAUNCH, "robots/a", "rm.xacro", "robots/arm.xacro"),
        ("arm.launch", LAUNCH, "$(find a", "rm)/robots", "package.xml"),
        ("arm.launch", LAUNCH, "other", ".launch", "launch/other.launch"),
        ("arm.launch", LAUNCH, "robot_desc", "ription", ""),
        ("arm.launch.py", PYTHON_LAUNCH, '"robots", "a', 'rm.xacro"', "robots/arm.xacro"),
        ("arm.launch.py", PYTHON_LAUNCH, '"view', '.rviz"', "view.rviz"),
        ("arm.launch.py", PYTHON_LAUNCH, "from la", "unch", ""),
    ],
)
def test_from_a_launch_file_to_the_files_that_it_names(
    tmp_path: Path, file: str, text: str, before: str, after: str, expected: str
) -> None:
    for name in ("robots/arm.xacro", "launch/other.launch", "view.rviz"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text('<robot name="arm"/>' if "xacro" in name else "<launch/>")
    (tmp_path / "package.xml").write_text("<package><name>arm</name></package>")
    assert before + after in text
    here = Edited(tmp_path / "launch" / file, text.replace(before + after, f"{before}|{after}", 1))
    found = [span.source.path for span in definitions(here.robot, here.markup, here.offset)]
    assert found == ([str(tmp_path / expected)] if expected else [])
