"""The models under ``models/`` are what the tests and the documents take them for."""

import math
import re
import shutil
import struct
import subprocess
import sys
from collections import Counter
from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree

import pytest

from tests.conftest import MODELS, SEED, needs_seed
from urdfkit.lint.engine import check

PACKAGE = MODELS / "gazebo_pkg"
MISSION = PACKAGE / "urdf" / "waking_robot_new.xacro"
LAUNCH = PACKAGE / "launch" / "view_waking_robot.launch"
BAD_MESHES = MODELS / "bad" / "meshes"
GOOD = sorted(
    path for path in (MODELS / "good").rglob("*") if path.name.endswith((".urdf", ".urdf.xacro"))
)
GOOD_STL = sorted((MODELS / "good").rglob("*.stl"))

Flat = list[tuple[int, str, list[tuple[str, str]], str]]
Point = tuple[float, float, float]


def from_seed(start: str, end: str) -> str:
    """The piece of the mission's text from one string to another, both included."""
    text = SEED.read_text(encoding="utf-8")
    first = text.index(start)
    return text[first : text.index(end, first) + len(end)]


def seed_xacro() -> str:
    return from_seed('<?xml version="1.0"?> <robot name="robot"', "</robot>")


def seed_launch() -> str:
    return from_seed("<launch>", "</launch>")


def flat(xml: str) -> Flat:
    """Every element in order: depth, tag, attributes in order, text; a leaf's to the letter."""
    rows: Flat = []

    def add(element: ElementTree.Element, depth: int) -> None:
        text = element.text or ""
        assert not (element.tail or "").strip()
        if len(element) or not text.strip():
            text = text.strip()
        rows.append((depth, element.tag, list(element.attrib.items()), text))
        for child in element:
            add(child, depth + 1)

    add(ElementTree.fromstring(xml), 0)
    return rows


def commented_out(xml: str) -> list[str]:
    """The comments that hold elements, without the white space between tags."""
    comments = re.findall(r"<!--(.*?)-->", xml, re.DOTALL)
    return [
        re.sub(r"\s*(<[^<>]*>)\s*(?=<|$)", r"\1", comment).strip()
        for comment in comments
        if comment.lstrip().startswith("<")
    ]


def stock_xacro(path: Path) -> str:
    program = "import sys, xacro; sys.argv[0] = 'xacro'; xacro.main()"
    command = [sys.executable, "-c", program, str(path)]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


@pytest.fixture(scope="module")
def expanded() -> ElementTree.Element:
    return ElementTree.fromstring(stock_xacro(MISSION))


class TestMissionsPackage:
    @needs_seed
    def test_xacro_has_the_elements_of_the_seed(self) -> None:
        assert flat(MISSION.read_text(encoding="utf-8")) == flat(seed_xacro())

    @needs_seed
    def test_launch_file_has_the_elements_of_the_seed(self) -> None:
        assert flat(LAUNCH.read_text(encoding="utf-8")) == flat(seed_launch())

    @needs_seed
    def test_keeps_what_the_seed_comments_out(self) -> None:
        ours = commented_out(MISSION.read_text(encoding="utf-8"))
        assert ours == commented_out(seed_xacro())
        assert len(ours) == 12

    def test_comments_are_readable_by_ros2_launch(self) -> None:
        # ROS 2 reads robot_description as YAML, where a colon before a blank starts a mapping.
        for comment in re.findall(r"<!--.*?-->", MISSION.read_text(encoding="ascii"), re.DOTALL):
            assert ": " not in comment

    def test_counts(self, expanded: ElementTree.Element) -> None:
        kinds = Counter(joint.get("type") for joint in expanded.findall("joint"))
        assert len(expanded.findall("link")) == 10
        assert kinds == {"continuous": 4, "fixed": 5}

    def test_mass(self, expanded: ElementTree.Element) -> None:
        masses = [float(mass.attrib["value"]) for mass in expanded.iter("mass")]
        assert math.fsum(masses) == pytest.approx(10.2301, abs=1e-12)

    def test_degrees_of_freedom(self) -> None:
        pinocchio = pytest.importorskip("pinocchio")
        model = pinocchio.buildModelFromXML(stock_xacro(MISSION))
        assert (model.nq, model.nv) == (8, 4)

    def test_the_mesh_and_the_rviz_settings_are_missing_on_purpose(self) -> None:
        assert sorted(path.name for path in PACKAGE.iterdir()) == [
            "CMakeLists.txt",
            "launch",
            "package.xml",
            "urdf",
        ]

    def test_the_package_declares_what_its_launch_file_starts(self) -> None:
        package = ElementTree.parse(PACKAGE / "package.xml").getroot()
        declared = {element.text for element in package.findall("exec_depend")}
        launch = LAUNCH.read_text(encoding="utf-8")
        used = set(re.findall(r'pkg="(\w+)"|\$\(find (\w+)\)', launch))
        names = {name for pair in used for name in pair if name}
        assert package.findtext("name") == "gazebo_pkg" == PACKAGE.name
        assert names - {"gazebo_pkg"} <= declared


