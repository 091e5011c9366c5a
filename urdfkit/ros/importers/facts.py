"""The programs whose import of a URDF is known, and the facts about each."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache

from urdfkit.core.record import Record
from urdfkit.core.suggest import did_you_mean
from urdfkit.errors import UrdfkitError
from urdfkit.ros.catalog import data, names, record

#: Their names; each has a file of facts.
IMPORTERS = tuple(names("importers"))
#: One more, of which `urdfkit.ros.gazebo.conversion` knows all; it has no order of joints.
GAZEBO = "gazebo"

#: Positions and velocities of each type of joint, where a program says nothing else.
_COORDINATES = {
    "revolute": (1, 1),
    "continuous": (1, 1),
    "prismatic": (1, 1),
    "planar": (3, 3),
    "floating": (7, 6),
}


class UnknownImporter(UrdfkitError):
    """A name that is no importer."""


class ImporterFacts(Record):
    """How one program imports a URDF, with its default settings."""

    name: str  # on the command line
    title: str  # of the program, with the version or versions that it was compared with
    walk: str  # ``depth`` or ``breadth`` first from the root, or ``file``: as they are written
    #: How the joints of one link are ordered: as they are written (``file``), by their names
    #: (``joint``), or as their child links are written (``link``).
    siblings: str
    root: str  # ``welded`` to the world, ``free``, or ``asked``: an option without a default
    about_root: str = ""  # how to get the other one
    #: Positions and velocities of a free root, which come before the joints.
    root_coordinates: tuple[int, int] = (0, 0)
    #: True if the coordinates of a free root are counted for a welded one, too.
    numbers_root: bool = False
    massless_root_is_welded: bool = False  # True if a free root without mass is welded
    merges_fixed: bool = False  # True if the child of a fixed joint becomes part of the parent
    #: True if what is welded to the world becomes part of it, and loses its mass.
    merges_into_world: bool = False
    target: str = ""  # the name of the same program for ``--target``; empty if it is none
    #: In kg/m³, of the collision shapes of a link without ``<inertial>``; 0 if it has no mass then.
    density: float = 0.0
    #: The volume of a mesh is that of tetrahedra, ``signed`` or ``unsigned``; empty if it is not
    #: known.
    mesh_volume: str = ""
    default_mass: float = 0.0  # of a link without ``<inertial>``, in kg
    massless: str = ""  # what becomes of such a link, where neither of these is true
    ignores_tensors: bool = False  # True if inertia is computed from the collision shapes
    drops_visuals: bool = False  # True if visuals are not loaded
    reads_compiler: bool = False  # True if a ``<mujoco><compiler>`` changes all this
    #: True if the child of a floating joint is a free body, the root of a tree of its own, and
    #: the joint has the name of that body.
    frees_floating: bool = False
    skips_mimic: bool = False  # True if a joint that follows another one has no coordinate
    about_mimic: str = ""  # what such a joint is instead, or as well
    #: Positions and velocities by type of joint, where they are not the usual ones.
    coordinates: Mapping[str, tuple[int, int]] = {}
    #: Names of the joints that one joint of a type becomes.
    suffixes: Mapping[str, tuple[str, ...]] = {}
    unknown_types: tuple[str, ...] = ()  # types of joints that it does not load

    def coordinates_of(self, kind: str) -> tuple[int, int]:
        """Positions and velocities of a type of joint; none of a fixed one."""
        positions, velocities = self.coordinates.get(kind) or _COORDINATES.get(kind, (0, 0))
        return positions, velocities


@cache
def facts_of(name: str) -> ImporterFacts:
    """The facts of an importer.

    Raises:
        UnknownImporter: with the nearest.
    """
    if name not in IMPORTERS:
        known = sorted((*IMPORTERS, GAZEBO))
        raise UnknownImporter(
            f"unknown importer '{name}'{did_you_mean(name, known)} ({', '.join(known)})"
        )
    return record(ImporterFacts, data(f"importers/{name}"), name=name)


def chosen(asked: Iterable[str]) -> tuple[ImporterFacts, ...]:
    """Importers by their names, each once.

    Raises:
        UnknownImporter: with the nearest.
    """
    return tuple(map(facts_of, dict.fromkeys(asked)))
