import os
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.workspaces import add_file, add_package, record_listings
from urdfkit import check, load
from urdfkit.cli import main
from urdfkit.errors import PackageNotFound, UnreadableFile
from urdfkit.lint.loading import expand
from urdfkit.workspace.references import ResolvedReference
from urdfkit.workspace.resolve import Resolver


@pytest.fixture
def arm(tmp_path: Path) -> Path:
    """A package with a model and two meshes."""
    package = add_package(tmp_path / "arm_description", "arm")
    add_file(package / "urdf" / "arm.urdf")
    add_file(package / "meshes" / "link.stl")
    add_file(package / "meshes" / "two words.stl")
    return package


def resolver(**environment: str) -> Resolver:
    return Resolver(environment=environment)


def locate(package: Path, reference: str, **environment: str) -> ResolvedReference:
    return resolver(**environment).locate(reference, str(package / "urdf" / "arm.urdf"))


@pytest.mark.parametrize(
    ("reference", "scheme", "file"),
    [
        ("package://arm/meshes/link.stl", "package", "link.stl"),
        ("package://arm//meshes/./link.stl", "package", "link.stl"),
        ("package://arm/meshes/../meshes/link.stl", "package", "link.stl"),
        ("PACKAGE://arm/meshes/link.stl", "package", "link.stl"),
        ("package://arm\\meshes\\link.stl", "package", "link.stl"),
        ("package://arm/meshes/two words.stl", "package", "two words.stl"),
        ("package://arm/meshes/two%20words.stl", "package", "two words.stl"),
        ("model://arm/meshes/link.stl", "model", "link.stl"),
        ("../meshes/link.stl", "relative", "link.stl"),
        ("..\\meshes\\link.stl", "relative", "link.stl"),
        ("../meshes/two%20words.stl", "relative", "two words.stl"),
        ("file://../meshes/link.stl", "relative", "link.stl"),
        ("{}/meshes/link.stl", "absolute", "link.stl"),
        ("file://{}/meshes/link.stl", "absolute", "link.stl"),
        ("file:{}/meshes/link.stl", "absolute", "link.stl"),
        ("file://localhost{}/meshes/link.stl", "absolute", "link.stl"),
        ("file://{}/meshes/two%20words.stl", "absolute", "two words.stl"),
        ("file://{}/urdf/../meshes/link.stl", "absolute", "link.stl"),
    ],
)
def test_a_reference_leads_to_its_file(arm: Path, reference: str, scheme: str, file: str) -> None:
    reference = reference.format(arm)
    located = locate(arm, reference)
    assert located.path == str(arm / "meshes" / file)
    assert (located.reference, located.scheme) == (reference, scheme)
    if scheme in ("package", "model"):
        assert (located.package, located.directory) == ("arm", str(arm))
    else:
        assert (located.package, located.directory) == (None, None)


def test_a_missing_file_names_what_was_tried(arm: Path) -> None:
    located = locate(arm, "package://arm/meshes/no%20link.stl")
    assert located == ResolvedReference(
        "package://arm/meshes/no%20link.stl",
        "package",
        "arm",
        str(arm),
        "meshes/no%20link.stl",
        None,
        (str(arm / "meshes" / "no%20link.stl"), str(arm / "meshes" / "no link.stl")),
    )
    assert locate(arm, "../none.stl").tried == (str(arm / "none.stl"),)
    assert locate(arm, "/no/such.stl").tried == ("/no/such.stl",)


def test_a_missing_package_is_another_thing(arm: Path) -> None:
    located = locate(arm, "package://hand/meshes/link.stl")
    assert (located.package, located.directory, located.path) == ("hand", None, None)
    assert located.tried == ()
    assert located.searched[:3] == (
        f"{arm / 'urdf'} and its parent directories",
        "AMENT_PREFIX_PATH (not set)",
        "ROS_PACKAGE_PATH (not set)",
    )
    with pytest.raises(PackageNotFound) as error:
        resolver().package("hand", str(arm / "urdf" / "arm.urdf"))
    assert (error.value.name, error.value.searched) == ("hand", located.searched)


