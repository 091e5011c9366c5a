"""What Gazebo makes of a robot, against libsdformat itself."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.conftest import MISSION, manifest
from tests.growth import executed_lines
from tests.libsdformat import Simulated, convert
from urdfkit.lint.context import Context
from urdfkit.ros.gazebo.conversion import NEW, OLD, Converter, SdfConversion
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver


def compare(conversion: SdfConversion, expected: Simulated) -> None:
    """Links with their mass properties, joints, and names of shapes are the same."""
    links = {link.name: link for link in conversion.links}
    assert set(links) == set(expected.links) - conversion.added
    for name, link in links.items():
        mass, tensor = link.properties, link.properties.tensor
        measured = (mass.mass, *mass.center, tensor.ixx + tensor.iyy + tensor.izz)
        assert measured == pytest.approx(expected.links[name], rel=1e-6, abs=1e-6)
    joints = {
        joint.joint.name: (joint.type, joint.parent, joint.child) for joint in conversion.joints
    }
    assert joints == {
        name: joint for name, joint in expected.joints.items() if name not in conversion.added
    }
    for kind in ("collisions", "visuals"):
        named = [name for link in conversion.links for name, _ in getattr(link, kind)]
        assert sorted(named) == sorted(getattr(expected, kind))


def robots() -> Iterator[object]:
    for entry in manifest():
        yield pytest.param(entry.path, entry.facts, id=str(entry))


def context(path: Path, *arguments: str) -> Context:
    values = dict(argument.split(":=", 1) for argument in arguments)
    return Context(Source.read(path), Resolver(), values)


@pytest.mark.parametrize(("path", "model"), list(robots()))
def test_robots_of_the_corpus_are_converted_like_libsdformat(sdformat, tmp_path, path, model):
    robot = context(path, *model["xacro_args"])
    if robot.reading.document is None:
        pytest.skip("it does not expand here")
    text = robot.reading.xacro.text() if robot.reading.xacro else robot.source.data.decode()
    expected = convert(sdformat, tmp_path, text)
    if not expected.links:
        pytest.skip("libsdformat refuses it")
    compare(SdfConversion(robot.tree, OLD), expected)


LINK = (
    '<link name="{}"><inertial><mass value="{}"/>'
    '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>'
)
JOINT = (
    '<joint name="{0}_{1}" type="{2}"><parent link="{0}"/><child link="{1}"/><axis xyz="0 0 1"/>'
    '<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>'
)
KEEP = '<gazebo reference="{}"><preserveFixedJoint>true</preserveFixedJoint></gazebo>'


def robot(*parts: str) -> str:
    return "<robot name='r'>" + "".join(parts) + "</robot>"


CASES = {
    "a massless link is dropped with its subtree": robot(
        LINK.format("a", 1),
        '<link name="b"/>',
        LINK.format("c", 1),
        JOINT.format("a", "b", "revolute"),
        JOINT.format("b", "c", "revolute"),
    ),
    "a merged massless link loses what moves on it": robot(
        LINK.format("a", 1),
        '<link name="b"/>',
        LINK.format("c", 1),
        JOINT.format("a", "b", "fixed"),
        JOINT.format("b", "c", "revolute"),
    ),
    "a merged link with a heavy child keeps what moves on it": robot(
        LINK.format("a", 1),
        '<link name="b"/>',
        LINK.format("c", 1),
        LINK.format("d", 1),
        JOINT.format("a", "b", "fixed"),
        JOINT.format("b", "c", "fixed"),
        JOINT.format("b", "d", "revolute"),
    ),
    "a massless root lives by what is merged into it": robot(
        '<link name="a"/>', LINK.format("b", 1), JOINT.format("a", "b", "fixed")
    ),
    "a preserved joint keeps its child": robot(
        LINK.format("a", 1),
        LINK.format("b", 2),
        JOINT.format("a", "b", "fixed"),
        KEEP.format("a_b"),
    ),
    "a preserved joint with a massless child vanishes": robot(
        LINK.format("a", 1), '<link name="b"/>', JOINT.format("a", "b", "fixed"), KEEP.format("a_b")
    ),
    "the world is no link, and what is fixed to it stays": robot(
        '<link name="world"/>',
        LINK.format("a", 1),
        LINK.format("b", 1),
        JOINT.format("world", "a", "fixed"),
        JOINT.format("a", "b", "fixed"),
    ),
    "a millionth of a kilogram counts as nothing": robot(
        LINK.format("a", 1), LINK.format("b", 1e-6), JOINT.format("a", "b", "revolute")
    ),
    "names of shapes": robot(
        '<link name="base"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" '
        'iyz="0" izz="1"/></inertial>'
        + "<collision{}><geometry><sphere radius='1'/></geometry></collision>".format("") * 2
        + "<collision name='base_x'><geometry><sphere radius='1'/></geometry></collision>"
        + "<collision name='other'><geometry><sphere radius='1'/></geometry></collision></link>",
        "<link name='base_laser'><inertial><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' "
        "iyy='1' iyz='0' izz='1'/></inertial>"
        "<collision><geometry><sphere radius='1'/></geometry></collision></link>",
        JOINT.format("base", "base_laser", "fixed"),
    ),
}  # fmt: skip


@pytest.mark.parametrize("text", CASES.values(), ids=CASES)
def test_corner_cases_are_converted_like_libsdformat(sdformat, tmp_path, text):
    compare(SdfConversion(_context(text).tree, OLD), convert(sdformat, tmp_path, text))


def _context(text: str) -> Context:
    return Context(Source("robot.urdf", text.encode()), Resolver())


def test_newer_versions_keep_children_of_a_merged_massless_link():
    tree = _context(CASES["a merged massless link loses what moves on it"]).tree
    assert [link.name for link in SdfConversion(tree, OLD).links] == ["a"]
    assert [link.name for link in SdfConversion(tree, NEW).links] == ["a", "c"]
    assert SdfConversion(tree, OLD).dropped == {
        "c": "child of 'b', which is merged and has no mass"
    }


def test_newer_versions_keep_a_tiny_mass():
    tree = _context(CASES["a millionth of a kilogram counts as nothing"]).tree
    assert SdfConversion(tree, OLD).dropped == {"b": "mass 1e-06 kg"}
    assert SdfConversion(tree, NEW).dropped == {}


def test_the_mission_model():
    conversion = context(MISSION).gazebo
    assert [link.name for link in conversion.links] == [
        "dummy", "wheel_1", "wheel_2", "wheel_3", "wheel_4",
    ]  # fmt: skip
    assert conversion.merged == dict.fromkeys(
        ["base_footprint", "base_link", "imu_link", "camera_link", "laser_frame"], "dummy"
    )
    assert conversion.links[0].properties.mass == pytest.approx(8.2301)
    assert conversion.dropped == {}


def test_a_loop_of_fixed_joints_ends():
    joint = '<joint name="{0}{1}" type="fixed"><parent link="{0}"/><child link="{1}"/></joint>'
    body = '<inertial><mass value="1"/></inertial><collision name="of {0}"/>'
    text = "".join(f'<link name="{name}">{body.format(name)}</link>' for name in "abc")
    text += "".join(joint.format(*pair) for pair in ("ab", "bc", "cb"))
    (link,) = SdfConversion(_context(f'<robot name="r">{text}</robot>').tree).links
    assert [element.get("name") for _, element in link.collisions] == ["of a", "of b", "of c"]


@pytest.mark.parametrize("converter", [NEW, OLD])
def test_circular_fixed_joints_end(converter: Converter) -> None:
    """HEBI's rosie: `omni_base` is fixed to `base_link`, and `base_link` to `omni_base`."""
    text = b"""<robot name="rosie">
<link name="base_footprint"/><link name="base_link"/>
<link name="omni_base"><inertial><mass value="1"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link><link name="wheel"/>
<joint name="a" type="fixed"><parent link="omni_base"/><child link="base_link"/></joint>
<joint name="b" type="fixed"><parent link="base_link"/><child link="omni_base"/></joint>
<joint name="c" type="fixed"><parent link="base_footprint"/><child link="base_link"/></joint>
<joint name="w" type="continuous"><parent link="omni_base"/><child link="wheel"/></joint>
</robot>"""
    context = Context(Source("rosie.urdf", text), Resolver())
    assert set(SdfConversion(context.tree, converter).dropped) == {"wheel"}


def test_time_is_linear_in_the_number_of_links() -> None:
    def lines(links: int) -> int:
        inertia = '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>'
        made = [
            f'<link name="l{n}"><inertial><mass value="1"/>{inertia}</inertial></link>'
            for n in range(links)
        ]
        made += [
            f'<joint name="j{n}" type="continuous"><parent link="l{n - 1}"/><child link="l{n}"/>'
            "</joint>"
            for n in range(1, links)
        ]
        text = f'<robot name="r">{"".join(made)}</robot>'
        context = Context(Source("r.urdf", text.encode()), Resolver({}, environment={}))
        tree = context.tree
        return executed_lines(lambda: SdfConversion(tree))

    assert lines(400) < 5 * lines(100)
