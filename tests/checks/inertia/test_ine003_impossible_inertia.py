import pytest

from tests.massive import BALL, BOX, inertial, joint, link, part
from tests.naming import naming
from tests.reported import fixed, messages, places, reported


def test_moments_of_a_diagonal_tensor() -> None:
    assert messages("INE003", link("arm", inertial(2, (0.01, 0.03, 0.01)))) == [
        naming("arm", "0.03", "> 0.01", "0.01 kg·m²")
    ]


def test_principal_moments_and_not_the_diagonal() -> None:
    # 0.02, 0.02, 0.04 +- 0.01: the diagonal is a flat disc, which exists.
    robot = link("arm", inertial(2, (0.02, 0.01, 0, 0.02, 0, 0.04)))
    assert messages("INE003", robot) == []
    robot = link("arm", inertial(2, (0.03, 0.02, 0, 0.03, 0, 0.03)))
    assert messages("INE003", robot) == [naming("arm", "0.05", "> 0.01", "0.03 kg·m²")]


@pytest.mark.parametrize(("high", "found"), [(2.0, 0), (2.019, 0), (2.021, 1), (20, 1)])
def test_rounding_is_no_defect(high: float, found: int) -> None:
    assert len(messages("INE003", link("arm", inertial(2, (1, 1, high))))) == found


@pytest.mark.parametrize(("high", "found"), [(2 + 1e-10, 0), (2 + 1e-8, 1)])
def test_what_mujoco_takes_for_rounding(high: float, found: int) -> None:
    robot = link("arm", inertial(2, (1, 1, high))) + link("tip") + joint("arm", "tip", "revolute")
    assert len(reported("INE003", robot, targets=("mujoco",))) == found


def test_a_moment_that_stands_alone() -> None:
    (found,) = reported("INE003", part("base", 12, (0, 0, 0.9), BOX))
    assert found.message.endswith("0.9 > 0 + 0 kg·m²")
    assert found.help == naming('ixx="0.1"', 'iyy="0.05"', 'izz="0.13"')


def test_a_moment_that_stands_alone_and_is_plausible() -> None:
    """KUKA's arms: of the first link, the moment about the joint is measured."""
    (found,) = reported("INE003", part("base", 12, (0, 0, 0.26), BOX))
    assert found.help == naming('ixx="0.2"', 'iyy="0.1"', 'izz="0.26"')
    assert found.fix is not None
    assert len(found.fix.edits) == 2


@pytest.mark.parametrize(("mass", "is_fixed"), [(0.2, True), (0.15, False)])
def test_a_counterpart_gives_the_value(mass: float, is_fixed: bool) -> None:
    """Not one of another mass, as the left and right finger tips of a HSR."""
    robot = (
        link("hip")
        + link("l_ankle", inertial(mass, (1e-4, 0, 7e-6, 3.7e-4, 0, 4.2e-4)))
        + link("r_ankle", inertial(0.2, (1e-4, 0, -1.2e-4, 3.7e-4, 0, 4.2e-4)))
        + joint("hip", "l_ankle")
        + joint("hip", "r_ankle")
    )
    (found,) = reported("INE003", robot)
    assert found.element == "link/r_ankle/inertial/inertia"
    help = naming("l_ankle", 'ixx="0.0001"', 'ixz="7e-06"', 'iyy="0.00037"', 'izz="0.00042"')
    assert (found.help == help) is (found.fix is not None) is is_fixed


def test_without_a_diagnosis_the_help_is_the_rule_s() -> None:
    (found,) = reported("INE003", link("arm", inertial(2, (1, 1, 50))))
    assert "take" in found.help


def test_the_message_has_all_three_moments() -> None:
    robot = link("arm", inertial(2, (0.01, 0.03, 0, 0.01, 0, 0.02)))
    assert messages("INE003", robot) == [naming("arm", "-0.02, 0.02, 0.04 kg·m²")]
    assert places("INE003", robot) == [
        (3, '<inertia ixx="0.01" ixy="0.03" ixz="0" iyy="0.01" iyz="0" izz="0.02"/>')
    ]


@pytest.mark.parametrize("low", [-1e-20, -1e-15, -0.00019])
def test_rounding_below_zero_is_no_defect(low: float) -> None:
    assert messages("INE003", link("arm", inertial(2, (low, 0.02, 0.02)))) == []


def test_noise_is_no_defect() -> None:
    assert messages("INE003", link("arm", inertial(1e-9, (-1e-18, 1e-38, 1e-17)))) == []


def test_a_link_without_mass_is_not_judged() -> None:
    assert messages("INE003", link("arm", inertial(0, (-1, 1, 1)))) == []


def test_one_finding() -> None:
    robot = part("arm", 2, (-1, 1, 3), BALL)
    assert len(messages("INE003", robot)) == 1
    assert messages("INE006", robot) == []


def test_copies_are_one_finding_and_the_order_of_sdf_is_known() -> None:
    wrong = (0.03, 0.02, 0.01, 0.001, 0, 0)
    robot = "".join(link(name, inertial(2, wrong)) for name in ("a", "b")) + joint("a", "b")
    (found,) = reported("INE003", robot)
    assert found.message == naming("a", "-0.0113, 0.00021, 0.0421 kg·m²", "b")
    assert [note.span.line for note in found.related] == [5]
    assert found.help == naming('ixx="0.03"', 'ixy="0.001"', 'ixz="0"', 'iyy="0.02"', 'izz="0.01"')


def test_a_product_with_a_misplaced_decimal_point() -> None:
    robot = part("arm", 2, (0.0151, -1e-5, 2e-5, 0.0121, 0.0411, 0.0133), BALL)
    (found,) = reported("INE003", robot)
    assert found.help.startswith("perhaps the tensor has iyz ten times too large")
    assert 'iyy="0.0121" iyz="0.00411" izz="0.0133"' in fixed("INE003", robot)


@pytest.mark.parametrize(
    ("moments", "is_shape"),
    [
        ((0.012838, 0.056852, 0.0711), False),  # of a CAD program, 2 % too much
        ((0.012838, 0.056852, 0.0911), True),  # much too much
        ((0.01, 0.05, 0.065), True),  # a guess
    ],
)
def test_the_shape_does_not_replace_a_tensor_that_is_almost_right(
    moments: tuple[float, ...], is_shape: bool
) -> None:
    robot = part("base", 3.748, moments, '<box size="0.212 0.204 0.088"/>')
    (found,) = reported("INE003", robot)
    assert (found.fix is not None) is is_shape
    assert ("0.06969 kg·m²" in found.help) is not is_shape
