"""Assertions about robots: what passes, and what a failure says."""

import os
import subprocess
from pathlib import Path

import pytest

from tests.workspaces import add_file
from urdfkit.errors import UnknownRule, UrdfkitError
from urdfkit.lint.config import ConfigError
from urdfkit.testing import (
    Description,
    Tolerances,
    assert_dof,
    assert_limits_within,
    assert_mass,
    assert_no_findings,
    assert_no_self_collision,
    assert_unchanged_since,
    variants,
)
from urdfkit.text.diagnostic import Severity

ARM = """\
<robot name="arm">
  <link name="base"/>
  <link name="upper"><inertial><mass value="1.5"/>
    <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial></link>
  <link name="fore"><inertial><mass value="0.5"/>
    <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial></link>
  <link name="finger"/>
  <joint name="shoulder" type="revolute">
    <parent link="base"/><child link="upper"/>
    <limit lower="-1" upper="2" effort="40" velocity="2"/>
  </joint>
  <joint name="elbow" type="continuous"><parent link="upper"/><child link="fore"/></joint>
  <joint name="grip" type="prismatic">
    <parent link="fore"/><child link="finger"/>
    <limit lower="0" upper="0.1" effort="4" velocity="1"/>
    <mimic joint="elbow"/>
  </joint>
</robot>
"""
SETTINGS = 'select = ["REF", "TRE", "URD", "XAC"]\n'


def described(directory: Path, text: str = ARM, name: str = "arm.urdf") -> Description:
    (directory / "urdfkit.toml").write_text(SETTINGS)
    (directory / name).write_text(text)
    return Description(str(directory / name))


def failure(call, *args, **kwargs) -> str:
    with pytest.raises(AssertionError) as error:
        call(*args, **kwargs)
    return str(error.value)


def test_findings(tmp_path):
    good = described(tmp_path).report
    assert_no_findings(good)
    bad = described(tmp_path, ARM.replace('<child link="fore"/>', '<child link="foer"/>')).report
    text = failure(assert_no_findings, bad)
    assert "error REF001 joint 'elbow': child link 'foer' is not in the model" in " ".join(
        text.split()
    )
    assert_no_findings(bad, ignore=["REF001", "several-roots", "TRE"])
    assert "REF001" in failure(assert_no_findings, bad, ignore=["TRE"])
    with pytest.raises(UnknownRule):
        assert_no_findings(bad, ignore=["RFE"])


def test_the_mildest_finding_that_counts(tmp_path):
    text = ARM.replace("<limit lower", "<anchor/><limit lower", 1)
    report = described(tmp_path, text).report
    assert [d.severity for d in report.diagnostics] == [Severity.WARNING]
    assert_no_findings(report, fail_on=Severity.ERROR)
    assert "URD001" in failure(assert_no_findings, report)


def test_degrees_of_freedom(tmp_path):
    model = described(tmp_path).model
    assert_dof(model, 2)
    assert failure(assert_dof, model, 3) == "2 degrees of freedom, not 3: shoulder, elbow"


def test_mass(tmp_path):
    model = described(tmp_path).model
    assert_mass(model, 2.0)
    assert_mass(model, 2.1, tolerance=0.11)
    assert failure(assert_mass, model, 2.1) == "total mass 2 kg, not 2.1 +- 0.001 kg"


def test_limits(tmp_path):
    model = described(tmp_path).model
    assert_limits_within(model, {"shoulder": (-1, 2), "grip": (0, 0.2)})
    assert_limits_within(model, {"[sg]*": (0, 40)}, of="effort")
    assert_limits_within(model, {"shoulder": (0, 2)}, of="velocity")
    assert failure(assert_limits_within, model, {"*": (-0.5, 1), "nothing": (0, 1)}) == (
        "joint 'shoulder': lower -1 is outside -0.5 to 1\n"
        "joint 'shoulder': upper 2 is outside -0.5 to 1\n"
        "joint 'elbow' has no lower\n"
        "joint 'elbow' has no upper\n"
        "no joint 'nothing'"
    )


def test_a_model_that_cannot_be_read_fails_with_what_is_wrong(tmp_path):
    text = failure(lambda: described(tmp_path, "<robot>").model)
    assert "arm.urdf:1:8: error XML001" in text


def test_settings_and_variants_are_those_of_the_project(tmp_path):
    described(tmp_path)
    (tmp_path / "urdfkit.toml").write_text(
        'ignore = ["REF"]\n[arguments]\nscale = 2\n'
        '[[robot]]\nfile = "arm.urdf"\nvariants = { l = { side = "l" }, r = { side = "r" } }\n'
    )
    path = str(tmp_path / "arm.urdf")
    assert variants(path) == ["l", "r"]
    with pytest.raises(ConfigError, match=r"select one with --variant \(l, r\)"):
        Description(path)
    assert Description(path, {"side": "x"}).arguments == {"scale": "2", "side": "x"}
    description = Description(path, variant="l")
    assert description.arguments == {"scale": "2", "side": "l"}
    assert description.report.files == (path,)
    assert "REF001" not in description.report.rules
    assert variants(str(tmp_path / "other.urdf")) == [""]


