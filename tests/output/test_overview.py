"""A robot on one page: the facts of the mission's model, of real robots, and of odd ones."""

import builtins
import json
import math
from typing import Any

import pytest

from tests.conftest import ARM, GRIPPER, MISSION, CorpusRobot, manifest, model_id
from tests.massive import BALL, inertial, joint, link, shape
from urdfkit.core.installation import install_command
from urdfkit.lint.context import Context
from urdfkit.lint.loading import read
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.output.overview import summarise
from urdfkit.text.source import Source


def of(text: str) -> Context:
    return read(Source("r.urdf", whole_robot(text).encode()))


def test_the_mission_s_model() -> None:
    found = summarise(read(MISSION))
    structure = found.structure
    assert (structure.links, sum(structure.joints.values())) == (10, 9)
    assert structure.joints == {"fixed": 5, "continuous": 4}
    assert (structure.nq, structure.nv) == (8, 4)
    assert structure.roots == ("dummy",)
    assert found.weight.whole.mass == pytest.approx(10.2301, rel=1e-12)
    assert found.targets == ("ros1", "classic-ros1")
    assert [sensor.type for sensor in found.sensors] == ["ray", "camera", "imu"]
    assert len(found.plugins) == 4
    assert found.shapes.missing == ("package://gazebo_pkg/meshes/hokuyo.dae",)


def test_a_follower_is_no_degree_of_freedom() -> None:
    structure = summarise(read(GRIPPER)).structure
    assert (structure.nq, structure.nv) == (1, 1)
    assert structure.free == {"left_finger_joint": "prismatic"}
    assert structure.followers == {"right_finger_joint": "left_finger_joint"}


def test_the_arm_lies_down() -> None:
    """Centre of mass and size at a right angle of the shoulder, by hand."""
    found = summarise(
        read(ARM),
        {"shoulder": math.pi / 2},
    )
    x = (1.5 * 0.15 + 0.7 * (0.36 + 0.125)) / 5.2
    z = (3 * 0.05 + 2.2 * 0.145) / 5.2
    whole = found.weight.whole.properties
    assert whole is not None
    assert list(whole.center) == pytest.approx([x, 0, z], abs=1e-12)
    box = found.shapes.box
    assert box is not None
    assert box.high == pytest.approx((0.61, 0.06, 0.185), abs=1e-6)
    assert found.pose == {"shoulder": math.pi / 2}


def test_the_whole_tensor_of_two_balls_by_the_parallel_axes() -> None:
    ball = inertial(2, (0.1, 0.1, 0.1))
    text = link("a", ball) + link("b", ball) + joint("a", "b", xyz="1 0 0")
    whole = summarise(of(text)).weight.whole.properties
    assert whole is not None
    mass, center, tensor = whole
    assert (mass, center) == (4, (0.5, 0, 0))
    assert tensor == pytest.approx((0.2, 0, 0, 1.2, 0, 1.2), abs=1e-15)


def test_without_the_readers_of_meshes_the_rest_is_there(monkeypatch: pytest.MonkeyPatch) -> None:
    arm = read(ARM)
    importing = builtins.__import__

    def lean(name: str, *rest: Any) -> Any:
        if name.partition(".")[0] in ("numpy", "trimesh") or name.startswith(
            "urdfkit.mesh.io.load"
        ):
            raise ImportError(name)
        return importing(name, *rest)

    monkeypatch.setattr(builtins, "__import__", lean)
    found = summarise(arm)
    assert found.shapes.triangles is None
    assert found.skipped == (
        f"triangles: meshes are not read without: {install_command('meshes')}",
    )
    assert set(found.shapes.left_out) == {"upper_arm", "forearm"}
    box = found.shapes.box
    assert box is not None
    assert box.high == pytest.approx((0.06, 0.06, 0.755))


def test_odd_robots_have_a_page() -> None:
    loop = (
        '<link name="a"/><link name="b"/>'
        '<joint name="ab" type="revolute"><parent link="a"/><child link="b"/></joint>'
        '<joint name="ba" type="fixed"><parent link="b"/><child link="a"/></joint>'
    )
    for text in ("<gazebo/>", '<link name="a"/>', loop, '<link/><joint/><link name="x"/>'):
        found = summarise(of(text))
        assert found.weight.whole.mass == 0
        assert found.shapes.box is None
    assert summarise(of(loop)).structure.roots == ()


def test_the_mass_of_a_loop_counts_although_it_is_nowhere() -> None:
    ball = inertial(2, (0.1, 0.1, 0.1))
    loop = link("a", ball) + link("b", ball) + joint("a", "b") + joint("b", "a")
    whole = summarise(of(loop)).weight.whole
    assert (whole.mass, whole.properties) == (4, None)
    assert whole.reason == "links in a closed loop without a root: a, b"


def test_of_many_roots_a_few_are_named() -> None:
    text = "".join(link(name, inertial(1, (1, 1, 1))) for name in "abcde")
    reason = "no joint connects the roots a, b, c and 2 more"
    assert summarise(of(text)).weight.whole.reason == reason


def test_how_several_roots_stand_to_one_another_nobody_says() -> None:
    ball = inertial(2, (0.1, 0.1, 0.1))
    text = link("a", ball, shape("visual", BALL)) + link("b", ball, shape("collision", BALL))
    found = summarise(of(text))
    assert (found.weight.whole.mass, found.weight.whole.properties) == (4, None)
    assert found.weight.whole.reason == "no joint connects the roots a, b"
    assert found.shapes.left_out == {"b": "not connected to root link a"}
    light = summarise(of(text.replace('value="2"', 'value="0"', 1))).weight.whole
    assert light.root == "b"
    assert light.properties is not None
    assert light.properties.center == (0, 0, 0)


def test_turned_primitives_are_measured_exactly() -> None:
    cylinder = shape("visual", '<cylinder radius="0.1" length="2"/>', rpy="1.5707963267948966 0 0")
    box = summarise(of(link("a", cylinder))).shapes.box
    assert box is not None
    assert box.edges == pytest.approx((0.2, 2, 0.2), abs=1e-12)


ENTRIES = [
    entry for entry in manifest() if "expect" in entry.facts and "fail_" not in entry.facts["path"]
]


@pytest.mark.parametrize("entry", ENTRIES, ids=model_id)
def test_real_robots(entry: CorpusRobot) -> None:
    """Masses and joints as other tools measured them, Pinocchio's nq and nv among them."""
    context = entry.alone
    vars(context)["meshes"] = _NoMeshes()
    found, expected = summarise(context), entry.facts["expect"]
    assert found.structure.joints == expected["joint_types"]
    assert found.weight.whole.mass == pytest.approx(expected["total_mass_kg"], rel=1e-9, abs=1e-12)
    pinocchio = expected["pinocchio"]
    if pinocchio["ok"] and not found.structure.followers:
        assert (found.structure.nq, found.structure.nv) == (pinocchio["nq"], pinocchio["nv"])
    planar = found.structure.joints.get("planar", 0)
    assert found.structure.nv - 2 * planar == expected["dof_independent_of_mimic"]


class _NoMeshes:
    """Their triangles are for other tests."""

    def mesh(self, shape: object) -> None:
        return None

    def vertices(self, shape: object) -> None:
        return None

    def reason(self, shape: object) -> str:
        return "not here"


def test_it_is_all_json() -> None:
    from urdfkit.cli.info import as_json

    assert json.loads(json.dumps(as_json(summarise(read(MISSION)))))["structure"]["nq"] == 8
