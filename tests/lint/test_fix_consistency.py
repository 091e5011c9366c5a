"""Text that robots, variants and calls of a macro share is edited where all of them agree."""

import os
from pathlib import Path

import pytest

from tests.fixing import FIXED_JOINT, SEVERITIES, fix, write
from tests.xacros import NAMESPACE
from urdfkit.lint.config import Config, RobotEntry
from urdfkit.lint.engine import check
from urdfkit.text.diagnostic import Severity


@pytest.fixture
def fleet(tmp_path: Path) -> Path:
    """Two robots that include one file with a defect, each with one of its own."""
    write(tmp_path, "shared.xacro", FIXED_JOINT, NAMESPACE)
    include = '<xacro:include filename="shared.xacro"/>\n'
    own = FIXED_JOINT.replace('"a"', '"b"').replace('name="b"/>\n', "", 1)
    own = own.replace('<link name="b"/>', '<link name="c"/>').replace(
        'child link="b"', 'child link="c"'
    )
    own = own.replace("  <link   <link", "  <link").replace('name="j"', 'name="own"')
    for name in ("one", "two"):
        write(tmp_path, f"{name}.urdf.xacro", include + own, NAMESPACE)
    return tmp_path


def test_a_file_of_several_robots_is_edited_once(fleet: Path) -> None:
    assert check(fleet).count(Severity.ERROR) == 0
    fixes = fix(fleet)
    assert sorted(os.path.basename(file.path) for file in fixes.files) == [
        "one.urdf.xacro",
        "shared.xacro",
        "two.urdf.xacro",
    ]
    assert all(b"axis" not in file.after for file in fixes.files)
    shared = next(file for file in fixes.files if "shared" in file.path)
    assert shared.after.count(b"<!-- stays -->") == 1


def test_what_another_robot_needs_is_kept(tmp_path: Path) -> None:
    """'arm_lnk' is a typo in one robot, which has 'arm_link', and right in the other."""
    joint = '<joint name="j" type="fixed"><parent link="base"/><child link="arm_lnk"/></joint>\n'
    write(tmp_path, "shared.xacro", f'<link name="base"/>\n{joint}', NAMESPACE)
    include = '<xacro:include filename="shared.xacro"/>\n'
    one = write(tmp_path, "one.urdf.xacro", f'{include}<link name="arm_link"/>\n', NAMESPACE)
    alone = fix(one, unsafe=True)
    assert [d.code for d in alone.applied] == ["REF001"]
    write(tmp_path, "two.urdf.xacro", f'{include}<link name="arm_lnk"/>\n', NAMESPACE)
    for files in ((one,), (tmp_path,), (one, tmp_path / "two.urdf.xacro")):
        fixes = fix(*files, unsafe=True)
        assert fixes.files == ()
        assert ("REF001", "skipped: another robot uses this text and is correct as it is") in {
            (left.diagnostic.code, left.reason) for left in fixes.left
        }


MACRO = """\
  <xacro:macro name="pair" params="name type">
    <link name="${name}"/>
    <joint name="${name}_joint" type="${type}">
      <parent link="base"/><child link="${name}"/>
      <axis xyz="0 0 1"/>
    </joint>
  </xacro:macro>
  <link name="base"/>
  <xacro:pair name="a" type="fixed"/>
"""


@pytest.mark.parametrize(("other", "agree"), [("fixed", True), ("continuous", False)])
def test_a_macro_is_edited_only_where_all_calls_agree(
    tmp_path: Path, other: str, agree: bool
) -> None:
    call = f'  <xacro:pair name="b" type="{other}"/>\n'
    fixes = fix(write(tmp_path, "r.xacro", MACRO + call, NAMESPACE))
    assert [one.code for one in fixes.applied] == ["JNT020"] * agree
    found = [left.diagnostic for left in fixes.left if left.diagnostic.code == "JNT020"]
    assert [one.fix for one in found] == [None] * (not agree)


TYPED = """\
  <xacro:arg name="type" default="fixed"/>
  <link name="a"/>
  <link name="b"/>
  <joint name="j" type="$(arg type)">
    <parent link="a"/><child link="b"/>
    <axis xyz="0 0 1"/>
  </joint>
"""


@pytest.mark.parametrize(("other", "agree"), [("fixed", True), ("continuous", False)])
def test_variants_must_agree_on_what_they_share(tmp_path: Path, other: str, agree: bool) -> None:
    file = str(write(tmp_path, "r.xacro", TYPED, NAMESPACE))
    robots = (RobotEntry(file, "one", {}), RobotEntry(file, "two", {"type": other}))
    fixes = fix(file, config=Config(robots=robots, severities=SEVERITIES))
    assert [one.code for one in fixes.applied] == ["JNT020"] * agree
    reasons = {left.reason for left in fixes.left if left.diagnostic.code == "JNT020"}
    text = "skipped: another robot uses this text and is correct as it is"
    assert reasons == (set() if agree else {text})


@pytest.mark.parametrize(("other", "agree"), [("fixed", True), ("continuous", False)])
def test_robots_that_were_not_named_must_agree_as_well(
    tmp_path: Path, other: str, agree: bool
) -> None:
    write(tmp_path, "part.xacro", TYPED, NAMESPACE)
    include = '  <xacro:include filename="part.xacro"/>\n'
    one = write(tmp_path, "one.urdf.xacro", include, NAMESPACE)
    argument = f'  <xacro:arg name="type" default="{other}"/>\n'
    write(tmp_path, "two.urdf.xacro", argument + include, NAMESPACE)
    assert [found.code for found in fix(one).applied] == ["JNT020"] * agree
    assert [found.code for found in fix(tmp_path).applied] == ["JNT020"] * agree


BLOCK = """\
  <xacro:property name="turn"><axis xyz="0 0 2"/></xacro:property>
  <link name="a"/><link name="b"/><link name="c"/>
  <joint name="i" type="continuous">
    <parent link="a"/><child link="b"/><xacro:insert_block name="turn"/>
  </joint>
  <joint name="j" type="{}">
    <parent link="b"/><child link="c"/><xacro:insert_block name="turn"/>
  </joint>
"""


@pytest.mark.parametrize(("other", "agree"), [("continuous", True), ("fixed", False)])
def test_a_block_that_is_inserted_twice_is_edited_for_both(
    tmp_path: Path, other: str, agree: bool
) -> None:
    """Two joints that move want a unit axis; a fixed one beside a moving one wants none."""
    file = write(tmp_path, "r.xacro", BLOCK.format(other), NAMESPACE)
    fixes = fix(file, unsafe=True, select=["JNT006", "JNT020"])
    assert [one.code for one in fixes.applied] == ["JNT006"] * 2 * agree
    text = fixes.files[0].after.decode() if fixes.files else file.read_text()
    assert ('<axis xyz="0 0 1"/>' in text) is agree
