"""A macro that is called without its prefix makes no link: one finding, where it stands."""

from pathlib import Path

import pytest

from tests.xacros import NAMESPACE
from urdfkit import Source, check, fix

ROBOT = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:macro name="arm" params="side">
  <link name="${{side}}_arm">
    <inertial><mass value="1"/>
      <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/></inertial>
  </link>
  <joint name="${{side}}" type="fixed">
    <parent link="base"/><child link="${{side}}_arm"/>
  </joint>
</xacro:macro>
<link name="base"/>
<{call} side="left"/>
<link name="hand"/>
<joint name="wrist" type="fixed"><parent link="left_arm"/><child link="hand"/></joint>
<gazebo reference="left_arm"><material>Gazebo/Red</material></gazebo>
</robot>
"""


def codes(directory: Path, call: str, ignore: tuple[str, ...] = ()) -> set[str]:
    robot = directory / "r.urdf.xacro"
    robot.write_text(ROBOT.format(call=call))
    report = check(robot, targets=["gz-harmonic"], ignore=ignore)
    return {one.code for one in report.diagnostics}


def test_what_follows_from_it_is_silent(tmp_path: Path) -> None:
    assert codes(tmp_path, "arm") == {"XAC002"}
    assert codes(tmp_path, "xacro:arm") == {"GEO002"}


def test_who_does_not_want_to_know_of_it_hears_of_the_rest(tmp_path: Path) -> None:
    found = codes(tmp_path, "arm", ignore=("XAC002",))
    assert found >= {"INE004", "REF001", "GAZ001"}


MISSPELT = """<link name="tool"/>
<joint name="t" type="fixed"><parent link="hamd"/><child link="tool"/></joint>"""


#: Each is the cause of a child link that is not there.
UNEXPANDED = [
    ("XAC003", '<xacro:wheel name="left"/>', "plain.urdf"),
    ("XAC003", '<link name="${side}_wheel"/>', "plain.urdf"),
    ("XAC003", '<xacro:property name="side" value="left"/><link name="{side}_wheel"/>', "r.xacro"),
]


@pytest.mark.parametrize(("code", "cause", "name"), UNEXPANDED)
def test_what_is_not_expanded_is_the_error(
    code: str, cause: str, name: str, tmp_path: Path
) -> None:
    robot = tmp_path / name
    robot.write_text(f"""<robot name="r" {NAMESPACE if "xacro" in cause else ""}>
    <link name="base"/>{cause}
    <joint name="j" type="fixed"><parent link="base"/><child link="left_wheel"/></joint></robot>""")
    report = check(robot, ignore=["XAC004"])
    assert [(one.code, one.severity.value) for one in report.diagnostics] == [(code, "error")]
    ignored = {one.code for one in check(robot, ignore=[code]).diagnostics}
    assert "REF001" in ignored


def test_a_number_that_is_not_expanded_hides_no_link(tmp_path: Path) -> None:
    robot = tmp_path / "r.urdf"
    robot.write_text("""<robot name="r"><link name="base"><inertial><mass value="${m}"/></inertial>
    </link><joint name="j" type="fixed"><parent link="base"/><child link="arm"/></joint></robot>""")
    assert {"XAC003", "REF001"} <= {one.code for one in check(robot).diagnostics}


def test_the_fix_of_the_cause_may_reveal_another_error(tmp_path: Path) -> None:
    text = ROBOT.format(call="arm").replace("</robot>", MISSPELT + "</robot>")
    (tmp_path / "r.xacro").write_text(text)
    fixes = fix(tmp_path / "r.xacro", unsafe=True)
    assert [one.code for one in fixes.applied] == ["XAC002"]
    assert "REF001" in {one.code for one in fixes.report.diagnostics}


@pytest.mark.parametrize("count", [0, 1])
def test_what_the_macro_would_make_is_not_missing(tmp_path: Path, count: int) -> None:
    """rbkairos_description: <solid_cuboid_inertia> without xacro: in <inertial>."""
    macro = '<xacro:macro name="cuboid"><inertia ixx="1" iyy="1" izz="1"/></xacro:macro>'
    text = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        f'{"" if count else macro}<link name="a"><inertial><mass value="1"/><cuboid/></inertial>'
        "</link></robot>"
    )
    path = tmp_path / "r.xacro"
    path.write_text(text)
    assert len(check(path, select=["URD004"]).diagnostics) == count


def test_a_macro_of_the_first_years_is_named_as_the_cause() -> None:
    """eusurdf: `<macro name=... params="name">`, without the namespace of xacro."""
    robot = '<robot name="r"><macro name="m" params="name"><link name="${name}"/></macro></robot>'
    report = check(Source("r.urdf.xacro", robot.encode()), select=["XAC001"])
    assert [one.message for one in report.diagnostics] == [
        "<macro> without xacro: defines no macro, so name 'name' is not defined in ${name}"
    ]
