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
    """How one program imports a URDF, with its default settings.

    Attributes:
        name: on the command line.
        title: of the program, with the version or versions that it was compared with.
        walk: ``depth`` or ``breadth`` first from the root, or ``file``: as they are written.
        siblings: how the joints of one link are ordered: as they are written (``file``), by their
            names (``joint``), or as their child links are written (``link``).
        root: ``welded`` to the world, ``free``, or ``asked``: an option without a default.
        about_root: how to get the other one.
        root_coordinates: positions and velocities of a free root, which come before the joints.
        numbers_root: True if the coordinates of a free root are counted for a welded one, too.
        massless_root_is_welded: True if a free root without mass is welded.
        merges_fixed: True if the child of a fixed joint becomes part of the parent.
        merges_into_world: True if what is welded to the world becomes part of it, and loses its
            mass.
        target: the name of the same program for ``--target``; empty if it is none.
        density: in kg/m³, of the collision shapes of a link without ``<inertial>``; 0 if it has no
            mass then.
        mesh_volume: the volume of a mesh is that of tetrahedra, ``signed`` or ``unsigned``; empty
            if it is not known.
        default_mass: of a link without ``<inertial>``, in kg.
        massless: what becomes of such a link, where neither of these is true.
        ignores_tensors: True if inertia is computed from the collision shapes.
        drops_visuals: True if visuals are not loaded.
        reads_compiler: True if a ``<mujoco><compiler>`` changes all this.
        skips_mimic: True if a joint that follows another one has no coordinate.
        about_mimic: what such a joint is instead, or as well.
        coordinates: positions and velocities by type of joint, where they are not the usual ones.
        suffixes: names of the joints that one joint of a type becomes.
        unknown_types: types of joints that it does not load.
    """

    name: str
    title: str
    walk: str
    siblings: str
    root: str
    about_root: str = ""
    root_coordinates: tuple[int, int] = (0, 0)
    numbers_root: bool = False
    massless_root_is_welded: bool = False
    merges_fixed: bool = False
    merges_into_world: bool = False
    target: str = ""
    density: float = 0.0
    mesh_volume: str = ""
    default_mass: float = 0.0
    massless: str = ""
    ignores_tensors: bool = False
    drops_visuals: bool = False
    reads_compiler: bool = False
    skips_mimic: bool = False
    about_mimic: str = ""
    coordinates: Mapping[str, tuple[int, int]] = {}
    suffixes: Mapping[str, tuple[str, ...]] = {}
    unknown_types: tuple[str, ...] = ()

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
