"""fix(): what is applied, what is refused or dropped, and how files are written."""

import os
import subprocess
from pathlib import Path
from typing import Any

import pytest

from tests.conftest import MODELS
from tests.fixing import FIXED_JOINT, SEVERITIES, fix, write
from tests.naming import naming
from tests.xacros import NAMESPACE
from urdfkit.errors import UnwritableFile
from urdfkit.lint import engine, fix_checker, processes, rule_index
from urdfkit.lint.config import Config
from urdfkit.lint.engine import check
from urdfkit.lint.fix import changes
from urdfkit.lint.fix_checker import SLOW
from urdfkit.lint.options import Options
from urdfkit.text.diagnostic import Severity

WITHOUT_AXIS = FIXED_JOINT.replace("    <axis xyz='0 1 0'/>\n", "")
#: A swap of limits, which is unsafe.
SWAPPED = """\
  <joint name="k" type="revolute">
    <parent link="a"/><child link="b"/>
    <axis xyz="0 1 0"/>
    <limit lower="0.9" upper="-0.8" effort="1" velocity="1"/>
  </joint>
"""


def test_a_safe_fix_is_applied_and_nothing_is_written_before_it_is_asked_for(
    tmp_path: Path,
) -> None:
    file = write(tmp_path, "r.urdf", FIXED_JOINT)
    before = file.read_bytes()
    fixes = fix(file)
    assert [one.code for one in fixes.applied] == ["JNT020"]
    assert "JNT020" not in {left.diagnostic.code for left in fixes.left}
    assert file.read_bytes() == before
    assert fixes.diff().splitlines()[3:] == [
        '   <link name="b"/>',
        '   <joint name="j" type="fixed">',
        '     <parent link="a"/><child link="b"/> <!-- stays -->',
        "-    <axis xyz='0 1 0'/>",
        "   </joint>",
        " </robot>",
    ]
    fixes.write()
    assert file.read_text() == before.decode().replace("    <axis xyz='0 1 0'/>\n", "")
    assert fix(file).files == ()


def test_the_diff_is_one_that_patch_takes(tmp_path: Path) -> None:
    write(tmp_path, "r.urdf", FIXED_JOINT)
    shown = "python -m urdfkit check --diff --select JNT020 r.urdf"
    done = f"cd {{}} && {shown} > r.diff; patch -p0 < r.diff"
    environment = {**os.environ, "PYTHONPATH": str(MODELS.parent)}
    subprocess.run(done.format(tmp_path), shell=True, check=True, env=environment)
    assert "axis" not in (tmp_path / "r.urdf").read_text()


def test_an_unsafe_fix_is_left_unless_asked_for(tmp_path: Path) -> None:
    file = write(tmp_path, "r.urdf", '<link name="a"/><link name="b"/>' + SWAPPED)
    careful, bold = fix(file), fix(file, unsafe=True)
    assert careful.applied == ()
    assert ("JNT003", "unsafe") in {(one.diagnostic.code, one.reason) for one in careful.left}
    assert [one.code for one in bold.applied] == ["JNT003"]
    assert b'lower="-0.8" upper="0.9"' in bold.files[0].after


@pytest.mark.parametrize(
    ("encoding", "mark"),
    [
        ("utf-8", b""),
        ("utf-8", b"\xef\xbb\xbf"),
        ("latin-1", b""),
        ("utf-16-le", b"\xff\xfe"),
        ("utf-16-be", b"\xfe\xff"),
    ],
)
@pytest.mark.parametrize("newline", ["\n", "\r\n"])
def test_encoding_mark_and_line_ends_are_kept(
    tmp_path: Path, encoding: str, mark: bytes, newline: str
) -> None:
    declared = "UTF-16" if encoding.startswith("utf-16") else encoding
    head = f'<?xml version="1.0" encoding="{declared}"?>\n<!-- é -->\n<robot name="r">\n'
    text = f"{head}{FIXED_JOINT}</robot>".replace("\n", newline)
    file = tmp_path / "r.urdf"
    file.write_bytes(mark + text.encode(encoding))
    fix(file).write()
    expected = text.replace(f"    <axis xyz='0 1 0'/>{newline}", "")
    assert file.read_bytes() == mark + expected.encode(encoding)


