"""Diagnosis of wrong tensors: the cause and the probably intended tensor.

A diagnosis is a guess that the numbers support: with the correction, the tensor agrees with the
shape of the link, or becomes physically possible. It has a confidence.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import permutations

from urdfkit.core.record import Record
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.robot import inertia
from urdfkit.robot.inertials.defects import MAX_PART_DENSITY, MIN_MOMENT_RATIO
from urdfkit.robot.inertials.link_comparison import EXACT_RATIO, LinkInertia
from urdfkit.robot.inertials.tensor_entries import opposite, rearranged
from urdfkit.robot.inertials.tensor_text import format_tensor
from urdfkit.robot.link import Tensor
from urdfkit.robot.shapes import OTHER_UNIT
from urdfkit.text.diagnostic import Confidence

if TYPE_CHECKING:
    from urdfkit.robot.inertials.masses import Masses

#: Units of CAD programs in kg·m²; 1 lb is 0.45359237 kg and 1 in is 0.0254 m by definition.
UNITS = (
    ("g·mm²", 1e-9),
    ("g·cm²", 1e-7),
    ("kg·mm²", 1e-6),
    ("kg·cm²", 1e-4),
    ("lb·in²", 0.45359237 * 0.0254**2),
    ("lb·ft²", 0.45359237 * 0.3048**2),
)

#: Of a unit that a tensor may fit by chance, since it is only 24 times as small as kg·m².
_LIKE_METRIC = "is in lb·ft²"
#: Ratio of moments up to which a tensor fits a shape, as the density of a part varies.
_ROUGH_RATIO = 3.0

#: Largest ratio of the corrected moments to those of the shape.
_CORRECTED_RATIO = 1.5

#: In kg/m³: below this density, the shape is too large, such as with millimetres read as metres.
_DENSITY_OF_AIR = 1.2

#: Moments up to this ratio are equal.
_EQUAL_MOMENTS = 1.01

#: Related locations of a finding about many links.
MAX_RELATED = 20


class Diagnosis(Record):
    """The probable defect of a tensor."""

    cause: str  # predicate on the tensor, such as ``is in g·mm²``; empty if unknown
    tensor: Tensor | None  # the intended tensor, in kg·m²; None if unknown
    confidence: Confidence  # of the proposal

    def describe(self, present: Tensor) -> str:
        """The cause and the correction of the present tensor, in one line; empty if unknown."""
        if self.tensor is None:
            return f"the tensor {self.cause}" if self.cause else ""
        written = format_tensor(self.tensor, present)
        if not self.cause:
            return f"write {written}"
        if self.confidence is Confidence.GUESSED:
            return f"perhaps the tensor {self.cause}; then it is {written}"
        return f"the tensor {self.cause}: write {written}"


def diagnose_unlike_shape(link: LinkInertia, masses: Masses) -> Diagnosis:
    """Diagnosis of a tensor that differs from the shape; without a cause, that of the shape."""
    expected = link.expected
    assert expected is not None
    if link.densities and link.densities[1] < _DENSITY_OF_AIR:
        return Diagnosis("", None, Confidence.GUESSED)
    for cause, tensor in _mistakes(link, expected):
        if cause != _LIKE_METRIC or not _fit_as_written(link, masses):
            return Diagnosis(cause, tensor, Confidence.INFERRED)
    match = masses.of_their_shape.get(link.tensor)
    cause = f"is that of link '{match.name}', which it fits" if match else ""
    is_wrong = bool(match) or _is_invented(link, expected)
    return Diagnosis(cause, tensor_of_shape(link) if is_wrong else None, Confidence.INFERRED)


def _fit_as_written(link: LinkInertia, masses: Masses) -> bool:
    """True if the tensors of most other links fit their shapes in kg·m²."""
    others = [other for other in masses.inertias if other is not link and other.is_measured]
    fit = sum(bool(other.expected and other.fits(other.expected, _ROUGH_RATIO)) for other in others)
    return 2 * fit > len(others)


def _is_invented(link: LinkInertia, expected: Tensor) -> bool:
    """True if a tensor was invented, so that even the rough shape of the link is more accurate.

    Three equal moments of an uneven shape, or with one digit, are a guess; moments in the exact
    proportions of the shape were computed from it; and no rough shape is wrong by a factor of 100.
    Other tensors may be published for the real robot, whose shape here may be a placeholder.
    """
    moment = link.tensor.ixx
    if link.is_diagonal and {*link.diagonal} == {moment}:
        return not _has_equal_moments(expected) or float(f"{moment:.0e}") == moment
    ratios = link.ratios(expected)
    is_far = max(ratios) < MIN_MOMENT_RATIO or min(ratios) > 1 / MIN_MOMENT_RATIO
    return is_far or _is_scaled(link, expected)


def _is_scaled(link: LinkInertia, expected: Tensor) -> bool:
    """True if the moments are in the exact proportions of the shape."""
    ratios = link.ratios(expected)
    return min(ratios) > 0 and max(ratios) <= EXACT_RATIO * min(ratios)


def tensor_of_shape(link: LinkInertia) -> Tensor | None:
    """The tensor of the shape; None for a marker, or if the shape does not fit the mass."""
    low, high = link.densities or (MAX_PART_DENSITY, MAX_PART_DENSITY)
    is_unknown = link.is_marker or link.lengths_differ(OTHER_UNIT)
    return None if is_unknown or low > MAX_PART_DENSITY or high < _DENSITY_OF_AIR else link.expected


def _mistakes(link: LinkInertia, expected: Tensor) -> Iterator[tuple[str, Tensor]]:
    """Mistakes that explain the difference from the shape, each with the intended tensor."""
    if link.is_at_wrong_axes:
        yield explain_wrong_axes(link)
    # Three equal moments of an uneven shape fit a unit by chance.
    is_invented = _has_equal_moments(link.tensor) and not _has_equal_moments(expected)
    if not link.is_placeholder and not is_invented:
        for unit, factor in UNITS:
            tensor, cause = inertia.scaled(link.tensor, factor), f"is in {unit}"
            # Without products it was computed for the shape; 16 times is another mistake.
            is_chance = (
                cause == _LIKE_METRIC
                and link.is_diagonal
                and not inertia.agree(tensor, expected, EXACT_RATIO)
            )
            if inertia.agree(tensor, expected, _CORRECTED_RATIO) and not is_chance:
                yield cause, tensor
    about_center = link.about_center
    if about_center != link.tensor and inertia.agree(about_center, expected, _CORRECTED_RATIO):
        yield "is about the origin of the link, not the centre of mass", about_center
    twice = link.expected_of_twice
    if link.is_diagonal and twice is not None and link.fits(twice, EXACT_RATIO):
        yield "was computed with twice the size, as of a diameter for a radius", expected
    swapped = link.expected_of_swapped
    if link.is_diagonal and swapped is not None and link.fits(swapped, EXACT_RATIO):
        yield "was computed with the radius as the length, and the length as the radius", expected


def _has_equal_moments(tensor: Tensor) -> bool:
    """True for the tensor of a ball or a cube."""
    least, _, largest = sorted((tensor.ixx, tensor.iyy, tensor.izz))
    products = max(map(abs, (tensor.ixy, tensor.ixz, tensor.iyz)))
    return largest <= _EQUAL_MOMENTS * least and products <= (_EQUAL_MOMENTS - 1) * largest


def explain_wrong_axes(link: LinkInertia) -> tuple[str, Tensor]:
    """Cause and intended tensor of a tensor with the moments of the shape about other axes.

    The intended tensor has the same entries with as few changes of position and sign as possible.
    """
    expected = link.expected
    assert expected is not None
    if suggested := rearranged(link, expected, list(permutations(range(3)))):
        if keys := opposite(link.tensor, suggested):
            return f"has {' and '.join(keys)} with the opposite sign", suggested
        return "has its moments at the wrong axes", suggested
    return "has its moments at the wrong axes", expected
