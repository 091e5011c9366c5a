"""GAZ067: see the rule."""

import pytest

from tests.gazebos import BASE, block, child
from tests.reported import messages

CAMERA = child("camera", "fixed")
OFF = "<turnGravityOff>true</turnGravityOff>"


@pytest.mark.parametrize(
    ("tag", "does"),
    [
        (OFF, "loses its weight"),
        ('<turnGravityOff value="1"/>', "loses its weight"),
        ("<gravity>false</gravity>", "loses its weight"),
        ("<selfCollide>yes</selfCollide>", "collides with its own robot"),
        ("<self_collide>1</self_collide>", "collides with its own robot"),
    ],
)
def test_a_switch_of_a_merged_link(tag: str, does: str) -> None:
    (message,) = messages("GAZ067", BASE + CAMERA + block(tag, "camera"))
    assert message.endswith(f"also applies to 'base', the link it is merged into, which {does}")


@pytest.mark.parametrize(
    ("tag", "reference", "more"),
    [
        (OFF, "base", ""),
        (OFF, "camera", block(OFF)),  # meant for both
        (OFF, "camera", block("<preserveFixedJoint>true</preserveFixedJoint>", "camera_joint")),
        *(
            (f"<{tag}>{value}</{tag}>", "camera", "")
            for tag in ("turnGravityOff", "selfCollide")
            for value in ("no", "0", "false")
        ),
        ("<gravity>true</gravity>", "camera", ""),
        *((f"<self_collide>{value}</self_collide>", "camera", "") for value in ("0", "false")),
        ("<gravity>1</gravity>", "camera", ""),
        ("<mu1>0.1</mu1>", "camera", ""),
    ],
)
def test_others_are_calm(tag: str, reference: str, more: str) -> None:
    assert messages("GAZ067", BASE + CAMERA + block(tag, reference) + more) == []
