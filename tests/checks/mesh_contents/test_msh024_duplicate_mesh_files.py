from pathlib import Path

from tests.meshed import SOUND, link, mesh, messages, reported
from tests.naming import naming

OTHER = SOUND[:-3] + b"abc"


def test_a_copy(tmp_path: Path) -> None:
    robot = link(mesh("a.stl"), mesh("b.stl"), mesh("a.stl"), mesh("c.stl"))
    files = {"a.stl": SOUND, "b.stl": SOUND, "c.stl": OTHER}
    (found,) = reported(tmp_path, "MSH024", robot, files)
    assert found.message == naming("arm", "collision", "b.stl", "a.stl")
    assert [note.span.text for note in found.related] == ["a.stl"]


def test_a_robot_is_reported_once(tmp_path: Path) -> None:
    robot = link(mesh("a.stl"), mesh("b.stl"), mesh("c.stl"), mesh("d.stl"), mesh("e.stl"))
    files = dict.fromkeys(("a.stl", "b.stl", "c.stl"), SOUND)
    files |= dict.fromkeys(("d.stl", "e.stl"), OTHER)
    (found,) = messages(tmp_path, "MSH024", robot, files)
    assert found == naming("arm", "collision", "b.stl", "a.stl", "2")


def test_a_link_to_a_file_is_no_copy(tmp_path: Path) -> None:
    (tmp_path / "b.stl").symlink_to(tmp_path / "a.stl")
    robot = link(mesh("a.stl"), mesh("b.stl"))
    assert messages(tmp_path, "MSH024", robot, {"a.stl": SOUND}) == []


def test_broken_files_are_not_reported(tmp_path: Path) -> None:
    robot = link(mesh("a.stl"), mesh("b.stl"))
    assert messages(tmp_path, "MSH024", robot, {"a.stl": b"", "b.stl": b""}) == []
