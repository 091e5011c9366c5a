from __future__ import annotations

import pytest

from tests.gazebos import BASE, block, child
from tests.reported import messages, places, reported


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
    assert reported("GAZ002", BASE + block(f"<{tag}>1</{tag}>", "")) == []


def test_with_a_reference_all_is_well() -> None:
    assert reported("GAZ002", BASE + block("<mu1>1</mu1>")) == []


@pytest.mark.parametrize("name", ["refernce", "link"])
def test_a_reference_by_another_name_is_told_once(name: str) -> None:
    tags = "<mu1>1</mu1><mu2>1</mu2>"
    (found,) = reported("GAZ002", BASE + f'<gazebo {name}="base">{tags}</gazebo>')
    assert found.message == (
        f'Gazebo does not read {name}="base" of <gazebo>, and takes the block for one without a '
        "reference"
    )
    assert found.help == 'write reference="base"'


def test_of_a_block_it_is_told_once() -> None:
    tags = "<mu1>1</mu1><mu2>1</mu2><kp>1</kp><kd>1</kd><mu1>1</mu1>"
    robot = BASE + block(f"{tags}<static>1</static>", "")
    said = "it belongs to a link, and this block refers to none"
    assert messages("GAZ002", BASE + block("<mu1>1</mu1>", "")) == [
        f"Gazebo ignores <mu1> here: {said}"
    ]
    said = said.replace("it belongs", "they belong")
    assert messages("GAZ002", robot) == [f"Gazebo ignores <mu1>, <mu2>, <kp>, <kd> here: {said}"]
    assert places("GAZ002", robot)[0][1] == "<gazebo>"
    longer = BASE + block(f"{tags}<selfCollide>1</selfCollide>", "")
    assert " <kd> and others here: " in messages("GAZ002", longer)[0]


def test_a_joint_by_another_name_of_the_reference() -> None:
    flag = '<gazebo joint="arm_joint"><preserveFixedJoint>true</preserveFixedJoint></gazebo>'
    (found,) = reported("GAZ002", BASE + child("arm", "fixed") + flag)
    assert found.help == 'write reference="arm_joint"'
