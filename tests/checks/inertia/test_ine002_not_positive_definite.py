from __future__ import annotations

import pytest

from tests.massive import BALL, inertial, joint, link, part
from tests.reported import messages, places, reported


def test_the_message_has_all_three_moments() -> None:
    robot = link("arm", inertial(2, (0.01, 0.03, 0, 0.01, 0, 0.02)))
    assert messages("INE002", robot) == [
        (
            "link 'arm' has principal moments of inertia of -0.02, 0.02, 0.04 kg m^2; all must be "
            "positive"
        )
    ]
    assert places("INE002", robot) == [
        (3, '<inertia ixx="0.01" ixy="0.03" ixz="0" iyy="0.01" iyz="0" izz="0.02"/>')
    ]


@pytest.mark.parametrize("low", [-1e-20, -1e-15, -0.00019])
def test_rounding_is_no_defect(low: float) -> None:
    assert messages("INE002", link("arm", inertial(2, (low, 0.02, 0.02)))) == []


def test_noise_is_no_defect() -> None:
    assert messages("INE002", link("arm", inertial(1e-9, (-1e-18, 1e-38, 1e-17)))) == []


def test_a_link_without_mass_is_not_judged() -> None:
    assert messages("INE002", link("arm", inertial(0, (-1, 1, 1)))) == []


def test_only_this_rule_tells_it() -> None:
    robot = part("arm", 2, (-1, 1, 3), BALL)
    assert len(messages("INE002", robot)) == 1
    assert messages("INE003", robot) == messages("INE006", robot) == []


def test_copies_are_one_finding_and_the_order_of_sdf_is_known() -> None:
    wrong = (0.03, 0.02, 0.01, 0.001, 0, 0)
    robot = "".join(link(name, inertial(2, wrong)) for name in ("a", "b")) + joint("a", "b")
    (found,) = reported("INE002", robot)
    assert found.message.endswith("all must be positive (and likewise 'b')")
    assert [note.span.line for note in found.related] == [5]
    assert found.help == (
        "perhaps the tensor is in the order ixx iyy izz ixy ixz iyz; then it is "
        'ixx="0.03" ixy="0.001" iyy="0.02" izz="0.01"'
    )
