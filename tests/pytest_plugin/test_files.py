"""Robots that are tests themselves, by settings of pytest."""

from xml.etree import ElementTree

import pytest

from tests.pytest_plugin.projects import SETTINGS, Project, outcome

pytest_plugins = ["pytester"]


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
        for case in ElementTree.parse(project.directory / "junit.xml").iter("testcase")
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
        ("urdf_files = urdf/*.udrf", "urdf_files: no file in {directory} matches 'urdf/*.udrf'"),
        ("urdf_files = /urdf/*.urdf", "urdf_files: '/urdf/*.urdf': "),
        ("urdf_fail_on = fatal", "urdf_fail_on: 'fatal' is not one of error, warning, info"),
    ],
)
def test_a_typo_in_a_setting_is_reported(project: Project, setting: str, message: str) -> None:
    project.write("pytest.ini", f"[pytest]\n{setting}\n")
    result = project.run()
    assert result.ret == pytest.ExitCode.USAGE_ERROR
    assert f"ERROR: {message.format(directory=project.directory)}" in result.stderr.str()


def test_several_processes_agree(project: Project) -> None:
    pytest.importorskip("xdist")
    project.write("urdfkit.toml", SETTINGS + ROBOT_TABLES)
    project.write("pytest.ini", "[pytest]\nurdf_files = urdf/*.urdf urdf/*.xacro\n")
    project.write_test(
        """
@pytest.mark.urdf("urdf/arm.urdf.xacro", args={"side": ["left", "right"]})
def test_it(robot_model): assert_dof(robot_model, 1)
"""
    )
    text = outcome(project.run_process("-v", "-n", "2"), passed=4, failed=1)
    assert "urdf/broken.urdf:3:63: error REF001" in text
