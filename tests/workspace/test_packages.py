import os
from collections.abc import Mapping
from pathlib import Path

import pytest

from tests.workspaces import add_file, add_package, record_listings
from urdfkit.workspace import package_scan as module
from urdfkit.workspace.directories import Directories
from urdfkit.workspace.packages import Candidate, Packages
from urdfkit.workspace.search_root import ScannedDirectory


def finder(
    environment: Mapping[str, str] | None = None, explicit: Mapping[str, str] | None = None
) -> Packages:
    return Packages(explicit or {}, environment or {}, Directories())


def first(packages: Packages, name: str, near: Path) -> str | None:
    candidate = next(packages.candidates(name, str(near)), None)
    return candidate and candidate.directory


def test_above_the_file(tmp_path: Path) -> None:
    package = add_package(tmp_path / "any_directory", "arm")
    assert first(finder(), "arm", package / "urdf" / "deep" / "arm.urdf") == str(package)
    assert first(finder(), "wrong", package / "urdf" / "arm.urdf") is None


def test_the_outer_of_two_nested_packages_wins(tmp_path: Path) -> None:
    """colcon and catkin do not look inside a package."""
    outer = add_package(tmp_path / "outer", "arm")
    inner = add_package(outer / "inner", "arm")
    assert first(finder(), "arm", inner / "arm.urdf") == str(outer)
    assert finder().known(str(inner / "arm.urdf")) == {"arm": str(outer)}


def test_rosbuild(tmp_path: Path) -> None:
    add_file(tmp_path / "old_arm" / "manifest.xml", b"<package><author>x</author></package>")
    add_file(tmp_path / "android" / "manifest.xml", b"<manifest/>")
    packages = finder()
    assert packages.name_of(str(tmp_path / "old_arm")) == "old_arm"
    assert packages.name_of(str(tmp_path / "android")) is None


@pytest.mark.parametrize("marker", [b"", b"<package/>", b"<package><name/></package>", b"\xff"])
def test_a_package_xml_without_a_name_is_no_package(tmp_path: Path, marker: bytes) -> None:
    add_file(tmp_path / "package.xml", marker)
    assert finder().name_of(str(tmp_path)) is None


def test_explicit_wins_and_is_the_only_place(tmp_path: Path) -> None:
    add_package(tmp_path / "a", "arm")
    other = add_file(tmp_path / "b" / "arm.urdf").parent
    near = tmp_path / "a" / "arm.urdf"
    assert first(finder(explicit={"arm": str(other)}), "arm", near) == str(other)
    none = finder(explicit={"arm": str(tmp_path / "none")})
    assert first(none, "arm", near) is None
    assert none.searched("arm", str(near)) == (
        f"{tmp_path / 'none'} (given for arm; no such directory)",
    )


def test_ament_prefixes_in_order(tmp_path: Path) -> None:
    near = tmp_path / "model" / "arm.urdf"
    for prefix in ("one", "two"):
        add_package(tmp_path / prefix / "share" / "arm", "arm")
    path = os.pathsep.join(str(tmp_path / name) for name in ("none", "two", "one"))
    found = next(finder({"AMENT_PREFIX_PATH": path}).candidates("arm", str(near)))
    assert found == Candidate(str(tmp_path / "two" / "share" / "arm"), trusted=True)


def test_ros_package_path(tmp_path: Path) -> None:
    near = tmp_path / "model" / "arm.urdf"
    source = tmp_path / "ws" / "src"
    direct = add_package(source / "arm", "arm")
    deep = add_package(source / "stack" / "renamed", "hand")
    itself = add_package(tmp_path / "tool", "tool")
    packages = finder({"ROS_PACKAGE_PATH": os.pathsep.join((str(source), str(itself)))})
    assert first(packages, "arm", near) == str(direct)
    assert first(packages, "hand", near) == str(deep)
    assert first(packages, "tool", near) == str(itself)


def test_the_own_package_wins_over_the_installed_one(tmp_path: Path) -> None:
    installed = add_package(tmp_path / "prefix" / "share" / "arm", "arm")
    own = add_package(tmp_path / "src" / "arm", "arm")
    packages = finder({"AMENT_PREFIX_PATH": str(tmp_path / "prefix")})
    assert first(packages, "arm", own / "urdf" / "arm.urdf") == str(own)
    assert first(packages, "arm", tmp_path / "else" / "arm.urdf") == str(installed)


