"""The arguments and variants of the configuration hold for every command that reads a robot."""

import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from tests.xacros import xacro
from urdfkit.cli import main, view
from urdfkit.lint.options import Options
from urdfkit.lsp.workspace import Workspace
from urdfkit.output.report.document import describe

ARM = xacro(
    """<link name="$(arg side)_base"><inertial><mass value="1"/>
    <inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>
    <visual><geometry><box size="1 1 1"/></geometry></visual>
    <collision><geometry><box size="1 1 1"/></geometry></collision></link>
  <link name="$(arg side)_arm"><inertial><mass value="1"/>
    <inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial>
    <visual><geometry><box size="1 1 1"/></geometry></visual>
    <collision><geometry><box size="1 1 1"/></geometry></collision></link>
  <joint name="$(arg side)_joint" type="revolute"><origin xyz="0 0 3"/><axis xyz="0 1 0"/>
    <parent link="$(arg side)_base"/><child link="$(arg side)_arm"/>
    <limit lower="-1" upper="1" effort="9" velocity="1"/></joint>"""
)
ONE = '[[robot]]\nfile = "arm.urdf.xacro"\narguments = {side = "left"}\n'
TWO = """[[robot]]
file = "arm.urdf.xacro"
variants = {left = {side = "left"}, right = {side = "right"}}
"""

#: Command lines whose output names the links; FILE stands for the robot.
COMMANDS = [
    "check FILE --format json --select TRE,NAM,INE",
    "collisions FILE --samples 10 --format json",
    "diff FILE FILE --format json --fail-on none",
    "expand FILE",
    "gazebo FILE",
    "inertia FILE",
    "info FILE",
    "kinematics FILE",
    "mass FILE",
    "mesh capsules FILE --most 2",
    "mesh collision FILE --link SIDE_base --most 1",
    "mesh spheres FILE --format urdf --most 2",
    "migrate FILE --to gz-harmonic",
    "render FILE -o OUT.png",
    "report FILE --quick",
    "statics FILE --samples 10",
    "trace FILE link/SIDE_base",
    "tree FILE",
]
#: What does as the ``xacro`` command does.
AS_XACRO = ("expand", "migrate", "trace")
LAUNCH = """<launch><param name="robot_description"
command="xacro $(find arms)/arm.urdf.xacro side:={}"/></launch>"""

#: What shows no link, or checks and reports each variant.
MUTE = ("check", "diff", "migrate", "render")
ALL = ("check", "report")


pytestmark = pytest.mark.usefixtures("rough_meshes", "small_pictures")


@pytest.fixture
def robot(tmp_path: Path) -> Path:
    path = tmp_path / "arm.urdf.xacro"
    path.write_text(ARM)
    return path


def run(command: str, robot: Path, side: str, *more: str) -> int:
    if command.startswith(("collisions", "statics")):
        pytest.importorskip("pinocchio")
        pytest.importorskip("coal")
    out = str(robot.with_name("out"))
    words = [
        word.replace("FILE", str(robot)).replace("SIDE", side).replace("OUT", out)
        for word in command.split()
    ]
    return main([*words, *more])


def read(capsys: pytest.CaptureFixture[str]) -> SimpleNamespace:
    """What was printed, without the backslashes of Markdown."""
    captured = capsys.readouterr()
    return SimpleNamespace(out=captured.out.replace("\\_", "_"), err=captured.err)


def configure(robot: Path, text: str) -> None:
    robot.with_name("urdfkit.toml").write_text(text)


@pytest.mark.parametrize("command", COMMANDS)
def test_configured_arguments(command: str, robot: Path, capsys) -> None:
    configure(robot, ONE)
    assert run(command, robot, "left") in (0, 1)
    captured = read(capsys)
    assert "error" not in captured.err
    assert "left_base" in captured.out or command.startswith(MUTE)


@pytest.mark.parametrize("command", COMMANDS)
def test_arguments_on_the_command_line_take_precedence(command: str, robot: Path, capsys) -> None:
    for text in (ONE, TWO):
        configure(robot, text)
        assert run(command, robot, "mid", "side:=mid") in (0, 1)
        captured = read(capsys)
        assert "left" not in captured.out.replace("left_out", "")
        assert "mid_base" in captured.out or command.startswith(MUTE)


