"""Dynamics against closed forms, and the traps of Pinocchio."""

from math import cos, pi, sin
from typing import Any

import pytest

np = pytest.importorskip("numpy")
pin = pytest.importorskip("pinocchio")

from tests.conftest import ARM, MISSION
from tests.documents import tree
from tests.jointed import limit, mimic
from tests.massive import inertial, joint, link
from urdfkit.lint.loading import read
from urdfkit.physics.dynamics.robot import MAX_JOINTS, Dynamics, Unsuitable
from urdfkit.robot import inertia
from urdfkit.robot.composite_body import composite_body
from urdfkit.robot.kinematics import frames
from urdfkit.robot.link import Tensor
from urdfkit.robot.model import UnknownLink
from urdfkit.text.source import Source

G = 9.81


def exactly(expected: Any) -> Any:
    return pytest.approx(expected, rel=1e-10, abs=1e-12)


def dynamics(text: str, **options: Any) -> Dynamics:
    return Dynamics(tree(text), **options)


def moving(
    parent: str, child: str, kind: str, axis: str, xyz: str = "0 0 0", more: str = ""
) -> str:
    """A joint with an axis, called after its child."""
    bounds = limit("-3", "3") if kind in ("revolute", "prismatic") else ""
    return (
        f'<joint name="{child}_joint" type="{kind}"><origin xyz="{xyz}"/><parent link="{parent}"/>'
        f'<child link="{child}"/><axis xyz="{axis}"/>{bounds}{more}</joint>\n'
    )


# --- closed forms


@pytest.mark.parametrize("kind", ["revolute", "continuous"])
@pytest.mark.parametrize("q", [0.0, 0.4, -pi / 2, 3.0])
def test_a_pendulum(kind: str, q: float) -> None:
    """2 kg at 0.7 m, swinging about y, hanging along -z at 0."""
    text = link("base", inertial(5, (1, 1, 1))) + link(
        "bob", inertial(2, (0.01, 0.02, 0.03), xyz="0 0 -0.7")
    )
    pendulum = dynamics(text + moving("base", "bob", kind, "0 1 0"))
    pose = {"bob_joint": q}
    assert pendulum.columns == ("bob_joint",)
    assert pendulum.gravity(pose) == exactly([2 * G * 0.7 * sin(q)])
    assert pendulum.mass_matrix(pose) == exactly(np.array([[2 * 0.49 + 0.02]]))
    assert pendulum.mass_properties(pose).mass == 7
    x, _, z = pendulum.mass_properties(pose).center
    assert (x, z) == exactly((-2 * 0.7 * sin(q) / 7, -2 * 0.7 * cos(q) / 7))


@pytest.mark.parametrize(
    ("tensor", "expected"),
    [
        (inertia.box(3, (0.1, 0.2, 0.3)), (3 * 0.13 / 12, 3 * 0.1 / 12, 3 * 0.05 / 12)),
        (inertia.cylinder(3, 0.1, 0.4), (3 * 0.19 / 12, 3 * 0.19 / 12, 3 * 0.01 / 2)),
    ],
    ids=["box", "cylinder"],
)
def test_solids_turned_about_their_axes(
    tensor: Tensor, expected: tuple[float, float, float]
) -> None:
    for axis, moment in zip(("1 0 0", "0 1 0", "0 0 1"), expected, strict=True):
        text = link("base", inertial(1, (1, 1, 1))) + link("body", inertial(3, tuple(tensor)))
        body = dynamics(text + moving("base", "body", "continuous", axis))
        assert body.mass_matrix({"body_joint": 1.1}) == exactly(np.array([[moment]]))


