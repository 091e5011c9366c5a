"""How far robots reach: closed forms, a search by brute force, and data sheets."""

from math import hypot, pi, sqrt
from random import Random

import pytest

from tests.conftest import CORPUS, needs_corpus
from tests.documents import tree
from urdfkit.lint.loading import read
from urdfkit.robot.joint_limits import bounds
from urdfkit.robot.kinematics import frames
from urdfkit.robot.reach import reach


def chain(*joints: tuple[str, str, str]) -> str:
    """A chain of joints, each of a type, with an origin and more content."""
    text = '<link name="l0"/>'
    for number, (kind, xyz, content) in enumerate(joints):
        text += (
            f'<link name="l{number + 1}"/><joint name="j{number}" type="{kind}">'
            f'<origin xyz="{xyz}"/><parent link="l{number}"/><child link="l{number + 1}"/>'
            f"{content}</joint>"
        )
    return text


Z = '<axis xyz="0 0 1"/>'


def limited(lower: float, upper: float) -> str:
    return f'{Z}<limit lower="{lower}" upper="{upper}" effort="1" velocity="1"/>'


def test_an_arm_stretches() -> None:
    """The base of 0.3 m does not count: the first joint turns behind it."""
    arm = chain(
        ("continuous", "0 0 0.3", Z), ("continuous", "0.5 0 0", Z), ("fixed", "0 0.4 0", "")
    )
    found = reach(tree(arm))
    assert found is not None
    assert found.distance == pytest.approx(0.9, rel=1e-12)
    assert (found.joint, found.link) == ("j0", "l3")
    assert found.pose["j1"] == pytest.approx(-pi / 2)


def test_a_slide_takes_the_end_that_adds_to_what_is_before_it() -> None:
    """0.3 m and then 0.2 m more, though it slides 0.25 m the other way."""
    slide = '<axis xyz="1 0 0"/><limit lower="-0.25" upper="0.2" effort="1" velocity="1"/>'
    found = reach(tree(chain(("continuous", "0 0 0", Z), ("prismatic", "0.3 0 0", slide))))
    assert found is not None
    assert found.distance == pytest.approx(0.5, rel=1e-12)
    assert found.pose["j1"] == 0.2


def test_limits_hold_it_back() -> None:
    """Law of cosines at the elbow's end of 60 degrees from folded."""
    elbow = limited(pi - pi / 3, pi)
    arm = chain(
        ("continuous", "0 0 0", Z), ("revolute", "0.5 0 0", elbow), ("fixed", "0.5 0 0", "")
    )
    found = reach(tree(arm))
    assert found is not None
    assert found.distance == pytest.approx(0.5, rel=1e-12)


def test_a_slide_goes_to_the_end_that_is_farther() -> None:
    slide = '<axis xyz="1 0 0"/><limit lower="-0.7" upper="0.2" effort="1" velocity="1"/>'
    found = reach(tree(chain(("continuous", "0 0 0", Z), ("prismatic", "0.1 0.3 0", slide))))
    assert found is not None
    assert found.distance == pytest.approx(hypot(0.6, 0.3), rel=1e-12)
    assert found.pose["j1"] == -0.7


def test_of_two_arms_the_longer_one_is_reported() -> None:
    """An arm may be longer by what it slides alone, which must not be left out."""
    slide = '<axis xyz="1 0 0"/><limit lower="0" upper="5" effort="1" velocity="1"/>'
    long = chain(("continuous", "0 0 0", Z), ("prismatic", "0.1 0 0", slide))
    short = chain(("continuous", "0 0 0", Z), ("continuous", "2 0 0", Z))
    renamed = short.replace('"l0"', '"root"').replace('"l', '"s').replace('"j', '"k')
    both = long + renamed.replace('<link name="root"/>', "").replace('"root"', '"l0"')
    found = reach(tree(both))
    assert found is not None
    assert (found.link, round(found.distance, 9)) == ("l2", 5.1)


@pytest.mark.parametrize(
    "text",
    [
        '<link name="l0"/>',
        chain(("fixed", "1 0 0", "")),
        chain(("floating", "1 0 0", "")),
        chain(*[("continuous", "1 0 0", Z)] * 300),
    ],
    ids=["one link", "fixed", "floating", "no arm"],
)
def test_what_has_no_reach(text: str) -> None:
    assert reach(tree(text)) is None


def test_absurd_numbers_are_no_reach() -> None:
    huge = chain(("continuous", "1e308 0 0", Z), *[("continuous", "1e308 1e308 0", Z)] * 3)
    assert reach(tree(huge)) is None


@needs_corpus
@pytest.mark.parametrize(
    ("ur_type", "data_sheet"), [("ur3e", 0.5), ("ur5e", 0.85), ("ur10e", 1.3), ("ur16e", 0.9)]
)
def test_arms_of_data_sheets(ur_type: str, data_sheet: float) -> None:
    """Those tell the radius at the wrist; the tool's flange stands out beyond it."""
    file = CORPUS / "Universal_Robots_ROS2_Description" / "urdf" / "ur.urdf.xacro"
    found = reach(read(file, arguments={"name": "ur", "ur_type": ur_type}).tree)
    assert found is not None
    assert data_sheet < found.distance < data_sheet * 1.25


@needs_corpus
@pytest.mark.parametrize(
    "path",
    [
        "moveit_resources/panda_description/urdf/panda.urdf",
        "moveit_resources/fanuc_description/urdf/fanuc.urdf",
        "anymal_c_simple_description/urdf/anymal.urdf",
    ],
)
def test_no_sampled_pose_reaches_farther_and_the_one_reported_does(path: str) -> None:
    robot = read(CORPUS / path).tree
    found = reach(robot)
    assert found is not None
    first = robot.model.joints_by_name[found.joint]
    assert first.parent is not None

    def distance(pose: dict[str, float]) -> float:
        placed = frames(robot, pose)
        start = (placed[first.parent.value] @ first.origin).position  # type: ignore[union-attr]
        end = placed[found.link].position
        return sqrt(sum((a - b) ** 2 for a, b in zip(start, end, strict=True)))

    assert distance(found.pose) == pytest.approx(found.distance, rel=1e-9)
    random = Random(1)
    ends = {name: bounds(robot.model.joints_by_name[name]) or (-pi, pi) for name in found.pose}
    samples = ({name: random.uniform(*e) for name, e in ends.items()} for _ in range(1000))
    best = max(map(distance, samples))
    assert 0.9 * found.distance < best < found.distance * (1 + 1e-9)
