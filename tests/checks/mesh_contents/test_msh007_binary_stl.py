from pathlib import Path

import pytest

from tests.mesh import made
from tests.meshed import SOUND, link, mesh, messages, reported
from tests.naming import naming
from urdfkit import Severity
from urdfkit.mesh.samples import box, stl

MISLEADING = stl(box((0, 0, 0), (1, 1, 1)), b"solid part")
TEXT = made.ascii_stl()


def test_a_binary_one_that_says_solid(tmp_path: Path) -> None:
    assert messages(tmp_path, "MSH007", link(mesh("a.stl")), {"a.stl": MISLEADING}) == [
        naming("arm", "collision", "a.stl", "binary", "STL", "solid")
    ]


def test_a_file_is_reported_once(tmp_path: Path) -> None:
    robot = link(mesh("a.stl"), mesh("b.stl"), mesh("a.stl"))
    found = messages(tmp_path, "MSH007", robot, {"a.stl": MISLEADING, "b.stl": MISLEADING})
    assert [message.split("'")[3] for message in found] == ["a.stl", "b.stl"]


@pytest.mark.parametrize("data", [SOUND, TEXT])
def test_others(tmp_path: Path, data: bytes) -> None:
    assert messages(tmp_path, "MSH007", link(mesh("a.stl")), {"a.stl": data}) == []


def test_an_ascii_one_in_rviz_2(tmp_path: Path) -> None:
    files = {"a.stl": TEXT, "b.stl": SOUND}
    both = link(mesh("a.stl", "visual"), mesh("b.stl", "visual"))
    (found,) = reported(tmp_path, "MSH007", both, files, ("ros2",))
    assert found.message == naming(
        "arm", "visual", "a.stl", "ASCII", "STL", "RViz 2", "ROS 2", "Iron"
    )
    assert found.severity is Severity.INFO
    assert reported(tmp_path, "MSH007", both, files, ("ros1",)) == []
    collision = link(mesh("a.stl"))
    assert reported(tmp_path, "MSH007", collision, files, ("ros2",)) == []
    (error,) = reported(tmp_path, "MSH007", collision, files, ("mujoco",))
    assert error.severity is Severity.ERROR
