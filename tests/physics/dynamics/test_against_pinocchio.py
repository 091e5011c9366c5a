"""Every quantity against Pinocchio's own reading of the URDF.

Pinocchio reads each follower as a joint of its own; the laws of ``<mimic>`` are applied here, from
the XML alone. Velocities of our coordinates stand in another order than Pinocchio's, by name.
"""

import re
from typing import Any
from xml.etree import ElementTree

import pytest

np = pytest.importorskip("numpy")
pin = pytest.importorskip("pinocchio")

from hypothesis import HealthCheck, event, given, settings
from hypothesis import strategies as st

from tests.conftest import CorpusRobot, manifest, model_id, needs_corpus
from urdfkit.lint.loading import read
from urdfkit.physics.dynamics.conditioning import conditioning
from urdfkit.physics.dynamics.robot import Dynamics
from urdfkit.robot.composite_body import composite_body
from urdfkit.robot.kinematics import frames, positions
from urdfkit.text.source import Source

ALIGNED = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED


class Theirs:
    """A robot as Pinocchio reads it, with the root fixed, and with a free-flyer."""

    def __init__(self, text: bytes) -> None:
        self.text = text.decode()
        self.model = pin.buildModelFromXML(self.text)
        self.data = self.model.createData()
        self.free = pin.buildModelFromXML(self.text, pin.JointModelFreeFlyer())

    def configuration(self, model: Any, pose: dict[str, float]) -> Any:
        """Of all joints, the followers too."""
        q = pin.neutral(model)
        for name, value in pose.items():
            if name in model.names and value:
                joint = model.joints[model.getJointId(name)]
                both = [value] if joint.nq == 1 else [np.cos(value), np.sin(value)]
                q[joint.idx_q : joint.idx_q + joint.nq] = both
        return q

    def selection(self, columns: tuple[str, ...]) -> Any:
        """Velocities of all joints from those of our coordinates."""
        found = np.zeros((self.model.nv, len(columns)))
        text = re.sub(r"^\s*<\?xml[^>]*>", "", self.text)  # some misspell it
        laws = {one.get("name"): one.find("mimic") for one in ElementTree.fromstring(text)}
        for number in range(1, self.model.njoints):
            joint = self.model.joints[number]
            leader, factor = self.model.names[number], 1.0
            while (law := laws.get(leader)) is not None:
                leader, factor = law.get("joint"), factor * float(law.get("multiplier", "1"))
            for offset in range(joint.nv):
                name = leader if joint.nv == 1 else f"{leader}[{offset}]"
                found[joint.idx_v + offset, columns.index(name)] = factor
        return found


def close(found: Any, expected: Any) -> bool:
    scale = max(1e-4, float(np.abs(expected).max(initial=0.0)))  # below: rounding
    return np.shape(found) == np.shape(expected) and bool(
        np.abs(found - expected).max(initial=0.0) <= 1e-9 * scale
    )


def symmetric(upper: Any) -> Any:
    return np.triu(upper) + np.triu(upper, 1).T


def compare(text: bytes, ours: Dynamics, pose: dict[str, float]) -> None:
    """All that ``Dynamics`` computes, and the nonlinear terms of the model that it builds.

    Args:
        pose: of all joints that one number moves.
    """
    theirs = Theirs(text)
    model, data = theirs.model, theirs.data
    q, free = theirs.configuration(model, pose), theirs.configuration(theirs.free, pose)
    select = theirs.selection(ours.columns)

    matrix = select.T @ symmetric(pin.crba(model, data, q)) @ select
    assert close(ours.mass_matrix(pose), matrix)
    torques = select.T @ pin.computeGeneralizedGravity(model, data, q)
    assert close(ours.gravity(pose), torques)
    velocity = np.linspace(-1, 1, ours.nv)
    terms = select.T @ pin.nonLinearEffects(model, data, q, select @ velocity)
    mine = pin.nonLinearEffects(
        ours.model, ours.data, ours.configuration(pose), ours.selection @ velocity
    )
    assert close(ours.selection.T @ mine, terms)
    for link in ours.tree.frames:
        number = model.getFrameId(link, pin.FrameType.BODY)
        jacobian = pin.computeFrameJacobian(model, data, q, number, ALIGNED).reshape(6, model.nv)
        assert close(ours.jacobian(link, pose), jacobian @ select)
        pin.framesForwardKinematics(model, data, q)
        assert close(ours.placement(link, pose), data.oMf[number].homogeneous)
    whole = ours.mass_properties(pose)
    assert whole.mass == pytest.approx(pin.computeTotalMass(theirs.free), rel=1e-12)
    lumped = composite_body(ours.tree, frames(ours.tree, pose)).properties
    assert lumped is not None
    assert close(np.array([whole.mass, *whole.center]), np.array([lumped.mass, *lumped.center]))
    assert close(np.array(whole.tensor), np.array(lumped.tensor))
    if whole.mass:
        center = pin.centerOfMass(theirs.free, theirs.free.createData(), free)
        assert close(np.array(whole.center), center)


ENTRIES = [
    entry
    for entry in manifest()
    if "expect" in entry.facts and entry.facts["expect"]["pinocchio"]["ok"]
]


@needs_corpus
@pytest.mark.parametrize("entry", ENTRIES, ids=model_id)
def test_every_robot_of_the_corpus(entry: CorpusRobot) -> None:
    context = entry.alone
    if not context.tree.is_sound:
        return
    ours = Dynamics(context.tree)
    free = [name for name in ours.columns if "[" not in name]
    pose = {name: 0.1 * (number % 7) for number, name in enumerate(free)}
    compare(context.text, ours, positions(context.tree, pose))


