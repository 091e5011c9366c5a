from pathlib import Path

import pytest

from tests.naming import naming
from tests.workspaces import add_file
from urdfkit import Diagnostic, check

MESH = '<visual><geometry><mesh filename="{}"/></geometry></visual>'
LAUNCH = "IncludeLaunchDescription(share('ros_gz_sim') / 'gz_sim.launch.py')\n"
ROBOT = """<robot name="r"><link name="base">
{}
</link></robot>"""
OWN = "package://arm/meshes/a.stl"


def reported(
    directory: Path, *meshes: str, launch: str = LAUNCH, target: str = "gz-harmonic"
) -> list[Diagnostic]:
    """The findings of a workspace with one package, which starts Gazebo unless told otherwise."""
    package = directory / "src" / "arm"
    (directory / ".git").mkdir(exist_ok=True)
    for name in ("urdf", "meshes", "launch"):
        (package / name).mkdir(parents=True, exist_ok=True)
    if not (package / "package.xml").exists():
        (package / "package.xml").write_text("<package><name>arm</name></package>")
    (package / "meshes" / "a.stl").write_text("solid")
    (package / "launch" / "sim.launch.py").write_text(launch)
    file = package / "urdf" / "r.urdf"
    file.write_text(ROBOT.format("\n".join(map(MESH.format, meshes or [OWN]))))
    report = check(file, select=["PKG004"], targets=[target])
    assert report.crashed == ()
    return list(report.diagnostics)


def test_nothing_tells_gazebo(tmp_path: Path) -> None:
    add_file(tmp_path / "src" / "arm" / "meshes" / "b.stl")
    (found,) = reported(tmp_path, OWN, OWN, OWN.replace("a.stl", "b.stl"))
    assert found.message == naming(
        "Gazebo", OWN, "1", "nothing", "GZ_SIM_RESOURCE_PATH", "gazebo_model_path"
    )
    assert (found.span.line, found.span.text) == (2, OWN)
    assert found.related[0].span.source.path.endswith("launch/sim.launch.py")


def test_the_variable_is_that_of_the_target(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, target="classic-ros2")
    assert "sets GAZEBO_MODEL_PATH or" in found.message


@pytest.mark.parametrize("target", ["classic-ros1", "moveit", "ros1"])
def test_others_resolve_packages_by_themselves(tmp_path: Path, target: str) -> None:
    assert reported(tmp_path, target=target) == []


@pytest.mark.parametrize(
    ("file", "text"),
    [
        ("src/arm/hooks/arm.dsv.in", "prepend-non-duplicate;GZ_SIM_RESOURCE_PATH;share"),
        ("src/bringup/launch/all.launch.py", "SetEnvironmentVariable('GAZEBO_MODEL_PATH', x)"),
        ("README.md", "export GZ_SIM_RESOURCE_PATH=..."),
        (
            "src/arm/launch/spawn.launch.py",
            "text = text.replace(\n  'package://arm/', f'{share}/')",
        ),
        ("src/arm/launch/spawn.sh", "xacro r.urdf | sed -e 's#package://arm#file:///opt/arm#g'"),
        (
            "src/arm/package.xml",
            '<package><name>arm</name><gazebo_ros gazebo_model_path="x/.."/></package>',
        ),
    ],
)
def test_something_tells_it(tmp_path: Path, file: str, text: str) -> None:
    add_file(tmp_path / file, text)
    assert reported(tmp_path) == []


def test_another_use_of_a_package(tmp_path: Path) -> None:
    launch = f"{LAUNCH}parameters = [{{'camera_info_url': 'package://arm/camera.yaml'}}]\n"
    assert len(reported(tmp_path, launch=launch)) == 1


def test_no_gazebo_no_package_no_file(tmp_path: Path) -> None:
    assert reported(tmp_path, launch="Node(package='rviz2')") == []
    assert reported(tmp_path, "../meshes/a.stl") == []
    assert reported(tmp_path, "package://arm/meshes/b.stl") == []