def test_mode_and_links_are_kept(tmp_path: Path) -> None:
    file = write(tmp_path, "real.urdf", FIXED_JOINT)
    file.chmod(0o640)
    link = tmp_path / "link.urdf"
    link.symlink_to("real.urdf")
    fix(link).write()
    assert link.is_symlink()
    assert "axis" not in file.read_text()
    assert file.stat().st_mode & 0o777 == 0o640


def test_a_file_that_changed_meanwhile_is_left_alone(tmp_path: Path) -> None:
    file = write(tmp_path, "r.urdf", FIXED_JOINT)
    fixes = fix(file)
    file.write_text("<robot/>")
    with pytest.raises(UnwritableFile, match="changed meanwhile"):
        fixes.write()
    assert file.read_text() == "<robot/>"


def test_a_fix_that_adds_an_error_is_dropped_and_the_others_are_applied(tmp_path: Path) -> None:
    """With the parent renamed to 'tool', the joints would be a cycle."""
    body = """\
  <link name="base"/><link name="gripper"/><link name="tool"/>
  <joint name="i" type="fixed"><parent link="base"/><child link="gripper"/></joint>
  <joint name="j" type="fixed"><parent link="toool"/><child link="base"/></joint>
  <joint name="k" type="fixed"><parent link="gripper"/><child link="tool"/>
    <axis xyz="1 0 0"/></joint>
"""
    fixes = fix(write(tmp_path, "r.urdf", body), unsafe=True)
    assert [one.code for one in fixes.applied] == ["JNT020"]
    reasons = {left.diagnostic.code: left.reason for left in fixes.left}
    assert reasons["REF001"] == naming("skipped", "TRE003")


def test_errors_that_were_hidden_do_not_forbid_a_fix(tmp_path: Path) -> None:
    file = tmp_path / "r.urdf"
    file.write_text(
        '\n<?xml version="1.0"?>\n<robot name="r"><link name="a"/><link name="a"/></robot>'
    )
    fixes = fix(file)
    assert [one.code for one in fixes.applied] == ["XML007"]
    assert [left.diagnostic.code for left in fixes.left if left.diagnostic.code == "NAM001"]


@pytest.mark.parametrize(
    "comment",
    [
        "This document was autogenerated by xacro from r.urdf.xacro",
        "EDITING THIS FILE BY HAND IS NOT RECOMMENDED",
        "Do not edit!",
    ],
)
def test_a_generated_file_is_refused_unless_forced(tmp_path: Path, comment: str) -> None:
    file = write(tmp_path, "r.urdf", f"<!-- {comment} -->\n{FIXED_JOINT}")
    assert fix(file).files == ()
    assert {left.reason for left in fix(file).left if left.diagnostic.fix} == {
        "the file is generated: fix the file that it is generated from"
    }
    assert len(fix(file, force=True).files) == 1


def test_a_comment_on_an_element_makes_no_generated_file(tmp_path: Path) -> None:
    file = write(tmp_path, "r.urdf", f'<link name="x"/><!-- do not edit -->\n{FIXED_JOINT}')
    assert len(fix(file).files) == 1


def test_ignored_files_and_those_outside_are_refused(tmp_path: Path) -> None:
    repository, outside = tmp_path / "here", tmp_path / "there"
    for directory in (repository, outside):
        write(directory, "part.xacro", FIXED_JOINT, NAMESPACE)
        needs = "<depend>there</depend>"
        (directory / "package.xml").write_text(
            f"<package><name>{directory.name}</name>{needs}</package>"
        )
        subprocess.run(["git", "init", "-q", str(directory)], check=True)
    file = write(
        repository, "r.xacro", '<xacro:include filename="$(find there)/part.xacro"/>', NAMESPACE
    )
    packages = {"there": str(outside)}
    fixes = fix(file, packages=packages)
    assert fixes.files == ()
    assert {left.reason for left in fixes.left} - {""} == {"the file is outside the workspace"}
    assert len(fix(file, packages=packages, force=True).files) == 1
    (repository / ".gitignore").write_text("part.xacro\n")
    reasons = {left.reason for left in fix(repository / "part.xacro").left} - {""}
    assert reasons == {"git ignores the file, so it is probably generated"}


