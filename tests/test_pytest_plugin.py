"""The pytest plugin, in projects of its own, as pytest runs them."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from importlib.metadata import entry_points
from pathlib import Path
from xml.etree import ElementTree

import pytest

from tests.conftest import ROOT
from tests.meshes.made import binary_stl
from urdfkit.libraries import why_unmeasured

pytest_plugins = ["pytester"]

#: An installed urdfkit brings its plugin along; a checkout has to name it.
PLUGIN = (
    []
    if any(point.name == "urdfkit" for point in entry_points(group="pytest11"))
    else ["-p", "urdfkit.pytest_plugin"]
)

ARM = """\
<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="side" default="left"/>
  <xacro:arg name="joints" default="1"/>
  <link name="$(arg side)_base"/>
  <link name="$(arg side)_tip"/>
  <xacro:if value="${$(arg joints) == 1}">
    <joint name="$(arg side)_joint" type="revolute">
      <parent link="$(arg side)_base"/>
      <child link="$(arg side)_tip"/>
      <axis xyz="0 0 1"/>
      <limit lower="-1" upper="1" effort="10" velocity="1"/>
    </joint>
  </xacro:if>
  <xacro:unless value="${$(arg joints) == 1}">
    <joint name="$(arg side)_joint" type="fixed">
      <parent link="$(arg side)_base"/>
      <child link="$(arg side)_tip"/>
    </joint>
  </xacro:unless>
</robot>
"""

BROKEN = """\
<robot name="broken">
  <link name="a"/>
  <joint name="j" type="fixed"><parent link="a"/><child link="b"/></joint>
</robot>
"""

#: What the robots above are about; rules about bodies without mass are not.
SETTINGS = 'select = ["XML", "XAC", "URD", "REF", "TRE"]\n'


class Project:
    """A folder with models and tests in which pytest runs as a process of its own."""

    def __init__(self, pytester: pytest.Pytester) -> None:
        self.pytester = pytester
        self.folder = pytester.path
        self.write("urdfkit.toml", SETTINGS)
        self.write("urdf/arm.urdf.xacro", ARM)
        self.write("urdf/broken.urdf", BROKEN)

    def write(self, name: str, text: str) -> None:
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def run(self, *words: str) -> pytest.RunResult:
        return self.pytester.runpytest_subprocess(*PLUGIN, *words)

    def test(self, text: str, *words: str) -> pytest.RunResult:
        """The outcome of a test module."""
        self.write("test_it.py", f"import pytest\nfrom urdfkit.testing import *\n\n{text}\n")
        return self.run("-v", *words)


@pytest.fixture
def project(pytester: pytest.Pytester, monkeypatch: pytest.MonkeyPatch) -> Project:
    monkeypatch.setenv("PYTHONPATH", str(ROOT))
    for name in ("PYTEST_ADDOPTS", "PYTEST_PLUGINS"):
        monkeypatch.delenv(name, raising=False)
    return Project(pytester)


def outcome(result: pytest.RunResult, **counts: int) -> str:
    """All that was printed, of a run with these outcomes and no others."""
    assert result.parseoutcomes() == counts, result.stdout.str() + result.stderr.str()
    return result.stdout.str()


def test_the_factory_expands_with_arguments(project: Project) -> None:
    result = project.test(
        """
def test_arguments(urdf):
    right = urdf("urdf/arm.urdf.xacro", side="right", joints=2)
    assert [link.name for link in right.model.links] == ["right_base", "right_tip"]
    assert right.model.degrees_of_freedom == 0
    assert urdf("urdf/arm.urdf.xacro").model.degrees_of_freedom == 1

def test_a_boolean_is_written_as_xacro_wants_it(urdf):
    assert urdf("urdf/arm.urdf.xacro", side=True).arguments == {"side": "true"}

def test_its_report(urdf):
    assert [d.code for d in urdf("urdf/broken.urdf").report.diagnostics] == ["REF001"]

def test_an_absolute_path(urdf, tmp_path, request):
    assert urdf(request.path.parent / "urdf" / "arm.urdf.xacro").model.name == "arm"
