"""yourdfpy is a second opinion on frames, numbers of joints and meshes."""

import re
import sys
from pathlib import Path
from typing import Any

import pytest

from tests.conftest import (
    ARM,
    GRIPPER,
    MOBILE_BASE,
    MODELS,
    CorpusRobot,
    manifest,
    model_id,
    needs_corpus,
)
from urdfkit import Context, frames, load, read, to_yourdfpy
from urdfkit.core.installation import install_command
from urdfkit.errors import MissingLibrary, UnreadableRobot
from urdfkit.robot.kinematics import laws

np = pytest.importorskip("numpy")
pytest.importorskip("yourdfpy")

#: What numbers written with a dozen digits leave of a frame after a chain of twenty joints.
TOLERANCE = 1e-9


def homogeneous(frame: Any) -> Any:
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = frame.rotation, frame.position
    return matrix


def positions(robot: Context) -> dict[str, float]:
    """Another position within a radian for each joint that can be moved by itself."""
    joints = robot.model.joints_by_name
    free = [
        joint.name
        for joint in robot.tree.spanning
        if joint.is_single_dof and laws(joints)[joint.name].leader == joint.name
    ]
    return {name: 0.3 + 0.7 * number / len(free) for number, name in enumerate(free)}


def assert_same_frames(robot: Context) -> None:
    given = positions(robot)
    ours = frames(robot.tree, given)
    theirs = to_yourdfpy(robot, load_meshes=False)
    theirs.update_cfg(given)
    root = robot.tree.roots[0].name
    for link, frame in ours.items():
        expected = theirs.get_transform(link, root)
        assert np.allclose(homogeneous(frame), expected, atol=TOLERANCE), link


def is_one_tree(robot: Context) -> bool:
    names = [link.name for link in robot.model.links]
    return len(robot.tree.roots) == 1 and len(set(names)) == len(frames(robot.tree, {}))


@needs_corpus
@pytest.mark.parametrize("entry", list(manifest()), ids=model_id)
def test_yourdfpy_agrees_about_every_frame(entry: CorpusRobot) -> None:
    try:
        robot = entry.read()
    except UnreadableRobot:
        pytest.skip("it cannot be read")
    if not is_one_tree(robot):
        pytest.skip("yourdfpy takes one tree only")
    try:
        assert_same_frames(robot)
    except UnreadableRobot as reason:
        pytest.skip(str(reason))


def test_a_xacro_comes_with_its_meshes() -> None:
    package = MODELS / "gazebo_pkg"
    robot = read(package / "urdf" / "waking_robot_new.xacro", packages={"gazebo_pkg": str(package)})
    theirs = to_yourdfpy(robot)
    assert set(theirs.link_map) == set(robot.model.links_by_name)
    assert_same_frames(robot)


def test_a_mesh_that_only_urdfkit_finds_is_loaded(tmp_path: Path) -> None:
    trimesh = pytest.importorskip("trimesh")
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    trimesh.creation.box((1, 2, 3)).export(elsewhere / "box.stl")
    file = tmp_path / "robot.urdf"
    file.write_text(
        "<robot name='r'><link name='a'><visual><geometry>"
        "<mesh filename='package://parts/box.stl'/></geometry></visual></link></robot>"
    )
    theirs = to_yourdfpy(read(file, packages={"parts": str(elsewhere)}))
    assert theirs.scene.extents == pytest.approx((1, 2, 3))


def test_without_yourdfpy_it_is_said_how_to_install_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "yourdfpy", None)
    robot = read(GRIPPER)
    with pytest.raises(MissingLibrary, match=re.escape(install_command("exchange"))):
        to_yourdfpy(robot)


def test_what_yourdfpy_makes_of_a_defect_is_one_clear_error(tmp_path: Path) -> None:
    file = tmp_path / "robot.urdf"
    file.write_text(
        "<robot name='r'><link name='a'/><link name='b'/>"
        "<joint name='j' type='fixed'><parent link='a'/><child link='b'/><origin xyz='0 0 }'/>"
        "</joint></robot>"
    )
    with pytest.raises(UnreadableRobot, match=r"yourdfpy cannot read .*robot\.urdf: could not"):
        to_yourdfpy(read(file))


def test_a_path_and_a_model_are_robots_too() -> None:
    expected = to_yourdfpy(read(MOBILE_BASE), load_meshes=False)
    for robot in (MOBILE_BASE, str(MOBILE_BASE), load(MOBILE_BASE)):
        found = to_yourdfpy(robot, load_meshes=False)
        assert found.link_map.keys() == expected.link_map.keys()
        for link in expected.link_map:
            assert np.array_equal(found.get_transform(link), expected.get_transform(link))


def test_a_model_finds_its_meshes() -> None:
    pytest.importorskip("trimesh")
    arm = load(ARM)
    assert to_yourdfpy(arm).scene.geometry


def test_the_arguments_of_a_model_hold(tmp_path: Path) -> None:
    text = (
        '<robot name="r" xmlns:xacro="http://ros.org/wiki/xacro"><xacro:arg name="p" default=""/>'
    )
    (tmp_path / "r.xacro").write_text(text + '<link name="$(arg p)a&amp;b"/></robot>')
    robot = to_yourdfpy(load(tmp_path / "r.xacro", arguments={"p": "left_"}))
    assert list(robot.link_map) == ["left_a&b"]


def test_a_model_knows_the_packages_that_it_was_loaded_with(tmp_path: Path) -> None:
    package, robot = tmp_path / "elsewhere", tmp_path / "robot" / "r.urdf"
    (package / "meshes").mkdir(parents=True)
    robot.parent.mkdir()
    mesh = MODELS / "good" / "two_link_arm" / "meshes"
    file = next(mesh.glob("*.stl"))
    (package / "meshes" / file.name).write_bytes(file.read_bytes())
    robot.write_text(
        '<robot name="r"><link name="a"><visual><geometry><mesh '
        f'filename="package://parts/meshes/{file.name}"/></geometry></visual></link></robot>'
    )
    scene = to_yourdfpy(load(robot, packages={"parts": str(package)})).scene
    assert len(scene.geometry) == 1