# --- trees drawn at random


lengths = st.floats(-1, 1).map(lambda value: round(value, 3))
vectors = st.tuples(lengths, lengths, lengths)
axes = vectors.filter(lambda axis: np.linalg.norm(axis) > 0.1)
sizes = st.floats(0.05, 0.8).map(lambda value: round(value, 3))
HINGES = ("revolute", "continuous", "prismatic")


def words(numbers: Any) -> str:
    return " ".join(map(str, numbers))


@st.composite
def robots(draw: st.DrawFn) -> str:
    """A tree of up to nine links, each a box with its own frame of inertia."""
    count = draw(st.integers(2, 9))
    text = ""
    for number in range(count):
        mass = draw(sizes) * 10
        x, y, z = (draw(sizes) ** 2 * mass / 12 for _ in range(3))
        text += (
            f'<link name="l{number}"><inertial><mass value="{mass}"/>'
            f'<origin xyz="{words(draw(vectors))}" rpy="{words(draw(vectors))}"/>'
            f'<inertia ixx="{y + z}" iyy="{x + z}" izz="{x + y}" ixy="0" ixz="0" iyz="0"/>'
            "</inertial></link>"
        )
    leaders: list[int] = []
    for child in range(1, count):
        kind = draw(st.sampled_from((*HINGES, "fixed", "planar", "floating")))
        axis = (0, 0, 1) if kind == "planar" else draw(axes)  # Pinocchio takes no other
        mimic = ""
        if kind in HINGES:
            follows = draw(st.booleans())
            if leaders and follows:
                leader = draw(st.sampled_from(leaders))
                law = f'multiplier="{draw(lengths)}" offset="{draw(lengths)}"'
                mimic = f'<mimic joint="j{leader}" {law}/>'
            else:
                leaders.append(child)
        parent = draw(st.integers(0, child - 1))
        text += (
            f'<joint name="j{child}" type="{kind}"><parent link="l{parent}"/>'
            f'<child link="l{child}"/><axis xyz="{words(axis)}"/>'
            f'<origin xyz="{words(draw(vectors))}" rpy="{words(draw(vectors))}"/>'
            f'<limit lower="-2" upper="2" effort="10" velocity="1"/>{mimic}</joint>'
        )
    return f'<robot name="r">{text}</robot>'


def drawn(text: str) -> tuple[Dynamics, dict[str, float]]:
    robot = read(Source("r.urdf", text.encode()))
    ours = Dynamics(robot.tree)
    event("branched" if any(len(joints) > 1 for joints in robot.tree.children.values()) else "row")
    free = {name: 0.3 * (1 + at % 4) for at, name in enumerate(ours.columns) if "[" not in name}
    return ours, positions(robot.tree, free)


@settings(suppress_health_check=[HealthCheck.too_slow], derandomize=True)
@given(robots())
def test_trees_against_pinocchio(text: str) -> None:
    compare(text.encode(), *drawn(text))


@settings(suppress_health_check=[HealthCheck.too_slow], derandomize=True)
@given(robots(), st.sampled_from(("1.0", "1.1", "1.2")))
def test_quaternions(text: str, version: str) -> None:
    """urdfdom reads them from URDF 1.1 on, of any length."""
    text = re.sub(r' rpy="([^"]*)"', r' quat_xyzw="\1 0.7"', text)
    text = text.replace('name="r"', f'name="r" version="{version}"')
    compare(text.encode(), *drawn(text))


# --- robots with branches


BODY = (
    '<inertial><mass value="{0}"/><origin xyz="0.4 0 0"/>'
    '<inertia ixx="{1}" ixy="0" ixz="0" iyy="{1}" iyz="0" izz="{1}"/></inertial>'
)


def two_arms(upper: str, moment: str) -> Dynamics:
    """A base with two arms of two links; the left one's upper arm as given."""
    text = '<link name="base"/>'
    for side, sign in (("left", ""), ("right", "-")):
        first = BODY.format(upper, moment) if side == "left" else BODY.format("1", "0.01")
        for name, parent, body in (
            (f"{side}_upper", "base", first),
            (f"{side}_fore", f"{side}_upper", BODY.format("1", "0.01")),
        ):
            text += (
                f'<link name="{name}">{body}</link><joint name="{name}" type="continuous">'
                f'<origin xyz="0 {sign}0 0"/><parent link="{parent}"/><child link="{name}"/>'
                '<axis xyz="0 0 1"/></joint>'
            )
    return read(Source("r.urdf", f'<robot name="r">{text}</robot>'.encode())).dynamics


def test_a_forearm_moves_its_own_upper_arm() -> None:
    """Joints added siblings first made the couplings of all branches 0."""
    arms = two_arms("1", "0.01")
    matrix = arms.mass_matrix({})
    order = [
        arms.columns.index(f"{side}_{part}")
        for side in ("left", "right")
        for part in ("upper", "fore")
    ]
    # Both hinges of an arm are at one place: 1 kg at 0.4 m each.
    arm = np.array([[0.34, 0.17], [0.17, 0.17]])
    assert matrix[np.ix_(order, order)] == pytest.approx(
        np.block([[arm, np.zeros((2, 2))], [np.zeros((2, 2)), arm]])
    )


def test_the_condition_sees_a_light_link_on_one_of_two_arms() -> None:
    assert not conditioning(two_arms("1", "0.01")).is_ill
    ill = conditioning(two_arms("1e-9", "1e-11"))
    assert ill.is_ill
    assert set(ill.joints) == {"left_upper", "left_fore"}
