"""Diagnosis of wrong tensors: the cause and the probably intended tensor.

A diagnosis is a guess that the numbers support: with the correction, the tensor agrees with the
shape of the link, or becomes physically possible. It has a confidence.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence
from itertools import permutations, product

from urdfkit.core.record import Record
from urdfkit.core.spatial import rotate, transposed
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.robot import inertia
from urdfkit.robot.inertials.defects import MAX_PART_DENSITY, MIN_MOMENT_RATIO
from urdfkit.robot.inertials.link_comparison import EXACT_RATIO, ROUNDING, LinkInertia
from urdfkit.robot.joint import Joint
from urdfkit.robot.joint_loads import is_effort_excessive
from urdfkit.robot.link import Tensor
from urdfkit.robot.rigid_bodies import properties_of
from urdfkit.robot.shapes import OTHER_UNIT
from urdfkit.robot.values import number
from urdfkit.text.diagnostic import Confidence, Fix
from urdfkit.text.editing.edits import all_or_none, from_macro, replace_value

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

#: Largest ratio of the corrected moments to those of the shape.
_CORRECTED_RATIO = 1.5

#: In kg/m³: below this density, the shape is too large, such as with millimetres read as metres.
_DENSITY_OF_AIR = 1.2

#: Products of inertia below this part of the largest moment result from angles such as 1.57.
PRODUCT_ROUNDING = 2e-3

#: Largest difference of a tensor with rearranged entries or signs from that of the shape, as a part
#: of the largest moment.
_ENTRY_TOLERANCE = 0.05

#: Row and column of ``ixx``, ``ixy``, ``ixz``, ``iyy``, ``iyz`` and ``izz``.
_CELLS = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))

#: Largest ratio of two multiples of the moments of a shape that are the same, as of a hollow part.
_SAME_MULTIPLE = 1.5

#: Moments up to this ratio are equal.
_EQUAL_MOMENTS = 1.01

#: Related locations of a finding about many links.
MAX_RELATED = 20


class Diagnosis(Record):
    """The probable defect of a tensor."""

    cause: str  # predicate on the tensor, such as ``is in g·mm²``; empty if unknown
    tensor: Tensor | None  # the intended tensor, in kg·m²; None if unknown
    confidence: Confidence  # of the proposal

    def __str__(self) -> str:
        """The cause and the correction, in one line; empty if both are unknown."""
        if self.tensor is None:
            return f"the tensor {self.cause}" if self.cause else ""
        if not self.cause:
            return f"write {format_tensor(self.tensor)}"
        if self.confidence is Confidence.GUESSED:
            return f"perhaps the tensor {self.cause}; then it is {format_tensor(self.tensor)}"
        return f"the tensor {self.cause}: write {format_tensor(self.tensor)}"


def diagnose_unlike_shape(link: LinkInertia, masses: Masses) -> Diagnosis:
    """Diagnosis of a tensor that differs from the shape; without a cause, that of the shape."""
    expected = link.expected
    assert expected is not None
    if link.densities and link.densities[1] < _DENSITY_OF_AIR:
        return Diagnosis("", None, Confidence.GUESSED)
    for cause, tensor in _mistakes(link, expected):
        return Diagnosis(cause, tensor, Confidence.INFERRED)
    match = masses.of_their_shape.get(link.tensor)
    cause = f"is that of link '{match.name}', which it fits" if match else ""
    is_wrong = bool(match) or _is_invented(link, expected)
    return Diagnosis(cause, _of_shape(link) if is_wrong else None, Confidence.INFERRED)


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
    is_scaled = min(ratios) > 0 and max(ratios) <= EXACT_RATIO * min(ratios)
    return is_scaled or max(ratios) < MIN_MOMENT_RATIO or min(ratios) > 1 / MIN_MOMENT_RATIO


def _of_shape(link: LinkInertia) -> Tensor | None:
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
            tensor = inertia.scaled(link.tensor, factor)
            if inertia.agree(tensor, expected, _CORRECTED_RATIO):
                yield f"is in {unit}", tensor
    about_center = _shifted_from_origin(link, -link.mass)
    if about_center != link.tensor and inertia.agree(about_center, expected, _CORRECTED_RATIO):
        yield "is about the origin of the link, not the centre of mass", about_center
    twice = link.expected_of_twice
    if link.is_diagonal and twice is not None and link.fits(twice, EXACT_RATIO):
        yield "was computed with twice the size, as of a diameter for a radius", expected


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
    if suggested := _rearranged(link, expected, list(permutations(range(3)))):
        if keys := opposite(link.tensor, suggested):
            return f"has {' and '.join(keys)} with the opposite sign", suggested
        return "has its moments at the wrong axes", suggested
    return "has its moments at the wrong axes", expected


def _rearranged(
    link: LinkInertia, expected: Tensor, orders: Iterable[Sequence[int]]
) -> Tensor | None:
    """The tensor with rearranged entries or signs that agrees with the shape.

    None if no arrangement agrees. Of several, the one with the fewest changes.
    """
    candidates = []
    for order, signs in product(orders, product((1, -1), repeat=3)):
        tensor = _permuted(link.tensor, order, signs)
        pairs = zip(tensor, expected, strict=True)
        if max(abs(a - b) for a, b in pairs) <= _ENTRY_TOLERANCE * abs(link.moments[2]):
            changes = sum(a != b for a, b in zip(tensor, link.tensor, strict=True))
            candidates.append((changes, tensor))
    return min(candidates)[1] if candidates else None


def _permuted(tensor: Tensor, order: Sequence[int], signs: Sequence[int]) -> Tensor:
    """A tensor with permuted axes, and with signs for ``ixy``, ``ixz`` and ``iyz``."""
    of_cell = dict(zip(_CELLS, tensor, strict=True))
    xx, xy, xz, yy, yz, zz = (
        of_cell[min(order[i], order[j]), max(order[i], order[j])] for i, j in _CELLS
    )
    return Tensor(xx, signs[0] * xy or 0.0, signs[1] * xz or 0.0, yy, signs[2] * yz or 0.0, zz)


def opposite(tensor: Tensor, other: Tensor) -> list[str]:
    """The entries with opposite signs; empty if the tensors differ otherwise, too."""
    rows = zip(Tensor._fields, tensor, other, strict=True)
    different = [(key, a, b) for key, a, b in rows if a != b]
    keys = [key for key, a, b in different if a == -b]
    return keys if len(keys) == len(different) else []


def diagnose_impossible(link: LinkInertia, masses: Masses) -> Diagnosis:
    """Diagnosis of a physically impossible tensor, with the intended one if the numbers show it."""
    if link.is_measured and link.expected:
        suggested = _rearranged(link, link.expected, [range(3)])
        if suggested and is_possible(suggested) and (keys := opposite(link.tensor, suggested)):
            cause = f"has {' and '.join(keys)} with the opposite sign"
            return Diagnosis(cause, suggested, Confidence.INFERRED)
        shape = _of_shape(link)
        if shape and [_differs(key, link, shape) for key in Tensor._fields].count(True) == 1:
            return Diagnosis("", shape, Confidence.INFERRED)  # only one entry differs
    for cause, tensor in _rewritten(link):
        return Diagnosis(cause, tensor, Confidence.GUESSED)
    for counterpart in _symmetric_pairs(link, masses):
        tensor = counterpart.tensor
        mirrored = tensor._replace(ixy=-tensor.ixy, iyz=-tensor.iyz)
        if is_possible(mirrored):
            cause = f"of its counterpart '{counterpart.name}' is possible"
            return Diagnosis(cause, mirrored, Confidence.INFERRED)
    if link.is_measured and (tensor := _with_another_moment(link)):
        return Diagnosis("", tensor, Confidence.INFERRED)
    for cause, tensor in _with_a_tenth(link):
        return Diagnosis(cause, tensor, Confidence.GUESSED)
    if link.is_measured:
        return Diagnosis("", _of_shape(link), Confidence.INFERRED)
    return Diagnosis("", None, Confidence.GUESSED)


def _with_another_moment(link: LinkInertia) -> Tensor | None:
    """A tensor of a CAD program with the one moment that does not go with the two others.

    These are the same multiple of those of the shape, such as 2 for a hollow part.
    """
    expected = link.expected
    if expected is None or link.is_round:
        return None
    keys = ("ixx", "iyy", "izz")
    ratios = {key: getattr(link.tensor, key) / getattr(expected, key) for key in keys}
    found = []
    for key in keys:
        low, high = sorted(ratio for name, ratio in ratios.items() if name != key)
        if 0 < high <= _SAME_MULTIPLE * low:
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
    if b == d and e > 0 and abs(f) <= e and a > 0 and len({*link.tensor}) > 1:
        rows = "contains the first two rows of the matrix, so that the value at iyz is iyy"
        yield f"{rows}, the one at izz is iyz, and izz is missing", None
    positive = Tensor(abs(a), b, c, abs(d), e, abs(f))
    if positive != link.tensor and is_possible(positive):
        yield "has a negative moment that is possible when positive", positive
    turned = Tensor(a, -b, -c, d, -e, f)
    if turned != link.tensor and is_possible(turned):
        yield "has products of inertia with the opposite sign", turned


def _with_a_tenth(link: LinkInertia) -> Iterator[tuple[str, Tensor]]:
    """A moment with the decimal point one digit too far to the right."""
    for key in ("ixx", "iyy", "izz"):
        tenth = link.tensor._replace(**{key: getattr(link.tensor, key) / 10})
        diagonal = (tenth.ixx, tenth.iyy, tenth.izz)
        if is_possible(tenth) and max(diagonal) <= 2 * min(diagonal):
            yield f"has {key} ten times too large", tenth


def _symmetric_pairs(link: LinkInertia, masses: Masses) -> Iterator[LinkInertia]:
    for left, right in masses.symmetric_pairs:
        if link in (left, right):
            yield right if link is left else left


def is_possible(tensor: Tensor) -> bool:
    """True if the tensor is physically possible."""
    low, middle, high = inertia.principal_moments(tensor)
    return low > 0 and high <= (low + middle) * (1 + ROUNDING)


def _shifted_from_origin(link: LinkInertia, mass: float) -> Tensor:
    """The tensor shifted between the centre of mass and the origin of the link."""
    origin = link.inertial.origin
    offset = rotate(transposed(origin.rotation), origin.position)
    return inertia.shifted(link.tensor, mass, offset)


def excessive_joint(link: LinkInertia, tensor: Tensor) -> Joint | None:
    """The joint whose effort is excessive for a new tensor of a link, but not for the present one.

    ``urdfkit simulate`` fails such a robot: a virtual link of 1 g between two joints of a hand.
    """
    joint = link.body.joint
    if joint is None or is_effort_excessive(joint, link.body.properties):
        return None
    parts = (
        own._replace(tensor=inertia.rotated(tensor, (frame @ link.inertial.origin).rotation))
        if part is link.link
        else own
        for part, frame in link.body.links
        for own in (properties_of(part, frame),)
    )
    return joint if is_effort_excessive(joint, inertia.combined(parts)) else None


def advice(link: LinkInertia, diagnosis: Diagnosis) -> str:
    """Advice about a tensor, in one line; empty if the help of the rule is sufficient."""
    if diagnosis.tensor and (joint := excessive_joint(link, diagnosis.tensor)):
        return f"give it more mass first: joint '{joint.name}' has too much effort for less inertia"
    if not from_macro(link.at):
        return str(diagnosis)
    where = "correct it in the macro, or in the values that it is called with"
    return f"the tensor {diagnosis.cause}; {where}" if diagnosis.cause else ""


def format_tensor(tensor: Tensor) -> str:
    """The attributes of a tensor, without products of inertia that are 0."""
    texts = zip(Tensor._fields, _digits(tensor), strict=True)
    return " ".join(f'{key}="{text}"' for key, text in texts if text != "0" or key[1] == key[2])


def _digits(tensor: Tensor) -> list[str]:
    """The values with six digits; products that result from rounded angles are 0."""
    least = PRODUCT_ROUNDING * max(map(abs, tensor))
    rows = zip(Tensor._fields, tensor, strict=True)
    return [
        f"{value:.6g}" if key[1] == key[2] or abs(value) > least else "0" for key, value in rows
    ]


def replacement(link: LinkInertia, tensor: Tensor | None) -> Fix | None:
    """A fix that replaces a tensor that is written as numbers.

    Correct entries keep their text; moved entries and entries with changed sign keep their digits.
    None if the effort of a joint is too large for the tensor.
    """
    if tensor is None or excessive_joint(link, tensor):
        return None
    changed = _changed(link, tensor)
    attributes = link.at.attributes
    edits = all_or_none(replace_value(attributes[key], text) for key, text in changed.items())
    title = " ".join(f'{key}="{text}"' for key, text in changed.items())
    return Fix.of(f"write {title}", edits)


def _changed(link: LinkInertia, tensor: Tensor) -> dict[str, str]:
    """The new texts of the wrong entries, by name."""
    texts = {key: link.at.attributes[key].value.strip() for key in Tensor._fields}
    written_as = {-old: _negated(texts[key]) for key, old in link.tensor._asdict().items()}
    written_as |= {old: texts[key] for key, old in link.tensor._asdict().items()}
    new = {
        key: (written_as.get(value) if value else None) or text
        for (key, value), text in zip(tensor._asdict().items(), _digits(tensor), strict=True)
    }
    wrong = [key for key in Tensor._fields if number(texts[key]) != number(new[key])]
    worse = [key for key in wrong if new[key] in written_as.values() or _differs(key, link, tensor)]
    mixed = tensor._replace(
        **{key: old for key, old in link.tensor._asdict().items() if key not in worse}
    )
    return {key: new[key] for key in (worse if is_possible(mixed) else wrong)}


def _negated(text: str) -> str:
    return text[1:] if text.startswith("-") else f"-{text.removeprefix('+')}"


def _differs(key: str, link: LinkInertia, tensor: Tensor) -> bool:
    """True if an entry differs from the computed one by more than its digits explain."""
    old, value = getattr(link.tensor, key), getattr(tensor, key)
    bound = (EXACT_RATIO - 1) * abs(value)
    if key[1] != key[2]:
        bound = PRODUCT_ROUNDING * max(map(abs, tensor))
    return bool(abs(old - value) > bound)


def describe_solid(link: LinkInertia) -> str:
    """The tensor of the shape as text, such as ``a solid sphere of radius 0.1 m has 0.004 ...``."""
    expected = link.expected
    assert expected is not None
    moments = format_moments((expected.ixx, expected.iyy, expected.izz))
    article = "the" if link.solid and len(link.solid.parts) > 1 else "a"
    return f"{article} solid {link.solid} has {moments}"


def format_moments(numbers: Iterable[float]) -> str:
    """Moments with three digits and their unit, such as ``0.1, 0.1, 0.2 kg·m²``."""
    texts = [f"{value:.3g}" for value in numbers]
    return f"{texts[0]} kg·m² each" if len({*texts}) == 1 else f"{', '.join(texts)} kg·m²"
