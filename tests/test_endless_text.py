"""Texts in which things begin over and over and never end are read in linear time.

A pattern that looks for an end anew from each beginning takes quadratic time.
"""

import time
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.growth import assert_linear
from tests.workspaces import add_file, add_files, mesh_link
from urdfkit import check
from urdfkit.lint.config import Config
from urdfkit.lint.discovery import discover
from urdfkit.lint.ignore_comments import ignores
from urdfkit.mesh.io.salvage import salvage
from urdfkit.mesh.io.sniff import sniff
from urdfkit.text.file_kinds import is_xacro
from urdfkit.text.source import Source
from urdfkit.text.xml_reader import read_xml
from urdfkit.workspace.manifest import manifest_of
from urdfkit.workspace.package_references import package_references
from urdfkit.workspace.resolve import Resolver

MANY = 40_000
TRIANGLE = b"facet normal 0 0 1\nouter loop\nvertex 0 0 %s\nendloop\nendfacet\nendsolid"
MESHES: dict[str, tuple[str, Callable[[int], bytes]]] = {
    "comments": (".dae", lambda many: b"<COLLADA>" + b"<!-- " * many),
    "comments before the root": (".dae", lambda many: b"<!-- " * many),
    "instructions": (".dae", lambda many: b"<? " * many),
    "declarations": (".dae", lambda many: b"<!a " * many),
    "character data": (".dae", lambda many: b"<COLLADA>" + b"<![CDATA[" * many),
    "tags in a comment": (
        ".dae",
        lambda many: b"<COLLADA><!-- " + b"<triangles " * many + b"--></COLLADA>",
    ),
    "inputs in a comment": (
        ".dae",
        lambda many: b"<COLLADA><!-- " + b"<input a" * many + b"--></COLLADA>",
    ),
    "one number": (".stl", lambda many: b"solid a\n" + TRIANGLE % (b"1" * many + b"x")),
    "one list": (
        ".dae",
        lambda many: (
            b"<COLLADA><source id='s'><float_array>" + b"1," * many + b"</float_array></source>"
            b"<mesh><input semantic='POSITION' source='#s'/></mesh><triangles/><instance_geometry/>"
            b"<scene><instance_visual_scene a='&b;'/></scene></COLLADA>"
        ),
    ),
}
COMMENTS = [b"<!-- ", b"<!-- urdfkit: ignore[A] ", b"<!-- urdfkit: ignore["]


@pytest.mark.parametrize("name", MESHES)
def test_mesh_files(name: str, tmp_path: Path):
    suffix, text = MESHES[name]

    def reading(many: int) -> Callable[[], object]:
        data = text(many)
        path = add_file(tmp_path / f"{many}{suffix}", data)
        assert sniff(data, suffix).defect
        return lambda: (sniff(data, suffix), salvage(str(path)))

    assert_linear(reading, MANY)


def test_a_manifest(tmp_path: Path):
    head = b"<package><name>arm</name><export><build_type>ament_cmake</build_type></export>"

    def reading(many: int) -> Callable[[], object]:
        add_file(tmp_path / str(many) / "package.xml", head + b"<!-- " * many)
        robot = str(tmp_path / str(many) / "arm.urdf")
        manifest = manifest_of(Resolver(), robot)
        assert manifest is not None
        assert (manifest.package, manifest.ros) == ("arm", 2)
        return lambda: manifest_of(Resolver(), robot)

    assert_linear(reading, MANY)


def test_a_setup_file(tmp_path: Path):
    robot = f"<robot name='arm'>{mesh_link('package://arm/arm.stl')}</robot>"

    def reading(many: int) -> Callable[[], object]:
        directory = tmp_path / str(many)
        add_file(directory / "package.xml", b"<package><name>arm</name></package>")
        add_file(directory / "setup.py", b"\n" * many + b"package_name = 'leg'\n")
        path = add_file(directory / "arm.urdf", robot.encode())
        assert "PKG008" in [found.code for found in check(path, select=["PKG"]).diagnostics]
        return lambda: check(path, select=["PKG"])

    assert_linear(reading, 10 * MANY)


@pytest.mark.parametrize("comment", COMMENTS)
def test_comments_of_a_robot(comment: bytes):
    head = b"<robot xmlns:xacro='x'>package://a<xacro:a/>"

    def reading(many: int) -> Callable[[], object]:
        source = Source("arm.urdf", head + comment * many)
        assert not is_xacro(source)
        assert ignores(source) == ()
        assert [one.package for one in package_references(source)] == ["a"]
        again = Source("arm.urdf", head + comment * many)
        return lambda: (is_xacro(again), ignores(again), package_references(again))

    assert_linear(reading, MANY)


def test_paths_of_many_siblings() -> None:
    def work(many: int) -> Callable[[], object]:
        document, _ = read_xml(Source("r.urdf", b"<robot>" + b"<a/>" * many + b"</robot>"))
        assert document is not None
        return lambda: [element.path for element in document.root.walk()]

    assert_linear(work, 20_000)