@pytest.mark.parametrize("reference", ["package:///arm/meshes/link.stl", "package://", "model:///"])
def test_an_empty_package_is_not_found(arm: Path, reference: str) -> None:
    located = locate(arm, reference)
    assert (located.package, located.directory, located.path) == ("", None, None)


@pytest.mark.parametrize("reference", ["package://arm", "package://arm/", "package://arm/meshes"])
def test_a_directory_is_no_file(arm: Path, reference: str) -> None:
    located = locate(arm, reference)
    assert (located.directory, located.path) == (str(arm), None)


def test_other_schemes_are_not_followed(arm: Path) -> None:
    located = locate(arm, "https://example.org/link.stl")
    assert located == ResolvedReference("https://example.org/link.stl", "https")


def test_relative_to_the_checked_file_first_then_to_the_file_it_stands_in(arm: Path) -> None:
    other = add_package(arm.parent / "hand_description", "hand")
    near = str(add_file(other / "urdf" / "hand.xacro"))
    top = str(arm / "urdf" / "arm.urdf")
    find = resolver().locate
    only_near = add_file(other / "meshes" / "palm.stl")
    assert find("../meshes/palm.stl", near, top).path == str(only_near)
    add_file(other / "meshes" / "link.stl")
    assert find("../meshes/link.stl", near, top).path == str(arm / "meshes" / "link.stl")
    assert find("../none.stl", near, top).tried == (str(arm / "none.stl"), str(other / "none.stl"))


def test_models_are_found_as_gazebo_finds_them(arm: Path) -> None:
    models = arm.parent / "models"
    whole = add_file(models / "lidar.stl")
    inside = add_file(models / "arm" / "meshes" / "link.stl")
    for variable in ("GAZEBO_MODEL_PATH", "GZ_SIM_RESOURCE_PATH", "IGN_GAZEBO_RESOURCE_PATH"):
        environment = {variable: f"/none{os.pathsep}{models}"}
        assert locate(arm, "model://lidar.stl", **environment).path == str(whole)
        assert locate(arm, "model://arm/meshes/link.stl", **environment).path == str(inside)
    missing = locate(arm, "model://lidar.stl")
    assert (missing.package, missing.directory, missing.path) == ("lidar.stl", None, None)
    assert missing.searched[:3] == (
        "GZ_SIM_RESOURCE_PATH (not set)",
        "IGN_GAZEBO_RESOURCE_PATH (not set)",
        "GAZEBO_MODEL_PATH (not set)",
    )


def test_packages_may_add_to_the_model_path(arm: Path) -> None:
    simulation = arm.parent / "simulation"
    lidar = add_file(simulation / "meshes" / "lidar.stl")
    add_file(
        simulation / "package.xml",
        b"<package><name>simulation</name><export>"
        b'<gazebo_ros gazebo_model_path="${prefix}/meshes"/></export></package>',
    )
    assert locate(arm, "model://lidar.stl").path == str(lidar)
    assert locate(arm, "model://none.stl").tried == (str(simulation / "meshes" / "none.stl"),)


def test_the_directory_with_the_file_among_directories_of_that_name(tmp_path: Path) -> None:
    near = add_file(tmp_path / "robot" / "v1" / "robot" / "urdf" / "x.urdf")
    outer = add_file(tmp_path / "robot" / "meshes" / "outer.stl")
    inner = add_file(tmp_path / "robot" / "v1" / "robot" / "meshes" / "inner.stl")
    find = resolver().locate
    assert find("package://robot/meshes/inner.stl", str(near)).path == str(inner)
    assert find("package://robot/meshes/outer.stl", str(near)).path == str(outer)
    missing = find("package://robot/meshes/none.stl", str(near))
    assert missing.directory == str(tmp_path / "robot" / "v1" / "robot")
    assert resolver().package("robot", str(near)) == missing.directory


