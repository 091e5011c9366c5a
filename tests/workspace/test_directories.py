import os
from pathlib import Path

import pytest

from tests.workspaces import add_file, record_listings
from urdfkit.workspace.directories import Directories, walk


def test_a_file_is_found_by_its_exact_name(tmp_path: Path) -> None:
    arm = add_file(tmp_path / "meshes" / "visual" / "Arm.STL")
    directories = Directories()
    assert directories.find(str(tmp_path), "meshes/visual/Arm.STL") == str(arm)
    assert directories.find(str(tmp_path), "./meshes//visual/../visual/Arm.STL") == str(arm)
    assert directories.find(str(tmp_path / "meshes"), "../meshes/visual/Arm.STL") == str(arm)
    for wrong in (
        "meshes/visual/arm.stl",
        "Meshes/visual/Arm.STL",
        "meshes/visual",
        "meshes/visual/..",
        "meshes/visual/Arm.STL/more",
        "meshes/none/Arm.STL",
        "",
        ".",
        "\0",
    ):
        assert directories.find(str(tmp_path), wrong) is None, wrong


def test_case_is_distinguished(tmp_path: Path) -> None:
    add_file(tmp_path / "meshes" / "Arm.STL")
    directories = Directories()
    assert directories.find_ignoring_case(str(tmp_path), "MESHES/arm.stl") == "meshes/Arm.STL"
    assert directories.find_ignoring_case(str(tmp_path), "meshes/Arm.STL") == "meshes/Arm.STL"
    assert directories.find_ignoring_case(str(tmp_path / "meshes"), "../Meshes/arm.stl") == (
        "../meshes/Arm.STL"
    )
    assert directories.find_ignoring_case(str(tmp_path), "meshes/hand.stl") is None
    assert directories.find_ignoring_case(str(tmp_path), "") is None


def test_of_two_names_that_differ_in_case_none_is_meant(tmp_path: Path) -> None:
    add_file(tmp_path / "Arm.stl")
    add_file(tmp_path / "ARM.stl")
    if len(os.listdir(tmp_path)) < 2:
        pytest.skip("this file system does not tell upper and lower case apart")
    assert Directories().find_ignoring_case(str(tmp_path), "arm.stl") is None
    assert Directories().find_ignoring_case(str(tmp_path), "ARM.stl") == "ARM.stl"


def test_links_that_lead_nowhere_or_in_circles_are_no_files(tmp_path: Path) -> None:
    os.symlink("nowhere.stl", tmp_path / "gone.stl")
    os.symlink("circle", tmp_path / "circle")
    add_file(tmp_path / "real.stl")
    os.symlink("real.stl", tmp_path / "link.stl")
    directories = Directories()
    assert directories.entries(str(tmp_path)) == {"real.stl": False, "link.stl": False}
    assert directories.find(str(tmp_path), "gone.stl") is None
    assert directories.find(str(tmp_path), "link.stl") == str(tmp_path / "link.stl")


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="pipes have no names here")
def test_pipes_and_devices_are_no_files(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.yaml")
    (tmp_path / "null.yaml").symlink_to(os.devnull)
    add_file(tmp_path / "a.yaml")
    assert Directories().entries(str(tmp_path)) == {"a.yaml": False}


def test_every_directory_is_listed_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for number in range(100):
        add_file(tmp_path / "meshes" / f"link_{number}.stl")
    listed = record_listings(monkeypatch)
    directories = Directories()
    for number in range(100):
        assert directories.find(str(tmp_path), f"meshes/link_{number}.stl")
        assert directories.find(str(tmp_path), f"none/link_{number}.stl") is None
    assert sorted(listed) == [str(tmp_path), str(tmp_path / "meshes")]


@pytest.mark.skipif(os.name != "posix" or os.geteuid() == 0, reason="permissions do not bind root")
def test_a_directory_that_may_be_entered_but_not_listed(tmp_path: Path) -> None:
    arm = add_file(tmp_path / "meshes" / "arm.stl")
    (tmp_path / "meshes").chmod(0o100)
    try:
        assert Directories().find(str(tmp_path), "meshes/arm.stl") == str(arm)
    finally:
        (tmp_path / "meshes").chmod(0o700)


def test_files_below_come_nearest_first_and_are_bounded(tmp_path: Path) -> None:
    for name in (
        "b.stl",
        "a/d/e.stl",
        "a/c.stl",
        ".git/config",
        "build/b.stl",
        "venv/site-packages/m.stl",
    ):
        add_file(tmp_path / name)
    os.symlink("..", tmp_path / "a" / "up")
    found = Directories().files_below(str(tmp_path), 100)
    assert [os.path.relpath(path, tmp_path) for path in found] == ["b.stl", "a/c.stl", "a/d/e.stl"]
    assert len(Directories().files_below(str(tmp_path), 2)) == 2


def test_a_walk_lists_what_os_walk_lists_and_each_directory_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("b/x", "b/a/y", "a/z", "top", "build/made", "lib/site-packages/x", ".git/config"):
        add_file(tmp_path / name)
    (tmp_path / "dead").symlink_to("nowhere")
    (tmp_path / "round").symlink_to(tmp_path)
    expected = [*walk(str(tmp_path))]
    listed = record_listings(monkeypatch)
    directories = Directories()
    assert directories.walk(str(tmp_path)) == expected
    assert [os.path.relpath(path, tmp_path) for path in expected] == [
        "dead", "top", "a/z", "b/x", "b/a/y",
    ]  # fmt: skip
    monkeypatch.chdir(tmp_path)
    assert directories.walk(".")[:2] == ["./dead", "./top"]
    directories.files_below(str(tmp_path), 100)
    assert len(listed) == len(set(listed))


def test_a_workspace_of_many_directories_is_listed_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """autoware.universe has more directories than listings are kept."""
    monkeypatch.setattr("urdfkit.workspace.directories.LIMIT", 4)
    for name in ("a", "b", "c", "d", "e", "f"):
        add_file(tmp_path / name / "x")
    directories = Directories()
    listed = record_listings(monkeypatch)
    for _ in range(3):
        assert len(directories.files_below(str(tmp_path), 100)) == 6
    assert len(listed) == 7
