"""What is offered at the cursor, in texts that are not finished."""

import shutil
from pathlib import Path

import pytest

from tests.conftest import MODELS
from tests.lsp.edited import XACRO, Edited
from urdfkit.lsp import completion_in_text
from urdfkit.lsp.completion import complete
from urdfkit.lsp.completion_in_text import CompletionItem
from urdfkit.ros.catalog import plugins
from urdfkit.text.schema import ROBOT

ARM = (
    '<robot name="r">\n<link name="base"/><link name="arm"/>'
    '<joint name="hip" type="revolute"><parent link="base"/><child link="arm"/></joint>\n'
    '<material name="red"><color rgba="1 0 0 1"/></material>\n{}\n</robot>'
)


def offers(tmp_path: Path, text: str, name: str = "r.urdf") -> dict[str, CompletionItem]:
    file = Edited(tmp_path / name, text)
    return {offer.text: offer for offer in complete(file.robot, file.markup, file.offset)}


@pytest.mark.parametrize(
    ("text", "some"),
    [
        ("<|", {"robot"}),
        ("<robot><|", {"link", "joint", "material", "gazebo", "/robot>"}),
        ('<robot><link name="a"><|', {"visual", "collision", "inertial", "/link>"}),
        ("<robot><link><visual><geo|", {"geometry", "origin", "material"}),
        ("<robot><link><visual><geometry><|</geometry>", {"box", "mesh", "cylinder", "sphere"}),
        ("<robot><joint><lim|", {"limit", "axis", "mimic", "parent"}),
        ("<robot><joint></|", {"joint"}),
        ("<robot><joint></jo|int></robot>", {"joint"}),
        ("<robot><link |", {"name"}),
        ("<robot><link><visual><origin r|", {"xyz", "rpy"}),
        ("<robot><joint><limit effort='1' |", {"lower", "upper", "velocity"}),
        ('<robot><joint type="|"', {"revolute", "continuous", "fixed", "prismatic"}),
        (ARM.format('<joint><parent link="|'), {"base", "arm"}),
        (ARM.format('<joint><parent link="ba|"/></joint>'), {"base", "arm"}),
        (ARM.format('<joint><mimic joint="|"/></joint>'), {"hip"}),
        (ARM.format('<disable_collisions link1="arm" link2="|"/>'), {"base", "arm"}),
        (ARM.format('<group name="g"><joint name="|"/></group>'), {"hip"}),
        (ARM.format('<gazebo reference="|"/>'), {"base", "arm", "hip"}),
        (ARM.format('<link><visual><material name="|"/>'), {"red"}),
        (ARM.format('<transmission><joint name="|"/></transmission>'), {"hip"}),
        (ARM.format('<gazebo reference="arm"><material>|</material>'), {"Gazebo/Red"}),
        (ARM.format('<gazebo reference="arm"><m|'), {"mu1", "material", "maxVel", "sensor"}),
        (ARM.format('<gazebo reference="arm"><turnGravityOff>|<'), {"true", "false"}),
        (ARM.format("<gazebo><plugin |"), {"name", "filename"}),
        (ARM.format('<gazebo><plugin filename="lib|"'), {"libgazebo_ros_diff_drive.so"}),
        (ARM.format('<gazebo><sensor type="|"'), {"camera", "imu", "gpu_lidar"}),
        (
            ARM.format('<gazebo><plugin filename="libgazebo_ros_diff_drive.so"><|'),
            {"leftJoint", "left_joint", "wheelSeparation", "ros"},
        ),
        (
            ARM.format('<gazebo><plugin filename="libgazebo_ros_diff_drive.so"><left_joint>|<'),
            {"hip"},
        ),
        (
            ARM.format('<gazebo><plugin filename="libgazebo_ros_diff_drive.so"><ros><|'),
            {"namespace", "remapping"},
        ),
    ],
)
def test_what_is_offered(tmp_path: Path, text: str, some: set[str]) -> None:
    found = offers(tmp_path, text)
    assert some <= set(found), sorted(found)


@pytest.mark.parametrize(
    "text", ["<!-- <| -->", "<robot/>|", "<robot>|", '<robot name="|"', '<link><mass value="|']
)  # fmt: skip
def test_nothing_is_offered_where_nothing_is_known(tmp_path: Path, text: str) -> None:
    assert offers(tmp_path, text) == {}


def test_what_an_element_needs_comes_first(tmp_path: Path) -> None:
    found = offers(tmp_path, "<robot><joint><parent link='a'/><|</joint></robot>")
    assert {text for text, offer in found.items() if offer.required} == {"child"}
    found = offers(tmp_path, "<robot><joint name='a' |></joint></robot>")
    assert {text for text, offer in found.items() if offer.required} == {"type"}


def test_an_offer_takes_the_place_of_the_word_before_the_cursor(tmp_path: Path) -> None:
    for text, word in (
        ("<robot><link><visual><geo|", "geo"),
        ("<robot><link><visual><origin rp|", "rp"),
        (ARM.format('<joint><parent link="ba|"/></joint>'), "ba"),
        (ARM.format('<gazebo reference="arm"><material>Gazebo/R|<'), "Gazebo/R"),
    ):
        data, end = text.replace("|", "").encode(), text.index("|")
        found = offers(tmp_path, text)
        assert found
        starts = {data[o.start : end].decode() for o in found.values() if o.kind != "end"}
        assert starts == {word}


# --- xacro


