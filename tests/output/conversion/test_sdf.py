"""SDF: what was written is the robot, and what libsdformat itself makes of the URDF."""

import re
import subprocess
from collections.abc import Iterator
from math import pi
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from tests.conftest import CorpusRobot, manifest, model_id, needs_corpus
from tests.gazebos import BASE, block, child, plugin, sensor
from tests.gz_sdf import program
from tests.output.conversion.converted import assert_whole, of_corpus
from tests.output.conversion.converted import results as results_of
from tests.own_robots import own_robots
from urdfkit import convert, read
from urdfkit.core.spatial import from_rpy
from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.output.conversion.sdf_proof import prove
from urdfkit.output.conversion.sdf_reader import Sdf
from urdfkit.output.conversion.sdf_values import snapped_rpy
from urdfkit.robot.values import numbers
from urdfkit.ros.gazebo.conversion import NEW, OLD, SdfConversion
from urdfkit.text.document import Element
from urdfkit.text.source import Source
from urdfkit.text.xml_reader import read_xml

#: Each tree starts libsdformat.
FEWER = settings(max_examples=settings().max_examples // 3)

BOX = '<geometry><box size="1 1 1"/></geometry>'


def robot(*parts: str) -> Context:
    return read(Source("r.urdf", f'<robot name="r">\n{BASE}{"".join(parts)}</robot>'.encode()))


def element(data: bytes) -> Element:
    document, _ = read_xml(Source("a.sdf", data))
    assert document is not None
    return document.root


def model_of(robot: Context, out: Path) -> Element:
    """The model that is written."""
    found = convert(robot, out, to="sdf")
    model = element((out / found.file).read_bytes()).child("model")
    assert model is not None
    return model


def at(place: Element, path: str) -> Element:
    """A part by tags, or by the name after an ``=``."""
    for step in path.split("/"):
        tag, _, name = step.partition("=")
        found = [one for one in place.all(tag) if not name or one.get("name") == name]
        assert found, step
        place = found[0]
    return place


def text(place: Element, path: str) -> str:
    return at(place, path).text.strip()


@own_robots
def test_robots_of_the_project(path: Path, tmp_path: Path) -> None:
    pytest.importorskip("trimesh")
    found = convert(path, tmp_path / "o", to="sdf")
    assert found.proof.holds
    uris = [one.text.strip() for one in element((tmp_path / "o" / found.file).read_bytes()).walk()
            if one.tag == "uri" and one.parent and one.parent.tag == "mesh"]  # fmt: skip
    assert all((tmp_path / "o" / uri).is_file() for uri in uris)
    config = element((tmp_path / "o" / "model.config").read_bytes())
    assert (text(config, "name"), text(config, "sdf")) == (read(path).model.name, found.file)


# What libsdformat makes of the URDF.


def printed(path: str, file: Path) -> Element:
    """The model as libsdformat prints it."""
    said = subprocess.run([path, "sdf", "-p", str(file)], capture_output=True, check=False)
    model = element(said.stdout).child("model")
    assert model is not None
    return model


#: In versions before these: no frames of merged links and joints, no mimic; a sensor that is merged
#: twice is elsewhere, a light stays where it was, and SDF of the model does not follow its links.
FRAMES, MIMIC = (12, 7, 0), (14, 0, 0)


def differences(ours: Element, theirs: Element, version: tuple[int, ...]) -> Iterator[str]:
    """What is different in two models, but for rounding and the names of mesh files."""
    has_frames = version >= FRAMES
    if _values(ours) != _values(theirs):
        yield f"{ours.path}: {_values(ours)} is not {_values(theirs)}"
    is_moved = ours.parent is not None and ours.parent.tag in ("sensor", "light", "projector")
    is_file = ours.tag == "uri" and ours.parent is not None and ours.parent.tag == "mesh"
    if not is_file and not (ours.tag == "pose" and is_moved and not has_frames):
        one, other = _numbers(ours), _numbers(theirs)
        near = pytest.approx(other, rel=2e-5, abs=1e-6) if not isinstance(other, str) else other
        if one != near:
            yield f"{ours.path}: {ours.text.strip()} is not {theirs.text.strip()}"
    parts = [_parts(one, has_frames) for one in (ours, theirs)]
    if [*parts[0]] != [*parts[1]]:
        yield f"{ours.path}: {[*parts[0]]} is not {[*parts[1]]}"
        return
    for name in parts[0]:
        yield from differences(parts[0][name], parts[1][name], version)


def _values(one: Element) -> dict[str, str]:
    return {name: attribute.value for name, attribute in one.attributes.items()}


def _numbers(one: Element) -> Any:
    values = numbers(one.text)
    if values is not None and one.tag == "pose" and len(values) == 6:
        return [*values[:3], *(cell for row in from_rpy(*values[3:]) for cell in row)]
    return values if values is not None else one.text.strip()


def _parts(one: Element, has_frames: bool) -> dict[tuple[str, str, int], Element]:
    """The children, by tag and name; what is empty or a default counts as nothing."""
    found: dict[tuple[str, str, int], Element] = {}
    for part in sorted(one.children, key=lambda part: (part.tag, part.get("name") or "")):
        is_old = part.tag == "frame" and not has_frames
        is_old |= part.tag.endswith("::corrected_offsets")  # ignition:: before gz::
        is_empty = part.tag in ("ode", "static") and part.text.strip() in ("", "false")
        if is_old or (is_empty and not part.children):
            continue
        number = sum(key[:2] == (part.tag, part.get("name") or "") for key in found)
        found[part.tag, part.get("name") or "", number] = part
    return found


def require_equal(robot: Context, directory: Path) -> None:
    """What is written must be what the installed libsdformat makes of the URDF."""
    path, version = program()
    model = convert(robot, directory / "o", to="sdf")
    if version < FRAMES:
        old, new = (SdfConversion(robot.tree, one) for one in (OLD, NEW))
        if [one.name for one in old.links] != [one.name for one in new.links]:
            pytest.skip("this version drops other links")
        if any(joint.parent or joint.child("parent") for joint in new.added_joints):
            pytest.skip("in this version the joints of <gazebo> do not follow their links")
    urdf, sdf = directory / "robot.urdf", directory / "o" / "read.sdf"
    urdf.write_bytes(robot.text)
    written = (directory / "o" / model.file).read_text(encoding="utf-8")
    if version < MIMIC:  # what it reads is at most SDF 1.9
        written = re.sub(r"(?s)<mimic.*?</mimic>", "", written.replace('"1.11"', '"1.7"'))
    sdf.write_text(written, encoding="utf-8")
    found = [*differences(printed(path, sdf), printed(path, urdf), version)]
    assert not found, f"libsdformat {version}"


@needs_corpus
@pytest.mark.parametrize("entry", list(manifest()), ids=model_id)
def test_robots_of_the_corpus(entry: CorpusRobot, tmp_path: Path) -> None:
    pytest.importorskip("trimesh")
    converted = of_corpus(entry, tmp_path / "proved", "sdf")
    assert all(one.note for one in converted.entries)
    require_equal(entry.read(), tmp_path)


SHAPES = f"<visual>{BOX}</visual><collision>{BOX}</collision>"
MASS = (
    '<inertial><mass value="2"/><origin xyz="0 0 1" rpy="0.1 0.2 0.3"/>'
    '<inertia ixx="0.1" ixy="0.01" ixz="0" iyy="0.2" iyz="0" izz="0.25"/></inertial>'
)
ARM = child("arm", "fixed", inside=MASS + SHAPES, xyz="1 2 3")
CASES = {
    "a merged link": ARM,
    "one with settings": ARM
    + block("<mu1>0.5</mu1><kp>1e5</kp><maxContacts>3</maxContacts>", "arm"),
    "a preserved joint": ARM + block("<preserveFixedJoint>true</preserveFixedJoint>", "arm_joint"),
    "a joint without a range": ARM
    + block("<disableFixedJointLumping>true</disableFixedJointLumping>", "arm_joint"),
    "a material": ARM
    + block("<material>Gazebo/Orange</material><selfCollide>1</selfCollide>", "arm"),
    "parts of visuals and collisions": child("arm", inside=MASS + SHAPES)
    + block(
        "<visual><material><ambient>1 0 0 1</ambient></material></visual>"
        "<collision><surface><bounce><restitution_coefficient>1</restitution_coefficient>"
        "</bounce></surface></collision><turnGravityOff>true</turnGravityOff>",
        "arm",
    ),
    "settings of a joint": child("arm", "revolute")
    + block(
        "<stopErp>0.2</stopErp><springStiffness>3</springStiffness>"
        "<provideFeedback>true</provideFeedback><implicitSpringDamper>1</implicitSpringDamper>",
        "arm_joint",
    ),
    "a pitch near a right angle": child("arm", "fixed", inside=MASS + SHAPES).replace(
        '<origin xyz="0 0 0"/>', '<origin xyz="1 0 0" rpy="0.3 1.57 0.2"/>'
    ),
    "limits the wrong way round": child("arm", "prismatic").replace('lower="-1"', 'lower="2"'),
    "a plugin": plugin("libgazebo_ros_p3d.so", "<a>1</a><b><c d='2'>x</c></b>"),
    "an old plugin": ARM
    + plugin(
        "p.so", "<bodyName>arm</bodyName><xyzOffset>1 0 0</xyzOffset><rpyOffset>0 0 1</rpyOffset>"
    ),
    "a sensor": ARM + sensor("imu", "<pose>1 0 0 0 0 1</pose><topic>i</topic>", "arm"),
    "static": block("<static>true</static>", ""),
    "the world": '<link name="world"/><joint name="w" type="fixed"><parent link="world"/>'
    '<child link="base"/><origin xyz="0 0 1"/></joint>' + ARM,
}  # fmt: skip


@pytest.mark.parametrize("case", CASES)
def test_pieces_of_robots(case: str, tmp_path: Path) -> None:
    require_equal(robot(CASES[case]), tmp_path)


@st.composite
def trees(draw: st.DrawFn) -> str:
    """Links in frames of all directions; fixed joints, some of them preserved."""
    value = st.sampled_from((0.0, 0.3, -1.2, 1.57, pi / 2, -1.5708, 3.1))
    parts = []
    for number in range(1, draw(st.integers(2, 7))):
        words = [" ".join(str(draw(value)) for _ in range(3)) for _ in range(4)]
        name, parent = f"l{number}", draw(st.integers(0, number - 1))
        inertial = MASS.replace("0.1 0.2 0.3", words[0]) if draw(st.booleans()) else ""
        kind = draw(st.sampled_from(("fixed", "fixed", "revolute", "continuous")))
        shape = f'<visual><origin xyz="{words[1]}" rpy="{words[2]}"/>{BOX}</visual>'
        part = child(name, kind, parent=f"l{parent}" if parent else "base", inside=inertial + shape)
        parts.append(
            part.replace('<origin xyz="0 0 0"/>', f'<origin xyz="1 2 3" rpy="{words[3]}"/>')
        )
        if draw(st.integers(0, 4)) == 0:
            parts.append(block("<preserveFixedJoint>1</preserveFixedJoint>", f"{name}_joint"))
    return "".join(parts)  # fmt: skip


@settings(FEWER, suppress_health_check=list(HealthCheck), derandomize=True)
@given(trees())
def test_random_trees(tmp_path_factory: pytest.TempPathFactory, parts: str) -> None:
    made = robot(parts)
    try:
        found = convert(made, tmp_path_factory.mktemp("tree") / "o", to="sdf")
    except UrdfkitError as error:
        assert "rejects the robot" in str(error)  # noqa: PT017
        return
    assert_whole(made, found)


# What is written, without libsdformat.


def test_a_merged_link_becomes_a_frame_and_keeps_its_parts(tmp_path: Path) -> None:
    extension = block("<mu1>0.5</mu1>", "arm")
    model = model_of(robot(ARM, extension, sensor("imu", "<pose>1 0 0 0 0 0</pose>", "arm")),
                     tmp_path / "o")  # fmt: skip
    assert [one.get("name") for one in model.all("link")] == ["base"]
    assert at(model, "frame=arm_joint").get("attached_to") == "base"
    assert text(model, "frame=arm_joint/pose") == "1 2 3 0 0 0"
    assert at(model, "frame=arm").get("attached_to") == "arm_joint"
    assert text(model, "link/inertial/mass") == "3"
    lumped = "link/collision=base_fixed_joint_lump__arm_collision"
    assert text(model, f"{lumped}/surface/friction/ode/mu") == "0.5"
    assert text(model, "link/sensor/pose") == "2 2 3 0 0 0"


def test_a_moved_pose_in_degrees_is_read_in_radians(tmp_path: Path) -> None:
    """As libsdformat 12.3 has it: it moves sensors of merged links alone."""
    pose = '<pose degrees="true">1 0 0 0 0 90</pose>'
    tags = sensor("imu", pose, "arm"), sensor("imu", pose).replace('"s"', '"own"')
    found = convert(robot(ARM, *tags), tmp_path / "o", to="sdf")
    results = {one.part: one.result.value for one in found.entries}
    assert results["gazebo/arm/sensor/s/pose"] == "approximated"
    assert results["gazebo/base/sensor/own/pose"] == "kept"


def test_a_massless_link_is_dropped_with_its_children(tmp_path: Path) -> None:
    made = robot(child("tip", inside=""), child("end", parent="tip"))
    found = convert(made, tmp_path / "o", to="sdf")
    results = {one.part: one.note for one in found.entries if one.result.value == "lost"}
    assert results["link/tip"] == "Gazebo drops the link: no inertial"
    assert results["joint/end_joint"] == "Gazebo drops 'end'"
    assert found.counts["link"] == 1


def test_a_mimic_joint_keeps_its_mimic(tmp_path: Path) -> None:
    leader = child("left", "revolute")
    follower = child("right", "revolute").replace(
        "<axis", '<mimic joint="left_joint" multiplier="-2" offset="0.5"/><axis'
    )
    mimic = at(model_of(robot(leader, follower), tmp_path / "o"), "joint=right_joint/axis/mimic")
    assert mimic.get("joint") == "left_joint"
    assert (text(mimic, "multiplier"), text(mimic, "offset")) == ("-2", "0.5")


def test_joints_of_gazebo_follow_merged_links(tmp_path: Path) -> None:
    loop = block(
        "<joint name='loop' type='fixed'><parent>base</parent><child>arm</child></joint>", ""
    )
    model = model_of(robot(ARM, child("tip"), loop), tmp_path / "o")
    assert text(model, "joint=loop/child") == "base"


def test_results_of_the_parts(tmp_path: Path) -> None:
    parts = (
        ARM.replace("<visual>", '<visual><material name="m"><color rgba="1 0 0 1"/></material>'),
        child("tip", "fixed", inside="<visual><origin rpy='0 1.57 0'/>" + BOX + "</visual>"),
        block("<mu1>1</mu1><preserveFixedJoint>1</preserveFixedJoint>", "base"),
        block("<mu1>1</mu1>", "nobody"),
        block("<sensor name='ft' type='force_torque'/>", "arm_joint"),
        block("<mu2>1</mu2><static>false</static>", ""),
        child("plate", "fixed", inside=f"<collision name='c'>{BOX}</collision>"),
        block("<mu1>1</mu1><static>true</static><gravity>1</gravity>", "plate"),
        "<transmission name='t'/>",
    )
    found = convert(robot(*parts), tmp_path / "o", to="sdf")
    results = results_of(found)
    assert results["link/base"] == "kept: link"
    assert results["link/arm"] == "approximated: frame of 'base', into which it is merged"
    assert results["joint/arm_joint"] == "approximated: frame; the links are merged"
    assert results["link/arm/inertial/mass@value"] == "kept: part of the mass of 'base'"
    color = results["link/arm/visual/material/m/color"]
    assert color == "approximated: diffuse and ambient, 1.25 times as bright"
    assert "rounded to 90 degrees, off by 0.0008 rad" in results["link/tip/visual/origin"]
    assert results["gazebo/base/mu1"] == ("lost: it applies to a collision, and 'base' has none")
    assert results["gazebo/base/preserveFixedJoint"] == "lost: sdformat ignores it"
    assert results["gazebo/nobody"] == "lost: no link or joint 'nobody'"
    assert results["gazebo/arm_joint"] == "lost: joint 'arm_joint' is merged or dropped"
    assert results["transmission/t"].startswith("lost: not in SDF")
    lost = [note for part, note in results.items() if part.endswith("mu2")]
    assert lost == ["lost: it applies to a collision, and the <gazebo> has no reference"]
    assert results["gazebo/plate/mu1"].endswith(
        "no collision of 'plate' has a name that it applies to"
    )
    assert results["gazebo/plate/static"].startswith("lost: it applies to the model")


REFUSED = {
    "a merged link on a dropped one": (
        child("a", inside="") + child("b", "fixed", parent="a", inside=""),
        "'b' is merged into a link that is dropped"),
    "a frame with the name of a joint": (
        child("tip") + child("tip_joint", "fixed"), "has the name of another"),
    "a floating joint": (child("a", "floating"), "floating joint 'a_joint'"),
    "two masses of zero": (
        child("a", "fixed", inside=MASS.replace('"2"', '"0"'))
        + child("b", "fixed", parent="a", inside=MASS.replace('"2"', '"0"')),
        "links 'b' and 'a' have a total mass of 0"),
    "a capsule": (
        child("a", inside=MASS + "<visual><geometry><capsule radius='1' length='1'/></geometry>"
              "</visual>"),
        "Gazebo does not read <capsule>"),
    "a colour of three numbers": (
        child("a", inside=MASS + "<visual>" + BOX
              + "<material name='m'><color rgba='1 1 1'/></material></visual>"),
        "3 numbers, not 4"),
    "a planar joint": (child("a", "planar"), "not convert planar joints"),
    "a joint that follows itself": (
        child("a").replace("<axis", '<mimic joint="a_joint"/><axis'), "mimics itself"),
    "a frame with the name of a link": (block("<frame name='base'/>", ""), "has the name 'base'"),
    "an integer that is too large": (block("<maxContacts>3000000000</maxContacts>"), "a number"),
    "a number that is too large": (block("<kp>1e400</kp>"), "not a number"),
    "too many elements": (block("<a>" * 500 + "</a>" * 500), "at most 500 nested elements"),
    "a pose of three numbers": (
        ARM + sensor("imu", "<pose>1 0 0</pose>", "arm"), "not 6 numbers"),
}  # fmt: skip


@pytest.mark.parametrize("case", REFUSED)
def test_a_robot_that_gazebo_rejects_is_an_error(case: str, tmp_path: Path) -> None:
    parts, message = REFUSED[case]
    with pytest.raises(UrdfkitError, match=message) as caught:
        convert(robot(parts), tmp_path / "o", to="sdf")
    assert re.match(r"r\.urdf:\d+:\d+: .+; [^;]+", str(caught.value))
    assert not (tmp_path / "o").exists()


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("<mass>3<", "<mass>3.1<"),
        ("1 2 3 0 0 0</pose>", "1 2 3.1 0 0 0</pose>"),
        ('to="base">\n      <pose>1 2 3 0 0', 'to="base">\n      <pose>1 2 3 0 1'),
        (
            "<pose>1 2 3 0 0 0</pose>\n        <geometry>",
            "<pose>1 2 3 0 1 0</pose>\n        <geometry>",
        ),
        ("<effort>1<", "<effort>2<"),
        ("<xyz>0 1 0<", "<xyz>0 -1 0<"),
        ('type="revolute"', 'type="prismatic"'),
        ("<lower>-1<", "<lower>-2<"),
    ],
)
def test_the_proof_fails_for_a_wrong_file(old: str, new: str, tmp_path: Path) -> None:
    made = robot(ARM, child("tip", "revolute"))
    convert(made, tmp_path / "o", to="sdf")
    written = (tmp_path / "o" / "model.sdf").read_text()
    assert old in written

    def holds(changed: str) -> bool:
        sdf = Sdf(Source("m.sdf", changed.encode()))
        return prove(sdf, made, SdfConversion(made.tree, NEW)).holds

    assert holds(written)
    assert not holds(written.replace(old, new, 1))


@pytest.mark.parametrize("pitch", [1.57, -1.57, pi / 2, -pi / 2, 1.2])
def test_a_pitch_near_90_degrees_is_rounded(pitch: float) -> None:
    roll, found, yaw = snapped_rpy(from_rpy(0.3, pitch, 0.2))
    assert found == pytest.approx(pitch if abs(pitch) < 1.5 else pi / 2 * (1 if pitch > 0 else -1))
    assert (roll == 0) == (abs(pitch) > 1.5)
    if abs(pitch) == pi / 2:
        before, after = from_rpy(0.3, pitch, 0.2), from_rpy(roll, found, yaw)
        assert sum(after, ()) == pytest.approx(sum(before, ()), abs=1e-12)
