from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")
pytest.importorskip("manifold3d")

from tests.meshed import link, mesh, messages, reported
from tests.naming import naming
from urdfkit.lint import engine
from urdfkit.lint.config import Config
from urdfkit.lint.options import Options
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.mesh.samples import box, stl
from urdfkit.text.diagnostic import Severity

CUBE = box((0, 0, 0), (1, 1, 1))
MANY = stl(CUBE, copies=1667)


def test_20_004_triangles(tmp_path: Path) -> None:
    assert messages(tmp_path, "MSH019", link(mesh("a.stl")), {"a.stl": MANY}) == [
        naming("arm", "collision", "a.stl", "20,004 triangles", "20,000", "collision")
    ]


def test_mujoco_rejects_it(tmp_path: Path) -> None:
    files = {"a.stl": stl(CUBE, copies=16_667)}
    for targets, severity in (((), Severity.WARNING), (("mujoco",), Severity.ERROR)):
        (found,) = reported(tmp_path, "MSH019", link(mesh("a.stl")), files, targets)
        assert found.message.endswith(" 200,000")
        assert "MuJoCo rejects" in found.message
        assert found.severity is severity


def test_fewer_or_a_visual(tmp_path: Path) -> None:
    files = {"a.stl": MANY, "b.stl": stl(CUBE, copies=1666)}
    robot = link(mesh("a.stl", "visual"), mesh("b.stl"))
    assert messages(tmp_path, "MSH019", robot, files) == []


def test_a_visual_of_100_008_triangles(tmp_path: Path) -> None:
    files = {"a.stl": stl(CUBE, copies=8334), "b.stl": stl(CUBE, copies=8333)}
    robot = link(mesh("a.stl", "visual"), mesh("b.stl", "visual"))
    (found,) = reported(tmp_path, "MSH019", robot, files)
    assert found.severity.value == "info"
    assert found.message == naming("arm", "visual", "a.stl", "100,008 triangles", "100,000")
    both = link(mesh("a.stl", "visual"), mesh("a.stl"))
    (found,) = reported(tmp_path, "MSH019", both, files)
    assert found.severity.value == "warning"


@pytest.mark.parametrize(
    ("cubes", "severity"), [(416, []), (417, ["info"]), (1666, ["info"]), (1667, ["warning"])]
)
def test_a_visual_mesh_used_for_collision(tmp_path: Path, cubes: int, severity: list[str]) -> None:
    robot = link(mesh("a.stl", "visual"), mesh("a.stl"))
    found = reported(tmp_path, "MSH019", robot, {"a.stl": stl(CUBE, copies=cubes)})
    assert [one.severity.value for one in found] == severity


def test_another_file_or_another_link(tmp_path: Path) -> None:
    files = {"a.stl": stl(CUBE, copies=500), "b.stl": stl(CUBE, copies=501)}
    two = link(mesh("a.stl", "visual"), mesh("b.stl")) + link(mesh("a.stl"), name="b")
    assert messages(tmp_path, "MSH019", two, files) == []


@pytest.mark.parametrize(
    ("option", "roles"),
    [
        ("triangles", ("collision",)),
        ("shared-triangles", ("visual", "collision")),
        ("visual-triangles", ("visual",)),
    ],
)
def test_another_bound(tmp_path: Path, option: str, roles: tuple[str, ...]) -> None:
    robot = link(*(mesh("a.stl", role) for role in roles))
    (tmp_path / "a.stl").write_bytes(stl(CUBE))
    (tmp_path / "robot.urdf").write_text(whole_robot(robot))
    for bound, count in ((11, 1), (12, 0)):
        config = Config(options={"MSH019": {option: bound}})
        options = Options(select=["MSH019"], config=config, cache=False)
        assert len(engine.check(tmp_path / "robot.urdf", options=options).diagnostics) == count
