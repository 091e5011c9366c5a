"""What is checked of a directory, and what is said of the rest."""

from pathlib import Path

import pytest

from tests.lint.directories import CART, write
from tests.workspaces import add_file, add_package
from tests.xacros import xacro
from urdfkit import check
from urdfkit.lint.config import Config
from urdfkit.lint.options import Options

LAUNCH = """<launch>
<param name="robot_description" command="xacro $(find pkg)/urdf/cart.xacro"/>
<rosparam file="$(find pkg)/c.yaml"/>
</launch>"""


def test_a_dangling_link_hides_no_robot(tmp_path):
    (tmp_path / "a.urdf").symlink_to(tmp_path / "gone.urdf")
    (tmp_path / "b.urdf").write_text('<robot name="b"><link name="a"/></robot>')
    assert check(tmp_path).files == (str(tmp_path / "b.urdf"),)


def test_robots_of_a_directory_are_spelt_as_the_directory_was(tmp_path, monkeypatch):
    (tmp_path / "robots").mkdir()
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "robots" / "b.urdf").write_text('<robot name="b"><link name="a"/></robot>')
    monkeypatch.chdir(tmp_path / "elsewhere")
    assert check("../robots").files == ("../robots/b.urdf",)
    assert check(tmp_path / "robots").files == (str(tmp_path / "robots" / "b.urdf"),)
    monkeypatch.chdir(tmp_path)
    assert check("robots").files == check(tmp_path / "robots").files == ("robots/b.urdf",)


def test_a_launch_file_computes_the_name_of_a_robot_with_any_suffix(tmp_path):
    (tmp_path / "b.urdf").write_text('<robot name="b"><link name="a"/></robot>')
    robot = tmp_path / "r.description"
    robot.write_text('<robot name="r"><link name="a"/></robot>')
    launch = tmp_path / "a.launch.py"
    launch.write_text(
        "import xacro\nfrom launch import LaunchDescription\nfrom launch_ros.actions import Node\n"
        "def generate_launch_description():\n    name = 'r'\n"
        f"    text = xacro.process_file(f'{tmp_path}/{{name}}.description').toxml()\n"
        '    return LaunchDescription([Node(parameters=[{"robot_description": text}])])\n'
    )
    report = check(tmp_path)
    assert set(report.files) == {str(tmp_path / "b.urdf"), str(launch), str(robot)}
    assert report.skipped == ()
    launch.write_text("def generate_launch_description(): ...")
    assert [skip.path for skip in check(tmp_path).skipped] == [str(robot)]


def test_what_a_launch_file_of_another_package_gives_is_enough(tmp_path):
    """And what is excluded is no robot of the directory, though a launch file starts it."""
    for name in ("arm", "bringup"):
        add_package(tmp_path / name, name)
    body = '<link name="$(arg side)base"/>'
    robot = add_file(tmp_path / "arm" / "r.urdf.xacro", xacro(body).encode())
    start = "<launch><param name='robot_description' command='xacro $(find arm)/r.urdf.xacro {}'/>"
    launch = tmp_path / "bringup" / "a.launch"
    for given, codes in (("side:=x", []), ("other:=x", ["CFG003"])):
        launch.write_text(start.format(given) + "</launch>")
        report = check(tmp_path, select=["TRE"])
        assert [one.code for one in report.diagnostics] == codes
        assert bool(report.skipped) == bool(codes)
    launch.write_text(start.format("side:=x") + "</launch>")
    report = check(tmp_path, select=["TRE"], config=Config(exclude=(f"{robot}", "*/arm/*")))
    assert report.files == (str(launch),)


def test_a_directory_is_checked_and_the_library_is_reported(package):
    report = check(package)
    assert len(report.files) == 2
    assert [(Path(skip.path).name, skip.code) for skip in report.skipped] == [("lonely.xacro", "")]


@pytest.mark.parametrize(
    ("file", "text"),
    [
        ("demo.launch", '<launch><node pkg="p" name="n" type="t"/></launch>'),
        ("macros.xacro", "<robot><xacro:macro name='m'><link name='a'/></xacro:macro></robot>"),
    ],
)
def test_a_directory_without_a_robot_is_not_green(tmp_path: Path, file: str, text: str) -> None:
    (tmp_path / file).write_text(text)
    (found,) = [d for d in check(tmp_path).diagnostics if d.code == "CFG003"]
    assert found.message.startswith("no robot checked in ")
    assert (Path(found.span.source.path).name, found.severity.value) == (file, "warning")
    assert "CFG003" not in {d.code for d in check(tmp_path, ignore=["CFG003"]).diagnostics}
    write(tmp_path, "r.urdf", '<link name="a"/>')
    assert "CFG003" not in {d.code for d in check(tmp_path).diagnostics}


