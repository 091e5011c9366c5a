"""Whatever a robot says, the process lives: numbers come out, or one sentence."""

import pytest

np = pytest.importorskip("numpy")
pytest.importorskip("pinocchio")

from hypothesis import event, given
from hypothesis import strategies as st

from tests.output.test_overview import of
from urdfkit.errors import Unavailable
from urdfkit.lint.context import Context
from urdfkit.output.mass_table import mass_properties
from urdfkit.output.overview import summarise
from urdfkit.physics.dynamics.conditioning import conditioning
from urdfkit.physics.dynamics.statics import statics
from urdfkit.physics.poses import PoseError, pose
from urdfkit.robot.kinematics import frames
from urdfkit.robot.model import UnknownLink
from urdfkit.robot.reach import reach
from urdfkit.robot.stability import standing_verdict

plain = st.floats(-10, 10).map(str)
odd = st.sampled_from("0 1 -1 0.5 1e-300 1e9 1e29 -1e29 nan inf 1,5 x".split())
huge = st.sampled_from("1e31 1e300 -1e308".split())
#: Most are plain, or no robot would come as far as its dynamics.
numbers = st.integers(0, 60).flatmap(lambda at: huge if at == 60 else odd if at > 50 else plain)
vectors = st.tuples(numbers, numbers, numbers).map(" ".join)
kinds = st.sampled_from(
    "revolute continuous prismatic fixed planar floating wobbly".split(),
)


@st.composite
def robots(draw: st.DrawFn) -> str:
    """A tree of up to six links in which every number may be odd."""
    count = draw(st.integers(1, 6))
    text = "".join(
        f'<link name="l{n}"><inertial><origin xyz="{draw(vectors)}" rpy="{draw(vectors)}"/>'
        f'<mass value="{draw(numbers)}"/><inertia ixx="{draw(numbers)}" ixy="{draw(numbers)}" '
        f'ixz="{draw(numbers)}" iyy="{draw(numbers)}" iyz="{draw(numbers)}" '
        f'izz="{draw(numbers)}"/></inertial><collision><origin xyz="{draw(vectors)}"/><geometry>'
        f'<box size="{draw(vectors)}"/></geometry></collision></link>'
        for n in range(count)
    )
    for child in range(1, count):
        follows = draw(st.one_of(st.none(), st.integers(0, count)))
        law = f'multiplier="{draw(numbers)}" offset="{draw(numbers)}"'
        mimic = "" if follows is None else f'<mimic joint="j{follows}" {law}/>'
        text += (
            f'<joint name="j{child}" type="{draw(kinds)}">'
            f'<origin xyz="{draw(vectors)}" rpy="{draw(vectors)}"/>'
            f'<parent link="l{draw(st.integers(0, child - 1))}"/><child link="l{child}"/>'
            f'<axis xyz="{draw(vectors)}"/><limit lower="{draw(numbers)}" upper="{draw(numbers)}" '
            f'effort="{draw(numbers)}" velocity="1"/>{mimic}</joint>'
        )
    return text


@given(robots(), st.floats(-4, 4))
def test_odd_numbers(text: str, position: float) -> None:
    robot = of(text)
    given_pose = settable(robot, position)
    assert set(frames(robot.tree, given_pose)) == set(robot.model.links_by_name)
    summarise(robot, given_pose)
    mass_properties(robot, given_pose)
    standing_verdict(robot, given_pose)
    reach(robot.tree)
    try:
        dynamics = robot.dynamics
    except Unavailable:
        event("refused")
        return
    assert dynamics.mass_matrix(given_pose).shape == (dynamics.nv, dynamics.nv)
    assert dynamics.gravity(given_pose).shape == (dynamics.nv,)
    assert dynamics.jacobian("l0", given_pose).shape == (6, dynamics.nv)
    loads = statics(dynamics, samples=3).loads
    assert {load.joint for load in loads} <= set(dynamics.columns)
    conditioning(dynamics)


def settable(robot: Context, position: float) -> dict[str, float]:
    """The joints that a pose may set, all at one position."""
    found: dict[str, float] = {}
    for name in robot.model.joints_by_name:
        try:
            found |= pose(robot, {name: position})
        except PoseError:
            pass
    return found


def test_the_largest_numbers_that_are_taken_give_no_nonsense_of_types() -> None:
    body = '<inertial><mass value="9e29"/><inertia ixx="9e29" iyy="9e29" izz="9e29" ixy="0" '
    body += 'ixz="0" iyz="0"/></inertial>'
    text = f'<link name="a">{body}</link><link name="b">{body}</link>'
    text += (
        '<joint name="j" type="prismatic"><parent link="a"/><child link="b"/>'
        '<limit lower="-9e29" upper="9e29" effort="1" velocity="1"/></joint>'
    )
    robot = of(text)
    assert np.isfinite(robot.dynamics.mass_matrix({"j": 9e29})).all()
    with pytest.raises(UnknownLink, match="no link"):
        robot.dynamics.placement("c", {})