@pytest.mark.parametrize("marker", [".git/HEAD", "src"])
def test_a_repository_or_workspace_is_searched_to_its_outermost_directory(
    tmp_path: Path, marker: str
) -> None:
    root = tmp_path / "src" if marker == "src" else tmp_path
    if marker != "src":
        add_file(tmp_path / marker)
    near = add_package(root / "a" / "b" / "c" / "d" / "e" / "arm", "arm") / "arm.urdf"
    far = add_package(root / "z" / "y" / "x" / "w" / "v" / "hand", "hand")
    packages = finder()
    assert first(packages, "hand", near) == str(far)
    assert packages.workspace(str(near)) == str(root)


def test_the_outermost_repository_counts(tmp_path: Path) -> None:
    add_file(tmp_path / ".git" / "HEAD")
    add_file(tmp_path / "sub" / ".git", b"gitdir: ../.git/modules/sub")
    near = add_package(tmp_path / "sub" / "arm", "arm") / "arm.urdf"
    hand = add_package(tmp_path / "other" / "hand", "hand")
    assert first(finder(), "hand", near) == str(hand)
    assert finder().workspace(str(near)) == str(tmp_path)


def test_build_results_are_passed_over(tmp_path: Path) -> None:
    add_file(tmp_path / ".git" / "HEAD")
    near = add_package(tmp_path / "arm", "arm") / "arm.urdf"
    for directory in ("build", "install", "log", "node_modules", ".hidden"):
        add_package(tmp_path / directory / "hand", "hand")
    assert first(finder(), "hand", near) is None


def test_links_in_circles_end(tmp_path: Path) -> None:
    add_file(tmp_path / ".git" / "HEAD")
    near = add_package(tmp_path / "arm", "arm") / "arm.urdf"
    os.symlink("..", tmp_path / "arm" / "up")
    elsewhere = add_package(tmp_path / "elsewhere" / "hand", "hand")
    os.symlink(elsewhere, tmp_path / "arm" / "linked")
    packages = finder()
    assert first(packages, "none", near) is None
    assert packages.searched("none", str(near))[3] == f"below {tmp_path / 'arm'} (2 packages)"


def root(near: Path) -> tuple[str, str]:
    found = finder().root(str(near))
    return found.directory, found.mark


def test_a_repository_sees_nothing_of_the_clones_next_to_it(tmp_path: Path) -> None:
    near = add_package(tmp_path / "one" / "arm", "arm") / "arm.urdf"
    add_file(tmp_path / "one" / ".git" / "HEAD")
    add_package(tmp_path / "two" / "hand", "hand")
    add_file(tmp_path / "two" / ".git" / "HEAD")
    assert first(finder(), "hand", near) is None
    assert first(finder(), "two", near) is None
    assert finder().known(str(near)) == {"arm": str(near.parent)}
    assert root(near) == (str(tmp_path / "one"), ".git")


@pytest.mark.parametrize("git", [".git/HEAD", ".git"])
def test_a_clone_or_worktree_inside_a_repository_ends_the_search(tmp_path: Path, git: str) -> None:
    add_file(tmp_path / ".git" / "HEAD")
    near = add_package(tmp_path / "clones" / "arm", "arm") / "arm.urdf"
    add_file(near.parent / git, b"gitdir: ../../.git/worktrees/arm")
    add_package(tmp_path / "hand", "hand")
    assert first(finder(), "hand", near) is None
    assert root(near) == (str(near.parent), ".git")


@pytest.mark.parametrize(
    ("mark", "reported"),
    [
        ("src/.keep", "src"),
        (".catkin_workspace", ".catkin_workspace"),
        (".catkin_tools/README", ".catkin_tools"),
        ("install/COLCON_IGNORE", os.path.join("install", "COLCON_IGNORE")),
    ],
)
def test_the_repositories_of_a_workspace_see_one_another(
    tmp_path: Path, mark: str, reported: str
) -> None:
    add_file(tmp_path / "ws" / mark)
    source = tmp_path / "ws" / "src" if reported == "src" else tmp_path / "ws"
    near = add_package(source / "one" / "arm", "arm") / "arm.urdf"
    add_file(source / "one" / ".git" / "HEAD")
    hand = add_package(source / "two" / "hand", "hand")
    add_file(source / "two" / ".git" / "HEAD")
    add_package(tmp_path / "ws" / "install" / "foot", "foot")
    add_package(tmp_path / "else" / "leg", "leg")
    assert root(near) == (str(source), reported)
    assert first(finder(), "hand", near) == str(hand)
    assert first(finder(), "foot", near) is None
    assert first(finder(), "leg", near) is None


