"""The fixtures that take a path: urdf and check_urdf."""

import pytest

from tests.pytest_plugin.projects import Project, outcome

pytest_plugins = ["pytester"]

HELD = """\
<robot name="held">
  <link name="base"/>
  <link name="arm">
    <inertial>
      <origin xyz="0.1 0 0"/>
      <mass value="1"/>
      <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
    </inertial>
  </link>
  <joint name="shoulder" type="revolute">
    <parent link="base"/>
    <child link="arm"/>
    <axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" effort="10" velocity="1"/>
  </joint>
</robot>
"""


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


@pytest.mark.parametrize("read", ["model", "report"])
def test_an_unknown_argument_is_a_warning(project: Project, read: str) -> None:
    result = project.test(
        f"""
def test_it(urdf):
    with pytest.warns(UserWarning, match="argument 'sid'; did you mean 'side'"):
        urdf("urdf/arm.urdf.xacro", sid="right").{read}
"""
    )
    outcome(result, passed=1)


@pytest.mark.parametrize("fixture", ["urdf", "check_urdf"])
def test_an_unknown_path_is_reported_without_a_traceback(project: Project, fixture: str) -> None:
    text = outcome(
        project.test(f"def test_it({fixture}):\n    {fixture}('urdf/arn.xacro')"), failed=1
    )
    assert f"no such model {project.directory / 'urdf' / 'arn.xacro'}\n" in text
    assert "pytest_plugin/__init__.py" not in text


def test_an_unknown_path_in_a_marker_is_reported_without_a_traceback(project: Project) -> None:
    text = outcome(
        project.test("@pytest.mark.urdf('arn.xacro')\ndef test_it(robot_model): pass"), errors=1
    )
    assert f"no such model {project.directory / 'arn.xacro'}\n" in text
    assert "pytest_plugin/__init__.py" not in text


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


def test_simulate_fails_with_what_the_robot_does(project: Project) -> None:
    pytest.importorskip("mujoco")
    project.write("arm.urdf", HELD)
    project.write("weak.urdf", HELD.replace('effort="10"', 'effort="0.01"'))
    result = project.test(
        """
def test_good(simulate):
    assert simulate("arm.urdf").passes

def test_bad(simulate):
    simulate("weak.urdf")
"""
    )
    text = outcome(result, passed=1, failed=1)
    assert "FAILS hold: joint" in text
    assert "weak.urdf:" in text
    assert "pytest_plugin/__init__.py" not in text
