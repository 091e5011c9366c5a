"""Comparison of declared inertias with those of the shapes; edits that replace them."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from math import dist

from urdfkit.core.record import Record
from urdfkit.core.spatial import IDENTITY, ORIGIN, Transform, Vector
from urdfkit.core.words import spaced
from urdfkit.robot import Robot
from urdfkit.robot.inertia import ZERO, MassProperties, combined, principal_moments
from urdfkit.robot.inertials.shape_mass import ShapeMass, shape_mass
from urdfkit.robot.inertials.tensor_text import PRODUCT_ROUNDING
from urdfkit.robot.link import Inertial, Link, Tensor
from urdfkit.robot.rigid_bodies import rigid_bodies
from urdfkit.robot.values import numbers
from urdfkit.text.diagnostic import Edit
from urdfkit.text.document import Element
from urdfkit.text.editing import rewriting
from urdfkit.text.editing.edits import (
    all_or_none,
    from_macro,
    insert_first,
    insert_last,
    replace_value,
)
from urdfkit.text.editing.rewriting import Rewrite

#: Moments up to this ratio were computed from the same shape.
SAME_SHAPE_FACTOR = 1.03
#: Moments up to this ratio may be correct: real parts are not of uniform density.
PLAUSIBLE_FACTOR = 3.0
#: Tensors of the same moments have other axes if their distance exceeds this part of the largest.
_MAX_TENSOR_DISTANCE = 0.1
#: Offsets and moments below this relative value are rounding errors.
_NOISE = 1e-6


class InertiaProposal(Record):
    """The proposed inertia of a link, or of a rigid body by its topmost link."""

    link: Link  # the link
    links: tuple[str, ...]  # names of all links of the body; one unless they are lumped
    #: In the frame of the link; None if it is missing or incomplete.
    declared: MassProperties | None
    shape_mass: ShapeMass | None  # of its shapes; None if unknown
    computed: MassProperties | None  # with uniform density; None if shapes or mass are unknown
    reason: str  # why ``computed`` is None; empty otherwise

    @property
    def factor(self) -> float:
        """The largest ratio of the principal moments; 0 if one side is unknown."""
        if self.declared is None or self.computed is None:
            return 0.0
        pairs = zip(
            principal_moments(self.declared.tensor),
            principal_moments(self.computed.tensor),
            strict=True,
        )
        return max(max(a / b, b / a) if a > 0 and b > 0 else float("inf") for a, b in pairs)

    @property
    def verdict(self) -> str:
        """The result of the comparison.

        ``agrees``, ``near``, ``rotated``, ``differs``, ``impossible``, ``missing`` or ``unknown``.
        """
        if self.computed is None:
            return "unknown"
        if self.declared is None:
            return "missing"
        low, middle, high = principal_moments(self.declared.tensor)
        if low <= 0 or high > (low + middle) * 1.01:
            return "impossible"
        mass = self.declared.mass / self.computed.mass if self.computed.mass else 0.0
        if not 1 / PLAUSIBLE_FACTOR <= mass <= PLAUSIBLE_FACTOR or self.factor > PLAUSIBLE_FACTOR:
            return "differs"
        if self.factor > SAME_SHAPE_FACTOR:
            return "near"
        difference = dist(self.declared.tensor, self.computed.tensor)
        return "agrees" if difference <= _MAX_TENSOR_DISTANCE * high else "rotated"

    @property
    def is_doubtful(self) -> bool:
        """True if the declared inertia should be replaced."""
        return self.verdict in ("rotated", "differs", "impossible", "missing")

    def lines(self) -> list[str]:
        """The computed inertia as an ``<inertial>``.

        Raises:
            ValueError: nothing is computed.
        """
        if self.computed is None:
            raise ValueError(self.reason)
        mass, center, tensor = _rounded(self.computed)
        return [
            "<inertial>",
            f'  <origin xyz="{spaced(center)}" rpy="0 0 0"/>',
            f'  <mass value="{mass:.6g}"/>',
            f"  {_inertia_tag(tensor)}",
            "</inertial>",
        ]


def propose(
    robot: Robot,
    *,
    source: str = "auto",
    mass: float | None = None,
    density: float | None = None,
    links: Collection[str] = (),
    lump: bool = False,
) -> tuple[InertiaProposal, ...]:
    """Declared and computed inertia of every link with a shape or an inertia.

    Args:
        source: one of `urdfkit.robot.inertials.shape_mass.SOURCES`.
        mass: of each link in kg, instead of the declared one.
        density: in kg/m³, to compute the mass instead.
        links: names of the links; all if empty.
        lump: treat links connected by fixed joints as one body.

    Raises:
        UnknownLink: one of the links is not in the robot.
    """
    for name in links:
        robot.model.require_link(name)
    if lump:
        groups = [body.links for body in rigid_bodies(robot.tree)]
    else:
        groups = [((link, Transform()),) for link in robot.model.links_by_name.values()]
    proposals = []
    for group in groups:
        if links and group[0][0].name not in links:
            continue
        each = [_proposal(robot, link, source, mass, density) for link, _ in group]
        proposal = _lumped(each, [frame for _, frame in group])
        if proposal.declared or proposal.shape_mass:
            proposals.append(proposal)
    return tuple(proposals)


def _proposal(
    robot: Robot, link: Link, source: str, mass: float | None, density: float | None
) -> InertiaProposal:
    declared = _declared(link.inertial)
    shapes = shape_mass(link, source, robot.measures)
    if isinstance(shapes, str):
        return InertiaProposal(link, (link.name,), declared, None, None, shapes)
    if mass is None:
        mass = density * shapes.properties.mass if density else link.mass
    if not mass > 0:
        reason = "no mass; pass --mass, --density or --material"
        return InertiaProposal(link, (link.name,), declared, shapes, None, reason)
    return InertiaProposal(link, (link.name,), declared, shapes, shapes.with_mass(mass), "")


def _declared(inertial: Inertial | None) -> MassProperties | None:
    if inertial is None or inertial.mass is None or inertial.tensor is None:
        return None
    own = MassProperties(inertial.mass.value, ORIGIN, inertial.tensor.value)
    return own.moved(inertial.origin)


def _lumped(parts: list[InertiaProposal], frames: list[Transform]) -> InertiaProposal:
    """Links as one body in the frame of the first; links without mass add nothing."""
    first = parts[0]
    if len(parts) == 1:
        return first
    links = tuple(name for part in parts for name in part.links)
    unknown = [
        part for part in parts if part.computed is None and (part.shape_mass or part.declared)
    ]
    placed = list(zip(parts, frames, strict=True))
    declared = [part.declared.moved(frame) for part, frame in placed if part.declared]
    computed = [part.computed.moved(frame) for part, frame in placed if part.computed]
    reason = "".join(f"link '{part.link.name}': {part.reason}" for part in unknown[:1])
    return InertiaProposal(
        first.link,
        links,
        combined(declared) if declared else None,
        next((part.shape_mass for part in parts if part.shape_mass), None),
        None if unknown or not computed else combined(computed),
        reason,
    )


def rewrites(proposals: Iterable[InertiaProposal]) -> tuple[tuple[Rewrite, ...], dict[str, str]]:
    """The files with the computed inertias, and the reasons for unchanged links.

    Only values that are written as numbers are edited. Nothing is written yet.

    Returns:
        The new files, and by link name the reason why the link is unchanged.
    """
    changes: list[Edit] = []
    unchanged: dict[str, str] = {}
    for proposal in proposals:
        edits = _edits(proposal)
        if isinstance(edits, str):
            unchanged[proposal.link.name] = edits
        else:
            changes += edits
    return rewriting.rewrites(changes), unchanged


def _edits(proposal: InertiaProposal) -> tuple[Edit, ...] | str:
    """The edits that write the computed inertia, or the reason why there are none."""
    if proposal.computed is None:
        return proposal.reason
    if len(proposal.links) > 1:
        return "it consists of several links; write each of them without --lump"
    inertial = proposal.link.inertial
    at = inertial.at if inertial else proposal.link.at
    if from_macro(at):
        return "a macro creates it; compute it in the macro"
    if inertial is None:
        return insert_first(at, proposal.lines())
    mass, center, tensor = _rounded(proposal.computed)
    moments = zip(Tensor._fields, (f"{value:.6g}" for value in tensor), strict=True)
    pieces = (
        _origin(inertial, center),
        _attributes(inertial.at, "mass", {"value": f"{mass:.6g}"}),
        _attributes(inertial.at, "inertia", dict(moments)),
    )
    edits = all_or_none(pieces)
    return "its values come from expressions; edit the expressions" if edits is None else edits


def _origin(inertial: Inertial, center: Vector) -> tuple[Edit, ...] | None:
    origin = inertial.at.child("origin")
    if origin is None and not any(center):
        return ()
    if inertial.origin.rotation == IDENTITY and inertial.origin.position == center:
        return ()
    values = {"xyz": spaced(center), "rpy": "0 0 0"}
    if origin is not None and "quat_xyzw" in origin.attributes:
        values["quat_xyzw"] = "0 0 0 1"
    return _attributes(inertial.at, "origin", values)


def _attributes(parent: Element, tag: str, values: dict[str, str]) -> tuple[Edit, ...] | None:
    """Edits that set the attributes of a child; None if an expression yields one."""
    child = parent.child(tag)
    text = "".join(f' {key}="{value}"' for key, value in values.items())
    if child is None:
        line = f"<{tag}{text}/>"
        return insert_first(parent, [line]) if tag == "origin" else insert_last(parent, [line])
    edits: list[Edit] = []
    for key, value in values.items():
        attribute = child.attributes.get(key)
        if attribute is None:
            if value not in ("0", "0 0 0"):
                return None
            continue
        if [f"{number:.6g}" for number in numbers(attribute.value) or ()] == value.split():
            continue
        piece = replace_value(attribute, value)
        if piece is None:
            return None
        edits += piece
    return tuple(edits)


def _rounded(properties: MassProperties) -> MassProperties:
    """Mass properties without rounding errors."""
    mass, center, tensor = properties
    largest = max(map(abs, tensor), default=0.0)
    reach = (largest / mass) ** 0.5 if mass > 0 else 0.0
    x, y, z = (0.0 if abs(value) < _NOISE * reach else value for value in center)
    products = PRODUCT_ROUNDING * largest
    moments = (
        value if abs(value) > (products if key[1] != key[2] else _NOISE * largest) else 0.0
        for key, value in zip(Tensor._fields, tensor, strict=True)
    )
    return MassProperties(mass, (x, y, z), Tensor(*moments) if largest else ZERO)


def _inertia_tag(tensor: Tensor) -> str:
    pairs = zip(Tensor._fields, tensor, strict=True)
    return "<inertia " + " ".join(f'{key}="{value:.6g}"' for key, value in pairs) + "/>"