@pytest.mark.parametrize("command", [c for c in COMMANDS if not c.startswith(AS_XACRO)])
def test_the_arguments_of_the_launch_file(command: str, robot: Path, capsys) -> None:
    robot.with_name("package.xml").write_text("<package><name>arms</name></package>")
    launch = robot.with_name("arm.launch")
    launch.write_text(LAUNCH.format("left"))
    assert run(command, robot, "left") in (0, 1)
    captured = read(capsys)
    assert "error" not in captured.err
    assert "left_base" in captured.out or command.startswith(MUTE)


def test_arguments_of_two_launch_files_are_ambiguous(robot: Path, capsys) -> None:
    robot.with_name("package.xml").write_text("<package><name>arms</name></package>")
    for side in ("left", "right"):
        robot.with_name(f"{side}.launch").write_text(LAUNCH.format(side))
    assert main(["info", str(robot)]) == 2
    assert "gives left, right" in capsys.readouterr().err


@pytest.mark.parametrize("command", COMMANDS)
def test_a_variant_is_required(command: str, robot: Path, capsys) -> None:
    configure(robot, TWO)
    if not command.startswith(ALL):
        assert run(command, robot, "right") == 2
        error = read(capsys).err
        assert "has several variants: select one with --variant (left, right)" in error
    assert run(command, robot, "right", "--variant", "right") in (0, 1)
    captured = read(capsys)
    assert "left_base" not in captured.out
    assert "right_base" in captured.out or command.startswith(MUTE)
    assert run(command, robot, "right", "--variant", "rigth") == 2
    assert "unknown variant 'rigth'; there are left, right" in read(capsys).err


def test_arguments_that_no_variant_has_are_reported_once(robot: Path, capsys) -> None:
    robot.write_text(ARM.replace("<link", '<xacro:arg name="side" default="left"/><link', 1))
    config = robot.with_name("urdfkit.toml")
    configure(robot, TWO + 'arguments = {sied = "left"}\n')
    for where in (robot, robot.parent):
        main(["check", str(where)])
        note = f"{config}: {robot} has no argument 'sied'; did you mean 'side'?"
        assert capsys.readouterr().out.count(note) == 1
        main(["check", str(where), "--format", "github"])
        assert capsys.readouterr().err.count(note) == 1  # has no place for it
        main(["check", str(where), "sied:=right"])
        out = capsys.readouterr().out
        assert note not in out
        assert "No robot here has an argument 'sied'; did you mean 'side'?" in out


@pytest.mark.parametrize("command", COMMANDS)
def test_isolated_ignores_the_configuration(command: str, robot: Path, capsys) -> None:
    configure(robot, ONE)
    code = run(command, robot, "left", "--isolated")
    assert code in (1, 2) or command.startswith(ALL)
    assert "left_base" not in read(capsys).out


def test_a_report_of_every_variant(robot: Path, capsys) -> None:
    configure(robot, TWO)
    assert main(["report", str(robot), "--quick", "-o", str(robot.with_name("arm.md"))]) == 0
    for side, other in (("left", "right"), ("right", "left")):
        text = robot.with_name(f"arm-{side}.md").read_text().replace("\\_", "_")
        assert f"{side}_base" in text
        assert f"{other}_base" not in text


def test_packages_and_trust_of_the_configuration(robot: Path, capsys) -> None:
    (robot.parent / "elsewhere").mkdir()
    (robot.parent / "elsewhere" / "names.yaml").write_text("side: left\n")
    robot.write_text(
        xacro(
            """<xacro:property name="names" value="${load_yaml('$(find given)/names.yaml')}"/>
          <link name="${names['side']}_base"/>"""
        )
    )
    configure(robot, '[packages]\ngiven = "elsewhere"\n')
    assert main(["tree", str(robot)]) == 0
    assert "left_base" in read(capsys).out


def test_the_viewer(robot: Path, monkeypatch, capsys) -> None:
    seen: list[tuple[str, Options]] = []
    monkeypatch.setattr(view, "serve", lambda *given, **_: seen.append(given[:2]))
    configure(robot, TWO)
    assert main(["view", str(robot), "--variant", "right", "--no-open"]) == 0
    reported = describe(*seen[0], quick=True)
    assert reported.context.arguments == {"side": "right"}


def test_the_language_server(robot: Path) -> None:
    configure(robot, ONE)
    model = Workspace().robot(str(robot)).model
    assert model is not None
    assert "left_base" in model.links_by_name


@pytest.mark.skipif(sys.platform == "win32", reason="links need rights")
def test_a_robot_is_recognised_by_another_path(robot: Path, capsys) -> None:
    configure(robot, ONE)
    other = robot.with_name("link.xacro")
    other.symlink_to(robot)
    assert main(["tree", str(other)]) == 0
    assert "left_base" in read(capsys).out
