"""A robot after a program has imported the URDF."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

from urdfkit.core.record import Record
from urdfkit.core.spatial import ORIGIN, Transform
from urdfkit.robot.inertia import ZERO, MassProperties, combined, scaled
from urdfkit.robot.joint import Joint
from urdfkit.robot.link import Link
from urdfkit.robot.rigid_bodies import RigidBody, properties_of, rigid_bodies
from urdfkit.robot.tree import KinematicTree
from urdfkit.ros.importers.facts import ImporterFacts
from urdfkit.ros.importers.orders import WORLD, free_trees, ordered
from urdfkit.ros.mujoco import compiler_of

#: Mass properties of the collision shapes of a link at 1 kg/m³, in the frame of the link; None
#: if unknown. The second argument is the fact ``mesh_volume``.
Solid = Callable[["Link", str], "MassProperties | None"]


class ImportedJoint(Record):
    """A joint in an importing program."""

    joint: Joint  # of the URDF
    names: tuple[str, ...]  # of the resulting joints; several for a joint with several axes
    #: q and nq: index of its first position, and number of positions.
    q: int
    nq: int
    #: v and nv: index of its first velocity, and number of velocities.
    v: int
    nv: int


class ImportedBody(Record):
    """A body in an importing program."""

    name: str  # of the body; ``world`` for links that are part of the world
    links: tuple[Link, ...]  # links of the URDF that it consists of, the topmost first
    #: In the frame of the first link; None if unknown.
    properties: MassProperties | None

    @property
    def mass(self) -> float | None:
        """Mass in kg; None if unknown."""
        return None if self.properties is None else self.properties.mass


def dense(unit: MassProperties, density: float) -> MassProperties:
    """Mass properties at a density in kg/m³, from those at 1 kg/m³."""
    return MassProperties(unit.mass * density, unit.center, scaled(unit.tensor, density))


class Imported:
    """A robot after the import by a program with its default settings."""

    def __init__(self, tree: KinematicTree, facts: ImporterFacts, solid: Solid) -> None:

        self.tree = tree
        self.facts = facts
        self._solid = solid
        compiler = compiler_of(tree.model) if facts.reads_compiler else None
        self._compiler = compiler
        #: True if links at fixed joints are merged.
        self.merges_fixed = facts.merges_fixed if compiler is None else compiler.fuses_static
        #: True if visuals are not loaded.
        self.drops_visuals = facts.drops_visuals if compiler is None else compiler.drops_visuals

    @property
    def root_is_free(self) -> bool | None:
        """True if the root moves; None if the user decides."""
        if self.facts.root == "asked":
            return None
        root = next(iter(self.tree.roots), None)
        if self.facts.root == "welded" or root is None or root.name == WORLD:
            return False
        if not self.facts.massless_root_is_welded:
            return True
        own = self.properties_of(root)
        return own is None or own.mass != 0

    @cached_property
    def joints(self) -> tuple[ImportedJoint, ...]:
        """The joints with coordinates, in the program's order.

        Their coordinates follow those of the free root of their tree.
        """
        facts = self.facts
        order = ordered(self.tree, facts.walk, facts.siblings, merged=self.merges_fixed)
        numbered: list[Joint | None] = [None, *order]
        if facts.frees_floating:
            numbered = free_trees(self.tree, order)
        is_counted = self.root_is_free or facts.numbers_root
        q = v = 0
        imported: list[ImportedJoint] = []
        for joint in numbered:
            nq, nv = facts.root_coordinates if is_counted else (0, 0)
            if joint is None:
                q, v = q + nq, v + nv
                continue
            nq, nv = facts.coordinates_of(joint.kind)
            if nv and not (facts.skips_mimic and joint.mimic):
                is_body = facts.frees_floating and joint.kind == "floating"
                name = joint.child_name if is_body else joint.name
                names = (name + end for end in facts.suffixes.get(joint.kind, ("",)))
                imported.append(ImportedJoint(joint, tuple(names), q, nq, v, nv))
                q, v = q + nq, v + nv
        return tuple(imported)

    @cached_property
    def bodies(self) -> tuple[ImportedBody, ...]:
        """The bodies, parents before children; the world only if links are part of it."""
        return tuple(map(self._body, self._groups))

    @cached_property
    def _groups(self) -> tuple[RigidBody, ...]:
        fixed = frozenset(joint.name for joint in self.tree.model.joints)
        return rigid_bodies(self.tree, frozenset() if self.merges_fixed else fixed)

    def _body(self, group: RigidBody) -> ImportedBody:
        links = tuple(link for link, _ in group.links)
        if group.joint is None and self.facts.merges_into_world and self.merges_fixed:
            return ImportedBody(WORLD, links, None)
        own = [(self.properties_of(link), frame) for link, frame in group.links]
        parts = [part.moved(frame) for part, frame in own if part is not None]
        # A program computes missing masses for bodies: one link with a mass is sufficient.
        is_known = len(parts) == len(own) or bool(parts and self.facts.massless)
        return ImportedBody(group.top.name, links, combined(parts) if is_known else None)

    def properties_of(self, link: Link) -> MassProperties | None:
        """Mass properties of a link in its frame, before links are merged; None if unknown."""
        facts, compiler = self.facts, self._compiler
        from_shapes = compiler.inertia_from_geometry if compiler else False
        properties: MassProperties | None
        if link.inertial is not None and not from_shapes:
            properties = properties_of(link, Transform())
        elif facts.default_mass:
            mass = 0.0 if link.name == WORLD else facts.default_mass
            properties = MassProperties(mass, ORIGIN, ZERO)
        elif facts.massless:
            properties = None
        elif facts.density and link.collisions:
            unit = self._solid(link, facts.mesh_volume)
            properties = None if unit is None else dense(unit, facts.density)
        else:
            properties = properties_of(link, Transform())
        return compiler.bounded(properties) if compiler and properties else properties
