"""``urdfkit init``: a first configuration that can be used as it is."""

import shutil
from pathlib import Path

import pytest

from tests.conftest import MODELS
from tests.shipped import GRIPPER
from tests.xacros import HEAD
from urdfkit.cli import main
from urdfkit.lint.config_reader import load

ARM = f"""{HEAD}
  <xacro:arg name="scale" default="1.0"/>
  <xacro:arg name="label" default='say "hi"'/>
  <link name="$(arg side)_base"/>
</robot>
"""
LIBRARY = f'{HEAD}<xacro:macro name="rod"><link name="rod"/></xacro:macro></robot>'


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "urdf").mkdir()
    (tmp_path / "urdf" / "arm.xacro").write_text(ARM)
    (tmp_path / "urdf" / "base.urdf").write_text('<robot name="r"><link name="a"/></robot>')
    (tmp_path / "urdf" / "rod.xacro").write_text(LIBRARY)
    return tmp_path


def test_every_robot_with_its_required_arguments(project: Path, capsys) -> None:
    assert main(["init"]) == 0
    assert capsys.readouterr().out == "wrote ./urdfkit.toml: 2 robots\n"
    assert (
        (project / "urdfkit.toml").read_text()
        == """\
# Settings of urdfkit. Lines starting with '#' are comments.

# Target programs; if not set, they are detected for each robot.
# targets = ["ros2", "gz-harmonic"]

# Rules to ignore: codes, or prefixes of codes.
# ignore = ["URD001"]

[[robot]]
file = "urdf/arm.xacro"
arguments.side = ""  # required: fill in the value
# arguments.scale = "1.0"
# arguments.label = "say \\"hi\\""

[[robot]]
file = "urdf/base.urdf"

# urdf/rod.xacro: defines no link, and no file includes it
"""
    )


def test_the_output_is_a_configuration(project: Path, capsys) -> None:
    main(["init"])
    text = (project / "urdfkit.toml").read_text()
    (project / "urdfkit.toml").write_text(text.replace('side = ""', 'side = "left"'))
    config = load("urdfkit.toml")
    assert [(Path(r.file).name, r.arguments) for r in config.robots] == [
        ("arm.xacro", {"side": "left"}),
        ("base.urdf", {}),
    ]
    capsys.readouterr()
    assert main(["check", ".", "--select", "XAC010,XML"]) == 0
    assert capsys.readouterr().out == "no findings in 2 files\n"
    every = "\n".join(
        line.removeprefix("# ") if " = " in line else line for line in text.split("\n")
    )
    (project / "urdfkit.toml").write_text(every)
    config = load("urdfkit.toml")
    assert config.robots[0].arguments == {"side": "", "scale": "1.0", "label": 'say "hi"'}
    assert config.targets == ("ros2", "gz-harmonic")


def test_detected_targets(project: Path, capsys) -> None:
    shutil.copytree(MODELS / "gazebo_pkg", project / "gazebo_pkg")
    assert main(["init", "gazebo_pkg", "--print"]) == 0
    out = capsys.readouterr().out
    assert '# targets = ["ros1", "classic-ros1"]\n' in out
    assert 'file = "urdf/waking_robot_new.xacro"\n' in out
    assert not (project / "gazebo_pkg" / "urdfkit.toml").exists()


@pytest.mark.parametrize(
    ("name", "text"), [("urdfkit.toml", "# mine"), ("pyproject.toml", "[tool.urdfkit]\n")]
)
def test_an_existing_configuration_is_unchanged(
    name: str, text: str, project: Path, capsys
) -> None:
    (project / name).write_text(text)
    assert main(["init"]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err == (
        f"error: ./{name}: configures it already; --print shows what would be written\n"
    )
    assert (project / name).read_text() == text
    assert main(["init", "--print"]) == 0
    assert main(["init", "urdf"]) == 0, "another directory has none"


def test_a_pyproject_of_another_tool_is_not_a_configuration(project: Path) -> None:
    (project / "pyproject.toml").write_text("[tool.ruff]\n")
    assert main(["init"]) == 0


def test_a_directory_without_robots(project: Path, capsys) -> None:
    (project / "empty").mkdir()
    assert main(["init", "empty"]) == 2
    assert "no .urdf, no .xacro" in capsys.readouterr().err
    assert main(["init", "none"]) == 2
    assert not (project / "empty" / "urdfkit.toml").exists()


def test_unusual_names_are_quoted_in_toml(tmp_path: Path) -> None:
    file = tmp_path / 'a "b" \\ é.xacro'
    file.write_text(ARM.replace("scale", "größe.x"))
    assert main(["init", str(tmp_path)]) == 0
    text = (tmp_path / "urdfkit.toml").read_text()
    assert '# arguments."größe.x" = "1.0"\n' in text
    (robot,) = load(str(tmp_path / "urdfkit.toml")).robots
    assert robot.file == str(file)


def test_a_symbolic_link_is_not_followed(project: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (project / "urdfkit.toml").symlink_to(project.parent / "outside.toml")
    assert main(["init"]) == 2
    assert "./urdfkit.toml: a link whose target does not exist" in capsys.readouterr().err
    assert not (project.parent / "outside.toml").exists()


def test_a_file_is_not_a_directory(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["init", GRIPPER]) == 2
    assert capsys.readouterr().err.endswith("gripper.urdf: is a file, not a directory\n")
