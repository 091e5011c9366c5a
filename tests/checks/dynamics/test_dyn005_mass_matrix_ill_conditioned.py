import pytest

from tests.massive import inertial, link
from tests.reported import messages, places

pytest.importorskip("pinocchio")


def turning(child: str, parent: str, axis: str = "0 0 1") -> str:
    return (
        f'<joint name="{child}_joint" type="continuous"><parent link="{parent}"/>'
        f'<child link="{child}"/><axis xyz="{axis}"/></joint>\n'
    )


def tower(mass: float, moment: float, axis: str = "0 0 1") -> str:
    middle = link("middle", inertial(mass, (moment,) * 3))
    top = link("top", inertial(5, (0.1, 0.1, 0.1)))
    rest = turning("middle", "base") + turning("top", "middle", axis)
    return link("base") + middle + top + rest


def test_two_joints_about_one_axis_with_nothing_between() -> None:
    """M = [[a + b, b], [b, b]]: scaled, its condition is near 4 b / a."""
    (message,) = messages("DYN005", tower(1e-9, 1e-11))
    assert "'middle_joint'" in message
    assert "'top_joint'" in message
    assert "4e+10" in message or "is singular" in message
    assert places("DYN005", tower(1e-9, 1e-11))[0][0] > 3


def test_what_is_light_and_harmless() -> None:
    assert messages("DYN005", tower(1e-5, 1e-7)) == []
    assert messages("DYN005", tower(1e-9, 1e-11, axis="1 0 0")) == []
    assert messages("DYN005", tower(1, 0.1)) == []


def test_a_negative_mass_makes_it_indefinite() -> None:
    (message,) = messages("DYN005", tower(-1, -0.05))
    assert "singular" in message


def test_one_of_two_branches() -> None:
    """Joints in the wrong order had no couplings, and no ill-conditioned matrix, on branches."""
    other = link("fore", inertial(1, (0.1,) * 3)) + link("back", inertial(1, (0.1,) * 3))
    other += turning("fore", "base") + turning("back", "fore")
    (message,) = messages("DYN005", other + tower(1e-9, 1e-11))
    assert "'middle_joint'" in message
    assert messages("DYN005", other + tower(1, 0.1)) == []
