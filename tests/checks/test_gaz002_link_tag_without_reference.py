from __future__ import annotations

import pytest

from tests.gazebos import BASE, block
from tests.told import messages, told


@pytest.mark.parametrize(
    ("tag", "owner"),
    [
        ("mu1", "link"),
        ("material", "link"),
        ("selfCollide", "link"),
        ("turnGravityOff", "link"),
        ("sensor", "link"),
        ("preserveFixedJoint", "joint"),
        ("provideFeedback", "joint"),
    ],
)
def test_tags_of_links_and_joints(tag: str, owner: str) -> None:
    assert messages("GAZ002", BASE + block(f"<{tag}>1</{tag}>", "")) == [
        f"Gazebo ignores <{tag}> here: it belongs to a {owner}, and this block refers to none"
    ]


@pytest.mark.parametrize("tag", ["plugin", "static", "self_collide", "link", "pose", "xyz"])
def test_what_a_model_has_or_nobody_knows(tag: str) -> None:
    assert told("GAZ002", BASE + block(f"<{tag}>1</{tag}>", "")) == []


def test_with_a_reference_all_is_well() -> None:
    assert told("GAZ002", BASE + block("<mu1>1</mu1>")) == []


@pytest.mark.parametrize("name", ["refernce", "link"])
def test_a_reference_by_another_name_is_told_once(name: str) -> None:
    tags = "<mu1>1</mu1><mu2>1</mu2>"
    (found,) = told("GAZ002", BASE + f'<gazebo {name}="base">{tags}</gazebo>')
    assert found.message == (
        f'Gazebo does not read {name}="base" of <gazebo>, and takes the block for one without a '
        "reference"
    )
    assert found.help == 'write reference="base"'
