"""Masses and inertia tensors of a robot, and their defects."""

from collections.abc import Callable, Iterable
from functools import cached_property

from urdfkit.robot.inertia import principal_moments
from urdfkit.robot.inertials.defects import MAX_PART_DENSITY, InertiaDefect, find_defects
from urdfkit.robot.inertials.link_comparison import SIGNIFICANT_PART, LinkInertia, by_tensor
from urdfkit.robot.link import Body, Link, Tensor
from urdfkit.robot.model import RobotModel
from urdfkit.robot.rigid_bodies import NO_MASS, RigidBody, rigid_bodies
from urdfkit.robot.shapes import MeshSolid
from urdfkit.robot.symmetry import numbered_pairs, pairs
from urdfkit.robot.tree import KinematicTree
from urdfkit.robot.values import number
from urdfkit.text.document import Element, Tag

#: Links with masses up to this ratio may share the tensor of a macro.
SAME_MASS = 1.2

#: Ratio of the masses of links with the same tensor above which it cannot fit all of them.
MAX_MASS_RATIO = 1.5

#: Largest ratios of mass and moments between counterparts: real parts are not quite symmetric.
PAIR_MASS, PAIR_MOMENTS = 1.2, 1.5

#: The same for the only pair that differs, where at least so many pairs are equal but for rounding.
ONLY_PAIR, _EQUAL, _EQUAL_PAIRS = 1.05, 1.001, 4

#: This many links of implausible density, if most of the known ones, have a common cause.
COMMON_CAUSE = 3

#: The smallest moment of inertia in kg·m² that MuJoCo accepts: its mjMINVAL.
LEAST_MOMENT = 1e-15

#: Ratio of the smallest to the largest moment below which a solver sees a singular tensor.
SINGULAR = 1e-9