@pytest.mark.parametrize("q", [(0.0, 0.0), (0.3, -0.8), (-1.2, 1.7)])
def test_a_two_link_arm(q: tuple[float, float]) -> None:
    """The textbook's mass matrix and torques of the arm that swings about y, upright at 0."""
    arm = Dynamics(read(ARM).tree)
    pose = {"shoulder": q[0], "elbow": q[1]}
    m1, m2, c1, c2, length, i1, i2 = 1.5, 0.7, 0.15, 0.125, 0.36, 0.01185, 0.00380333
    last = i2 + m2 * c2 * c2
    cross = m2 * (c2 * c2 + length * c2 * cos(q[1])) + i2
    first = i1 + m1 * c1 * c1 + i2 + m2 * (length * length + c2 * c2 + 2 * length * c2 * cos(q[1]))
    expected = np.array([[first, cross], [cross, last]])
    assert arm.mass_matrix(pose) == exactly(expected)
    elbow = -m2 * G * c2 * sin(q[0] + q[1])
    shoulder = -(m1 * c1 + m2 * length) * G * sin(q[0]) + elbow
    assert arm.gravity(pose) == exactly([shoulder, elbow])
    jacobian = arm.jacobian("forearm", pose)
    assert jacobian[:, 0] == exactly([length * cos(q[0]), 0, -length * sin(q[0]), 0, 1, 0])
    assert jacobian[:, 1] == exactly([0, 0, 0, 0, 1, 0])
    placement = arm.placement("forearm", pose)
    assert placement[:3, 3] == exactly([length * sin(q[0]), 0, 0.145 + length * cos(q[0])])


def test_the_whole_as_one_body_is_that_of_the_parallel_axes() -> None:
    """All six entries of the tensor, which Pinocchio keeps in another order."""
    odd = inertial(2, (0.3, 0.01, 0.02, 0.4, 0.03, 0.5), xyz="0.1 0.2 0.3", rpy="0.1 0.2 0.3")
    text = link("base", inertial(3, (0.1, 0.2, 0.25))) + link("a", odd)
    robot = dynamics(text + moving("base", "a", "revolute", "1 2 3", xyz="0.5 -0.4 0.2"))
    pose = {"a_joint": 0.7}
    expected = composite_body(robot.tree, frames(robot.tree, pose)).properties
    found = robot.mass_properties(pose)
    assert expected is not None
    assert found.mass == 5
    assert found.center == exactly(expected.center)
    assert tuple(found.tensor) == exactly(tuple(expected.tensor))
    assert len({round(abs(value), 6) for value in found.tensor}) == 6


def test_a_slide_lifts_what_hangs_on_it_and_its_payload() -> None:
    text = link("base", inertial(1, (1, 1, 1))) + link("cage", inertial(4, (1, 1, 1)))
    text += link("hook", inertial(0.5, (1, 1, 1))) + joint("cage", "hook", xyz="0.3 0 0")
    lift = dynamics(text + moving("base", "cage", "prismatic", "0 0 1"), payload={"hook": 1.5})
    assert lift.gravity({}) == exactly([6 * G])
    assert lift.mass_properties().mass == 7


def test_followers_in_front_of_their_leader_and_on_another_branch() -> None:
    """Traps: Pinocchio's reader refuses a follower before its leader, or ignores mimic at all."""
    ball = inertial(2, (0.1, 0.1, 0.1), xyz="0.5 0 0")
    text = link("base", inertial(1, (1, 1, 1))) + link("b", ball) + link("a", ball)
    text += moving("base", "b", "revolute", "0 1 0", more=mimic("a_joint", 'multiplier="-2"'))
    text += moving("base", "a", "continuous", "0 1 0")
    both = dynamics(text)
    assert both.columns == ("a_joint",)
    assert (both.nq, both.nv) == (2, 1)
    # V = -2 g 0.5 (sin q - sin 2q): the follower at -2 q rises where the leader sinks.
    expected = -2 * G * 0.5 * (cos(0.3) - 2 * cos(0.6))
    assert both.gravity({"a_joint": 0.3}) == exactly([expected])
    about = 0.1 + 2 * 0.25
    assert both.mass_matrix({}) == exactly(np.array([[about + 4 * about]]))


def test_pinocchio_s_own_reader_ignores_followers_or_refuses_them() -> None:
    """The trap behind the constant matrix; once it is gone, so may be the matrix."""
    text = link("base") + link("b") + link("a")
    text += moving("base", "a", "revolute", "0 1 0", more=mimic("b_joint"))
    text = f'<robot name="r">{text}{moving("base", "b", "revolute", "0 1 0")}</robot>'
    assert pin.buildModelFromXML(text).nv == 2
    with pytest.raises(ValueError, match="mimic"):
        pin.buildModelFromXML(text, mimic=True)
    assert Dynamics(read(Source("r.urdf", text.encode())).tree).nv == 1


