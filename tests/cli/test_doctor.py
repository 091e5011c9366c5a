"""``urdfkit doctor``: what a check works with, and why."""

import re
import shutil
import sys
from importlib.metadata import PackageNotFoundError
from pathlib import Path

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

import pytest

import urdfkit
from tests.conftest import ROOT
from tests.xacros import HEAD
from urdfkit.cli import main
from urdfkit.core.installation import install_command


class Doctor:
    def __init__(self, capsys: pytest.CaptureFixture[str]) -> None:
        self.capsys = capsys

    def __call__(self, *words: str, code: int = 0) -> str:
        """What it prints; on standard error if it fails."""
        assert main(["doctor", *words]) == code
        captured = self.capsys.readouterr()
        assert (captured.err if code == 0 else captured.out) == ""
        return captured.out or captured.err


@pytest.fixture
def doctor(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> Doctor:
    monkeypatch.chdir(tmp_path)
    for name in ("ROS_DISTRO", "AMENT_PREFIX_PATH", "ROS_PACKAGE_PATH"):
        monkeypatch.delenv(name, raising=False)
    return Doctor(capsys)


def test_installed_packages_and_environment(doctor: Doctor, monkeypatch) -> None:
    monkeypatch.setenv("ROS_DISTRO", "jazzy")
    out = doctor()
    first = out.partition("\n")[0]
    assert first.startswith(f"urdfkit {urdfkit.__version__}, Python {sys.version.split()[0]}, ")
    rows = {line.split()[0]: line.split()[1] for line in out.split("\n\n")[0].splitlines()[1:]}
    assert rows["xacro"].startswith("2.1")
    assert rows["git"] == ("found" if shutil.which("git") else "missing")
    assert {"click", "PyYAML", "trimesh", "pin", "coal"} <= set(rows)
    assert "ROS_DISTRO: jazzy\n" in out
    assert "AMENT_PREFIX_PATH: not set\n" in out
    assert out.endswith("configuration: none\n")


@pytest.fixture
def nothing_installed(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing(name: str) -> str:
        raise PackageNotFoundError(name)

    monkeypatch.setattr("urdfkit.cli.doctor.version", missing)


@pytest.mark.usefixtures("nothing_installed")
def test_missing_packages_are_reported_with_the_install_command(doctor: Doctor) -> None:
    out = doctor()
    assert f"  {'pin':<21}missing       dynamics\n{'':<23}{install_command('dynamics')}\n" in out


@pytest.mark.usefixtures("nothing_installed")
def test_it_fits_in_80_columns(doctor: Doctor, monkeypatch) -> None:
    # An editable installation names its directory, of any length.
    monkeypatch.setattr(
        "urdfkit.cli.doctor.install_command", lambda extra: f'pip install "urdfkit[{extra}]"'
    )
    assert max(map(len, doctor().splitlines())) <= 80


def test_every_library_of_an_extra_is_listed(doctor: Doctor) -> None:
    """By what pyproject.toml says; only the extras of developers are no concern of users."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    wanted = {
        re.split(r"[<>=\[;]", line)[0].lower()
        for extra, lines in project["optional-dependencies"].items()
        if extra not in ("dev", "docs")
        for line in lines
    }
    rows = {line.split()[0].lower() for line in doctor().split("\n\n")[0].splitlines()[1:]}
    assert wanted - {"urdfkit"} <= rows


def test_the_configuration_is_shown(doctor: Doctor, tmp_path: Path) -> None:
    (tmp_path / "urdfkit.toml").write_text("")
    (tmp_path / "other.toml").write_text("")
    assert doctor().endswith("configuration: urdfkit.toml\n")
    assert doctor("--config", "other.toml").endswith("configuration: other.toml\n")
    assert doctor("--isolated").endswith("configuration: none\n")
    (tmp_path / "urdfkit.toml").write_text("selct = []")
    assert "unknown setting 'selct'; did you mean 'select'?" in doctor()
    (tmp_path / "r.urdf").write_text("<robot/>")
    assert "unknown setting 'selct'" in doctor("r.urdf", code=2)


@pytest.mark.usefixtures("gazebo_pkg")
def test_targets_are_reported_with_the_reason(doctor: Doctor, tmp_path: Path) -> None:
    file = "gazebo_pkg/urdf/waking_robot_new.xacro"
    out = doctor(file)
    assert f"\n{file}: xacro\n" in out
    why = "no repository or workspace found around it"
    assert f"  packages are searched in gazebo_pkg ({why})\n    package gazebo_pkg: " in out
    assert "  targets: ros1, classic-ros1\n    ros1: package.xml\n    classic-ros1: plugin " in out
    assert "  targets: mujoco (given)\n" in doctor(file, "--target", "mujoco")
    (tmp_path / "urdfkit.toml").write_text('targets = ["drake"]')
    assert "  targets: drake (given)\n" in doctor(file)
    assert "did you mean 'mujoco'" in doctor(file, "--target", "mojoco", code=2)


def test_packages_of_the_command_line(doctor: Doctor, tmp_path: Path) -> None:
    (tmp_path / "parts").mkdir()
    (tmp_path / "r.urdf").write_text('<robot name="r"><link name="a"/></robot>')
    out = doctor("r.urdf", "--package", "my_parts=parts")
    assert "\nr.urdf: plain XML\n" in out
    assert "  package my_parts: parts (given)\n" in out
    assert "  targets: none detected; select with --target\n" in out
    (tmp_path / "urdfkit.toml").write_text('[packages]\nmy_parts = "parts"')
    assert "  package my_parts: parts (given)\n" in doctor("r.urdf")


@pytest.mark.usefixtures("gazebo_pkg")
def test_directories_of_packages(
    doctor: Doctor, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    file = "gazebo_pkg/urdf/waking_robot_new.xacro"
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "package.xml").write_text("<package><name>other</name></package>")
    assert "    and next to it, in .\n    package gazebo_pkg: gazebo_pkg\n" in doctor(file)
    (tmp_path / ".git").mkdir()
    monkeypatch.setenv("AMENT_PREFIX_PATH", "/opt/ros/none")
    assert (
        "  packages are searched in . (because of .git)\n"
        "    package gazebo_pkg: gazebo_pkg\n"
        "    package other: other\n"
        "    and in AMENT_PREFIX_PATH: /opt/ros/none\n"
    ) in doctor(file)


def test_skipped_rules_are_reported_with_the_reason(doctor: Doctor, tmp_path: Path) -> None:
    (tmp_path / "r.urdf").write_text("<robot")
    out = doctor("r.urdf")
    assert "  TRE003 skipped: the description cannot be read\n" in out
    assert "targets:" not in out
    (tmp_path / "s.urdf").write_text('<robot name="r"><link name="a"/></robot>')
    out = doctor("s.urdf")
    assert "skipped" not in out
    assert int(out.rpartition("  rules: ")[2].split()[0]) > 0


def test_a_directory_is_reported_by_its_robots(doctor: Doctor, tmp_path: Path) -> None:
    (tmp_path / "a.urdf").write_text('<robot name="r"><link name="a"/></robot>')
    (tmp_path / "lib.xacro").write_text(
        f'{HEAD}<xacro:macro name="m"><link/></xacro:macro></robot>'
    )
    assert doctor(".").endswith(
        "\n.: 1 robot\n  a.urdf\n  lib.xacro: defines no link, and no file includes it\n"
        "  packages are searched in . (no repository or workspace found around it)\n"
    )
    (tmp_path / "urdfkit.toml").write_text(
        '[[robot]]\nfile = "lib.xacro"\nvariants = { l = { side = "l" }, r = { side = "r" } }'
    )
    assert doctor(".").endswith(
        "\n.: 2 robots (named by the configuration)\n  lib.xacro side:=l\n  lib.xacro side:=r\n"
        "  a.urdf: no [[robot]] in the configuration for it\n"
        "  packages are searched in . (because of urdfkit.toml)\n"
    )


def test_unreadable_files(doctor: Doctor) -> None:
    assert doctor("none.urdf", code=2).startswith("error: none.urdf: file not found")


def test_arguments_and_variants_of_the_configuration(doctor: Doctor) -> None:
    """They are what ``check`` reads the robot with."""
    Path("r.xacro").write_text(f'{HEAD}<link name="$(arg side)"/></robot>')
    entry = '[[robot]]\nfile = "r.xacro"\n'
    Path("urdfkit.toml").write_text(f'{entry}arguments.side = "left"\n')
    out = doctor("r.xacro")
    assert "\nr.xacro: xacro side:=left\n" in out
    assert "file skipped" not in out
    Path("urdfkit.toml").write_text(f'{entry}variants.a.side = "a"\nvariants.b.side = "b"\n')
    assert "select one with --variant (a, b)" in doctor("r.xacro", code=2)
    assert "\nr.xacro: xacro side:=b\n" in doctor("r.xacro", "--variant", "b")


def test_a_launch_file_and_a_parameter_file_are_called_so(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for name, text, kind in (
        ("r.launch", "<launch/>", "launch file"),
        ("c.yaml", "node:\n  ros__parameters: {}\n", "parameter file"),
    ):
        (tmp_path / name).write_text(text)
        assert main(["doctor", str(tmp_path / name)]) == 0
        assert f"{name}: {kind}\n" in capsys.readouterr().out
