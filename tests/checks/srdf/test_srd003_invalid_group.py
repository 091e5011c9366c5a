"""SRD003: see the rule."""

from pathlib import Path

import pytest

from tests.growth import executed_lines
from tests.naming import naming
from tests.srdfs import ROBOT, findings, message_of
from tests.workspaces import add_files
from urdfkit import check

BAD = [
    (
        '<group name="g"><chain base_link="hand" tip_link="base"/></group>',
        naming("g", "base", "descendant", "hand"),
    ),
    (
        '<group name="g"/>',
        naming("g", "empty"),
    ),
    (
        '<group name="a"><group name="b"/></group><group name="b"><group name="a"/></group>',
        naming("groups", "a -> b -> a"),
    ),
    (
        '<group name="a"><group name="a"/></group>',
        naming("groups", "a -> a"),
    ),
]
GOOD = [
    '<group name="g"><chain base_link="base" tip_link="finger"/></group>',
    '<group name="g"><chain base_link="arm" tip_link="arm"/></group>',
    '<group name="g"/><group name="g"><link name="arm"/></group>',
    (
        '<group name="a"><group name="b"/><group name="c"/></group><group name="b">'
        '<group name="c"/></group><group name="c"><link name="arm"/></group>'
    ),
]


@pytest.mark.parametrize(("text", "message"), BAD)
def test_it_is_reported_in_the_srdf(tmp_path: Path, text: str, message: str) -> None:
    assert message_of(tmp_path, text, "SRD003") == message


@pytest.mark.parametrize(
    ("chain", "severity"),
    [
        ('base_link="hand" tip_link="base"', "warning"),
        ('base_link="finger" tip_link="tool"', "info"),
    ],
)
def test_what_moveit_takes_for_a_chain(tmp_path: Path, chain: str, severity: str) -> None:
    """tesseract: a group from the tool of a positioner to that of the robot.

    srdfdom and MoveIt go up from both links to where they meet.
    """
    robot = ROBOT.replace(
        "</robot>",
        '<link name="tool"/><joint name="t" type="fixed"><parent link="base"/><child link="tool"/>'
        "</joint></robot>",
    )
    (tmp_path / "r.urdf").write_text(robot)
    group = f'<group name="g"><chain {chain}/></group>'
    (tmp_path / "r.srdf").write_text(f'<robot name="r">{group}</robot>')
    (found,) = check(tmp_path / "r.urdf", select=["SRD003"]).diagnostics
    assert found.severity.value == severity


def test_each_cycle_is_reported_once(tmp_path: Path) -> None:
    def group(name: str, *inner: str) -> str:
        subgroups = "".join(f'<group name="{one}"/>' for one in inner)
        return f'<group name="{name}">{subgroups}</group>'

    text = group("x", "b", "a") + group("b", "c") + group("c", "b", "b") + group("a", "x", "y")
    found = findings(tmp_path, text + group("y", "y", "z"), "SRD003")
    assert sorted(one.message.rpartition(": ")[2] for one in found) == [
        "a -> x -> a",
        "b -> c -> b",
        "y -> y",
    ]


def test_time_grows_with_the_groups(tmp_path: Path) -> None:
    def work(count: int) -> int:
        text = "".join(
            f'<group name="g{n}"><group name="g{n + 1}"/><group name="g{n + 2}"/></group>'
            for n in range(count)
        )
        directory = tmp_path / str(count)
        directory.mkdir()
        return executed_lines(lambda: findings(directory, text, "SRD003"))

    work(10)  # imports
    assert work(800) < 3 * work(400)


@pytest.mark.parametrize("text", GOOD)
def test_valid(tmp_path: Path, text: str) -> None:
    assert findings(tmp_path, text, "SRD003") == []


SIDES = '<robot name="r"><link name="base"/>{}</robot>'.format(
    "".join(
        f'<link name="{side}_{name}_link"/>'
        f'<joint name="{side}_{name}" type="continuous"><parent link="{parent}"/>'
        f'<child link="{side}_{name}_link"/><origin xyz="0 {0.1 * sign} 0"/></joint>'
        for side, sign in (("left", 1), ("right", -1))
        for name, parent in (
            ("shoulder", "base"),
            ("elbow", f"{side}_shoulder_link"),
            ("wrist", f"{side}_elbow_link"),
        )
    )
)


@pytest.mark.parametrize(
    ("joints", "found"),
    [
        ("left_shoulder left_elbow left_wrist", ()),
        ("left_shoulder right_elbow left_wrist", ("right_elbow", "left_elbow")),
        ("right_shoulder left_elbow right_wrist", ("left_elbow", "right_elbow")),
        ("left_shoulder right_elbow", ()),  # one of each
        ("left_shoulder left_elbow left_wrist right_elbow", ()),
        ("left_shoulder left_elbow right_shoulder right_elbow left_wrist", ()),
    ],
)
def test_a_joint_of_the_other_side(tmp_path: Path, joints: str, found: tuple[str, ...]) -> None:
    group = "".join(f'<joint name="{name}"/>' for name in joints.split())
    (tmp_path / "r.urdf").write_text(SIDES)
    (tmp_path / "r.srdf").write_text(f'<robot name="r"><group name="g">{group}</group></robot>')
    report = check(tmp_path / "r.urdf", select=["SRD003"])
    assert [one.message for one in report.diagnostics] == ([naming("g", *found)] if found else [])


@pytest.mark.parametrize(("parent", "codes"), [("amr", ["REF001"]), ("base", ["SRD003"])])
def test_a_joint_without_its_parent_is_reported_once(
    tmp_path: Path, parent: str, codes: list[str]
) -> None:
    """A misspelt parent parts the tree, so that no chain reaches the hand."""
    disabled = '<disable_collisions link1="arm" link2="hand" reason="Adjacent"/>'
    group = '<group name="g"><chain base_link="arm" tip_link="hand"/></group>'
    text = f'<robot name="r">{group}{disabled}</robot>'
    ball = '<link name="hand"><collision><geometry><sphere radius="0.1"/></geometry></collision>'
    robot = ROBOT.replace('<link name="hand"/>', f"{ball}</link>")
    robot = robot.replace('<parent link="arm"', f'<parent link="{parent}"')
    (tmp_path / "r.urdf").write_text(robot)
    (tmp_path / "r.srdf").write_text(text)
    report = check(tmp_path / "r.urdf", select=["REF001", "SRD003", "SRD010"])
    assert sorted(one.code for one in report.diagnostics) == codes


@pytest.mark.parametrize(
    ("group", "solver", "count"),
    [
        ('<link name="hand"/>', "kdl_kinematics_plugin/KDLKinematicsPlugin", 1),
        ('<link name="arm"/><link name="hand"/>', "kdl_kinematics_plugin/KDLKinematicsPlugin", 0),
        ('<link name="hand"/>', "bio_ik/BioIKKinematicsPlugin", 0),
        ('<link name="unknown"/>', "kdl_kinematics_plugin/KDLKinematicsPlugin", 0),
    ],
)
def test_a_solver_for_a_group_that_does_not_move(
    tmp_path: Path, group: str, solver: str, count: int
) -> None:
    """MoveIt: a group without active joints is not a chain."""
    add_files(
        tmp_path,
        {
            "config/r.urdf": ROBOT,
            "config/r.srdf": f'<robot name="r"><group name="g">{group}</group></robot>',
            "config/kinematics.yaml": f"g:\n  kinematics_solver: {solver}\n",
        },
    )
    found = check(tmp_path / "config" / "r.urdf", select=["SRD003"]).diagnostics
    assert [(one.message, one.span.line) for one in found] == [(naming("g", solver), 1)] * count
