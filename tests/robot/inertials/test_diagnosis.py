from itertools import product

import pytest

from tests.massive import BALL, BOX, MESH, WHEEL, inertial, joint, link, masses, part, shape
from urdfkit.checks.inertia.copies import together
from urdfkit.lint.rules import Finding
from urdfkit.robot.inertials.defects import InertiaDefect
from urdfkit.robot.inertials.diagnosis import UNITS, Diagnosis, diagnose_unlike_shape
from urdfkit.robot.inertials.impossible_tensors import diagnose_impossible
from urdfkit.robot.inertials.link_comparison import LinkInertia
from urdfkit.robot.inertials.masses import Masses
from urdfkit.robot.inertials.tensor_fix import replacement
from urdfkit.robot.inertials.tensor_text import format_moments, format_tensor
from urdfkit.robot.link import Tensor
from urdfkit.text.diagnostic import Confidence, Fix

DIAGONAL = Tensor(1, 0, 0, 1, 0, 1)
#: Of 12 kg in BOX.
BOX_MOMENTS = (0.1, 0.05, 0.13)


def unlike(robot: str) -> Diagnosis:
    """The diagnosis of the first link, whose tensor is not that of its shape."""
    found = masses(robot)
    return diagnose_unlike_shape(found.inertias[0], found)


def impossible(moments: tuple[float, ...], *shapes: str) -> Diagnosis:
    found = masses(link("a", *shapes, inertial(12, moments)))
    return diagnose_impossible(found.inertias[0], found)


@pytest.mark.parametrize(
    ("moments", "izz"),
    [
        ((0.2003, 0.001, 0, 0.1002, 0, 0.4611), 0.2604),  # twice those of the solid
        ((0.0501, 0.001, 0, 0.0253, 0, 0.1611), 0.0655),
        ((0.2003, 0.001, 0, 0.0102, 0, 0.4611), None),  # no multiple
        ((200.3, 0.001, 0, 100.2, 0, 461.1), None),  # DARwIn: a neck of 24 g has that of a door
        ((0.2, 0, 0, 0.1, 0, 0.46), None),  # no digits of a CAD program
    ],
)
def test_one_moment_that_does_not_go_with_the_others(
    moments: tuple[float, ...], izz: float | None
) -> None:
    tensor = impossible(moments, shape("collision", BOX)).tensor
    assert tensor is not None
    expected = (*moments[:5], izz) if izz else (0.1, 0, 0, 0.05, 0, 0.13)
    assert tensor == pytest.approx(expected, rel=1e-3)


def test_without_a_cause_the_shape_is_proposed() -> None:
    diagnosis = unlike(part("a", 12, (7, 7, 7), BOX))
    assert (diagnosis.cause, diagnosis.confidence) == ("", Confidence.INFERRED)
    assert diagnosis.tensor == pytest.approx((0.1, 0, 0, 0.05, 0, 0.13))
    assert diagnosis.describe(DIAGONAL) == 'write ixx="0.1" iyy="0.05" izz="0.13"'