def test_what_follows_nobody_stands_still() -> None:
    text = link("base", inertial(1, (1, 1, 1))) + link("a", inertial(1, (1, 1, 1)))
    still = dynamics(text + moving("base", "a", "revolute", "0 1 0", more=mimic("a_joint")))
    assert still.columns == ()
    assert still.gravity({}).shape == (0,)
    assert still.mass_matrix({}).shape == (0, 0)


def test_a_planar_joint_moves_across_its_axis_and_turns_about_it() -> None:
    """As the specification of URDF has it; 2 kg at 0.5 m from the joint, on a table and a wall."""
    text = link("base", inertial(1, (1, 1, 1))) + link(
        "puck", inertial(2, (0.1, 0.1, 0.1), xyz="0.5 0 0")
    )
    table = dynamics(text + moving("base", "puck", "planar", "0 0 2"))
    assert table.columns == ("puck_joint[0]", "puck_joint[1]", "puck_joint[2]")
    assert (table.nq, table.nv) == (4, 3)
    assert table.gravity({}) == exactly([0, 0, 0])
    # Along x and y moves the mass; turning about the joint moves it along y at 0.5 m.
    assert table.mass_matrix({}) == exactly(np.array([[2, 0, 0], [0, 2, 1], [0, 1, 0.1 + 0.5]]))
    wall = dynamics(text + moving("base", "puck", "planar", "0 1 0"))
    # The least turn that takes z to y takes y to -z.
    assert wall.jacobian("puck", {}) == exactly(
        np.array([[1, 0, 0, 0, 0, 0], [0, 0, -1, 0, 0, 0], [0, 0, 0, 0, 1, 0]]).T
    )
    assert wall.gravity({}) == exactly([0, -2 * G, -2 * G * 0.5])
    assert wall.placement("puck", {}) == exactly(np.eye(4))


@pytest.mark.parametrize("axis", ["0 0 -1", "1 2 3", "-1 0.2 -1e-9", "1 0 0"])
@pytest.mark.parametrize("kind", ["planar", "continuous"])
def test_any_axis(kind: str, axis: str) -> None:
    """Turning is about the axis, sliding across it, and at zero all is at its place."""
    text = link("base", inertial(1, (1, 1, 1))) + link("a", inertial(1, (1, 1, 1)))
    found = dynamics(text + moving("base", "a", kind, axis, xyz="1 2 3"))
    jacobian = found.jacobian("a", {})
    unit = np.fromstring(axis, sep=" ") / np.linalg.norm(np.fromstring(axis, sep=" "))
    assert jacobian[3:, -1] == exactly(unit)
    assert jacobian[:3, -1] == exactly([0, 0, 0])
    assert jacobian[:3, :-1].T @ jacobian[:3, :-1] == exactly(np.eye(found.nv - 1))
    assert unit @ jacobian[:3, :-1] == exactly(np.zeros(found.nv - 1))
    expected = np.eye(4)
    expected[:3, 3] = 1, 2, 3
    assert found.placement("a", {}) == exactly(expected)


@pytest.mark.parametrize("kind", ["planar", "floating"])
def test_joints_of_several_coordinates_are_those_of_pinocchio_s_reader(kind: str) -> None:
    """It takes no axis but z."""
    ball = inertial(2, (0.1, 0.2, 0.3), xyz="0.5 0.1 0.2")
    text = link("base") + link("a", ball) + link("b", ball)
    text += moving("base", "a", kind, "0 0 1", xyz="0 0.3 1")
    text += moving("a", "b", "revolute", "0 1 0", xyz="1 0 0")
    ours = dynamics(text)
    theirs = pin.buildModelFromXML(f'<robot name="r">{text}</robot>')
    data, q = theirs.createData(), pin.neutral(theirs)
    q[-1] = 0.4
    pose = {"b_joint": 0.4}
    assert (ours.nq, ours.nv) == (theirs.nq, theirs.nv)
    upper = np.triu(pin.crba(theirs, data, q))
    assert ours.mass_matrix(pose) == exactly(upper + np.triu(upper, 1).T)
    assert ours.gravity(pose) == exactly(pin.computeGeneralizedGravity(theirs, data, q))
    expected = pin.computeFrameJacobian(
        theirs, data, q, theirs.getFrameId("b"), pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
    )
    assert ours.jacobian("b", pose) == exactly(expected)