def in_xacro(tmp_path: Path, text: str) -> set[str]:
    body = (
        '<xacro:property name="width" value="1"/><xacro:arg name="side" default="left"/>'
        '<xacro:macro name="leg" params="prefix mass:=1 *block"><link name="${prefix}_leg"/>\n'
        '<box/></xacro:macro>\n<xacro:leg prefix="a"><b/></xacro:leg>'
    )
    return set(offers(tmp_path, XACRO.format(body + text), "r.xacro"))


def test_macros_and_their_parameters(tmp_path: Path) -> None:
    assert {"xacro:leg", "xacro:include", "link"} <= in_xacro(tmp_path, "<xacro:|")
    assert in_xacro(tmp_path, '<xacro:leg prefix="b" |') == {"mass", "block"}
    assert in_xacro(tmp_path, "<xacro:include |") == {"filename", "ns", "optional"}


def test_words_of_expressions(tmp_path: Path) -> None:
    found = in_xacro(tmp_path, '<link name="${w|}"/>')
    assert {"width", "pi", "sqrt"} <= found
    assert "prefix" not in found, "that is a parameter of a macro elsewhere"
    text = '<xacro:macro name="m" params="size"><box size="${2 * |}"/></xacro:macro>'
    assert {"width", "size"} <= in_xacro(tmp_path, text)
    assert in_xacro(tmp_path, '<link name="$(|"/>') == {
        "arg", "dirname", "env", "eval", "find", "optenv"
    }  # fmt: skip
    assert in_xacro(tmp_path, '<link name="$(arg |)"/>') == {"side"}


def test_a_link_that_a_macro_makes_is_offered(tmp_path: Path) -> None:
    assert "a_leg" in in_xacro(tmp_path, '<joint name="j"><parent link="|"/></joint>')


def test_names_survive_a_text_that_breaks(tmp_path: Path) -> None:
    """The link that a macro makes is still known when the text no longer expands."""
    body = (
        '<xacro:macro name="leg" params="prefix"><link name="${{prefix}}_leg"/></xacro:macro>'
        '<xacro:leg prefix="a"/>{}'
    )
    file = Edited(tmp_path / "r.xacro", XACRO.format(body.format("")))
    assert file.robot.model is not None
    for broken in ('<joint name="j"><parent link="|', '<joint name="j"><child link="a|'):
        file.type(XACRO.format(body.format(broken)))
        assert file.robot.sources
        found = {offer.text for offer in complete(file.robot, file.markup, file.offset)}
        assert "a_leg" in found


# --- packages and files


@pytest.fixture
def arm(tmp_path: Path) -> Path:
    shutil.copytree(MODELS / "good" / "two_link_arm", tmp_path / "two_link_arm")
    return tmp_path / "two_link_arm" / "urdf"


def test_packages_and_their_files(arm: Path) -> None:
    text = '<robot><link name="a"><visual><geometry><mesh filename="{}|"/>'
    assert "package://two_link_arm/" in offers(arm, text.format(""))
    assert "package://two_link_arm/" in offers(arm, text.format("package://two"))
    found = offers(arm, text.format("package://two_link_arm/"))
    assert "meshes/" in found
    files = set(offers(arm, text.format("package://two_link_arm/meshes/")))
    there = {p.name for p in (arm.parent / "meshes").iterdir()}
    assert files == there
    assert files


def test_files_beside_the_robot(arm: Path) -> None:
    (arm / "parts.xacro").write_text("<robot/>")
    (arm / "notes.txt").write_text("")
    text = XACRO.format('<xacro:include filename="{}|"/>')
    found = set(offers(arm, text.format(""), "top.xacro"))
    assert "parts.xacro" in found
    assert "notes.txt" not in found
    assert "urdf/" in offers(arm, text.format("$(find two_link_arm)/"), "top.xacro")


def test_the_first_of_many_files_are_those_of_the_kind(
    arm: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(completion_in_text, "MAX_FILES", 2)
    for name in ("a.txt", "b.txt", "c.xacro", "d.xacro", "e.xacro"):
        (arm / name).touch()
    (arm / "circle").symlink_to("circle")
    found = offers(arm, XACRO.format('<xacro:include filename="|"/>'), "top.xacro").values()
    assert [offer.text for offer in found if offer.kind == "file"] == ["c.xacro", "d.xacro"]


def test_no_file_outside_is_offered(arm: Path) -> None:
    text = '<robot><link name="a"><visual><geometry><mesh filename="{}|"/>'
    for typed in ("/", "../../", "package://two_link_arm/../", "/etc/"):
        found = offers(arm, text.format(typed))
        assert {offer.kind for offer in found.values()} <= {"directory"}
        assert all(name.startswith("package://") for name in found)


def test_python_has_no_tags(tmp_path: Path) -> None:
    assert offers(tmp_path, 'is_small = 1 <| 2\nname = "<link name="', "a.launch.py") == {}


# --- against the grammar and the catalogue


@pytest.mark.parametrize("tag", sorted(ROBOT.children["link"].children))
def test_every_tag_of_a_link_is_offered_with_its_attributes(tmp_path: Path, tag: str) -> None:
    assert tag in offers(tmp_path, "<robot><link><|")
    found = set(offers(tmp_path, f"<robot><link><{tag} |"))
    assert found == set(ROBOT.children["link"].children[tag].attributes)


@pytest.mark.parametrize("plugin", plugins.all_plugins()[::12], ids=lambda plugin: plugin.id)
def test_every_parameter_of_a_plugin_is_offered(tmp_path: Path, plugin: plugins.Plugin) -> None:
    file = (plugin.files or plugin.fortress_files)[0]
    found = set(offers(tmp_path, ARM.format(f'<gazebo><plugin filename="{file}"><|')))
    tops = {name.partition("/")[0] for name in plugin.parameters if not name.startswith("@")}
    assert tops <= found
