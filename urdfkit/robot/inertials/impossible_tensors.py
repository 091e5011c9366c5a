"""Diagnosis of physically impossible tensors."""

from __future__ import annotations

import re
from collections.abc import Iterator
from math import isclose

from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.robot.inertia import scaled
from urdfkit.robot.inertials.diagnosis import Diagnosis, tensor_of_shape
from urdfkit.robot.inertials.link_comparison import LinkInertia
from urdfkit.robot.inertials.masses import unlike
from urdfkit.robot.inertials.tensor_entries import differs, is_possible, opposite, rearranged
from urdfkit.robot.link import Tensor
from urdfkit.text.diagnostic import Confidence

if TYPE_CHECKING:
    from urdfkit.robot.inertials.masses import Masses

#: Largest ratio of two multiples of the moments of a shape that are the same, as of a hollow part.
_SAME_MULTIPLE = 1.5
#: Multiples of the moments of a shape beyond which a part has other mistakes, too: a rod with its
#: mass at the ends has 3.
_LEAST_MULTIPLE, _MOST_MULTIPLE = 0.5, 3.0
#: Largest moment by the sum of the two others, up to which one of three computed numbers is wrong.
_MAX_EXCESS = 1.1
_MOMENTS = ("ixx", "iyy", "izz")
#: In kg·m²: what is written instead of zero.
_ZERO = 1e-15
#: Most digits of a number that is not computed.
_MAX_DIGITS = 12


def diagnose_impossible(link: LinkInertia, masses: Masses) -> Diagnosis:
    """Diagnosis of a physically impossible tensor, with the intended one if the numbers show it."""
    if link.is_measured and link.expected:
        suggested = rearranged(link, link.expected, [range(3)])
        if suggested and is_possible(suggested) and (keys := opposite(link.tensor, suggested)):
            cause = f"has {' and '.join(keys)} with the opposite sign"
            return Diagnosis(cause, suggested, Confidence.INFERRED)
        shape = tensor_of_shape(link)
        if shape and [differs(key, link, shape) for key in Tensor._fields].count(True) == 1:
            return Diagnosis("", shape, Confidence.INFERRED)  # only one entry differs
    for cause, tensor in _rewritten(link):
        return Diagnosis(cause, tensor, Confidence.GUESSED)
    for cause, tensor in _of_counterpart(link, masses):
        return Diagnosis(cause, tensor, Confidence.INFERRED)
    if link.is_measured and (tensor := _with_one_moment(link) or _with_corrected_moment(link)):
        return Diagnosis("", tensor, Confidence.INFERRED)
    for cause, tensor in _with_shifted_decimal_point(link):
        return Diagnosis(cause, tensor, Confidence.GUESSED)
    if link.is_measured:
        return _of_shape(link)
    return Diagnosis("", None, Confidence.GUESSED)


def _of_counterpart(link: LinkInertia, masses: Masses) -> Iterator[tuple[str, Tensor]]:
    """What the mirror image of the counterpart shows."""
    for counterpart in _symmetric_pairs(link, masses):
        tensor = counterpart.tensor
        mirrored = tensor._replace(ixy=-tensor.ixy, iyz=-tensor.iyz)
        swapped = link.tensor._replace(iyz=link.tensor.izz, izz=link.tensor.iyz)
        if is_possible(swapped) and _has_same_numbers(swapped, mirrored):
            yield "has iyz and izz swapped", swapped
        if is_possible(mirrored) and unlike(link, counterpart) != "mass":
            yield f"of its counterpart '{counterpart.name}' is possible", mirrored


def _has_same_numbers(tensor: Tensor, other: Tensor) -> bool:
    """True for the same entries but for their signs, which only the link itself has right."""
    return all(isclose(abs(a), abs(b), rel_tol=0.01) for a, b in zip(tensor, other, strict=True))


def _of_shape(link: LinkInertia) -> Diagnosis:
    """The tensor of the shape, unless that is only an outline of the link."""
    if not _is_computed_otherwise(link):
        return Diagnosis("", tensor_of_shape(link), Confidence.INFERRED)
    low, middle, _ = link.moments
    cause = f"can have a largest moment of {low + middle:.4g} kg·m² at most, with the others"
    return Diagnosis(cause, None, Confidence.GUESSED)


def _is_computed_otherwise(link: LinkInertia) -> bool:
    """True for a tensor of a CAD program that hardly breaks the inequality, unlike the shape.

    The other two moments are then closer to the truth than those of the shape.
    """
    low, middle, high = link.moments
    is_near = 0 < high <= _MAX_EXCESS * (low + middle)
    return (
        is_near and not link.has_round_numbers and not _has_proportions(link.tensor, link.expected)
    )


def _with_one_moment(link: LinkInertia) -> Tensor | None:
    """The tensor of the shape, scaled to the only entry that is written, if that is a moment.

    Of the base of an arm, the moment about its joint alone can be measured.
    """
    written = {key: value for key, value in link.tensor._asdict().items() if abs(value) > _ZERO}
    expected = tensor_of_shape(link)
    if expected is None or len(written) != 1 or not written.keys() <= set(_MOMENTS):
        return None
    ((key, value),) = written.items()
    ratio = value / getattr(expected, key)
    if not _LEAST_MULTIPLE <= ratio <= _MOST_MULTIPLE:
        return None
    return scaled(expected, ratio)._replace(**{key: value})


