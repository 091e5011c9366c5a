from __future__ import annotations

import pytest

from tests.massive import BALL, MESH, inertial, joint, link, part, shape
from tests.reported import messages, reported

TENSOR = (0.002, 1e-6, 0, 0.002, 0, 0.001)


def test_links_of_different_mass() -> None:
    robot = "".join(link(f"l{i}", inertial(mass, TENSOR)) for i, mass in enumerate((3, 1, 2)))
    (found,) = reported("INE013", robot)
    assert found.message == (
        "3 links, from 'l1' of 1 kg to 'l0' of 3 kg, have the same inertia tensor (0.002, 0.002, "
        "0.001 kg m^2)"
    )
    assert found.element == "link/l1/inertial/inertia"
    assert [note.message for note in found.related] == ["link 'l0' of 3 kg", "link 'l2' of 2 kg"]


@pytest.mark.parametrize(("mass", "found"), [(1, 0), (1.4, 0), (1.6, 1)])
def test_how_different(mass: float, found: int) -> None:
    robot = link("a", inertial(1, TENSOR)) + link("b", inertial(mass, TENSOR))
    assert len(messages("INE013", robot)) == found
    if found:
        assert messages("INE013", robot)[0].startswith("2 links, from 'a' of 1 kg to 'b' of 1.6 kg")


@pytest.mark.parametrize(
    "robot",
    [
        # INE006 tells it
        part("a", 0.1, (1, 1, 1), BALL) + part("b", 0.5, (1, 1, 1), BALL),
        # INE006 tells it of two, and the others have it too
        part("a", 0.1, (1, 1, 1), BALL)
        + link("b", inertial(1, (1, 1, 1)))
        + link("c", inertial(2, (1, 1, 1))),
        # one is fixed to the world
        link("world")
        + link("a", inertial(1, TENSOR))
        + link("b", inertial(2, TENSOR))
        + joint("world", "a"),
        # INE009
        link("a", shape("visual", MESH), inertial(1, (1, 1, 1)))
        + link("b", shape("visual", MESH), inertial(2, (1, 1, 1))),
        # INE012
        link("hand")
        + link("left_finger", inertial(1, TENSOR))
        + link("right_finger", inertial(2, TENSOR))
        + joint("hand", "left_finger")
        + joint("hand", "right_finger"),
        # lost in a larger body
        link("base", inertial(9, (1, 1, 1.1)))
        + link("a", inertial(1, (1e-5, 1e-5, 1e-6)))
        + link("b", inertial(2, (1e-5, 1e-5, 1e-6)))
        + joint("base", "a")
        + joint("base", "b"),
        # nothing to compare
        link("a", inertial(1, (0, 0, 0))) + link("b", inertial(2, (0, 0, 0))),
    ],
)
def test_what_does_not_matter_or_is_another_rule_s(robot: str) -> None:
    assert messages("INE013", robot) == []
