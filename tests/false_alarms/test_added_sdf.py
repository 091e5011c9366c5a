"""Links and joints that `<gazebo>` adds as SDF, as PR2's grippers have them."""

import pytest

from tests.gazebos import BASE, block, child
from tests.naming import naming
from tests.reported import reported

HAND = child("hand", "fixed")


def joint(parent: str) -> str:
    ends = f"<parent>{parent}</parent><child>finger</child>"
    return block(f'<link name="finger"/><joint name="j" type="revolute">{ends}</joint>', "")


def test_tags_of_a_link_that_is_sdf() -> None:
    (found,) = reported("GAZ001", BASE + joint("base") + block("<mu1>1</mu1>", "finger"))
    assert found.severity.value == "warning"
    assert found.message == naming("finger", "<gazebo>", "Gazebo", "<mu1>")


@pytest.mark.parametrize(
    ("parent", "code"), [("base", ""), ("finger", ""), ("hand", "GAZ067"), ("none", "GAZ001")]
)
def test_a_joint_between_what_gazebo_has(parent: str, code: str) -> None:
    robot = BASE + HAND + joint(parent)
    found = [one.code for rule in ("GAZ001", "GAZ067") for one in reported(rule, robot)]
    assert found == [code][: bool(code)]
