"""GAZ068: see the rule."""

import pytest

from tests.gazebos import BASE, BODY, block, child
from tests.reported import fixed, messages, places

SHAPE = "<{0}{1}><geometry><sphere radius='0.1'/></geometry></{0}>"
MU = "<mu1>0.2</mu1>"


def wheel(kind: str, name: str, joint: str = "continuous", link: str = "wheel") -> str:
    named = f' name="{name}"' if name else ""
    return child(link, joint, inside=BODY + SHAPE.format(kind, named))


@pytest.mark.parametrize(
    ("kind", "tags", "listed"),
    [
        ("collision", MU, "<mu1>"),
        ("collision", "<mu1>1</mu1><kp>1</kp>", "<mu1>, <kp>"),
        ("visual", "<material>Gazebo/Red</material>", "<material>"),
    ],
)
def test_a_shape_whose_name_is_its_own(kind: str, tags: str, listed: str) -> None:
    robot = BASE + wheel(kind, "tyre") + block(tags, "wheel")
    (message,) = messages("GAZ068", robot)
    lost = f"link 'wheel': {listed} of its <gazebo> block does not reach <{kind}> 'tyre'"
    assert message == f"{lost}, because of its name"
    assert [text for _, text in places("GAZ068", robot)] == ["tyre"]
    assert f'<{kind} name="wheel_tyre">' in fixed("GAZ068", robot)


@pytest.mark.parametrize(
    ("kind", "name", "tags"),
    [
        ("collision", "", MU),
        ("collision", "wheel_tyre", MU),
        ("visual", "tyre", MU),
        ("collision", "tyre", "<material>Gazebo/Red</material>"),
        ("collision", "tyre", "<selfCollide>true</selfCollide>"),
    ],
)
def test_others_are_calm(kind: str, name: str, tags: str) -> None:
    assert messages("GAZ068", BASE + wheel(kind, name) + block(tags, "wheel")) == []


def test_a_merged_link_whose_name_begins_with_that_of_its_parent() -> None:
    robot = BASE + wheel("collision", "", "fixed", "base_wheel") + block(MU, "base_wheel")
    assert messages("GAZ068", robot) == [
        (
            "link 'base_wheel': <mu1> of its <gazebo> block is lost: Gazebo merges it into 'base', "
            "whose name its own begins with"
        )
    ]


@pytest.mark.parametrize(("name", "count"), [("", 0), ("wheel", 0), ("wheel_tyre", 1), ("a", 1)])
def test_a_merged_link(name: str, count: int) -> None:
    robot = BASE + wheel("collision", name, "fixed") + block(MU, "wheel")
    assert len(messages("GAZ068", robot)) == count