@pytest.mark.parametrize(("find", "count"), [("$(find arm)", 0), ("$(find-pkg-share arm)", 1)])
def test_a_launch_file_of_ros_1_starts_another_gazebo(
    tmp_path: Path, find: str, count: int
) -> None:
    """The export of SolidWorks beside the ROBOTIS arms of Mani-P."""
    text = f'<launch><node pkg="gazebo_ros" exec="spawn_entity" args="{find}"/></launch>'
    add_file(tmp_path / "src" / "arm" / "launch" / "gazebo.launch", text.encode())
    assert len(reported(tmp_path, launch="")) == count


@pytest.mark.parametrize(("target", "count"), [("gz-harmonic", 1), ("gz-fortress", 0)])
def test_the_variable_of_fortress(tmp_path: Path, target: str, count: int) -> None:
    add_file(tmp_path / "README.md", "export IGN_GAZEBO_RESOURCE_PATH=...")
    assert len(reported(tmp_path, target=target)) == count


SET = """\
import os
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import AppendEnvironmentVariable
SHARE = get_package_share_directory('arm')
def generate_launch_description():
    return LaunchDescription([AppendEnvironmentVariable('GZ_SIM_RESOURCE_PATH', {})])
"""


@pytest.mark.parametrize(
    ("value", "count"),
    [
        ("SHARE", 1),
        ("os.pathsep.join([SHARE])", 0),  # unknown
        ("SHARE + os.pathsep + '/usr/share'", 1),
        ("os.path.dirname(SHARE)", 0),
        ("os.path.join(SHARE, '..')", 0),
        ("SHARE + ':' + os.path.dirname(SHARE)", 0),
        ("os.path.join(SHARE, 'meshes')", 0),
        ("somewhere()", 0),
    ],
)
def test_a_launch_file_sets_the_package_itself(tmp_path: Path, value: str, count: int) -> None:
    found = reported(tmp_path, launch=LAUNCH + SET.format(value))
    assert [one.span.text for one in found] == [value] * count
    assert all(one.message == naming("GZ_SIM_RESOURCE_PATH", "arm", OWN) for one in found)


def test_a_launch_file_of_xml_sets_the_package_itself(tmp_path: Path) -> None:
    text = '<launch><set_env name="GZ_SIM_RESOURCE_PATH" value="$(find-pkg-share arm){}"/></launch>'
    add_file(tmp_path / "src" / "arm" / "launch" / "env.launch.xml", text.format(""))
    (found,) = reported(tmp_path)
    assert found.span.source.path.endswith("env.launch.xml")
    add_file(tmp_path / "src" / "arm" / "launch" / "env.launch.xml", text.format("/.."))
    assert reported(tmp_path) == []
    add_file(tmp_path / "src" / "arm" / "launch" / "env.launch.xml", text.format(""))
    add_file(tmp_path / "README.md", "export GZ_SIM_RESOURCE_PATH=...")
    assert reported(tmp_path) == []


HOOK = "prepend-non-duplicate;GZ_SIM_RESOURCE_PATH;{}\n"


@pytest.mark.parametrize(
    ("hooks", "count"),
    [
        (HOOK.format("share/@PROJECT_NAME@/models"), 1),
        (HOOK.format("share/worlds_pkg/worlds"), 1),
        (HOOK.format("share"), 0),
        (HOOK.format("share/@PROJECT_NAME@/models") + HOOK.format("share"), 0),
        (HOOK.format("share/@PROJECT_NAME@/.."), 0),
        (HOOK.format("share/@PROJECT_NAME@/with_arm"), 0),  # there is a directory with the name
        (HOOK.format("lib/x"), 0),
        ("set;GZ_SIM_RESOURCE_PATH;x\n", 0),  # of another format
    ],
)
def test_a_hook_of_another_directory(tmp_path: Path, hooks: str, count: int) -> None:
    other = tmp_path / "src" / "worlds_pkg"
    add_file(other / "package.xml", "<package><name>worlds_pkg</name></package>")
    add_file(other / "with_arm" / "arm" / "model.config")
    add_file(other / "hooks" / "a.dsv.in", hooks)
    found = reported(tmp_path)
    assert len(found) == count
    assert all(one.related[0].span.source.path.endswith("a.dsv.in") for one in found)