class Masses:
    """Masses and inertia tensors of a model.

    Args:
        mesh_solid: returns a mesh as a solid; without it meshes are ignored.
    """

    def __init__(
        self,
        model: RobotModel,
        tree: KinematicTree,
        mesh_solid: Callable[[Body], MeshSolid | None] | None = None,
    ) -> None:
        self._mesh_solid = mesh_solid
        #: model and tree: of the robot.
        self.model = model
        self.tree = tree
        self.bodies = rigid_bodies(tree)  # the rigid bodies, each before its children
        self.total = model.mass  # the mass of all links in kg
        self._moments: dict[str, tuple[float, float, float]] = {}

    @cached_property
    def body_of(self) -> dict[str, RigidBody]:
        """The rigid body of each link, by the name of the link."""
        return {name: body for body in self.bodies for name in body.names}

    @cached_property
    def inertias(self) -> tuple[LinkInertia, ...]:
        """The links with a positive mass and a tensor, in document order."""
        return tuple(
            LinkInertia(link, inertial, inertial.tensor.value, body, self._mesh_solid)
            for link in self.model.links
            if (inertial := link.inertial)
            and inertial.tensor
            and (body := self.body_of.get(link.name))
            and link.mass > 0
        )

    @cached_property
    def by_name(self) -> dict[str, LinkInertia]:
        """``inertias`` by link name; the first of each name."""
        return {link.name: link for link in reversed(self.inertias)}

    @cached_property
    def of_their_shape(self) -> dict[Tensor, LinkInertia]:
        """The first link for each tensor that equals the tensor of its shape."""
        return {link.tensor: link for link in reversed(self.inertias) if link.is_of_shape}

    @cached_property
    def defects(self) -> dict[InertiaDefect, list[LinkInertia]]:
        """The links with each defect of mass or inertia."""
        return find_defects(self.inertias, self.is_significant, self._with_shared_tensor)

    @cached_property
    def consistently_wrong(self) -> list[LinkInertia]:
        """The links with implausible densities if they are the majority and all too high or low.

        One mistake caused them, such as a wrong unit of the whole robot.
        """
        dense = self.defects.get(InertiaDefect.DENSITY, [])
        if len(dense) < COMMON_CAUSE or 2 * len(dense) <= sum(
            bool(link.densities) for link in self.inertias
        ):
            return []
        are_high = {bool(link.densities and link.densities[0] > MAX_PART_DENSITY) for link in dense}
        return dense if len(are_high) == 1 else []

    def moments_of(self, body: RigidBody) -> tuple[float, float, float]:
        """The principal moments of a rigid body, smallest first, in kg·m²."""
        name = body.top.name
        if name not in self._moments:
            self._moments[name] = principal_moments(body.properties.tensor)
        return self._moments[name]

    def is_significant(self, body: RigidBody, moment: float) -> bool:
        """True if a moment in kg·m² is a significant part of the moments of a rigid body."""
        return moment >= SIGNIFICANT_PART * self.moments_of(body)[2]

    @property
    def without_inertia(self) -> list[RigidBody]:
        """The bodies with a joint and a mass, but without any moment of inertia."""
        return [
            body
            for body in self.bodies
            if body.joint and body.mass > 0 and self.moments_of(body)[2] <= LEAST_MOMENT
        ]

    @property
    def singular(self) -> list[RigidBody]:
        """The bodies with a joint and a mass, but without a moment of inertia about some axis."""
        impossible = (InertiaDefect.INDEFINITE, InertiaDefect.TRIANGLE_INEQUALITY)
        wrong = {link.body.top.name for key in impossible for link in self.defects.get(key, ())}
        bodies = []
        for body in self.bodies:
            if body.joint and body.mass > 0 and body.top.name not in wrong:
                low, _, high = self.moments_of(body)
                if high > LEAST_MOMENT and low <= SINGULAR * high:
                    bodies.append(body)
        return bodies

    def overloaded(self, ratio: float) -> list[tuple[RigidBody, float]]:
        """The bodies with a joint that carry ``ratio`` times their mass, with the load in kg."""
        carried = {body.top.name: 0.0 for body in self.bodies}
        bodies = []
        for body in reversed(self.bodies):  # leaves first
            mass, load = body.mass, carried[body.top.name]
            if body.joint:
                carried[self.body_of[body.joint.parent_name].top.name] += mass + load
                if mass > NO_MASS and load > ratio * mass:
                    bodies.append((body, load))
        return bodies[::-1]

    @cached_property
    def symmetric_pairs(self) -> list[tuple[LinkInertia, LinkInertia]]:
        """Left/right pairs of links whose parents are one link or a pair."""
        named = pairs(self.tree.parents)
        numbered = numbered_pairs(
            {
                name: joints[0].origin.position
                for name, joints in self.tree.parents.items()
                if joints
            }
        )
        all_pairs = {*named, *((right, left) for left, right in named)}
        symmetric = []
        for left, right in (*named, *numbered):
            above = self._parent(left), self._parent(right)
            mirrored = above[0] == above[1] or above in all_pairs
            if mirrored and left in self.by_name and right in self.by_name:
                symmetric.append((self.by_name[left], self.by_name[right]))
        return symmetric

    def counterpart(self, link: LinkInertia) -> LinkInertia | None:
        """The left/right counterpart of a link, if its mass is the same."""
        for left, right in self.symmetric_pairs:
            if link in (left, right) and unlike(left, right) != "mass":
                return right if link is left else left
        return None

    def _parent(self, name: str) -> str:
        joint = next(iter(self.tree.parents[name]), None)
        return joint.parent_name if joint else ""

    @property
    def _defective(self) -> list[LinkInertia]:
        """The links with a defect other than a tensor that differs from the shape."""
        others = (key for key in self.defects if key is not InertiaDefect.UNLIKE_SHAPE)
        return [link for key in others for link in self.defects[key]]

    @cached_property
    def asymmetric_pairs(self) -> list[tuple[LinkInertia, LinkInertia]]:
        """Pairs with clearly different mass or moments, without another defect.

        Also the only pair that differs noticeably, if the others are equal.
        """
        wrong = {link.name for link in self._defective}
        wrong |= {name for body in self.without_inertia for name in body.names}
        return [
            (left, right)
            for left, right in self.symmetric_pairs
            if wrong.isdisjoint((left.name, right.name))
            and any(link.mass >= SIGNIFICANT_PART * link.body.mass for link in (left, right))
            and (unlike(left, right) or (left, right) == self.only_unequal_pair)
        ]

    @cached_property
    def only_unequal_pair(self) -> tuple[LinkInertia, LinkInertia] | None:
        """The pair that alone differs in mass or moments; None if there are few others."""
        unequal = [pair for pair in self.symmetric_pairs if unlike(*pair, _EQUAL, _EQUAL)]
        is_only = len(unequal) == 1 and len(self.symmetric_pairs) > _EQUAL_PAIRS
        return unequal[0] if is_only and unlike(*unequal[0], ONLY_PAIR, ONLY_PAIR) else None

    @cached_property
    def shared_by_macro(self) -> dict[Tag, list[Link]]:
        """Links of different mass whose tensor is written as numbers in one macro."""
        groups: dict[Tag, list[Link]] = {}
        for link in self.model.links:
            tensor = link.inertial.at.child("inertia") if link.inertial else None
            if tensor is not None and _is_written_out(tensor):
                groups.setdefault(tensor.tag_at, []).append(link)
        return {tag: links for tag, links in groups.items() if _spread(links) > SAME_MASS}

    @cached_property
    def _with_shared_tensor(self) -> set[str]:
        """Names of the links in ``shared_by_macro``."""
        return {link.name for links in self.shared_by_macro.values() for link in links}

    @property
    def copies(self) -> list[list[LinkInertia]]:
        """Links of clearly different mass with the same tensor, if no other rule reports them."""
        reported = {link.tensor for link in self._defective}
        reported.update(link.tensor for pair in self.asymmetric_pairs for link in pair)
        free = (
            link
            for link in self.inertias
            if link.tensor not in reported
            and link.name not in self._with_shared_tensor
            and not (link.is_negligible or link.body.is_ground)
        )
        return [
            group
            for group in by_tensor(free)
            if _spread(link.link for link in group) > MAX_MASS_RATIO
            and any(self.is_significant(link.body, link.moments[2]) for link in group)
        ]


def unlike(
    left: LinkInertia,
    right: LinkInertia,
    mass_ratio: float = PAIR_MASS,
    moment_ratio: float = PAIR_MOMENTS,
) -> str:
    """The property that differs between two links: ``mass``, ``inertia``, or empty."""
    light, heavy = sorted((left.mass, right.mass))
    if heavy > mass_ratio * light:
        return "mass"
    noticeable = SIGNIFICANT_PART * max(left.moments[2], right.moments[2])
    for a, b in zip(left.moments, right.moments, strict=True):
        low, high = sorted((a, b))
        if high > moment_ratio * max(low, noticeable):
            return "inertia"
    return ""


def _spread(links: Iterable[Link]) -> float:
    """Ratio of the largest to the smallest mass, without missing ones."""
    masses = sorted(filter(None, (link.mass for link in links)))
    return masses[-1] / masses[0] if masses and masses[0] > 0 else 0.0


def _is_written_out(tensor: Element) -> bool:
    """True for a nonzero tensor that is written as numbers in a macro."""
    in_macro = tensor.frame is not None and tensor.frame.definition is not None
    attributes = tensor.attributes.values()
    return (
        in_macro
        and any(number(attribute.value) for attribute in attributes)
        and all(attribute.literal for attribute in attributes)
    )