@pytest.mark.skipif(shutil.which("check_urdf") is None, reason="check_urdf is not installed")
@pytest.mark.parametrize(
    "model", [MISSION, *(path for path in GOOD if path.suffix == ".urdf")], ids=lambda p: p.stem
)
def test_urdfdom_accepts(model: Path, tmp_path: Path) -> None:
    plain = tmp_path / "plain.urdf"
    text = stock_xacro(model) if model.suffix == ".xacro" else model.read_text(encoding="utf-8")
    plain.write_text(text, encoding="utf-8")
    result = subprocess.run(["check_urdf", plain], capture_output=True, text=True, check=False)
    assert (result.returncode, result.stderr) == (0, "")


class TestBadMeshes:
    @needs_seed
    def test_bot_is_the_seeds(self) -> None:
        text = SEED.read_text(encoding="utf-8")
        seed = text[text.index('<?xml version="1.0" encoding="UTF-8" standalone="no" ?>') :]
        ours = (BAD_MESHES / "bot.dae").read_text(encoding="utf-8")
        assert re.sub(r">\s+<", "><", ours).strip() == re.sub(r">\s+<", "><", seed).strip()

    def test_bot_ends_before_its_elements_do(self) -> None:
        with pytest.raises(ElementTree.ParseError, match="no element found"):
            ElementTree.parse(BAD_MESHES / "bot.dae")

    def test_empty(self) -> None:
        assert (BAD_MESHES / "empty.dae").read_bytes() == b""

    def test_web_page(self) -> None:
        assert (BAD_MESHES / "web_page.dae").read_bytes().startswith(b"<!DOCTYPE html>")

    def test_lfs_pointer(self) -> None:
        text = (BAD_MESHES / "lfs_pointer.stl").read_text(encoding="ascii")
        pointer = (
            r"version https://git-lfs\.github\.com/spec/v1\noid sha256:[0-9a-f]{64}\nsize \d+\n"
        )
        assert re.fullmatch(pointer, text)

    def test_truncated(self) -> None:
        data = (BAD_MESHES / "truncated.stl").read_bytes()
        assert struct.unpack_from("<I", data, 80) == (12,)
        assert 84 + 50 * 6 < len(data) < 84 + 50 * 7

    def test_each_is_named_by_the_robot(self) -> None:
        robot = ElementTree.parse(MODELS / "bad" / "broken_meshes.urdf")
        named = {mesh.attrib["filename"].rpartition("/")[2] for mesh in robot.iter("mesh")}
        assert named == {path.name for path in BAD_MESHES.iterdir()} | {"hokuyo.dae"}


class TestGoodModels:
    @pytest.mark.parametrize("model", GOOD, ids=lambda path: path.stem)
    def test_have_no_findings(self, model: Path) -> None:
        report = check(model)
        assert [f"{d.code} {d.message}" for d in report.diagnostics] == []
        assert report.crashed == ()

    def test_are_three(self) -> None:
        names = [path.name for path in GOOD]
        assert names == ["gripper.urdf", "mobile_base.urdf.xacro", "two_link_arm.urdf"]

    @pytest.mark.parametrize("file", GOOD_STL, ids=lambda path: path.stem)
    def test_meshes_are_closed_and_face_outwards(self, file: Path) -> None:
        triangles = read_stl(file)
        edges = Counter(edge for a, b, c in triangles for edge in pairwise((a, b, c, a)))
        assert set(edges.values()) == {1}
        assert all((end, start) in edges for start, end in edges)
        assert volume(triangles) == pytest.approx(cylinder(triangles), rel=0.02)


def read_stl(file: Path) -> list[tuple[Point, Point, Point]]:
    """The triangles of a binary STL whose length is as its header says."""
    data = file.read_bytes()
    (count,) = struct.unpack_from("<I", data, 80)
    assert len(data) == 84 + 50 * count
    rows = struct.iter_unpack("<12fH", data[84:])
    return [(row[3:6], row[6:9], row[9:12]) for row in rows]


def volume(triangles: list[tuple[Point, Point, Point]]) -> float:
    """Sum of the signed tetrahedra over the origin, in m^3; positive if faces look outwards."""
    return math.fsum(
        (
            a[0] * (b[1] * c[2] - b[2] * c[1])
            + a[1] * (b[2] * c[0] - b[0] * c[2])
            + a[2] * (b[0] * c[1] - b[1] * c[0])
        )
        / 6
        for a, b, c in triangles
    )


def cylinder(triangles: list[tuple[Point, Point, Point]]) -> float:
    """Volume of the upright cylinder about the triangles, in m^3."""
    points = [point for triangle in triangles for point in triangle]
    radius = max(math.hypot(x, y) for x, y, _ in points)
    heights = [z for _, _, z in points]
    return math.pi * radius**2 * (max(heights) - min(heights))