def test_with_some_rules_only_the_others_still_guard(tmp_path: Path) -> None:
    body = """\
  <link name="base"/><link name="gripper"/>
  <joint name="i" type="fixed"><parent link="base"/><child link="gripper"/></joint>
  <joint name="j" type="fixed"><parent link="griper"/><child link="base"/></joint>
"""
    file = write(tmp_path, "r.urdf", body)
    fixes = fix(file, unsafe=True, select=["REF"])
    assert [(left.diagnostic.code, left.reason) for left in fixes.left] == [
        ("REF001", naming("skipped", "TRE003"))
    ]


def test_overlapping_fixes_take_turns(tmp_path: Path) -> None:
    """The axis of a fixed joint that is no unit vector either: removed first, nothing remains."""
    body = FIXED_JOINT.replace("'0 1 0'", "'0 2 0'")
    fixes = fix(write(tmp_path, "r.urdf", body), unsafe=True)
    assert {left.diagnostic.code for left in fixes.left}.isdisjoint({"JNT006", "JNT020"})


def test_bytes_that_are_no_text_are_not_touched(tmp_path: Path) -> None:
    file = write(tmp_path, "r.urdf", FIXED_JOINT)
    file.write_bytes(file.read_bytes().replace(b"stays", b"st\xffys"))
    assert fix(file, force=True).files == ()


def test_a_read_only_file_is_not_replaced(tmp_path: Path) -> None:
    file = write(tmp_path, "r.urdf", FIXED_JOINT)
    file.chmod(0o444)
    assert {left.reason for left in fix(file).left if left.diagnostic.fix} == {
        "the file is read-only"
    }
    assert len(fix(file, force=True).files) == 1


def test_a_launch_file_leads_to_its_robot(tmp_path: Path) -> None:
    package = tmp_path / "pkg"
    robot = write(package, "r.urdf", FIXED_JOINT)
    (package / "package.xml").write_text("<package><name>pkg</name></package>")
    launch = package / "show.launch"
    launch.write_text(
        '<launch><param name="robot_description" textfile="$(find pkg)/r.urdf"/></launch>'
    )
    fixes = fix(launch)
    assert [os.path.realpath(file.path) for file in fixes.files] == [os.path.realpath(robot)]


def test_a_robot_that_a_launch_file_gives_controllers_disputes_no_fix(tmp_path: Path) -> None:
    """That robot is asked the rules about controllers only, and asks for no other edit."""
    write(tmp_path, "r.urdf", FIXED_JOINT)
    (tmp_path / "arm.yaml").write_text("arm_controller:\n  type: x\n")
    (tmp_path / "arm.launch").write_text(
        '<launch><param name="robot_description" textfile="$(dirname)/r.urdf"/>'
        '<rosparam file="$(dirname)/arm.yaml"/></launch>'
    )
    assert len(fix(tmp_path).files) == len(fix(tmp_path / "r.urdf").files) == 1


PREFIX = """\
  <link name="base"/>
  <xacro:macro name="arm" params="side">
    <link name="${side}_arm"/>
    <joint name="${side}" type="revolute">
      <parent link="base"/><child link="${side}_arm"/>
      <limit lower="0.5" upper="-0.5" effort="1" velocity="1"/>
    </joint>
  </xacro:macro>
"""


def test_a_defect_that_a_fix_reveals_does_not_forbid_it(tmp_path: Path) -> None:
    """Without its prefix the macro was not called, so that nobody saw its limits."""
    file = write(tmp_path, "r.xacro", f'{PREFIX}  <arm side="left"/>\n', NAMESPACE)
    assert {one.code for one in check(file).diagnostics if one.severity is Severity.ERROR} == {
        "XAC002"
    }
    fixes = fix(file, unsafe=True)
    assert [one.code for one in fixes.applied] == ["XAC002", "JNT003"]
    assert (
        fix(
            file, unsafe=True, options=Options(texts={fixes.files[0].path: fixes.files[0].after})
        ).files
        == ()
    )
    alone = fix(file, unsafe=True, select=["XAC002"])
    assert [one.code for one in alone.applied] == ["XAC002"]


def test_the_same_typo_in_an_element_that_a_fix_reveals_does_not_forbid_it(
    tmp_path: Path,
) -> None:
    body = """\
  <link name="a">
    <inertial><orgin xzy="0 0 1"/><mass value="1"/></inertial>
    <visual><origin xzy="0 0 1"/><geometry><sphere radius="1"/></geometry></visual>
  </link>
"""
    file = write(tmp_path, "r.urdf", body)
    fixes = fix(file, unsafe=True, select=["URD001", "URD002"])
    assert [one.code for one in fixes.applied] == ["URD001", "URD002", "URD002"]
    (rewrite,) = fixes.files
    assert rewrite.after.count(b'<origin xyz="0 0 1"/>') == 2