"""
    )
    outcome(result, passed=4)


def test_paths_start_at_the_test_then_at_the_root(project: Project) -> None:
    project.write("inner/near.urdf", '<robot name="near"><link name="a"/></robot>')
    project.write(
        "inner/test_inner.py",
        "def test_it(urdf):\n"
        "    assert urdf('near.urdf').model.name == 'near'\n"
        "    assert urdf('urdf/arm.urdf.xacro').model.name == 'arm'\n",
    )
    outcome(project.run("inner"), passed=1)


@pytest.mark.parametrize("fixture", ["urdf", "check_urdf"])
def test_an_unknown_path_is_told_without_a_traceback(project: Project, fixture: str) -> None:
    text = outcome(
        project.test(f"def test_it({fixture}):\n    {fixture}('urdf/arn.xacro')"), failed=1
    )
    assert f"there is no model {project.folder / 'urdf' / 'arn.xacro'}\n" in text
    assert "pytest_plugin.py" not in text


def test_an_unknown_path_in_a_marker_is_told_without_a_traceback(project: Project) -> None:
    text = outcome(
        project.test("@pytest.mark.urdf('arn.xacro')\ndef test_it(robot_model): pass"), errors=1
    )
    assert f"there is no model {project.folder / 'arn.xacro'}\n" in text
    assert "pytest_plugin.py" not in text


def test_check_urdf_fails_with_the_report(project: Project) -> None:
    result = project.test(
        """
def test_good(check_urdf):
    assert check_urdf("urdf/arm.urdf.xacro", side="right").ok

def test_bad(check_urdf):
    check_urdf("urdf/broken.urdf")
"""
    )
    text = outcome(result, passed=1, failed=1)
    assert "urdf/broken.urdf:3:63: error REF001" in text
    assert ">       check_urdf(" in text, "the line of the test"
    assert "urdfkit/testing.py" not in text


def test_a_marker_gives_the_model_and_its_report(project: Project) -> None:
    result = project.test(
        """
@pytest.mark.urdf("urdf/arm.urdf.xacro", args={"side": "right"})
def test_one(robot_model, urdf_report):
    assert robot_model.links[0].name == "right_base"
    assert urdf_report.ok
    assert_dof(robot_model, 1)
    assert_no_findings(urdf_report)
"""
    )
    assert "test_it.py::test_one PASSED" in outcome(result, passed=1)


def test_the_robot_in_pinocchio(project: Project) -> None:
    pytest.importorskip("pinocchio")
    result = project.test(
        """
@pytest.mark.urdf("urdf/arm.urdf.xacro", args={"side": "right"})
def test_one(robot_dynamics):
    assert robot_dynamics.columns == ("right_joint",)
    assert robot_dynamics.gravity({"right_joint": 0.5}).tolist() == [0]
"""
    )
    assert "test_it.py::test_one PASSED" in outcome(result, passed=1)


def test_without_pinocchio_the_test_is_skipped_with_the_command_to_install_it(
    project: Project,
) -> None:
    result = project.test(
        """
import sys
sys.modules["pinocchio"] = None
@pytest.mark.urdf("urdf/arm.urdf.xacro")
def test_one(robot_dynamics):
    assert False
"""
    )
    assert "pip install 'urdfkit[dynamics]'" in outcome(result, skipped=1)


MEASURED = """
@pytest.mark.urdf("urdf/arm.urdf.xacro")
def test_one(robot_meshes):
    assert [(mesh.link.name, mesh.role) for mesh in robot_meshes] == [("base", "visual")]
    (mesh,) = robot_meshes
    assert mesh.measures.triangles == 4
    assert mesh.edges == pytest.approx((2, 2, 2))
    assert mesh.measures.solid.volume == pytest.approx(1 / 6)
"""


def _add_a_mesh(project: Project) -> None:
    path = project.folder / "urdf" / "arm.urdf.xacro"
    visual = (
        '<link name="base"><visual><geometry><mesh filename="part.stl" scale="2 2 2"/></geometry>'
        "</visual></link></robot>"
    )
    path.write_text(path.read_text(encoding="utf-8").replace("</robot>", visual), encoding="utf-8")
    (path.parent / "part.stl").write_bytes(binary_stl())


def test_the_meshes_of_a_robot(project: Project) -> None:
    if reason := why_unmeasured():  # to import one here would break those that do later
        pytest.skip(reason)
    _add_a_mesh(project)
    assert "test_it.py::test_one PASSED" in outcome(project.test(MEASURED), passed=1)


def test_without_numpy_the_test_is_skipped_with_the_command_to_install_it(project: Project) -> None:
    _add_a_mesh(project)
    block = 'from urdfkit import libraries; libraries.missing_for_meshes = lambda: "numpy"\n'
    assert "pip install 'urdfkit[meshes]'" in outcome(
        project.test(block + MEASURED, "-rs"), skipped=1
    )


def test_lists_and_variants_run_the_test_for_each(project: Project) -> None:
    result = project.test(
        """