def test_many_ignore_comments():
    def reading(many: int) -> Callable[[], object]:
        comments = b"<!-- urdfkit: ignore[A] --><link/>" * many
        text = b"<robot>" + comments + b"</robot>"
        assert len(ignores(Source("arm.urdf", text))) == many
        return lambda: ignores(Source("arm.urdf", text))

    assert_linear(reading, MANY // 4)


@pytest.mark.parametrize("piece", [b"<!-- ", b"<xacro:macro ", b"<xacro:include "])
def test_a_directory(piece: bytes, tmp_path: Path):
    def reading(many: int) -> Callable[[], object]:
        directory = tmp_path / str(many)
        robot = add_file(directory / "arm.urdf", b"<robot name='arm'><link name='a'/></robot>")
        add_file(directory / "macros.xacro", b"<robot>" + piece * many)
        found = discover(str(directory), Config(), Resolver())
        assert str(robot) in [one.file for one in found.robots]
        return lambda: discover(str(directory), Config(), Resolver())

    assert_linear(reading, MANY)


MANIFEST = "<package><name>arm</name>"
XACRO = "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'><link name='a'/>"
PROPERTY = "<xacro:property name='p' value='1'/>"
SLAM = "-configuration_directory $(dirname) -configuration_basename a.lua"
LAUNCH = f"<launch><node pkg='cartographer_ros' exec='cartographer_node' args='{SLAM}'/>"
LAUNCH += "<node pkg='arm' exec='b'/>"
UNUSED = "def generate_launch_description():\n    c = Node(package='a')\n"
UNUSED += "    return LaunchDescription([])\n"


@pytest.mark.parametrize(
    ("file", "head", "piece", "tail"),
    [
        ("package.xml", MANIFEST, "<build_type ", ""),
        ("package.xml", MANIFEST, "<depend ", ""),
        ("part.xacro", "", "<xacro:arg ", ""),
        ("r.urdf.xacro", f"{XACRO}{PROPERTY}<!-- ", "${", " --></robot>"),
        ("a.launch.xml", f'{LAUNCH}<node pkg="a" exec="b" args="', "$(eval ", '"/></launch>'),
        ("a.lua", "options = {", "x", ""),
        ("a.launch.py", "generate_launch_description('", " '/home/a/b'", ""),
        ("a.launch.py", UNUSED, "#", ""),
        ("CMakeLists.txt", "add_executable(b)", "installinstall", ""),
        ("CMakeLists.txt", "add_executable(b)", "include(a ", ""),
        (".gitmodules", "[submodule]", "\n" * 5, ""),
        ("CMakeLists.txt", "rosidl_generate_interfaces(a", " ", ""),
        ("part.xacro", "<robot><!--", "xacro:include ", "--></robot>"),
    ],
)
def test_a_workspace(file: str, head: str, piece: str, tail: str, tmp_path: Path) -> None:
    """Each took 20 s and more."""
    files = {
        "package.xml": f"{MANIFEST}</package>",
        "r.urdf.xacro": "<robot xmlns:xacro='http://www.ros.org/wiki/xacro'><xacro:a/></robot>",
        "a.launch.xml": f"{LAUNCH}</launch>",
        file: head + piece * 150_000 + tail,
    }
    add_files(tmp_path, files)
    start = time.process_time()
    assert check(tmp_path).crashed == ()
    assert time.process_time() - start < 15


def test_a_comment_of_200_000_codes_is_read_once_a_rule() -> None:
    """Not once a finding, of which there may be a thousand: that took minutes."""
    start = time.process_time()
    comment = f"<!-- urdfkit: ignore[{'A,' * 200_000}] -->"
    report = check(Source("r.urdf", f'<robot name="r">{comment}<link name="a"/></robot>'.encode()))
    assert "CFG002" in {one.code for one in report.diagnostics}
    assert time.process_time() - start < 20


def test_a_manifest_of_many_dependencies_is_read_once_for_many_packages(tmp_path: Path) -> None:
    """Not once for each package that is missing: that took 40 s."""
    start = time.process_time()
    depends = "".join(f"<depend>a{number}</depend>" for number in range(30_000))
    add_file(tmp_path / "package.xml", f"<package><name>p</name>{depends}</package>".encode())
    links = "".join(mesh_link(f"package://p{n}/a.stl", link=f"l{n}") for n in range(1000))
    robot = add_file(tmp_path / "r.urdf", f'<robot name="r">{links}</robot>'.encode())
    report = check(robot, select=["XAC011"])
    assert len(report.diagnostics) == 1000
    assert time.process_time() - start < 15


@pytest.mark.parametrize("piece", [" ", "foreach(a", "a:=${a} ", "foreach(a b)"])
def test_a_build_that_passes_arguments(piece: str, tmp_path: Path) -> None:
    robot = f"{XACRO}<link name='$(arg a)'/></robot>"

    def reading(many: int) -> Callable[[], object]:
        directory = tmp_path / str(many)
        text = "xacro(r.xacro a:=left)\nforeach(S " + piece * many
        add_files(directory, {"package.xml": f"{MANIFEST}</package>", "CMakeLists.txt": text})
        add_file(directory / "r.xacro", robot)
        assert "CFG003" not in {one.code for one in check(directory / "r.xacro").diagnostics}
        return lambda: check(directory / "r.xacro", select=["CFG"])

    assert_linear(reading, MANY)