def test_a_build_may_install_the_directory_around_the_file_as_the_package(tmp_path: Path) -> None:
    add_file(tmp_path / "LICENSE")
    manual = add_package(tmp_path / "robot_manual", "robot")
    kept = add_file(manual / "meshes" / "kept.stl")
    add_file(manual / "meshes" / "both.stl")
    near = str(add_file(tmp_path / "robot" / "urdf" / "x.urdf"))
    made = add_file(tmp_path / "robot" / "meshes" / "made.stl")
    add_file(tmp_path / "robot" / "meshes" / "both.stl")
    find = resolver().locate
    assert find("package://robot/meshes/made.stl", near).path == str(made)
    assert find("package://robot/meshes/kept.stl", near).path == str(kept)
    assert find("package://robot/meshes/both.stl", near).directory == str(manual)
    assert find("package://robot/meshes/none.stl", near).directory == str(manual)
    assert resolver().package("robot", near) == str(manual)


def test_what_cmake_installs_elsewhere(arm: Path) -> None:
    moved = add_file(arm / "description" / "urdf" / "parts" / "a.xacro")
    kept = add_file(arm / "urdf" / "kept.xacro")
    (arm / "CMakeLists.txt").write_text(
        "install(DIRECTORY description/urdf DESTINATION share/${PROJECT_NAME})\n", encoding="utf-8"
    )
    near = str(arm / "urdf" / "arm.urdf")
    found = resolver()
    assert found.locate("package://arm/urdf/parts/a.xacro", near).path == str(moved)
    assert found.locate("package://arm/urdf/kept.xacro", near).path == str(kept)
    assert found.locate("package://arm/urdf/none.xacro", near).path is None
    assert found.locate("package://arm/urdf/parts/a.xacro", near).path == str(moved)
    assert found.installed(str(arm / "urdf" / "parts" / "a.xacro")) == str(moved)
    assert found.installed(str(arm / "urdf" / "x" / ".." / "parts" / "a.xacro")) == str(moved)
    assert found.installed(str(arm / "urdf" / "none.xacro")) is None
    assert found.installed(str(arm.parent / "none" / "a.xacro")) is None
    assert found.locate(f"file://{arm}/urdf/parts/a.xacro", near).path == str(moved)


def test_without_build_files_the_only_such_path_one_directory_down(arm: Path) -> None:
    near = str(arm / "urdf" / "arm.urdf")
    moved = add_file(arm / "description" / "config" / "a.yaml")
    assert resolver().installed(str(arm / "config" / "a.yaml")) == str(moved)
    assert resolver().locate("package://arm/config/a.yaml", near).path == str(moved)
    add_file(arm / "CMakeLists.txt")
    assert resolver().installed(str(arm / "config" / "a.yaml")) is None
    (arm / "CMakeLists.txt").unlink()
    add_file(arm / "bringup" / "config" / "a.yaml")
    assert resolver().installed(str(arm / "config" / "a.yaml")) is None