SEEN = []

@pytest.mark.urdf("urdf/arm.urdf.xacro", args={"side": ["left", "right"], "joints": [1, 2]})
def test_lists(robot_model):
    SEEN.append((robot_model.links[0].name, robot_model.degrees_of_freedom))

@pytest.mark.urdf(
    "urdf/arm.urdf.xacro",
    args={"side": "right"},
    variants={"free": {"joints": 1}, "stiff": {"joints": 2}},
)
def test_variants(robot_model):
    SEEN.append((robot_model.links[0].name, robot_model.degrees_of_freedom))

def test_all_of_them_ran():
    assert SEEN == [
        ("left_base", 1), ("left_base", 0), ("right_base", 1), ("right_base", 0),
        ("right_base", 1), ("right_base", 0),
    ]
"""
    )
    text = outcome(result, passed=7)
    for name in ("lists[left-1]", "lists[right-2]", "variants[free]", "variants[stiff]"):
        assert f"test_it.py::test_{name} PASSED" in text
    outcome(project.run("-k", "right and not stiff"), passed=2, deselected=5)


def test_names_that_look_alike_lose_no_arguments(project: Project) -> None:
    result = project.test(
        """
@pytest.mark.urdf("urdf/arm.urdf.xacro", args={"side": ["a-1", "a"], "joints": ["1", "1-1"]})
def test_it(marked_urdf): pass
"""
    )
    outcome(result, passed=4)


def test_no_value_is_no_test(project: Project) -> None:
    result = project.test(
        "@pytest.mark.urdf('urdf/arm.urdf.xacro', args={'side': []})\n"
        "def test_it(robot_model): pass"
    )
    outcome(result, skipped=1)


@pytest.mark.parametrize(
    ("marker", "message"),
    [
        ("'a', arguments={}", "takes a path, args and variants, not arguments"),
        ("", "takes a path, args and variants"),
    ],
)
def test_a_wrong_marker_is_told(project: Project, marker: str, message: str) -> None:
    result = project.test(f"@pytest.mark.urdf({marker})\ndef test_it(robot_model): pass")
    assert f"@pytest.mark.urdf {message}\n" in outcome(result, errors=1)


def test_a_missing_marker_is_told(project: Project) -> None:
    result = project.test("def test_it(robot_model): pass")
    assert 'mark the test with its model: @pytest.mark.urdf("path")' in outcome(result, errors=1)


def test_a_model_that_cannot_be_read_fails_with_what_is_wrong(project: Project) -> None:
    project.write("urdf/bad.xacro", ARM.replace("$(arg side)_tip", "${tip}"))
    result = project.test("@pytest.mark.urdf('urdf/bad.xacro')\ndef test_it(robot_model): pass")
    assert "urdf/bad.xacro:5:15: error XAC001" in outcome(result, errors=1)


ROBOT_TABLES = """
[[robot]]
file = "urdf/arm.urdf.xacro"
variants = { left = { side = "left" }, right = { side = "right" } }
"""


def test_files_are_tests_themselves(project: Project) -> None:
    project.write("urdfkit.toml", SETTINGS + ROBOT_TABLES)
    project.write("pytest.ini", "[pytest]\nurdf_files = urdf/*.urdf urdf/*.urdf.xacro\n")
    project.write("urdf/notes.txt", "nothing")
    text = outcome(project.run("-v", "--junitxml", "junit.xml"), passed=2, failed=1)
    assert "urdf/arm.urdf.xacro::urdfkit[left] PASSED" in text
    assert "urdf/arm.urdf.xacro::urdfkit[right] PASSED" in text
    assert "urdf/broken.urdf::urdfkit FAILED" in text
    assert "urdf/broken.urdf:3:63: error REF001" in text
    assert "Traceback" not in text
    cases = {
        (case.get("classname"), case.get("name")): case.find("failure") is not None
        for case in ElementTree.parse(project.folder / "junit.xml").iter("testcase")
    }
    assert cases == {
        ("urdf.arm.urdf.xacro", "urdfkit[left]"): False,
        ("urdf.arm.urdf.xacro", "urdfkit[right]"): False,
        ("urdf.broken.urdf", "urdfkit"): True,
    }
    outcome(project.run("-k", "left"), passed=1, deselected=2)
    outcome(project.run("urdf/arm.urdf.xacro::urdfkit[right]"), passed=1)


def test_the_severity_that_fails_a_file_is_set(project: Project) -> None:
    project.write("urdf/warned.urdf", '<robot name="r"><link name="a"/><lnik name="b"/></robot>')
    for fail_on, counts in (("warning", {"failed": 1}), ("error", {"passed": 1})):
        project.write(
            "pytest.ini", f"[pytest]\nurdf_files = urdf/warned.urdf\nurdf_fail_on = {fail_on}\n"
        )
        outcome(project.run(), **counts)


@pytest.mark.parametrize(
    ("setting", "message"),
    [
        ("urdf_files = urdf/*.udrf", "urdf_files: no file in {folder} matches 'urdf/*.udrf'"),
        ("urdf_files = /urdf/*.urdf", "urdf_files: '/urdf/*.urdf': "),
        ("urdf_fail_on = fatal", "urdf_fail_on: 'fatal' is none of error, warning, info"),
    ],
)
def test_a_slip_in_a_setting_is_told(project: Project, setting: str, message: str) -> None:
    project.write("pytest.ini", f"[pytest]\n{setting}\n")
    result = project.run()
    assert result.ret == pytest.ExitCode.USAGE_ERROR
    assert f"ERROR: {message.format(folder=project.folder)}" in result.stderr.str()


def test_several_processes_agree(project: Project) -> None:
    pytest.importorskip("xdist")
    project.write("urdfkit.toml", SETTINGS + ROBOT_TABLES)
    project.write("pytest.ini", "[pytest]\nurdf_files = urdf/*.urdf urdf/*.xacro\n")
    result = project.test(
        """
