from __future__ import annotations

import pytest

from tests.massive import BOX, inertial, joint, link, part
from tests.reported import messages, reported


def test_moments_of_a_diagonal_tensor() -> None:
    assert messages("INE003", link("arm", inertial(2, (0.01, 0.03, 0.01)))) == [
        (
            "link 'arm': the moments of inertia violate the triangle inequality: "
            "0.03 > 0.01 + 0.01 kg m^2"
        )
    ]


def test_principal_moments_and_not_the_diagonal() -> None:
    # 0.02, 0.02, 0.04 +- 0.01: the diagonal is a flat disc, which exists.
    robot = link("arm", inertial(2, (0.02, 0.01, 0, 0.02, 0, 0.04)))
    assert messages("INE003", robot) == []
    robot = link("arm", inertial(2, (0.03, 0.02, 0, 0.03, 0, 0.03)))
    assert messages("INE003", robot) == [
        (
            "link 'arm': the principal moments of inertia violate the triangle inequality: "
            "0.05 > 0.01 + 0.03 kg m^2"
        )
    ]


@pytest.mark.parametrize(("high", "found"), [(2.0, 0), (2.019, 0), (2.021, 1), (20, 1)])
def test_rounding_is_no_defect(high: float, found: int) -> None:
    assert len(messages("INE003", link("arm", inertial(2, (1, 1, high))))) == found


def test_a_moment_that_stands_alone() -> None:
    (found,) = reported("INE003", part("base", 12, (0, 0, 0.9), BOX))
    assert found.message.endswith("0.9 > 0 + 0 kg m^2")
    assert found.help == 'write ixx="0.1" iyy="0.05" izz="0.13"'


def test_a_twin_tells_the_value() -> None:
    robot = (
        link("hip")
        + link("l_ankle", inertial(0.2, (1e-4, 0, 7e-6, 3.7e-4, 0, 4.2e-4)))
        + link("r_ankle", inertial(0.2, (1e-4, 0, -1.2e-4, 3.7e-4, 0, 4.2e-4)))
        + joint("hip", "l_ankle")
        + joint("hip", "r_ankle")
    )
    (found,) = reported("INE003", robot)
    assert found.element == "link/r_ankle/inertial/inertia"
    assert found.help == (
        "the tensor of its twin 'l_ankle' is possible: write "
        'ixx="0.0001" ixz="7e-06" iyy="0.00037" izz="0.00042"'
    )


def test_without_a_diagnosis_the_help_is_the_rule_s() -> None:
    (found,) = reported("INE003", link("arm", inertial(2, (1, 1, 50))))
    assert found.help.startswith("take the tensor about the centre of mass anew")
