"""Why a tensor is wrong and what was probably meant, for the rules that find one.

A diagnosis is a guess that the numbers bear out: put right in this way, they agree with the shape
of the link, or become possible at all. It says how sure it is.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from urdfkit.diagnostic import Confidence, Fix, Related
from urdfkit.editing.edits import all_or_none, from_macro, replace_value
from urdfkit.inertials.claims import HEAVIEST
from urdfkit.inertials.weighed import EXACT, ROUNDING, Weighed
from urdfkit.mechanics import inertia
from urdfkit.model import Tensor, number
from urdfkit.record import Record
from urdfkit.rules import Finding
from urdfkit.spatial import rotate, transposed
from urdfkit.static import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.inertials.masses import Masses

#: Units of CAD programs in kg m^2; 1 lb is 0.45359237 kg and 1 in is 0.0254 m by definition.
UNITS = (
    ("g mm^2", 1e-9),
    ("g cm^2", 1e-7),
    ("kg mm^2", 1e-6),
    ("kg cm^2", 1e-4),
    ("lb in^2", 0.45359237 * 0.0254**2),
    ("lb ft^2", 0.45359237 * 0.3048**2),
)

#: Put right, the moments must be this near to those of the shape, as a factor.
NEAR = 1.5

#: Products of inertia below this part of the largest moment come from angles such as 1.5708.
CLEAR = 1e-4

#: Moments nearer to one another than this factor are as good as equal.
_EVEN = 1.01

#: Places that a finding about many links lists beside the first.
MAX_RELATED = 20


class Diagnosis(Record):
    """What is probably wrong with a tensor.

    Attributes:
        cause: after "the tensor", such as ``is in g mm^2``; empty if nothing explains it.
        tensor: that was meant, in kg m^2; None if the numbers do not tell it.
        confidence: how sure the proposal is.
    """

    cause: str
    tensor: Tensor | None
    confidence: Confidence

    def __str__(self) -> str:
        """The cause and what to do, in one line; empty without a cause and a tensor."""
        if self.tensor is None:
            return f"the tensor {self.cause}" if self.cause else ""
        if not self.cause:
            return f"write {written(self.tensor)}"
        if self.confidence is Confidence.GUESSED:
            return f"perhaps the tensor {self.cause}; then it is {written(self.tensor)}"
        return f"the tensor {self.cause}: write {written(self.tensor)}"


def of_unlike_shape(weighed: Weighed, masses: Masses) -> Diagnosis:
    """Why a tensor is not that of the shape of its link; without a cause, that of the shape."""
    expected = weighed.expected
    assert expected is not None
    for cause, tensor in _slips(weighed, expected):
        return Diagnosis(cause, tensor, Confidence.INFERRED)
    other = masses.of_their_shape.get(weighed.tensor)
    cause = f"is that of link '{other.link.name}', which it fits" if other else ""
    return Diagnosis(cause, _of_shape(weighed), Confidence.INFERRED)


def _of_shape(weighed: Weighed) -> Tensor | None:
    """The tensor of the shape; None where that marks a place, or is too small for the mass."""
    is_other = weighed.is_marker or (weighed.densities and weighed.densities[0] > HEAVIEST)
    return None if is_other else weighed.expected


def _slips(weighed: Weighed, expected: Tensor) -> Iterator[tuple[str, Tensor]]:
    """Slips without which the tensor agrees with the shape, each with the tensor meant."""
    if weighed.is_at_wrong_axes:
        yield "has its moments at the wrong axes", expected
    # Three equal moments of a shape that has none were made up, in whatever unit they fit.
    if not weighed.is_placeholder and (_is_even(expected) or not _is_even(weighed.tensor)):
        for unit, factor in UNITS:
            tensor = inertia.scaled(weighed.tensor, factor)
            if inertia.agree(tensor, expected, NEAR):
                yield f"is in {unit}", tensor
    about_center = _shifted_from_origin(weighed, -weighed.mass)
    if about_center != weighed.tensor and inertia.agree(about_center, expected, NEAR):
        yield "is about the origin of the link, not the centre of mass", about_center
    twice = weighed.expected_of_twice
    if weighed.is_diagonal and twice is not None and weighed.fits(twice, EXACT):
        yield "was computed with twice the size, as of a diameter for a radius", expected


def _is_even(tensor: Tensor) -> bool:
    """True for the tensor of a ball or a cube."""
    moments = (tensor.ixx, tensor.iyy, tensor.izz)
    products = max(map(abs, (tensor.ixy, tensor.ixz, tensor.iyz)))
    return max(moments) <= _EVEN * min(moments) and products <= (_EVEN - 1) * max(moments)


def of_impossible(weighed: Weighed, masses: Masses) -> Diagnosis:
    """Why no body can have a tensor, and which was meant if the numbers tell it."""
    for cause, tensor in _rewritten(weighed):
        return Diagnosis(cause, tensor, Confidence.GUESSED)
    for twin in _twins(weighed, masses):
        mirrored = twin.tensor._replace(ixy=-twin.tensor.ixy, iyz=-twin.tensor.iyz)
        if is_possible(mirrored):
            cause = f"of its twin '{twin.link.name}' is possible"
            return Diagnosis(cause, mirrored, Confidence.INFERRED)
    if weighed.is_measured:
        return Diagnosis("", _of_shape(weighed), Confidence.INFERRED)
    return Diagnosis("", None, Confidence.GUESSED)


def _rewritten(weighed: Weighed) -> Iterator[tuple[str, Tensor | None]]:
    """Ways of writing it that make the tensor possible, each with the tensor meant."""
    a, b, c, d, e, f = weighed.tensor
    as_in_sdf = Tensor(a, d, e, b, f, c)
    if min(a, b, c) > 0 and is_possible(as_in_sdf):
        yield "is in the order ixx iyy izz ixy ixz iyz", as_in_sdf
    if b == d and e > 0 and abs(f) <= e and a > 0 and len({*weighed.tensor}) > 1:
        rows = "holds the first two rows of the matrix, so that the value at iyz is iyy"
        yield f"{rows}, the one at izz is iyz, and izz is missing", None
    positive = Tensor(abs(a), b, c, abs(d), e, abs(f))
    if positive != weighed.tensor and is_possible(positive):
        yield "has a negative moment that is possible when positive", positive
    turned = Tensor(a, -b, -c, d, -e, f)
    if turned != weighed.tensor and is_possible(turned):
        yield "has products of inertia with the opposite sign", turned
    for key in ("ixx", "iyy", "izz"):
        tenth = weighed.tensor._replace(**{key: getattr(weighed.tensor, key) / 10})
        diagonal = (tenth.ixx, tenth.iyy, tenth.izz)
        if is_possible(tenth) and max(diagonal) <= 2 * min(diagonal):
            yield f"has {key} ten times too large", tenth


def _twins(weighed: Weighed, masses: Masses) -> Iterator[Weighed]:
    for left, right in masses.twins:
        if weighed in (left, right):
            yield right if weighed is left else left


def is_possible(tensor: Tensor) -> bool:
    """True if some body can have the tensor."""
    low, middle, high = inertia.principal_moments(tensor)
    return low > 0 and high <= (low + middle) * (1 + ROUNDING)


def _shifted_from_origin(weighed: Weighed, mass: float) -> Tensor:
    """The tensor moved between the centre of mass and the origin of the link."""
    origin = weighed.inertial.origin
    offset = rotate(transposed(origin.rotation), origin.position)
    return inertia.shifted(weighed.tensor, mass, offset)


def advice(weighed: Weighed, diagnosis: Diagnosis) -> str:
    """What to do about a tensor, in one line; empty if the help of the rule says it."""
    if not from_macro(weighed.at):
        return str(diagnosis)
    return f"the tensor {diagnosis.cause}; compute it in the macro" if diagnosis.cause else ""


def written(tensor: Tensor) -> str:
    """The attributes of a tensor; products of inertia only where there are any."""
    texts = zip(Tensor._fields, _digits(tensor), strict=True)
    return " ".join(f'{key}="{text}"' for key, text in texts if text != "0" or key[1] == key[2])


def _digits(tensor: Tensor) -> list[str]:
    """The numbers to six digits, without what the rounding of an angle makes of zero."""
    least = CLEAR * max(map(abs, tensor))
    rows = zip(Tensor._fields, tensor, strict=True)
    return [
        f"{value:.6g}" if key[1] == key[2] or abs(value) > least else "0" for key, value in rows
    ]


def replacement(weighed: Weighed, tensor: Tensor | None) -> Fix | None:
    """A fix that writes a tensor in the place of one that stands in the file as numbers."""
    if tensor is None:
        return None
    attributes = [weighed.at.attributes[key] for key in Tensor._fields]
    edits = all_or_none(
        replace_value(attribute, text)
        for attribute, text in zip(attributes, _digits(tensor), strict=True)
        if number(attribute.value) != float(text)
    )
    return Fix.of(f"write {written(tensor)}", edits)


def as_solid(weighed: Weighed) -> str:
    """What the shape of a link has, such as ``a solid sphere of radius 0.1 m has 0.004 ...``."""
    expected = weighed.expected
    assert expected is not None
    moments = values((expected.ixx, expected.iyy, expected.izz))
    article = "the" if weighed.solid and len(weighed.solid.parts) > 1 else "a"
    return f"{article} solid {weighed.solid} has {moments}"


def values(numbers: Iterable[float]) -> str:
    """Moments to three digits with their unit, such as ``0.1, 0.1, 0.2 kg m^2``."""
    texts = [f"{value:.3g}" for value in numbers]
    return f"{texts[0]} kg m^2 each" if len({*texts}) == 1 else f"{', '.join(texts)} kg m^2"


def together(
    findings: Iterable[tuple[Weighed, Finding]],
    by: Callable[[Weighed], object] = lambda weighed: weighed.tensor,
) -> Iterator[Finding]:
    """Findings about copies of one tensor as one, the worst first.

    ``by`` gives what the copies have in common, where that is less than the whole tensor.
    What a macro wrote stays apart: the engine makes one finding of it, with its calls.
    """
    groups: dict[object, list[tuple[Weighed, Finding]]] = {}
    for weighed, finding in findings:
        if from_macro(weighed.at):
            yield finding
        else:
            groups.setdefault(by(weighed), []).append((weighed, finding))
    for group in groups.values():
        group.sort(key=lambda pair: -pair[1].weight)
        (_, worst), *others = group
        if not others:
            yield worst
            continue
        yield worst._replace(
            message=f"{worst.message} ({and_more(others)})",
            related=tuple(Related(one.at.span, one.message) for _, one in others[:MAX_RELATED]),
            fix=_merged([finding.fix for _, finding in group if finding.fix]),
        )


def _merged(fixes: list[Fix]) -> Fix | None:
    """Several fixes as one."""
    if len(fixes) < 2:
        return fixes[0] if fixes else None
    edits = tuple(edit for fix in fixes for edit in fix.edits)
    return Fix(f"write the tensors of {len(fixes)} shapes", edits)


def and_more(others: list[tuple[Weighed, Finding]]) -> str:
    """Such as ``and likewise 'b', 'c' and 3 more``."""
    names = [f"'{weighed.link.name}'" for weighed, _ in others]
    if len(names) > 3:
        names = [*names[:2], f"{len(names) - 2} more"]
    return "and likewise " + " and ".join(filter(None, (", ".join(names[:-1]), names[-1])))
