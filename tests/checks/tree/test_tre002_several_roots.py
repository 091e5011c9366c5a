import itertools

from tests.naming import naming
from tests.reported import messages, reported
from urdfkit import Severity

JOINT = '<joint name="{0}_{1}" type="fixed"><parent link="{0}"/><child link="{1}"/></joint>\n'


def links(*names: str) -> str:
    return "".join(f'<link name="{name}"/>\n' for name in names)


def test_the_largest_tree_is_the_robot_and_the_others_are_loose() -> None:
    robot = links("camera", "base", "arm", "lamp") + JOINT.format("base", "arm")
    (found,) = reported("TRE002", robot)
    assert found.message == naming("3", "camera", "base", "lamp")
    assert (found.span.line, found.span.text) == (2, '<link name="camera"/>')
    assert [(one.span.line, one.message) for one in found.related] == [
        (3, naming("base", "parent")),
        (5, naming("lamp", "parent")),
    ]


def test_a_hundred_are_counted() -> None:
    (found,) = reported("TRE002", links(*(f"l{number}" for number in range(100))))
    assert found.message == naming("100", *(f"l{number}" for number in range(8)), "92")
    assert len(found.related) == 8


def test_eight_are_named_without_a_count() -> None:
    (message,) = messages("TRE002", links(*(f"l{number}" for number in range(8))))
    assert message.endswith(", 'l6', 'l7'")


def test_below_a_missing_link_hangs_no_root() -> None:
    robot = links("base", "arm") + JOINT.format("bse", "arm")
    assert reported("TRE002", robot) == []
    assert len(reported("REF001", robot)) == 1


def test_a_misspelt_child_is_no_root() -> None:
    """RoboMaster's engineer: the joint's child is mimiclink2_1, the link is mimic_link2_1."""
    robot = links("base", "mimic_link2_1") + JOINT.format("base", "mimiclink2_1")
    assert messages("TRE002", robot) == []
    assert messages("REF001", robot) != []
    assert messages("TRE002", robot.replace("mimiclink2_1", "lamp")) != []


def test_drake_takes_several_and_joints_of_its_own() -> None:
    (found,) = reported("TRE002", links("base", "arm"), targets=("drake",))
    assert found.severity is Severity.WARNING
    joint = (
        '<drake:joint name="j" type="ball"><parent link="base"/><child link="arm"/></drake:joint>'
    )
    namespace = 'xmlns:drake="http://drake.mit.edu"'
    robot = f'<robot name="r" {namespace}>{links("base", "arm")}{joint}</robot>'
    assert reported("TRE002", robot, targets=("drake",)) == []
    assert len(reported("TRE002", robot, targets=("ros2",))) == 1


def test_one_root_is_right() -> None:
    assert messages("TRE002", links("base", "arm") + JOINT.format("base", "arm")) == []
    assert messages("TRE002", links("base")) == []


def test_many_roots_above_one_long_chain_are_counted_once() -> None:
    size = 3000
    chain = [f"c{number}" for number in range(size)]
    joints = "".join(JOINT.format(*pair) for pair in itertools.pairwise(chain))
    tops = [f"t{number}" for number in range(size)]
    robot = links(*chain, *tops) + joints + "".join(JOINT.format(top, "c0") for top in tops)
    (found,) = reported("TRE002", robot)
    assert found.message == naming(size, *tops[:8], size - 8)
    assert found.related[0].message == naming("t0", "parent"), "the first has the chain"