def _with_corrected_moment(link: LinkInertia) -> Tensor | None:
    """A tensor of a CAD program with the one moment that does not go with the two others.

    These are the same multiple of those of the shape, such as 2 for a hollow part.
    """
    expected = link.expected
    if expected is None or link.has_round_numbers:
        return None
    ratios = {key: getattr(link.tensor, key) / getattr(expected, key) for key in _MOMENTS}
    found = []
    for key in _MOMENTS:
        low, high = sorted(ratio for name, ratio in ratios.items() if name != key)
        if _LEAST_MULTIPLE <= low <= high <= min(_MOST_MULTIPLE, _SAME_MULTIPLE * low):
            value = getattr(expected, key) * (low * high) ** 0.5
            found.append(link.tensor._replace(**{key: float(f"{value:.6g}")}))
    possible = list(filter(is_possible, found))
    return possible[0] if len(possible) == 1 else None


def _same_expressions(link: LinkInertia) -> list[str]:
    """The two moments of a box macro that are computed from the same edges; empty without any.

    Many tutorials contain ``m*(y*y+z*z)/12``, ``m*(x*x+z*z)/12`` and ``m*(x*x+z*z)/12``.
    """
    keys: list[str] = [key for key in ("ixx", "iyy", "izz") if key in link.at.attributes]
    texts = {key: link.at.attributes[key].span.text for key in keys}
    patterns = {re.sub(r"[A-Za-z_]\w*", "v", text) for text in texts.values()}
    twice = [key for key in keys if list(texts.values()).count(texts[key]) == 2]
    return twice if len(keys) == 3 and len(patterns) == 1 and "v" in patterns.pop() else []


def _rewritten(link: LinkInertia) -> Iterator[tuple[str, Tensor | None]]:
    """Mistakes in writing that explain an impossible tensor, each with the intended tensor."""
    if keys := _same_expressions(link):
        pairs = "of a box each moment has another pair of edges"
        yield f"has the same expression at {' and '.join(keys)}: {pairs}", None
    a, b, c, d, e, f = link.tensor
    as_in_sdf = Tensor(a, d, e, b, f, c)
    if min(a, b, c) > 0 and is_possible(as_in_sdf):
        yield "is in the order ixx iyy izz ixy ixz iyz", as_in_sdf
    if b == d and e > 0 and abs(f) <= e and a > 0 and b * b < a * e:
        rows = "contains the first two rows of the matrix, so that the value at iyz is iyy"
        yield f"{rows}, the one at izz is iyz, and izz is missing", None
    positive = Tensor(abs(a), b, c, abs(d), e, abs(f))
    if positive != link.tensor and is_possible(positive):
        yield "has a negative moment that is possible when positive", positive
    turned = Tensor(a, -b, -c, d, -e, f)
    if turned != link.tensor and is_possible(turned):
        yield "has products of inertia with the opposite sign", turned


def _with_shifted_decimal_point(link: LinkInertia) -> Iterator[tuple[str, Tensor]]:
    """A moment with the decimal point one digit too far to the right."""
    for key in ("ixx", "iyy", "izz"):
        attribute = link.at.attributes[key]
        if not attribute.literal or len(re.findall(r"\d", attribute.value)) > _MAX_DIGITS:
            continue  # the result of a formula, which a program may have written
        tenth = link.tensor._replace(**{key: getattr(link.tensor, key) / 10})
        diagonal = (tenth.ixx, tenth.iyy, tenth.izz)
        is_even = max(diagonal) <= 2 * min(diagonal)
        if is_possible(tenth) and is_even and _has_proportions(tenth, link.expected):
            yield f"has {key} ten times too large", tenth
    products = list(_with_smaller_product(link)) if link.is_indefinite else []
    yield from products if len(products) == 1 else ()


def _with_smaller_product(link: LinkInertia) -> Iterator[tuple[str, Tensor]]:
    """The same for a product of inertia, which makes a principal moment negative."""
    for key in ("ixy", "ixz", "iyz"):
        attribute = link.at.attributes.get(key)
        if attribute and attribute.literal and getattr(link.tensor, key):
            tenth = link.tensor._replace(**{key: getattr(link.tensor, key) / 10})
            if is_possible(tenth):
                yield f"has {key} ten times too large", tenth


def _has_proportions(tensor: Tensor, expected: Tensor | None) -> bool:
    """True if the moments are about the same multiple of those of the shape, if it is known."""
    ratios = [of_link / of_shape for of_link, of_shape in _moments(tensor, expected)]
    return not ratios or max(ratios) <= _SAME_MULTIPLE * min(ratios)


def _moments(tensor: Tensor, expected: Tensor | None) -> list[tuple[float, float]]:
    keys = ("ixx", "iyy", "izz") if expected else ()
    pairs = ((getattr(tensor, key), getattr(expected, key)) for key in keys)
    return [(of_link, of_shape) for of_link, of_shape in pairs if of_shape > 0]


def _symmetric_pairs(link: LinkInertia, masses: Masses) -> Iterator[LinkInertia]:
    for left, right in masses.symmetric_pairs:
        if link in (left, right):
            yield right if link is left else left