def test_the_repository_around_a_workspace_counts(tmp_path: Path) -> None:
    """Whether somebody has built it, which leaves marks, makes no difference."""
    add_file(tmp_path / ".git" / "HEAD")
    near = add_package(tmp_path / "ws" / "src" / "arm", "arm") / "arm.urdf"
    assert root(near) == (str(tmp_path), ".git")
    add_file(tmp_path / "ws" / "log" / "COLCON_IGNORE")
    assert root(near) == (str(tmp_path), ".git")


def test_an_archive_has_the_files_of_its_top(tmp_path: Path) -> None:
    near = add_package(tmp_path / "robot" / "parts" / "arm", "arm") / "arm.urdf"
    add_file(near.parent / "LICENSE")
    add_file(tmp_path / "robot" / "LICENSE.txt")
    hand = add_package(tmp_path / "robot" / "hand", "hand")
    add_package(tmp_path / "foot", "foot")
    assert root(near) == (str(tmp_path / "robot"), "LICENSE.txt")
    assert first(finder(), "hand", near) == str(hand)
    assert first(finder(), "foot", near) is None


def test_packages_alone_in_a_directory_are_of_one_repository(tmp_path: Path) -> None:
    near = add_package(tmp_path / "arm", "arm") / "urdf" / "arm.urdf"
    hand = add_package(tmp_path / "hand", "hand")
    assert first(finder(), "hand", near) == str(hand)
    assert root(near) == (str(tmp_path / "arm"), "")  # and nothing else is edited


def test_packages_that_depend_on_one_another_are_a_workspace(tmp_path: Path) -> None:
    workspace = tmp_path / "ws"
    robots = [
        add_package(workspace / name, name) / "urdf" / f"{name}.urdf" for name in ("arm", "hand")
    ]
    assert [root(robot)[1] for robot in robots] == ["", ""]
    text = "<package><name>hand</name><exec_depend>arm</exec_depend></package>"
    (workspace / "hand" / "package.xml").write_text(text)
    assert {root(robot) for robot in robots} == {(str(workspace), "package.xml")}
    foot = add_package(workspace / "examples" / "foot", "foot")
    assert {root(robot)[1] for robot in robots} == {""}  # of another repository
    (foot / "package.xml").write_text(text.replace("hand", "foot"))
    for robot in (*robots, foot / "foot.urdf"):
        assert root(robot) == (str(workspace), "package.xml")
    assert first(finder(), "foot", robots[0]) == str(foot)


@pytest.mark.parametrize("other", ["repository/foot/package.xml", "hand/.git/HEAD"])
def test_a_directory_of_repositories_is_none(tmp_path: Path, other: str) -> None:
    near = add_package(tmp_path / "arm", "arm") / "urdf" / "arm.urdf"
    add_package(tmp_path / "hand", "hand")
    add_file(tmp_path / other, b"<package><name>foot</name></package>")
    assert first(finder(), "hand", near) is None
    assert finder().known(str(near)) == {"arm": str(tmp_path / "arm")}


def test_where_nothing_is_known_the_search_ends_at_the_directory(tmp_path: Path) -> None:
    near = add_file(tmp_path / "robots" / "arm.urdf")
    add_package(tmp_path / "hand", "hand")
    foot = add_package(tmp_path / "robots" / "foot", "foot")
    assert first(finder(), "hand", near) is None
    assert first(finder(), "foot", near) == str(foot)
    assert root(near) == (str(tmp_path / "robots"), "")