def test_arguments_are_those_of_the_launch_file(tmp_path):
    (tmp_path / ".git").mkdir()
    (tmp_path / "package.xml").write_text("<package><name>arms</name></package>")
    head = '<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">'
    path = tmp_path / "arm.xacro"
    path.write_text(f'{head}<link name="$(arg side)_base"/></robot>')
    (tmp_path / "arm.launch").write_text(
        '<launch><param name="robot_description" '
        'command="xacro $(find arms)/arm.xacro side:=left"/></launch>'
    )
    assert [link.name for link in Description(str(path)).model.links] == ["left_base"]


# --- against an earlier revision

PART = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="part" params="name mass">
    <link name="${name}">
      <inertial><mass value="${mass}"/>
        <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial>
      <visual><geometry><mesh filename="package://parts/meshes/part.stl"/></geometry></visual>
    </link>
  </xacro:macro>
</robot>
"""
ROBOT = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="$(find parts)/urdf/part.xacro"/>
  <xacro:arg name="mass" default="2"/>
  <xacro:property name="sizes" value="${xacro.load_yaml('../config/sizes.yaml')}"/>
  <xacro:part name="base" mass="$(arg mass)"/>
  <xacro:part name="arm" mass="1"/>
  <joint name="j" type="revolute">
    <origin xyz="0 0 ${sizes['height']}"/>
    <parent link="base"/>
    <child link="arm"/>
    <limit lower="-1" upper="1" effort="10" velocity="1"/>
  </joint>
</robot>
"""


class Repository:
    """A git repository with two packages: a robot, and the parts that it is made of."""

    def __init__(self, directory: Path) -> None:
        self.directory = directory
        self.git("init", "-q", "-b", "main")
        for name in ("parts", "robot"):
            self.write(f"{name}/package.xml", f"<package><name>{name}</name></package>")
        self.write("parts/urdf/part.xacro", PART)
        self.write("robot/config/sizes.yaml", "height: 0.5\n")
        self.write("robot/urdf/robot.urdf.xacro", ROBOT)
        self.commit("v1")

    def git(self, *words: str) -> str:
        identity = ["-c", "user.name=a", "-c", "user.email=a@example.org"]
        return subprocess.run(
            ["git", *identity, *words],
            cwd=self.directory,
            check=True,
            capture_output=True,
            text=True,
        ).stdout

    def write(self, name: str, text: str) -> None:
        add_file(self.directory / name, text)

    def commit(self, tag: str) -> None:
        self.git("add", "-A")
        self.git("commit", "-q", "--allow-empty", "-m", tag)
        self.git("tag", tag)

    def robot(self, **arguments: str) -> Description:
        return Description(str(self.directory / "robot" / "urdf" / "robot.urdf.xacro"), arguments)


@pytest.fixture
def repository(tmp_path: Path) -> Repository:
    directory = tmp_path / "repository"
    directory.mkdir()
    return Repository(directory)


def test_nothing_has_changed_although_the_text_has(repository):
    repository.write("parts/urdf/part.xacro", PART.replace("  ", "\t").replace("0.1", "0.10"))
    assert_unchanged_since(repository.robot(), "v1")
    assert_unchanged_since(repository.robot(mass="5"), "v1")


def test_what_changed_in_an_included_file_of_another_package_is_reported(repository):
    repository.write("parts/urdf/part.xacro", PART.replace('ixx="0.1"', 'ixx="0.2"'))
    repository.write("robot/config/sizes.yaml", "height: 0.75\n")
    assert failure(assert_unchanged_since, repository.robot(), "v1") == (
        "since v1:\n"
        "link 'base': inertia ixx 0.1 -> 0.2 kg·m²\n"
        "link 'arm': inertia ixx 0.1 -> 0.2 kg·m²\n"
        "joint 'j': the origin of its frame moved by 0.25 m"
    )
    repository.commit("v2")
    assert_unchanged_since(repository.robot(), "v2")
    assert_unchanged_since(repository.robot(), "HEAD")
    assert_unchanged_since(repository.robot(), "v1", Tolerances(inertia=1, position=0.3))


def test_packages_outside_the_repository_are_taken_as_they_are(repository, tmp_path):
    outside = tmp_path / "outside"
    (repository.directory / "parts").rename(outside)
    (repository.directory / "urdfkit.toml").write_text('[packages]\nparts = "../outside"\n')
    repository.commit("v2")
    assert_unchanged_since(repository.robot(), "v2")


