"""load() and expand() of files, paths and Sources; and what they raise."""

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

import urdfkit
from tests.conftest import GRIPPER, MOBILE_BASE, ROOT
from urdfkit import Source, UnreadableRobot, UrdfkitError, expand, load
from urdfkit.errors import UnreadableFile

ARGUED = b"""\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:arg name="side" default="left"/>
  <link name="$(arg side)_base"/>
</robot>
"""


@pytest.mark.parametrize("form", [str, Path, Source.read])
@pytest.mark.parametrize("file", [GRIPPER, MOBILE_BASE], ids=lambda path: path.name)
def test_a_file_in_every_form(file: Path, form: Callable[[Path], str | Path | Source]) -> None:
    model = load(form(file))
    assert model.name == file.name.split(".")[0]
    assert model.links
    assert model.mass > 0
    assert model.links[0].at.span.source.path == str(file)


def test_arguments_and_packages(tmp_path: Path) -> None:
    source = Source("r.xacro", ARGUED)
    assert load(source).links[0].name == "left_base"
    assert load(source, arguments={"side": "right"}).links[0].name == "right_base"
    assert 'name="right_base"' in expand(source, arguments={"side": "right"}).text()
    (tmp_path / "package.xml").write_text("<package><name>parts</name></package>")
    (tmp_path / "part.xacro").write_text('<robot><link name="part"/></robot>')
    whole = Source(
        "r.xacro",
        b'<robot xmlns:xacro="http://www.ros.org/wiki/xacro">'
        b'<xacro:include filename="$(find parts)/part.xacro"/></robot>',
    )
    assert load(whole, packages={"parts": str(tmp_path)}).links[0].name == "part"
    with pytest.raises(UnreadableRobot, match="parts"):
        load(whole)


def test_expand_gives_what_the_xacro_command_gives() -> None:
    command = [sys.executable, "-m", "urdfkit", "expand", str(MOBILE_BASE)]
    printed = subprocess.run(command, check=True, cwd=ROOT, capture_output=True, text=True).stdout
    assert expand(MOBILE_BASE).text() == printed


def test_trust_lifts_the_fence(tmp_path: Path) -> None:
    (tmp_path / "outside.yaml").write_text("name: secret")
    text = ARGUED.replace(b"$(arg side)", b"${xacro.load_yaml('../outside.yaml')['name']}")
    (tmp_path / "robot").mkdir()
    (tmp_path / "robot" / "r.xacro").write_bytes(text)
    with pytest.raises(UnreadableRobot, match=r"outside\.yaml"):
        load(tmp_path / "robot" / "r.xacro")
    assert load(tmp_path / "robot" / "r.xacro", trust=True).links[0].name == "secret_base"


def test_every_reason_is_reported_with_its_place() -> None:
    broken = ARGUED.replace(b"$(arg side)_base", b"${one}${two}")
    broken = broken.replace(b"</robot>", b'  <link name="${three}"/>\n</robot>')
    for call in (load, expand):
        with pytest.raises(UnreadableRobot) as error:
            call(Source("r.xacro", broken))
        assert [line.partition(": ")[0] for line in str(error.value).split("; ")] == [
            "r.xacro:3:15",
            "r.xacro:3:21",
            "r.xacro:4:15",
        ]
        assert len(error.value.problems) == 3


def test_broken_xml_is_reported_with_its_place() -> None:
    with pytest.raises(UnreadableRobot, match=r"^r\.urdf:1:8: "):
        load(Source("r.urdf", b"<robot>"))


def test_a_missing_file_is_another_matter(tmp_path: Path) -> None:
    for call in (load, expand):
        with pytest.raises(UnreadableFile, match="file not found"):
            call(tmp_path / "none.urdf")
    assert issubclass(UnreadableFile, UrdfkitError)
    assert issubclass(UnreadableRobot, UrdfkitError)


def test_a_bad_robot_is_loaded_as_far_as_it_can_be_read() -> None:
    model = load(
        Source(
            "r.urdf",
            b'<robot><link name="a"><inertial><mass value="x"/></inertial></link><joint/></robot>',
        )
    )
    assert (model.name, model.mass, model.joints[0].kind) == ("", 0.0, "")
    assert urdfkit.load is load


LAUNCH = """<launch>
  <param name="robot_description" command="xacro $(dirname)/r.xacro side:={}"/>
</launch>
"""


def test_a_launch_file_is_the_robot_that_it_describes(tmp_path: Path) -> None:
    (tmp_path / "r.xacro").write_bytes(ARGUED)
    launch = tmp_path / "r.launch"
    launch.write_text(LAUNCH.format("right"))
    assert load(launch).links[0].name == "right_base"


def test_a_launch_file_of_no_robot_or_of_several(tmp_path: Path) -> None:
    (tmp_path / "r.xacro").write_bytes(ARGUED)
    launch = tmp_path / "r.launch"
    launch.write_text("<launch/>")
    with pytest.raises(UnreadableRobot, match=r"r\.launch is a launch file and describes no robot"):
        load(launch)
    both = LAUNCH.format("left") + LAUNCH.format("right")
    launch.write_text(f"<launch>{both.replace('<launch>', '').replace('</launch>', '')}</launch>")
    with pytest.raises(UnreadableRobot, match=r"describes several robots; pass one of .*r\.xacro"):
        load(launch)


def test_another_format_is_no_robot() -> None:
    """An empty robot would tell nobody that the file is an SDF."""
    with pytest.raises(UnreadableRobot, match="the root element is <sdf>, not <robot>"):
        load(Source("m.sdf", b'<sdf version="1.9"><model name="m"/></sdf>'))


@pytest.mark.parametrize("call", [urdfkit.check, urdfkit.fix])
@pytest.mark.parametrize("name", ["select", "ignore", "targets"])
def test_one_text_is_no_list_of_words(call: Callable[..., object], name: str) -> None:
    with pytest.raises(TypeError, match=rf"{name} must be a list of words, such as \['MSH'\]"):
        call(Source("r.urdf", ARGUED), **{name: "MSH"})