def test_the_nearest_of_two_packages_of_a_name(tmp_path: Path) -> None:
    add_file(tmp_path / ".git" / "HEAD")
    near = add_package(tmp_path / "ros2" / "arm", "arm") / "arm.urdf"
    add_package(tmp_path / "ros1" / "hand", "hand")
    hand = add_package(tmp_path / "ros2" / "hand", "hand")
    assert first(finder(), "hand", near) == str(hand)


def test_a_package_that_the_build_skips_comes_last(tmp_path: Path) -> None:
    """A workspace keeps an old version next to the one that colcon builds."""
    add_file(tmp_path / "src" / "old" / "COLCON_IGNORE")
    old = add_package(tmp_path / "src" / "old" / "arm", "arm")
    foot = add_package(tmp_path / "src" / "old" / "foot", "foot")
    arm = add_package(tmp_path / "src" / "robots" / "v2" / "arm", "arm")
    near = add_package(tmp_path / "src" / "bringup", "bringup") / "arm.urdf"
    assert first(finder(), "arm", near) == str(arm)
    assert first(finder(), "foot", near) == str(foot)
    assert first(finder(), "arm", foot / "foot.urdf") == str(old)


def test_nested_packages_of_neighbours_are_not_looked_for(tmp_path: Path) -> None:
    near = add_package(tmp_path / "arm", "arm") / "arm.urdf"
    add_package(tmp_path / "hand", "hand")
    add_package(tmp_path / "hand" / "test" / "pack", "pack")
    assert first(finder(), "pack", near) is None


