"""The marker, and the fixtures that give what it names."""

import pytest

from tests.mesh.made import binary_stl
from tests.pytest_plugin.projects import ARM, Project, outcome
from urdfkit.core.installation import install_command
from urdfkit.core.libraries import why_unmeasured

pytest_plugins = ["pytester"]


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
    project.write_test(
        """
import sys
sys.modules["pinocchio"] = None
@pytest.mark.urdf("urdf/arm.urdf.xacro")
def test_one(robot_dynamics):
    assert False
"""
    )
    assert install_command("dynamics") in outcome(project.run("-rs"), skipped=1)


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
    path = project.directory / "urdf" / "arm.urdf.xacro"
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
    block = 'from urdfkit.core import libraries; libraries.missing_for_meshes = lambda: "numpy"\n'
    project.write_test(block + MEASURED)
    text = outcome(project.run_process("-rs"), skipped=1)
    assert install_command("meshes") in text


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
        ("'a', arguments={}", "takes a path, args, variant and variants, not arguments"),
        ("", "takes a path, args, variant and variants"),
    ],
)
def test_a_wrong_marker_is_reported(project: Project, marker: str, message: str) -> None:
    result = project.test(f"@pytest.mark.urdf({marker})\ndef test_it(robot_model): pass")
    assert f"@pytest.mark.urdf {message}\n" in outcome(result, errors=1)


def test_a_missing_marker_is_reported(project: Project) -> None:
    result = project.test("def test_it(robot_model): pass")
    assert 'mark the test with its model: @pytest.mark.urdf("path")' in outcome(result, errors=1)


def test_a_model_that_cannot_be_read_fails_with_what_is_wrong(project: Project) -> None:
    project.write("urdf/bad.xacro", ARM.replace("$(arg side)_tip", "${tip}"))
    result = project.test("@pytest.mark.urdf('urdf/bad.xacro')\ndef test_it(robot_model): pass")
    assert "urdf/bad.xacro:5:15: error XAC001" in outcome(result, errors=1)
