"""The masses and inertia tensors of a robot, and their defects."""

from collections.abc import Callable, Iterable
from functools import cached_property

from urdfkit.robot.inertia import principal_moments
from urdfkit.robot.inertials.defects import InertiaDefect
from urdfkit.robot.inertials.link_comparison import SIGNIFICANT, LinkInertia, by_tensor
from urdfkit.robot.model import Body, Link, RobotModel, Tensor
from urdfkit.robot.rigid_bodies import NO_MASS, RigidBody, rigid_bodies
from urdfkit.robot.shapes import MeshSolid
from urdfkit.robot.symmetry import numbered_pairs, pairs
from urdfkit.robot.tree import KinematicTree
from urdfkit.robot.values import number
from urdfkit.text.document import Element, Tag

#: Masses this close together may well share a tensor that a macro holds.
SAME_MASS = 1.05

#: Masses of links that share a tensor, largest by smallest, over which it cannot fit all of them.
SPREAD = 1.5

#: How far counterparts may differ in mass and in moments: real parts are not quite symmetric.
PAIR_MASS, PAIR_MOMENTS = 1.2, 1.5

#: Links of implausible density, of more than half of those whose density is known, have one cause.
COMMON_CAUSE = 3

#: The smallest moment of inertia in kg·m² that MuJoCo takes for one: its mjMINVAL.
LEAST_MOMENT = 1e-15

#: A smallest moment that is this part of the largest is zero to a solver.
SINGULAR = 1e-9