def test_a_defect_that_a_fix_makes_where_all_could_be_seen_forbids_it(tmp_path: Path) -> None:
    """Both names would be 'left_arm'."""
    calls = '  <link name="left_arm"/>\n  <arm side="left"/>\n'
    text = PREFIX.replace('"0.5" upper="-0.5"', '"-0.5" upper="0.5"')
    fixes = fix(write(tmp_path, "r.xacro", text + calls, NAMESPACE), unsafe=True)
    assert [one.code for one in fixes.applied] == []
    reasons = {left.diagnostic.code: left.reason for left in fixes.left}
    assert reasons["XAC002"] == naming("skipped", "NAM001")


def test_rules_that_are_left_out_of_the_guard_have_no_fix() -> None:
    slow = [rule for rule in rule_index.all_rules() if rule.needs & SLOW]
    assert {"COL001", "SRD009"} <= {rule.code for rule in slow}
    assert [rule.code for rule in slow if rule.fixable] == []


def test_many_fixes_cost_three_checks(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Before, with all fixes together, and of what people asked for; halves only on conflict."""
    count = 40
    parts = (
        f'<link name="l{n}"/><joint name="j{n}" type="fixed"><parent link="base"/>\n'
        f'<child link="l{n}"/>\n<axis xyz="0 1 0"/>\n</joint>'
        for n in range(count)
    )
    path = write(tmp_path, "r.urdf", '<link name="base"/>' + "".join(parts))
    checked: list[object] = []

    def counting(*arguments: Any, **options: Any) -> object:
        checked.append(arguments)
        return engine.check_with(*arguments, **options)

    monkeypatch.setattr(fix_checker, "check_with", counting)
    fixes = fix(path, select=["JNT020"])
    assert len(fixes.applied) == count
    assert len(checked) <= 3
    checked.clear()
    config = Config(severities=SEVERITIES)
    only = changes([path], Options(select=("JNT020",), config=config), unsafe=False, force=False)
    assert only.files == fixes.files
    assert len(checked) == 2  # for a diff, what is left does not matter
    changed = [line for line in fixes.diff().splitlines() if line.startswith(("-", "+"))]
    assert len(changed) == 2 + len(fixes.applied)  # the names of the file, and a line for each


def test_the_processes_of_a_check_serve_the_next_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """They know the meshes already."""
    made: list[int] = []

    def counting(count: int, known: processes.Known) -> object:
        made.append(count)
        return make(count, known)

    make = processes._pool
    monkeypatch.setattr(processes, "_pool", counting)
    files = [write(tmp_path, f"{name}.urdf", FIXED_JOINT) for name in "ab"]
    fixes = fix(*files, select=["JNT020"], options=Options(jobs=2))
    assert len(fixes.files) == 2
    assert made == [2]


def test_a_fix_that_breaks_a_robot_is_searched_for_with_that_robot_alone(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of 22 fixes of a forklift two broke a xacro, and all robots were checked 24 times."""
    sound = [write(tmp_path, f"{number}.urdf", FIXED_JOINT) for number in range(6)]
    macro = '<xacro:macro name="part" params="size"><link name="p"/></xacro:macro><part/>'
    broken = write(tmp_path, "r.xacro", f"{macro}{FIXED_JOINT}", attributes=NAMESPACE)
    checked: list[int] = []

    def counting(options: Options, files: Any, *arguments: Any, **keywords: Any) -> object:
        checked.append(len(files))
        return engine.check_with(options, files, *arguments, **keywords)

    monkeypatch.setattr(fix_checker, "check_with", counting)
    fixes = fix(*sound, broken, select=["JNT020", "XAC002"], unsafe=True)
    assert [finding.code for finding in fixes.applied] == ["JNT020"] * 7
    (left,) = [item for item in fixes.left if item.diagnostic.code == "XAC002"]
    assert left.reason == f"dropped: with it, {broken} could not be checked any more"
    assert checked.count(1) > checked.count(7) == 4