@pytest.mark.urdf("urdf/arm.urdf.xacro", args={"side": ["left", "right"]})
def test_it(robot_model): assert_dof(robot_model, 1)
""",
        "-n",
        "2",
    )
    text = outcome(result, passed=4, failed=1)
    assert "urdf/broken.urdf:3:63: error REF001" in text


def test_the_marker_is_listed(project: Project) -> None:
    text = project.run("--markers").stdout.str()
    assert "@pytest.mark.urdf(path, args={}, variants={}): the model that robot_model" in text
    outcome(
        project.test(
            "@pytest.mark.urdf('urdf/arm.urdf.xacro')\ndef test_it(urdf_report): pass",
            "--strict-markers",
        ),
        passed=1,
    )


def test_the_settings_and_fixtures_are_listed(project: Project) -> None:
    assert "urdf_files (args):" in project.run("--help").stdout.str()
    text = project.run("--fixtures").stdout.str()
    fixtures = "urdf robot_model robot_dynamics robot_meshes urdf_report check_urdf".split()
    for fixture in fixtures:
        assert f"\n{fixture} -- " in text


def test_it_imports_only_pytest_until_it_is_used(project: Project) -> None:
    project.write(
        "test_it.py",
        "import sys\n"
        "def test_it():\n"
        "    ours = {name for name in sys.modules if name.partition('.')[0] == 'urdfkit'}\n"
        "    assert ours == {'urdfkit', 'urdfkit.pytest_plugin'}\n"
        "    assert not {'xacro', 'lxml', 'yaml', 'click', 'numpy'} & set(sys.modules)\n",
    )
    outcome(project.run(), passed=1)


def test_the_example_is_green_as_a_user_runs_it(tmp_path: Path) -> None:
    folder = tmp_path / "robot_tests"
    shutil.copytree(
        ROOT / "examples" / "robot_tests",
        folder,
        ignore=shutil.ignore_patterns(".*", "__pycache__"),
    )
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}

    def run(*words: str) -> str:
        done = subprocess.run(
            [sys.executable, "-m", *words],
            check=False,
            cwd=folder,
            env=environment,
            capture_output=True,
            text=True,
        )
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    assert "8 passed" in run("pytest", *PLUGIN, "-p", "no:cacheprovider")
    assert run("urdfkit", "check", ".").startswith("no findings in 1 file")