class Masses:
    """What a model says about masses.

    Args:
        mesh_solid: measures visuals and collisions that are meshes; without it they are left out.
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
        """The rigid body that each link is a part of, by the name of the link."""
        return {link.name: body for body in self.bodies for link, _ in body.links}

    @cached_property
    def inertias(self) -> tuple[LinkInertia, ...]:
        """The links with a positive mass and a tensor, in the order of the document."""
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
        """The same by the name of the link; the first of each name."""
        return {one.name: one for one in reversed(self.inertias)}

    @cached_property
    def of_their_shape(self) -> dict[Tensor, LinkInertia]:
        """The first link for each tensor that equals that of the link's own shape."""
        return {one.tensor: one for one in reversed(self.inertias) if one.is_of_shape}

    @cached_property
    def defects(self) -> dict[InertiaDefect, list[LinkInertia]]:
        """The links with each defect of mass or inertia."""
        from urdfkit.robot.inertials.defects import find_defects

        return find_defects(self.inertias, self.matters, self._with_shared_tensor)

    @cached_property
    def consistently_wrong(self) -> list[LinkInertia]:
        """The links with implausible densities, if they are most and all too high, or too low.

        One mistake caused them, such as a unit of the whole robot.
        """
        from urdfkit.robot.inertials.defects import HEAVIEST, InertiaDefect

        dense = self.defects.get(InertiaDefect.DENSITY, [])
        if len(dense) < COMMON_CAUSE or 2 * len(dense) <= sum(
            bool(w.densities) for w in self.inertias
        ):
            return []
        are_high = {bool(w.densities and w.densities[0] > HEAVIEST) for w in dense}
        return dense if len(are_high) == 1 else []

    def moments_of(self, body: RigidBody) -> tuple[float, float, float]:
        """The principal moments of a rigid body as a whole, smallest first, in kg·m²."""
        name = body.top.name
        if name not in self._moments:
            self._moments[name] = principal_moments(body.properties.tensor)
        return self._moments[name]

    def matters(self, body: RigidBody, moment: float) -> bool:
        """True if a moment of inertia in kg·m² is a noticeable part of a rigid body's."""
        return moment >= SIGNIFICANT * self.moments_of(body)[2]

    @property
    def without_inertia(self) -> list[RigidBody]:
        """The bodies that joints move, have a mass, and have no moment of inertia at all."""
        return [
            body
            for body in self.bodies
            if body.joint and body.mass > 0 and self.moments_of(body)[2] <= LEAST_MOMENT
        ]

    @property
    def singular(self) -> list[RigidBody]:
        """The bodies that joints move and that have no moment of inertia about some axis."""
        from urdfkit.robot.inertials.defects import InertiaDefect

        impossible = (InertiaDefect.INDEFINITE, InertiaDefect.TRIANGLE_INEQUALITY)
        wrong = {one.body.top.name for key in impossible for one in self.defects.get(key, ())}
        found = []
        for body in self.bodies:
            if body.joint and body.mass > 0 and body.top.name not in wrong:
                low, _, high = self.moments_of(body)
                if high > LEAST_MOMENT and low <= SINGULAR * high:
                    found.append(body)
        return found

    def overloaded(self, ratio: float) -> list[tuple[RigidBody, float]]:
        """The bodies that joints move and that carry this many times their own mass, in kg."""
        carried = {body.top.name: 0.0 for body in self.bodies}
        found = []
        for body in reversed(self.bodies):  # leaves first
            mass, load = body.mass, carried[body.top.name]
            if body.joint:
                carried[self.body_of[body.joint.parent_name].top.name] += mass + load
                if mass > NO_MASS and load > ratio * mass:
                    found.append((body, load))
        return found[::-1]

    @cached_property
    def symmetric_pairs(self) -> list[tuple[LinkInertia, LinkInertia]]:
        """The links of the left and of the right that are children of one link, or of a pair."""
        named = pairs(self.tree.parents)
        numbered = numbered_pairs(
            {
                name: joints[0].origin.position
                for name, joints in self.tree.parents.items()
                if joints
            }
        )
        known = {*named, *((right, left) for left, right in named)}
        found = []
        for left, right in (*named, *numbered):
            above = self._parent(left), self._parent(right)
            mirrored = above[0] == above[1] or above in known
            if mirrored and left in self.by_name and right in self.by_name:
                found.append((self.by_name[left], self.by_name[right]))
        return found

    def counterpart(self, link: LinkInertia) -> LinkInertia | None:
        """The link on the other side of the robot, if its mass is the same."""
        for left, right in self.symmetric_pairs:
            if link in (left, right) and unlike(left, right) != "mass":
                return right if link is left else left
        return None

    def _parent(self, name: str) -> str:
        joint = next(iter(self.tree.parents[name]), None)
        return joint.parent_name if joint else ""

    @property
    def _defective(self) -> list[LinkInertia]:
        """The links with a defect other than a tensor unlike that of their shape."""
        from urdfkit.robot.inertials.defects import InertiaDefect

        others = (key for key in self.defects if key is not InertiaDefect.UNLIKE_SHAPE)
        return [one for key in others for one in self.defects[key]]

    @cached_property
    def asymmetric_pairs(self) -> list[tuple[LinkInertia, LinkInertia]]:
        """Pairs of which one has clearly more mass or larger moments, without another defect."""
        wrong = {one.name for one in self._defective}
        wrong |= {link.name for body in self.without_inertia for link, _ in body.links}
        return [
            (left, right)
            for left, right in self.symmetric_pairs
            if wrong.isdisjoint((left.name, right.name))
            and any(one.mass >= SIGNIFICANT * one.body.mass for one in (left, right))
            and unlike(left, right)
        ]

    @cached_property
    def shared_by_macro(self) -> dict[Tag, list[Link]]:
        """The links of different mass to which one macro gives one tensor, written as numbers."""
        groups: dict[Tag, list[Link]] = {}
        for link in self.model.links:
            tensor = link.inertial.at.child("inertia") if link.inertial else None
            if tensor is not None and _is_written_out(tensor):
                groups.setdefault(tensor.tag_at, []).append(link)
        return {tag: links for tag, links in groups.items() if _spread(links) > SAME_MASS}

    @cached_property
    def _with_shared_tensor(self) -> set[str]:
        """The names of the links with such a tensor."""
        return {link.name for links in self.shared_by_macro.values() for link in links}

    @property
    def copies(self) -> list[list[LinkInertia]]:
        """The links of clearly different mass that have the same tensor, if no rule says so."""
        reported = {one.tensor for one in self._defective}
        reported.update(w.tensor for pair in self.asymmetric_pairs for w in pair)
        free = (
            w
            for w in self.inertias
            if w.tensor not in reported
            and w.name not in self._with_shared_tensor
            and not (w.is_noise or w.body.is_ground)
        )
        return [
            group
            for group in by_tensor(free)
            if _spread(w.link for w in group) > SPREAD
            and any(self.matters(w.body, w.moments[2]) for w in group)
        ]


def unlike(left: LinkInertia, right: LinkInertia) -> str:
    """What differs between two links beyond tolerance: ``mass``, ``inertia``, or nothing."""
    light, heavy = sorted((left.mass, right.mass))
    if heavy > PAIR_MASS * light:
        return "mass"
    for a, b in zip(left.moments, right.moments, strict=True):
        low, high = sorted((a, b))
        if high > PAIR_MOMENTS * max(low, SIGNIFICANT * max(left.moments[2], right.moments[2])):
            return "inertia"
    return ""


def _spread(links: Iterable[Link]) -> float:
    """The largest mass by the smallest, of those that have one."""
    masses = sorted(filter(None, (link.mass for link in links)))
    return masses[-1] / masses[0] if masses and masses[0] > 0 else 0.0


def _is_written_out(tensor: Element) -> bool:
    """True for a tensor other than zero whose numbers stand in a macro."""
    in_macro = tensor.frame is not None and tensor.frame.definition is not None
    attributes = tensor.attributes.values()
    return (
        in_macro
        and any(number(attribute.value) for attribute in attributes)
        and all(attribute.literal for attribute in attributes)
    )