def test_packages_of_the_configuration_are_taken_as_they_were(repository):
    repository.git("mv", "parts", "deep")
    repository.write("urdfkit.toml", '[packages]\nparts = "deep"\n')
    repository.commit("v2")
    repository.write("deep/urdf/part.xacro", PART.replace('"0 0', '"1 0').replace("0.1", "0.3"))
    assert "link 'arm': inertia" in failure(assert_unchanged_since, repository.robot(), "v2")


def test_the_repository_is_not_touched(repository, monkeypatch):
    repository.write("robot/urdf/new.xacro", ROBOT)
    repository.git("add", "robot/urdf/new.xacro")
    before = (
        repository.git("status", "--porcelain", "--ignored", "-uall"),
        os.listdir(repository.directory / ".git"),
    )
    assert_unchanged_since(repository.robot(), "v1")
    after = (
        repository.git("status", "--porcelain", "--ignored", "-uall"),
        os.listdir(repository.directory / ".git"),
    )
    assert before == after


def test_a_hook_of_another_repository_does_not_matter(repository, monkeypatch, tmp_path):
    monkeypatch.setenv("GIT_DIR", str(tmp_path / "nowhere"))
    monkeypatch.setenv("GIT_INDEX_FILE", str(tmp_path / "nowhere" / "index"))
    assert_unchanged_since(repository.robot(), "v1")


@pytest.mark.parametrize("revision", ["v9", "--help", "", "v1:robot"])
def test_an_unknown_revision_is_an_error(repository, revision):
    with pytest.raises(UrdfkitError) as error:
        assert_unchanged_since(repository.robot(), revision)
    assert str(error.value) == f"no git revision '{revision}' in {repository.directory}"


def test_a_file_that_was_not_there_yet_is_an_error(repository):
    path = repository.directory / "robot" / "urdf" / "new.urdf"
    path.write_text(ARM)
    with pytest.raises(UrdfkitError, match=r"new\.urdf is not in revision v1$"):
        assert_unchanged_since(Description(str(path)), "v1")


def test_a_file_that_could_not_be_read_then_is_an_error(repository):
    repository.write("robot/urdf/robot.urdf.xacro", ROBOT.replace("$(arg mass)", "${nothing}"))
    repository.commit("v2")
    repository.write("robot/urdf/robot.urdf.xacro", ROBOT)
    with pytest.raises(UrdfkitError, match="at v2 cannot be read:") as error:
        assert_unchanged_since(repository.robot(), "v2")
    assert "XAC001" in str(error.value)


def test_outside_of_git_it_is_an_error(tmp_path):
    with pytest.raises(UrdfkitError, match="not a git repository"):
        assert_unchanged_since(described(tmp_path), "v1")


def test_without_git_it_is_an_error(repository, monkeypatch):
    monkeypatch.setenv("PATH", str(repository.directory))
    with pytest.raises(UrdfkitError, match=r"^git is not installed$"):
        assert_unchanged_since(repository.robot(), "v1")


# --- collisions

BENT = """\
<robot name="bent">
  <link name="base"><collision><geometry><sphere radius="0.2"/></geometry></collision></link>
  <link name="arm"><collision><origin xyz="0 0 0.5"/>
    <geometry><sphere radius="0.1"/></geometry></collision></link>
  <link name="tip"><collision><origin xyz="0 0 0.5"/>
    <geometry><sphere radius="0.1"/></geometry></collision></link>
  <joint name="shoulder" type="continuous"><parent link="base"/><child link="arm"/></joint>
  <joint name="elbow" type="revolute"><parent link="arm"/><child link="tip"/>
    <origin xyz="0 0 0.6"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
</robot>
"""


def bent(directory: Path, limit: float = 3) -> Description:
    """A robot whose tip hits its base when the elbow is bent by more than 2.5 rad."""
    (directory / "bent.urdf").write_text(
        BENT.replace('upper="3"', f'upper="{limit}"').replace('lower="-3"', f'lower="-{limit}"')
    )
    return Description(str(directory / "bent.urdf"))


def test_self_collisions(tmp_path: Path) -> None:
    pytest.importorskip("coal")
    with pytest.raises(AssertionError, match=r"'base' and 'tip': .* mm deep at .*elbow -?[23]"):
        assert_no_self_collision(bent(tmp_path), samples=200)
    assert_no_self_collision(bent(tmp_path), samples=0)
    with pytest.raises(AssertionError, match="elbow 3"):
        assert_no_self_collision(bent(tmp_path), samples=0, begin={"elbow": 3})
    assert_no_self_collision(bent(tmp_path), samples=200, allowed=[("tip", "base")])
    assert_no_self_collision(bent(tmp_path, 1.5), samples=200)


def test_pairs_that_the_srdf_disables_may_collide(tmp_path: Path) -> None:
    pytest.importorskip("coal")
    description = bent(tmp_path)
    (tmp_path / "bent.srdf").write_text(
        '<robot name="bent"><disable_collisions link1="base" link2="tip" reason="User"/></robot>'
    )
    assert_no_self_collision(description, samples=200)