def test_many_links_with_one_tensor_are_compared_with_each_other_once(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """2000 of them took a minute."""
    calls: list[LinkInertia] = []
    fits = LinkInertia.fits

    def counted(one: LinkInertia, expected: Tensor, factor: float) -> bool:
        calls.append(one)
        return fits(one, expected, factor)

    monkeypatch.setattr(LinkInertia, "fits", counted)
    count = 50
    found = masses("".join(part(f"l{n}", 12, (7, 7, 7), BOX) for n in range(count)))
    for one in found.inertias:
        diagnose_unlike_shape(one, found)
    assert len(calls) <= 4 * count


@pytest.mark.parametrize(("unit", "factor"), UNITS)
def test_units(unit: str, factor: float) -> None:
    excess = 1.0 if unit == "lb·ft²" else 1.2
    moments = tuple(value * excess / factor for value in BOX_MOMENTS)
    diagnosis = unlike(part("a", 12, moments, BOX))
    assert diagnosis.cause == f"is in {unit}"
    ixx, iyy, izz = (value * excess for value in (0.1, 0.05, 0.13))
    assert diagnosis.tensor == pytest.approx((ixx, 0, 0, iyy, 0, izz))
    written = f'write ixx="{ixx:g}" iyy="{iyy:g}" izz="{izz:g}"'
    assert diagnosis.describe(DIAGONAL) == f"the tensor is in {unit}: {written}"


def test_units_in_si() -> None:
    # NIST SP 811: 1 lb = 0.453 592 37 kg, 1 in = 2.54 cm, 1 ft = 30.48 cm, all exact.
    assert dict(UNITS)["lb·in²"] == pytest.approx(2.92639653e-4, rel=1e-8)
    assert dict(UNITS)["lb·ft²"] == pytest.approx(4.21401101e-2, rel=1e-8)


def test_a_stand_in_is_in_no_unit() -> None:
    # 0.001 kg·mm² would fit this ball by chance.
    assert unlike(part("a", 2.5e-7, (1e-3,) * 3, BALL)).cause == ""


def test_equal_moments_of_a_box_are_in_no_unit() -> None:
    """Links of 1 kg that all have 0.0226667 three times, which fit one of them in lb·ft²."""
    even = sum(BOX_MOMENTS) / 3 / dict(UNITS)["lb·ft²"]
    assert unlike(part("a", 12, (even,) * 3, BOX)).cause == ""
    ball = 0.004 / dict(UNITS)["lb·ft²"]
    assert unlike(part("a", 1, (ball,) * 3, BALL)).cause == "is in lb·ft²"


@pytest.mark.parametrize(("factor", "cause"), [(1.3, ""), (30, "is in lb·ft²")])
def test_a_unit_that_the_other_links_do_not_have(factor: float, cause: str) -> None:
    """One link of an air hockey robot fits in lb·ft², the others in kg·m²: it is that of a box
    of 0.1 m."""
    ball = part("a", 1, (0.004 / dict(UNITS)["lb·ft²"],) * 3, BALL)
    moments = tuple(factor * moment for moment in BOX_MOMENTS)
    boxes = "".join(part(name, 12, moments, BOX) + joint("a", name) for name in "bc")
    diagnosis = unlike(ball + boxes)
    assert (diagnosis.cause, diagnosis.confidence) == (cause, Confidence.INFERRED)


def test_a_computed_tensor_fits_a_unit_exactly_or_by_chance() -> None:
    """m (3 r + l) / 12 and m r / 2 of a cylinder, not squared, were taken for lb·ft²."""
    mass, radius, length = 0.44, 0.048, 0.04
    across, along = mass * (3 * radius + length) / 12, mass * radius / 2
    shape = f'<cylinder radius="{radius}" length="{length}"/>'
    assert unlike(part("a", mass, (across, across, along), shape)).cause == ""


def test_about_the_origin_of_the_link() -> None:
    # The ball of 1 kg has 0.004; 0.5 m away it has 0.254 across.
    diagnosis = unlike(part("a", 1, (0.004, 0.254, 0.254), BALL, xyz="0.5 0 0"))
    assert diagnosis.cause == "is about the origin of the link, not the centre of mass"
    assert diagnosis.tensor == pytest.approx((0.004, 0, 0, 0.004, 0, 0.004))


def test_about_the_origin_with_a_turned_frame() -> None:
    robot = link(
        "a",
        shape("collision", BALL),
        inertial(1, (0.254, 0.004, 0.254), xyz="0.5 0 0", rpy="0 0 -1.5707963267948966"),
    )
    assert unlike(robot).cause == "is about the origin of the link, not the centre of mass"


def test_a_diameter_for_a_radius() -> None:
    across, along = 0.5 * (3 * 0.12**2 + 0.05**2) / 12, 0.5 * 0.12**2 / 2
    diagnosis = unlike(part("a", 0.5, (across, across, along), WHEEL))
    assert diagnosis.cause == "was computed with twice the size, as of a diameter for a radius"
    assert diagnosis.tensor is not None
    assert diagnosis.tensor.izz == pytest.approx(along / 4)


def test_at_the_wrong_axes() -> None:
    assert unlike(part("a", 12, (0.05, 0.1, 0.13), BOX)).cause == (
        "has its moments at the wrong axes"
    )


def test_copied_from_a_link_that_it_fits() -> None:
    robot = part("chassis", 20, BOX_MOMENTS, BALL) + part("box", 12, BOX_MOMENTS, BOX)
    diagnosis = unlike(robot)
    assert diagnosis.cause == "is that of link 'box', which it fits"
    assert diagnosis.tensor == pytest.approx((0.08, 0, 0, 0.08, 0, 0.08))


def test_in_the_order_of_sdf() -> None:
    diagnosis = impossible((0.03, 0.02, 0.01, 0.001, 0, 0.002))
    assert diagnosis == Diagnosis(
        "is in the order ixx iyy izz ixy ixz iyz",
        Tensor(0.03, 0.001, 0, 0.02, 0.002, 0.01),
        Confidence.GUESSED,
    )
    assert diagnosis.describe(DIAGONAL) == (
        "perhaps the tensor is in the order ixx iyy izz ixy ixz iyz; then it is "
        'ixx="0.03" ixy="0.001" iyy="0.02" iyz="0.002" izz="0.01"'
    )


def test_the_first_two_rows_of_the_matrix() -> None:
    matrix = ((0.03, 0.004, 0.0), (0.004, 0.02, 0.001), (0.0, 0.001, 0.01))
    diagnosis = impossible((*matrix[0], *matrix[1]))
    assert diagnosis.tensor is None
    assert diagnosis.describe(DIAGONAL).startswith(
        "the tensor contains the first two rows of the matrix"
    )


def test_equal_numbers_are_no_rows_of_a_matrix() -> None:
    """ROSbot's box: 0.01 at five of six places."""
    diagnosis = impossible((0.01, 0.01, 0, 0.01, 0.01, 0.01))
    assert "rows" not in diagnosis.describe(DIAGONAL)


def test_a_wrong_sign_of_a_moment() -> None:
    diagnosis = impossible((0.03, 0, 0, -0.02, 0, 0.015))
    assert diagnosis.cause == "has a negative moment that is possible when positive"
    assert diagnosis.tensor == Tensor(0.03, 0, 0, 0.02, 0, 0.015)


def test_products_of_inertia_with_the_opposite_sign() -> None:
    # The eigenvalues are 0.6, 0.6, 1.8, and with the other sign 0.2, 1.4, 1.4.
    diagnosis = impossible((1, 0.4, 0.4, 1, 0.4, 1))
    assert diagnosis.cause == "has products of inertia with the opposite sign"
    assert diagnosis.tensor == Tensor(1, -0.4, -0.4, 1, -0.4, 1)


def test_a_typo_of_a_digit() -> None:
    diagnosis = impossible((0.001, 0, 0, 0.001, 0, 0.012))
    assert diagnosis.cause == "has izz ten times too large"
    assert diagnosis.tensor == pytest.approx((0.001, 0, 0, 0.001, 0, 0.0012))


def right_leg(*moments: float) -> Diagnosis:
    """The diagnosis of the right one of two legs."""
    symmetric_pairs = (
        link("hip")
        + link("left_leg", inertial(1, (0.01, 0.002, 0.001, 0.02, 0.003, 0.025)))
        + link("right_leg", inertial(1, moments))
        + joint("hip", "left_leg", xyz="0 0.1 0")
        + joint("hip", "right_leg", xyz="0 -0.1 0")
    )
    found = masses(symmetric_pairs)
    return diagnose_impossible(found.inertias[1], found)


def test_the_counterpart_shows_that_the_last_values_are_swapped() -> None:
    """A Spot: the signs of its own values are right, those of the counterpart are not."""
    diagnosis = right_leg(0.01, -0.00201, -0.001, 0.02, 0.025, 0.003)
    assert diagnosis.cause == "has iyz and izz swapped"
    assert diagnosis.tensor == Tensor(0.01, -0.00201, -0.001, 0.02, 0.003, 0.025)


def test_the_counterpart_is_possible() -> None:
    diagnosis = right_leg(0.01, 0, 0, 0.02, 0, 0.9)
    assert diagnosis.cause == "of its counterpart 'left_leg' is possible"
    assert diagnosis.tensor == Tensor(0.01, -0.002, 0.001, 0.02, -0.003, 0.025)
    assert diagnosis.confidence is Confidence.INFERRED


def test_else_the_shape_or_nothing() -> None:
    moments = (0.01, 0, 0, 0.01, 0, 0.9)
    by_shape = impossible(moments, shape("collision", BOX))
    assert (by_shape.cause, by_shape.confidence) == ("", Confidence.INFERRED)
    assert by_shape.tensor == pytest.approx((0.1, 0, 0, 0.05, 0, 0.13))
    assert impossible(moments, shape("collision", MESH)).describe(DIAGONAL) == ""


def test_no_proposal_is_impossible() -> None:
    for moments in product((-0.02, 0.0, 0.001, 0.03), repeat=6):
        found = masses(link("a", inertial(1, moments)))
        impossible = (InertiaDefect.INDEFINITE, InertiaDefect.TRIANGLE_INEQUALITY)
        for one in (one for key in impossible for one in found.defects.get(key, [])):
            tensor = diagnose_impossible(one, found).tensor
            if tensor is not None:
                assert masses(link("a", inertial(1, tensor))).defects == {}


@pytest.mark.parametrize(
    ("tensor", "present", "text"),
    [
        (Tensor(1, 0, 0, 2, 0, 3), DIAGONAL, 'ixx="1" iyy="2" izz="3"'),
        (Tensor(1, 0, 0, 2, 0, 3), Tensor(1, 5, 0, 2, 0, 3), 'ixx="1" ixy="0" iyy="2" izz="3"'),
        (Tensor(1, 0.5, 0, 2, 0, 3), DIAGONAL, 'ixx="1" ixy="0.5" iyy="2" izz="3"'),
        (Tensor(1, 1e-17, 2e-5, 2, 0, 3), DIAGONAL, 'ixx="1" iyy="2" izz="3"'),
        (
            Tensor(1 / 3, 0, 0, 2e-7, 0, 1 / 3),
            DIAGONAL,
            'ixx="0.333333" iyy="2e-07" izz="0.333333"',
        ),
    ],
)
def test_how_a_tensor_is_written(tensor: Tensor, present: Tensor, text: str) -> None:
    assert format_tensor(tensor, present) == text


def test_equal_values_are_written_once() -> None:
    assert format_moments((0.1, 0.1, 0.1)) == "0.1 kg·m² each"
    assert format_moments((0.1, 0.12345, 1e-7)) == "0.1, 0.123, 1e-07 kg·m²"


def test_a_replacement_edits_what_is_different_only() -> None:
    (found,) = masses(part("a", 12, (0.1, 7, 0.13), BOX)).inertias
    fix = replacement(found, Tensor(0.1, 0, 0, 0.05, 0, 0.13))
    assert fix is not None
    assert fix.title == 'write iyy="0.05"'
    assert [(edit.span.text, edit.text) for edit in fix.edits] == [("7", "0.05")]
    assert replacement(found, Tensor(0.1, 0, 0, 7, 0, 0.13)) is None
    assert replacement(found, None) is None


def replaced(robot: str) -> list[tuple[str, str]]:
    """The old and new texts of what a fix writes instead of a tensor that is not of the shape."""
    (found,) = masses(robot).inertias
    fix = replacement(found, diagnose_unlike_shape(found, masses(robot)).tensor)
    return [(edit.span.text, edit.text) for edit in fix.edits] if fix else []


def test_a_tensor_that_may_be_published_is_not_replaced_by_that_of_a_placeholder() -> None:
    """RotorS' hummingbird: measured, in a box that is no more than its battery."""
    box = '<box size="0.1 0.1 0.12"/>'
    published = (0.007, 0.007, 0.012)
    assert unlike(part("base", 0.68, published, box)) == Diagnosis("", None, Confidence.INFERRED)
    assert replaced(part("base", 0.68, (0.01, 0.01, 0.01), box)) != []


def test_one_sign_is_all_that_is_changed() -> None:
    """As on the wrists of Kinova's arms."""
    turned = shape("collision", BOX, rpy="0 0 0.4")
    robot = link("wrist", turned, inertial(12, BOX_MOMENTS))
    (box,) = masses(robot).inertias
    assert box.expected is not None
    moments = Tensor(0.0923, -0.0178, 0, 0.0576, 0, 0.1303)
    assert box.expected == pytest.approx((0.0924, 0.0179, 0, 0.0576, 0, 0.13), abs=1e-4)
    wrong = link("wrist", turned, inertial(12, moments))
    (found,) = masses(wrong).inertias
    assert found.is_at_wrong_axes
    assert replaced(wrong) == [("-0.0178", "0.0178")]


def test_entries_that_are_right_keep_their_digits() -> None:
    assert replaced(part("a", 12, (0.0995, 0.13, 0.0505), BOX)) == [
        ("0.13", "0.0505"),
        ("0.0505", "0.13"),
    ]


def test_a_product_that_an_angle_of_1_57_leaves_is_not_written() -> None:
    lying = link("a", shape("collision", BOX, rpy="1.57 0 0"), inertial(12, (7, 7, 7)))
    (found,) = masses(lying).inertias
    assert found.expected is not None
    assert abs(found.expected.iyz) > 1e-5
    assert [old for old, _ in replaced(lying)] == ["7", "7", "7"]


def test_of_the_signs_that_are_possible_that_of_the_shape_is_meant() -> None:
    thin = shape("collision", '<box size="0.02 0.02 1"/>', rpy="0.5 0.6 0")
    (rod,) = masses(link("a", thin, inertial(1, (7, 7, 7)))).inertias
    assert rod.expected is not None
    wrong = link("a", thin, inertial(1, rod.expected._replace(ixz=-rod.expected.ixz)))
    found = masses(wrong)
    assert [*found.defects] == [InertiaDefect.TRIANGLE_INEQUALITY]
    diagnosis = diagnose_impossible(found.inertias[0], found)
    assert diagnosis.cause == "has ixz with the opposite sign"
    assert diagnosis.tensor == pytest.approx(rod.expected)


def findings(found: Masses) -> list[Finding]:
    pairs = [
        (
            one,
            Finding(
                one.at,
                one.link.name,
                weight=one.mass,
                fix=replacement(one, Tensor(1, 0, 0, 1, 0, one.mass)),
            ),
        )
        for one in found.inertias
    ]
    return list(together(pairs))


def test_copies_are_one_finding_the_worst_first() -> None:
    robot = "".join(part(f"l{i}", 3 + i % 3, (7, 7, 7), BOX) for i in range(5))
    first, other = findings(masses(robot + part("other", 1, (8, 8, 8), BOX)))
    assert first.message == "l2 (also 'l1', 'l4' and 2 more)"
    assert [note.message for note in first.related] == ["l1", "l4", "l0", "l3"]
    assert first.fix is not None
    assert first.fix.title == "write the tensors of 5 shapes"
    assert len({edit.span for edit in first.fix.edits}) == 15
    assert (other.message, other.related) == ("other", ())
    assert isinstance(other.fix, Fix)
    assert other.fix.title == 'write ixx="1" iyy="1" izz="1"'


def test_three_copies_are_named() -> None:
    robot = "".join(part(f"l{i}", 3, (7, 7, 7), BOX) for i in range(4))
    assert [one.message for one in findings(masses(robot))] == ["l0 (also 'l1', 'l2' and 'l3')"]
    two = "".join(part(f"l{i}", 3, (7, 7, 7), BOX) for i in range(2))
    assert [one.message for one in findings(masses(two))] == ["l0 (also 'l1')"]