# --- the traps of Pinocchio


def test_the_root_s_mass_counts() -> None:
    """A model with a fixed base says 2 kg of the mission's 10.2301 kg."""
    robot = read(MISSION)
    assert robot.dynamics.mass_properties().mass == pytest.approx(10.2301, rel=1e-12)
    assert (robot.dynamics.nq, robot.dynamics.nv) == (8, 4)
    fixed = pin.buildModelFromXML(robot.text.decode())
    assert pin.computeTotalMass(fixed) == pytest.approx(2.0)


def test_names_that_pinocchio_has_itself_are_names_as_any() -> None:
    text = link("universe", inertial(1, (1, 1, 1))) + link("root_joint", inertial(2, (1, 1, 1)))
    text += moving("universe", "root_joint", "continuous", "0 0 1").replace(
        "root_joint_joint", "universe"
    )
    odd = dynamics(text)
    assert odd.columns == ("universe",)
    assert odd.mass_properties().mass == 3
    assert odd.placement("root_joint", {"universe": pi})[0, 0] == pytest.approx(-1)


def test_what_pinocchio_takes_silently_is_taken() -> None:
    """Negative masses, tensors of no body, no axis: rules tell them, and nothing crashes."""
    text = link("base", inertial(-1, (-1, 1, 1))) + link("a", inertial(0, (0, 0, 0)))
    silly = dynamics(text + moving("base", "a", "revolute", "0 0 0"))
    assert silly.mass_properties().mass == -1
    assert silly.gravity({}) == pytest.approx([0])


@pytest.mark.parametrize("xyz", ["1e300 0 0", "0 -1e31 0"])
def test_numbers_of_no_robot_are_refused(xyz: str) -> None:
    text = link("base") + link("a", inertial(1, (1, 1, 1)))
    with pytest.raises(Unsuitable, match="implausibly far away"):
        dynamics(text + moving("base", "a", "continuous", "0 0 1", xyz=xyz))
    with pytest.raises(Unsuitable, match="link 'a' has an implausible mass, position or inertia"):
        dynamics(link("a", inertial(1, (1, 1, 1), xyz=xyz)))
    with pytest.raises(Unsuitable, match="link 'a' has an implausible mass, position or inertia"):
        dynamics(link("a", inertial(1e300, (1, 1, 1))))


def test_graphs_that_are_no_tree_are_refused() -> None:
    for text in (link("a") + link("b"), link("a") + link("a")):
        with pytest.raises(Unsuitable, match="do not form one tree"):
            dynamics(text)
    with pytest.raises(Unsuitable, match="it has no link"):
        dynamics("<gazebo/>")


def test_too_many_joints_are_refused_before_pinocchio_has_them(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """600 in a row would take Pinocchio 15 GB and minutes."""
    text = link("l0") + "".join(
        link(f"l{n + 1}") + moving(f"l{n}", f"l{n + 1}", "continuous", "0 0 1")
        for n in range(MAX_JOINTS + 1)
    )
    monkeypatch.delattr("urdfkit.physics.dynamics.robot._build")
    with pytest.raises(
        Unsuitable, match=f"^too many movable joints for Pinocchio: {MAX_JOINTS + 1} > {MAX_JOINTS}"
    ):
        dynamics(text)


def test_an_unknown_link_is_reported() -> None:
    arm = Dynamics(read(ARM).tree)
    with pytest.raises(UnknownLink, match="no link 'foream'; did you mean 'forearm'"):
        arm.jacobian("foream", {})
    with pytest.raises(UnknownLink, match="no link 'foream'"):
        Dynamics(arm.tree, {"foream": 1.0})
