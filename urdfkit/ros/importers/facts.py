"""The programs whose URDF import is known, and the facts about each."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache

from urdfkit.core.record import Record
from urdfkit.core.suggest import did_you_mean
from urdfkit.errors import UrdfkitError
from urdfkit.ros.catalog import data, names, record

#: Names of the importers; each has a file of facts.
IMPORTERS = tuple(names("importers"))
#: Another importer, in `urdfkit.ros.gazebo.conversion`; it has no order of joints.
GAZEBO = "gazebo"

#: Default number of positions and velocities of each type of joint.
_COORDINATES = {
    "revolute": (1, 1),
    "continuous": (1, 1),
    "prismatic": (1, 1),
    "planar": (3, 3),
    "floating": (7, 6),
}


class UnknownImporter(UrdfkitError):
    """The name of an importer is unknown."""


class ImporterFacts(Record):
    """Facts about the URDF import of a program, with its default settings."""

    name: str  # on the command line
    title: str  # of the program, with the compared versions
    walk: str  # order of joints: ``depth`` or ``breadth`` first from the root, or ``file`` order
    #: Order of the child joints of a link: order in the file (``file``), by name (``joint``), or
    #: order of their child links in the file (``link``).
    siblings: str
    root: str  # ``welded`` to the world, ``free``, or ``asked``: an option without a default
    about_root: str = ""  # how to choose the other root
    #: Number of positions and velocities of a free root, which precede the joints.
    root_coordinates: tuple[int, int] = (0, 0)
    #: True if a welded root is counted with the coordinates of a free root.
    numbers_root: bool = False
    massless_root_is_welded: bool = False  # True if a free root without mass is welded
    merges_fixed: bool = False  # True if the child of a fixed joint becomes part of the parent
    #: True if links welded to the world become part of it, and lose their masses.
    merges_into_world: bool = False
    target: str = ""  # name of the program for ``--target``; empty if it is not a target
    #: Density in kg/m³ of the collision shapes of a link without ``<inertial>``; 0 for no mass.
    density: float = 0.0
    #: Volume of a mesh: sum of ``signed`` or ``unsigned`` tetrahedra; empty if unknown.
    mesh_volume: str = ""
    default_mass: float = 0.0  # of a link without ``<inertial>``, in kg
    massless: str = ""  # effect on a link without mass, if there is no density or default mass
    ignores_tensors: bool = False  # True if inertia is computed from the collision shapes
    drops_visuals: bool = False  # True if visuals are not loaded
    reads_compiler: bool = False  # True if a ``<mujoco><compiler>`` changes these facts
    #: True if the child of a floating joint is a free body, the root of a separate tree, and the
    #: joint has the name of that body.
    frees_floating: bool = False
    skips_mimic: bool = False  # True if a mimic joint has no coordinate
    about_mimic: str = ""  # result of the import of a mimic joint
    #: Number of positions and velocities by type of joint, if not the default.
    coordinates: Mapping[str, tuple[int, int]] = {}
    #: Suffixes of the joints that a joint of a type is split into.
    suffixes: Mapping[str, tuple[str, ...]] = {}
    unknown_types: tuple[str, ...] = ()  # joint types that it rejects

    def coordinates_of(self, kind: str) -> tuple[int, int]:
        """Number of positions and velocities of a type of joint; 0 for a fixed joint."""
        positions, velocities = self.coordinates.get(kind) or _COORDINATES.get(kind, (0, 0))
        return positions, velocities


@cache
def facts_of(name: str) -> ImporterFacts:
    """The facts of an importer.

    Raises:
        UnknownImporter: the name is unknown; suggests the nearest name.
    """
    if name not in IMPORTERS:
        known = sorted((*IMPORTERS, GAZEBO))
        raise UnknownImporter(
            f"unknown importer '{name}'{did_you_mean(name, known)} ({', '.join(known)})"
        )
    return record(ImporterFacts, data(f"importers/{name}"), name=name)


def selected(words: Iterable[str]) -> tuple[ImporterFacts, ...]:
    """Importers by name, without duplicates.

    Raises:
        UnknownImporter: a name is unknown; suggests the nearest name.
    """
    return tuple(map(facts_of, dict.fromkeys(words)))
