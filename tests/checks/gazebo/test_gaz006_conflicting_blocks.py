import pytest

from tests.gazebos import BASE, block, child
from tests.naming import naming
from tests.reported import messages, reported


def test_the_last_one_wins() -> None:
    text = BASE + block("<mu1>1</mu1>") + block("<mu1>2</mu1>")
    assert messages("GAZ006", text) == [naming("<mu1>", "base", "1", "2", "Gazebo")]
    assert [note.span.line for one in reported("GAZ006", text) for note in one.related] == [4]


@pytest.mark.parametrize(
    ("tag", "one", "other"),
    [
        ("turnGravityOff", "true", "false"),
        ("selfCollide", "true", "false"),
        ("dampingFactor", "0.1", "0.2"),
    ],
)
def test_a_merged_body_has_one_value(tag: str, one: str, other: str) -> None:
    robot = BASE + child("cam", "fixed")
    text = robot + block(f"<{tag}>{one}</{tag}>", "cam") + block(f"<{tag}>{other}</{tag}>")
    assert messages("GAZ006", text) == [
        naming(f"<{tag}>", "cam", "base", "Gazebo", "base", one, other)
    ]


@pytest.mark.parametrize(
    "blocks",
    [
        block("<mu1>1</mu1>") + block("<mu1>1.0</mu1>"),
        block("<mu1>1</mu1>") + block("<mu2>2</mu2>"),
        block("<mu1>1</mu1>") + block("<mu1>2</mu1>", "cam"),  # each keeps its own surface
        block("<selfCollide>true</selfCollide>") + block("<selfCollide>True</selfCollide>"),
        block("<gravity>true</gravity>") + block("<gravity>false</gravity>", "cam"),
        block("<sensor>1</sensor>") + block("<sensor>2</sensor>"),
        block("<vendor>1</vendor>") + block("<vendor>2</vendor>"),
    ],
)
def test_no_conflict(blocks: str) -> None:
    assert reported("GAZ006", BASE + child("cam", "fixed") + blocks) == []


@pytest.mark.parametrize(
    ("names", "found"),
    [
        (("r_foot", "r_foot"), [naming("r_foot", "<gazebo>", "l_foot")]),
        (("r_foot", "l_foot"), []),
        (("r_foot", "r_foot", "l_foot"), []),
        (("base", "base"), []),
    ],
)
def test_a_copy_whose_reference_was_not_changed(names: tuple[str, ...], found: list[str]) -> None:
    feet = BASE + child("l_foot", "revolute") + child("r_foot", "revolute")
    blocks = "".join(block("<mu1>1</mu1>", name) for name in names)
    assert messages("GAZ006", feet + blocks) == found