def test_nobody_scans_the_home_directory(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("USERPROFILE", str(tmp_path))
    add_file(tmp_path / ".git" / "HEAD")  # people keep their settings so
    near = add_package(tmp_path / "arm", "arm") / "arm.urdf"
    add_package(tmp_path / "private", "private")
    packages = finder()
    assert first(packages, "private", near) is None
    assert packages.levels(str(near)) == (ScannedDirectory(str(near.parent), True),)
    assert packages.workspace(str(near)) == str(near.parent)
    for name in ("tmp", "home", "etc", "usr"):
        assert first(packages, name, near) is None


def test_a_directory_of_that_name_is_uncertain(tmp_path: Path) -> None:
    add_file(tmp_path / "LICENSE")
    near = add_file(tmp_path / "icub" / "robots" / "v2" / "model.urdf")
    beside = add_file(tmp_path / "icub" / "meshes_pack" / "arm.stl").parent
    packages = finder()
    assert list(packages.candidates("icub", str(near))) == [
        Candidate(str(tmp_path / "icub"), certain=False)
    ]
    assert list(packages.candidates("meshes_pack", str(near))) == [
        Candidate(str(beside), certain=False)
    ]
    real = add_package(tmp_path / "x" / "icub_pack", "icub")
    assert list(finder().candidates("icub", str(near))) == [
        Candidate(str(tmp_path / "icub"), certain=False),
        Candidate(str(real)),
    ]


@pytest.mark.parametrize("name", ["", ".", "..", "a/b", "a\\b", "\0"])
def test_strange_names_are_no_packages(tmp_path: Path, name: str) -> None:
    near = add_package(tmp_path / "arm", "arm") / "arm.urdf"
    assert first(finder(), name, near) is None


def test_what_was_searched_is_reported(tmp_path: Path) -> None:
    add_file(tmp_path / "repo" / ".git" / "HEAD")
    near = add_package(tmp_path / "repo" / "arm", "arm") / "urdf" / "arm.urdf"
    environment = {"AMENT_PREFIX_PATH": f"/opt/a{os.pathsep}/opt/b"}
    assert finder(environment).searched("none", str(near)) == (
        f"{near.parent} and its parent directories",
        f"AMENT_PREFIX_PATH (/opt/a{os.pathsep}/opt/b)",
        "ROS_PACKAGE_PATH (not set)",
        f"below {tmp_path / 'repo' / 'arm'} (1 package)",
        f"below {tmp_path / 'repo'} (1 package)",
    )


def test_scans_are_bounded_and_say_so(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "MAX_DIRECTORIES", 10)
    add_file(tmp_path / ".git" / "HEAD")
    near = add_package(tmp_path / "arm", "arm") / "arm.urdf"
    for number in range(30):
        (tmp_path / f"directory_{number:02}").mkdir()
    add_package(tmp_path / "zzz_directory", "zzz")
    packages = finder()
    assert first(packages, "zzz", near) is None
    assert f"below {tmp_path} (1 package, stopped after 10 directories)" in packages.searched(
        "zzz", str(near)
    )
    monkeypatch.setattr(module, "MAX_DIRECTORIES", 1000)
    monkeypatch.setattr(module, "MAX_SECONDS", 0.0)
    assert first(finder(), "zzz", near) is None


def test_the_same_directories_are_listed_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    add_file(tmp_path / ".git" / "HEAD")
    near = add_package(tmp_path / "a" / "arm", "arm") / "arm.urdf"
    for number in range(20):
        add_package(tmp_path / "b" / f"p{number}", f"p{number}")
    packages = finder()
    listed = record_listings(monkeypatch)
    for number in range(20):
        assert first(packages, f"p{number}", near)
        assert first(packages, f"none{number}", near) is None
    assert len(listed) == len(set(listed))


def test_known_packages_and_gazebo_model_paths(tmp_path: Path) -> None:
    add_file(tmp_path / ".git" / "HEAD")
    arm = add_package(tmp_path / "arm", "arm")
    sim = tmp_path / "sim"
    add_file(
        sim / "package.xml",
        b"<package><name>sim</name><export>"
        b'<!-- <gazebo_ros gazebo_model_path="${prefix}/old"/> -->'
        b"<gazebo_ros plugin_path='x' gazebo_model_path='${prefix}/models:${prefix}/../b:/c'/>"
        b"</export></package>",
    )
    packages = finder()
    near = str(arm / "urdf" / "arm.urdf")
    assert packages.known(near) == {"arm": str(arm), "sim": str(sim)}
    assert list(packages.gazebo_model_paths(near)) == [(str(sim), "/models"), (str(sim), "/../b")]


def test_the_package_around_a_clone_is_not_its_own(tmp_path: Path) -> None:
    outer = add_package(tmp_path / "outer", "outer")
    near = str(add_file(outer / "third_party" / "arm" / "urdf" / "arm.urdf"))
    add_file(outer / "third_party" / "arm" / ".git" / "HEAD")
    packages = finder()
    assert packages.enclosing(near) is None
    assert packages.workspace(near) == str(outer / "third_party" / "arm")
    assert next(packages.candidates("outer", near), None) is None


def test_a_robot_without_a_package_belongs_to_the_directory_of_its_meshes(tmp_path: Path) -> None:
    near = add_file(tmp_path / "arm" / "urdf" / "arm.urdf")
    assert root(near) == (str(near.parent), "")
    add_file(tmp_path / "arm" / "meshes" / "link.stl")
    assert root(near) == (str(tmp_path / "arm"), "")
    add_package(near.parent, "arm")
    assert root(near) == (str(near.parent), "")


def test_meshes_far_above_a_robot_are_not_its_own(tmp_path: Path) -> None:
    add_file(tmp_path / "arm" / "meshes" / "link.stl")
    near = add_file(tmp_path / "arm" / "a" / "b" / "c" / "arm.urdf")
    assert root(near) == (str(near.parent), "")


@pytest.mark.parametrize(
    ("link", "mark", "is_followed"),
    [
        ("repository/hands", "repository/.git/HEAD", False),
        ("repository/arm/src/hands", "repository/.git/HEAD", False),
        ("src/repository/hands", "src/repository/.git/HEAD", False),
        ("unpacked/hands", "unpacked/LICENSE", False),
        ("src/hands", "src/repository/.git/HEAD", True),  # which the user made
        ("src/hands", ".git/HEAD", False),  # a workspace that is a repository
    ],
)
def test_a_link_out_of_a_repository_leads_to_no_package(
    tmp_path: Path, link: str, mark: str, is_followed: bool
) -> None:
    """A pull request may bring it, to read what it has no business with."""
    outside = add_package(tmp_path / "outside" / "hand", "hand")
    top = tmp_path / "top"
    add_file(top / mark)
    at = top / link
    near = add_package(top / Path(link).parts[0] / "repository" / "arm", "arm") / "arm.urdf"
    at.parent.mkdir(parents=True, exist_ok=True)
    at.symlink_to(outside.parent)
    expected = str(at / "hand") if is_followed else None
    assert first(finder(), "hand", near) == expected