def test_a_found_robot_that_needs_arguments_is_not_checked(tmp_path):
    path = write(tmp_path, "r.xacro", '<link name="$(arg side)_a"/>')
    report = check(tmp_path)
    assert [(d.code, d.severity.value) for d in report.diagnostics] == [("CFG003", "warning")]
    (skip,) = report.skipped
    assert "side" in skip.reason
    assert [d.code for d in check(path).diagnostics] == ["XAC010"]


def test_the_launch_files_of_a_directory_are_checked(package):
    (package / "launch").mkdir()
    (package / "launch" / "a.launch").write_text("<launch><group></launch>")
    (package / "launch" / "gone.launch").symlink_to("nowhere")
    report = check(package, select=["LAU"])
    assert [(d.code, Path(d.span.source.path).name) for d in report.diagnostics] == [
        ("LAU001", "a.launch")
    ]
    config = Config(path=str(package / "urdfkit.toml"), exclude=("launch",))
    assert check(package, select=["LAU"], config=config).diagnostics == ()


def test_the_controllers_that_launch_files_load_are_compared_with_the_robots(package):
    write(package, "urdf/cart.xacro", CART)
    (package / "c.yaml").write_text(
        "grip:\n  type: position_controllers/JointPositionController\n  joint: axel\n"
    )
    (package / "launch").mkdir()
    (package / "launch" / "a.launch").write_text(LAUNCH)
    report = check(package / "urdf", package)
    (found,) = (d for d in report.diagnostics if d.code == "RCT001")
    assert "joint 'axel'" in found.message
    assert found.span.source.path == str(package / "c.yaml")
    assert [Path(file).name for file in report.files].count("cart.xacro") == 1


def test_a_directory_of_launch_files_alone_is_checked(tmp_path):
    (tmp_path / "a.launch").write_text("<launch><group></launch>")
    report = check(tmp_path, select=["LAU"])
    assert [found.code for found in report.diagnostics] == ["CFG003", "LAU001"]


def test_a_robot_is_checked_with_the_arguments_of_launch_files(package):
    """What is left out without them is reported once."""
    (package / "urdf").mkdir(exist_ok=True)
    (package / "urdf" / "arm.urdf.xacro").write_text(
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        '<xacro:arg name="sim" default="false"/><link name="base"/>'
        '<xacro:if value="$(arg sim)"><gazebo reference="bsae"><mu1>1</mu1></gazebo></xacro:if>'
        "</robot>"
    )
    (package / "launch").mkdir(exist_ok=True)
    for name in "ab":
        (package / "launch" / f"{name}.launch").write_text(
            '<launch><param name="robot_description" '
            'command="xacro $(dirname)/../urdf/arm.urdf.xacro sim:=true"/></launch>'
        )
    (found,) = check(package, select=["GAZ001"]).diagnostics
    assert found.span.text == "bsae"
    assert [step.name for step in found.calls[0].via] == ["a.launch"]


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("", "XML001"),
        ("version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 1\n", "XML001"),
        ('<robt name="r"><link name="a"/></robt>', "URD015"),
    ],
    ids=["empty", "a pointer of Git LFS", "misspelt"],
)
def test_a_urdf_without_a_robot_is_no_reason_for_a_green_report(
    tmp_path: Path, text: str, code: str
) -> None:
    write(tmp_path, "good.urdf", CART)
    (tmp_path / "lost.urdf").write_text(text)
    report = check(tmp_path)
    assert {Path(path).name for path in report.files} == {"good.urdf", "lost.urdf"}
    assert code in {found.code for found in report.diagnostics if found.severity.value == "error"}


def test_what_cannot_be_opened_is_reported(tmp_path: Path) -> None:
    write(tmp_path, "good.urdf", CART)
    (tmp_path / "lost.urdf").symlink_to(tmp_path / "nowhere")
    (skipped,) = [one for one in check(tmp_path).skipped if not one.code]
    assert (Path(skipped.path).name, skipped.reason.partition(";")[0]) == (
        "lost.urdf",
        "cannot be opened",
    )


def test_processes_give_the_same_report(package):
    write(package, "urdf/bad.urdf", '<link name="a"/><link name="a"/>')
    one, two = check(package), check(package, options=Options(jobs=2))
    assert [str(d.span) + d.message for d in one.diagnostics] == [
        str(d.span) + d.message for d in two.diagnostics
    ]
    assert one.diagnostics