def test_the_environment_is_that_of_the_process_unless_given(
    arm: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    far = add_package(arm.parents[3] / "x" / "y" / "z" / "far", "far")
    monkeypatch.setenv("ROS_PACKAGE_PATH", str(far.parent))
    near = str(arm / "urdf" / "arm.urdf")
    assert Resolver().package("far", near) == str(far)
    with pytest.raises(PackageNotFound):
        Resolver(environment={}).package("far", near)


def test_a_hundred_references_cost_one_listing_per_directory(
    arm: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for number in range(100):
        add_file(arm / "meshes" / f"link_{number}.stl")
    listed = record_listings(monkeypatch)
    stats: list[str] = []
    isfile = os.path.isfile

    def recording(path: str) -> bool:
        stats.append(path)
        return isfile(path)

    monkeypatch.setattr(os.path, "isfile", recording)
    found = resolver()
    near = str(arm / "urdf" / "arm.urdf")
    for number in range(100):
        for reference in ("package://arm/meshes/link_{}.stl", "package://arm/meshes/no_{}.stl"):
            found.locate(reference.format(number), near)
    assert len(listed) == len(set(listed))
    assert len(stats) == len(set(stats))
    assert len(listed) <= 8  # those around the package as well


class TestFence:
    def test_own_package_and_repository(self, tmp_path: Path, arm: Path) -> None:
        near = str(arm / "urdf" / "arm.urdf")
        found = resolver()
        assert found.allows(str(arm / "config" / "arm.yaml"), near)
        assert found.allows(str(arm / "urdf" / ".." / "config" / "arm.yaml"), near)
        outside = add_file(tmp_path / "secret.yaml")
        assert not found.allows(str(outside), near)
        assert not found.allows(str(arm / ".." / "secret.yaml"), near)
        assert not found.allows("/etc/passwd", near)
        assert not found.allows(f"{arm}_2/x.yaml", near)
        add_file(tmp_path / ".git" / "HEAD")
        assert resolver().allows(str(outside), near)

    def test_a_file_without_package_has_its_own_directory(self, tmp_path: Path) -> None:
        near = str(add_file(tmp_path / "models" / "arm.xacro"))
        found = resolver()
        assert found.allows(str(tmp_path / "models" / "parts" / "a.xacro"), near)
        assert not found.allows(str(tmp_path / "other" / "a.xacro"), near)

    def test_packages_that_were_found(self, tmp_path: Path, arm: Path) -> None:
        near = str(arm / "urdf" / "arm.urdf")
        far = add_package(tmp_path.parents[3] / "z" / "far", "far")
        found = Resolver({"far": str(far)}, environment={})
        inside = str(far / "config" / "x.yaml")
        assert not found.allows(inside, near)
        found.package("far", near)
        assert found.allows(inside, near)
        assert not found.allows(str(far.parent / "x.yaml"), near)

    def test_packages_beside_the_own_one(self, tmp_path: Path, arm: Path) -> None:
        near = str(arm / "urdf" / "arm.urdf")
        hand = add_package(tmp_path / "hand", "hand")
        assert resolver().allows(str(hand / "urdf" / "hand.xacro"), near)
        assert not resolver().allows(str(tmp_path / "no_package" / "hand.xacro"), near)

    def test_a_link_counts_as_what_it_leads_to(self, tmp_path: Path, arm: Path) -> None:
        near = str(arm / "urdf" / "arm.urdf")
        secret = add_file(tmp_path / "secret.yaml")
        os.symlink(secret, arm / "innocent.yaml")
        os.symlink(tmp_path, arm / "directory")
        assert not resolver().allows(str(arm / "innocent.yaml"), near)
        assert not resolver().allows(str(arm / "directory" / "secret.yaml"), near)
        explicit = Resolver({"arm": str(arm)}, environment={})
        explicit.package("arm", near)
        assert not explicit.allows(str(arm / "innocent.yaml"), near)

    @pytest.mark.parametrize("call", [check, load, expand], ids=lambda call: call.__name__)
    def test_a_package_that_is_not_there(self, arm: Path, call: Any, capsys: Any) -> None:
        robot = add_file(arm / "r.urdf", b'<robot name="r"><link name="a"/></robot>')
        with pytest.raises(UnreadableFile) as raised:
            call(robot, packages={"hand": str(arm / "none")})
        for command in ("check", "info", "expand"):
            assert main([command, str(robot), "--package", f"hand={arm / 'none'}"]) == 2
            assert str(raised.value) in capsys.readouterr().err
        assert str(raised.value) == f"package 'hand': no such directory '{arm / 'none'}'"

    def test_links_of_an_installation_that_the_user_named(self, tmp_path: Path, arm: Path) -> None:
        """As colcon build --symlink-install makes them."""
        near = str(arm / "urdf" / "arm.urdf")
        source = add_file(tmp_path.parents[3] / "elsewhere" / "far.xacro")
        share = add_package(tmp_path / "prefix" / "share" / "far", "far")
        os.symlink(source, share / "far.xacro")
        found = resolver(AMENT_PREFIX_PATH=str(tmp_path / "prefix"))
        assert found.package("far", near) == str(share)
        assert found.allows(str(share / "far.xacro"), near)
        assert not found.allows(str(source), near)

    def test_a_model_that_is_itself_a_link(self, tmp_path: Path, arm: Path) -> None:
        link = tmp_path.parents[3] / "x" / "link.urdf"
        link.parent.mkdir()
        os.symlink(arm / "urdf" / "arm.urdf", link)
        assert resolver().allows(str(arm / "config" / "arm.yaml"), str(link))
        assert resolver().allows(str(link.parent / "arm.yaml"), str(link))

    @pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs named pipes")
    def test_pipes_and_devices_are_refused(self, arm: Path) -> None:
        os.mkfifo(arm / "pipe.yaml")
        near = str(arm / "urdf" / "arm.urdf")
        assert not resolver().allows(str(arm / "pipe.yaml"), near)
        assert not resolver().allows(os.devnull, near)
        assert resolver().allows(str(arm / "urdf"), near)
        assert not resolver().allows("a\0b", near)


@given(st.text(max_size=60))
def test_any_reference_is_answered(reference: str) -> None:
    located = Resolver(environment={}).locate(reference, "/no/such/directory/robot.urdf")
    assert located.reference == reference
    assert located.path is None or os.path.exists(located.path)


@given(
    st.sampled_from(["package://", "model://", "file://", "file:", "", "x://", "C:"]),
    st.text("ab/\\.% 2F0~$:\0é", max_size=30),
)
def test_any_path_is_answered(scheme: str, rest: str) -> None:
    located = Resolver(environment={}).locate(scheme + rest, "/no/such/directory/robot.urdf")
    assert located.path is None


def test_texts_stand_for_the_bytes_on_disk(tmp_path: Path) -> None:
    file = tmp_path / "a.urdf"
    file.write_bytes(b"<robot/>")
    link = tmp_path / "link.urdf"
    link.symlink_to(file)
    resolver = Resolver(environment={}, texts={str(link): b"<robot name='b'/>"})
    assert resolver.read(str(file)).data == b"<robot name='b'/>"
    assert resolver.text(str(tmp_path / "b.urdf")) is None
    assert Resolver(environment={}).read(str(file)).data == b"<robot/>"


def test_a_file_is_read_again_once_it_has_changed(tmp_path: Path) -> None:
    file = tmp_path / "a.urdf"
    file.write_bytes(b"<robot/>")
    resolver = Resolver(environment={})
    first = resolver.read(str(file))
    assert resolver.read(str(file)) is first
    file.write_bytes(b"<robot name='b'/>")
    assert resolver.read(str(file)).data == b"<robot name='b'/>"
    file.unlink()
    with pytest.raises(UnreadableFile, match="not found"):
        resolver.read(str(file))


def test_other_texts_with_what_is_known_of_directories(tmp_path: Path) -> None:
    (tmp_path / "a.urdf").write_bytes(b"disk")
    resolver = Resolver(environment={}, texts={str(tmp_path / "a.urdf"): b"one"})
    other = resolver.with_texts({str(tmp_path / "b.urdf"): b"two"})
    assert resolver.read(str(tmp_path / "a.urdf")).data == b"one"
    assert other.read(str(tmp_path / "a.urdf")).data == b"disk"
    assert other.read(str(tmp_path / "b.urdf")).data == b"two"
    assert other.packages is resolver.packages
    assert other.directories is resolver.directories
