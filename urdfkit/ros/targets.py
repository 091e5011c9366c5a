"""Targets: the programs that read the robot, on which severities depend.

The same model suffers differently in each: a root link with inertia makes KDL warn while Gazebo
needs it. Targets are given, or inferred from the model itself: its plugins and
the build system of its package.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import cache

from urdfkit.core.record import Record
from urdfkit.core.suggest import did_you_mean
from urdfkit.errors import UrdfkitError
from urdfkit.robot.model import RobotModel
from urdfkit.ros.catalog import data, names, record
from urdfkit.text.document import Element
from urdfkit.workspace.manifest import Manifest

#: Their names; each has a file of facts. ROS comes first, whose parsers most others build on.
TARGETS = tuple(sorted(names("targets"), key=lambda name: (not name.startswith("ros"), name)))

CLASSIC = ("classic-ros1", "classic-ros2")
GZ = ("gz-fortress", "gz-harmonic", "gz-jetty")
#: Every Gazebo; they convert URDF to SDF with the same library.
GAZEBO = (*CLASSIC, *GZ)

#: How the names of packages begin that are for one of the two.
_CLASSIC_PACKAGES = ("gazebo_ros", "gazebo_plugins")
_GZ_PACKAGES = ("ros_gz", "ros_ign", "gz_", "ign_")
_CLASSIC_PLUGINS = ("gazebo_ros_", "hector_", "rotors_")


class UnknownTarget(UrdfkitError):
    """The name of a target is unknown."""


class Targets(Record):
    """The programs that a description is checked for."""

    names: tuple[str, ...]  # in the order of ``TARGETS``
    evidence: tuple[str, ...] = ()  # why each target was detected; empty if they are chosen

    def among(self, names: Iterable[str]) -> tuple[str, ...]:
        """The given targets that are among these targets."""
        return tuple(name for name in names if name in self.names)

    def any_of(self, names: Iterable[str]) -> bool:
        """True if one of the given targets is among these targets."""
        return bool(self.among(names))

    @property
    def applies_units(self) -> bool:
        """True unless all are known and take the numbers of COLLADA files as metres."""
        return not self.all_are("ignores_units")

    @property
    def facts(self) -> tuple[TargetFacts, ...]:
        return tuple(map(facts_of, self.names))

    def that(self, fact: str) -> tuple[str, ...]:
        """The targets for which a fact is true."""
        return tuple(one.name for one in self.facts if getattr(one, fact))

    def all_are(self, fact: str) -> bool:
        """True if there are targets, and a fact is true for all of them."""
        return bool(self.names) and all(getattr(one, fact) for one in self.facts)

    def passes_over(self, family: str) -> bool:
        """True if none of some targets reads what a family of rules is about."""
        return bool(self.names) and all(family in one.unread for one in self.facts)


class TargetFacts(Record):
    """What one program makes of a robot, where it is not what urdfdom and RViz make of it."""

    name: str  # of the target
    title: str  # what it stands for
    unread: tuple[str, ...] = ()  # families of rules about what the program does not read
    #: The formats that it loads; empty if that is not known, or depends on the machine.
    meshes: tuple[str, ...] = ()
    leaves_out_visuals: bool = False  # True if it takes a robot whose visuals are in other formats
    drops_visuals: bool = False  # True if it loads no visuals unless it is asked to
    loads_first_object: bool = False  # True if it loads only the first object or group of an OBJ
    collides_hulls: bool = False  # True if the convex hulls of meshes collide, not their triangles
    #: True if a link collides with the one above, where that is welded to the world.
    collides_with_welded: bool = False
    #: Of rules, where they differ for it, by their codes: what it rejects is an ``error``, what it
    #: takes is none.
    severities: Mapping[str, str] = {}
    simulates: bool = False  # True if forces move the links, so that they need a mass
    #: True if it makes a KDL tree of the robot, which lacks the inertia of the root.
    builds_kdl: bool = False
    finds_packages: bool = True  # False if it ignores packages: a mesh is a path
    #: True if it looks for such a path in the directory of the URDF and in all above it.
    searches_above: bool = False
    ignores_units: bool = False  # True if the numbers of COLLADA files are metres to it
    ignores_limits: bool = False  # True if it takes a joint without ``<limit>``, effort or velocity
    reads_capsules: bool = False  # True if it reads ``<capsule>`` in each version of URDF
    ignores_quaternions: bool = False  # True if it reads no ``quat_xyzw``, in no version of URDF
    reads_ball_joints: bool = False  # True if it reads joints of the type ``spherical``
    #: True if floating and ball joints and limits must be those that MJCF allows.
    reads_joints_as_mjcf: bool = False
    #: True if it reads numbers as C does: hexadecimal, with any white space, ``inf`` in limits.
    reads_c_numbers: bool = False
    ignores_unknown_leaders: bool = False  # True if it takes a mimic of a joint that is missing
    #: Tags of elements that may have the same name: ``joint``, ``material``.
    repeatable_names: tuple[str, ...] = ()
    rejects_recoloured: bool = False  # True if it rejects a material with two colours
    reads_drake_joints: bool = False  # True if ``<drake:joint>`` connects links
    reads_planes: bool = False  # True if it reads the shape ``<plane>``
    reads_unnamed_materials: bool = False  # True if a material needs no name
    reserves_world: bool = False  # True if a link ``world`` is the world
    adds_world: bool = False  # True if joints may name the world, which no link stands for
    #: True if it rejects a mimic of a joint that one number does not move.
    needs_movable_mimic: bool = False
    needs_usd_names: bool = False  # True if names are those of USD, which begin with no digit
    rejects_repeated: bool = False  # True if it rejects an element that is there twice
    rejects_massless: bool = False  # True if it rejects a moving link without mass
    #: In kg/m³, of the collisions of a link without ``<inertial>``, whose mass it computes; 0 if it
    #: computes none.
    density: float = 0.0
    #: True if moments must hold the triangle inequality to their last digit.
    rejects_rounding: bool = False
    least_moment: float = 0.0  # in kg·m²; it rejects tensors with less. 0 if it takes all
    rejects_empty_shapes: bool = False  # True if it rejects a collision one edge of which is 0
    least_volume: float = 0.0  # in m³; it rejects collision meshes with less. 0 if it takes all
    most_triangles: int = 0  # of an STL file that it loads; 0 if it loads all


@cache
def facts_of(name: str) -> TargetFacts:
    return record(TargetFacts, data(f"targets/{name}"), name=name)


def parse(names: Iterable[str]) -> Targets:
    """Targets given by name.

    Raises:
        UnknownTarget: with the nearest.
    """
    chosen = set(names)
    for name in chosen:
        if name not in TARGETS:
            hint = did_you_mean(name, TARGETS)
            raise UnknownTarget(f"unknown target '{name}'{hint} ({', '.join(TARGETS)})")
    return Targets(tuple(name for name in TARGETS if name in chosen))


def infer(model: RobotModel, manifest: Manifest | None) -> Targets:
    """The targets that a model and its package.xml imply, each with the reason."""
    evidence = list(_evidence(model, manifest))
    left_out = _contradicted(evidence, manifest)
    found: dict[str, str] = {}
    for one in evidence:
        if one.target not in left_out:
            found.setdefault(one.target, one.reason)
    names = tuple(name for name in TARGETS if name in found)
    return Targets(names, tuple(f"{name}: {found[name]}" for name in names))


class _Evidence(Record):
    """A line from which a target is detected, and its weight."""

    target: str
    reason: str
    weight: int = 0


#: Weights: Gazebo loads a plugin; a hardware plugin is a name that the control plugin looks up.
_PLUGIN, _HARDWARE = 2, 1


def _evidence(model: RobotModel, manifest: Manifest | None) -> Iterator[_Evidence]:
    ros = f"ros{manifest.ros}" if manifest and manifest.ros else None
    if ros:
        yield _Evidence(ros, "package.xml")
    if model.ros2_controls:
        yield _Evidence("ros2", "<ros2_control>")
    for element in (*model.gazebo, *model.ros2_controls):
        for plugin in element.walk():
            # ros2_control has its hardware plugin in the text
            name = plugin.get("filename") or plugin.text.strip()
            if plugin.tag == "plugin" and (target := target_of_plugin(name, plugin, ros)):
                weight = _PLUGIN if "filename" in plugin.attributes else _HARDWARE
                yield _Evidence(target, f"plugin {name}", weight)


def _contradicted(evidence: list[_Evidence], manifest: Manifest | None) -> tuple[str, ...]:
    """Gazebo Classic or gz-sim, if one line speaks for it and more for the other.

    That line is the mistake, which rules report; the rest fits and stays as it is.
    """
    weights = []
    lines = []
    for family, begins in ((CLASSIC, _CLASSIC_PACKAGES), (GZ, _GZ_PACKAGES)):
        own = {one.reason: one.weight for one in evidence if one.target in family}
        names = manifest.dependencies if manifest else ()
        lines.append(len(own))
        weights.append(sum(own.values()) + any(name.startswith(begins) for name in names))
    if lines[0] == 1 and weights[0] < weights[1] and lines[1]:
        return CLASSIC
    return GZ if lines[1] == 1 and weights[1] < weights[0] and lines[0] else ()


def target_of_plugin(name: str, plugin: Element, ros: str | None = None) -> str | None:
    """The target that the library of a plugin implies in a package of a ROS version."""
    if "ignition-gazebo" in name or "ign_ros2_control" in name:
        return "gz-fortress"
    if "gz-sim" in name or "gz_ros2_control" in name:
        return "gz-harmonic"
    if "gazebo_ros2_control" in name:
        return "classic-ros2"
    if name.removeprefix("lib").startswith(_CLASSIC_PLUGINS):
        return _classic_generation(name, plugin, ros)
    return None


def _classic_generation(name: str, plugin: Element, ros: str | None) -> str:
    """A ``<ros>`` block is of ROS 2; else the package decides, else the library, else the spelling.

    What the package says comes before the rest: a library or tags of ROS 1 in a package of ROS 2
    are a mistake, and many plugins of ROS 1 have snake_case tags among the others.
    """
    from urdfkit.ros.catalog.plugins import find  # loads the catalogue

    tags = {child.tag for child in plugin.children}
    if "ros" in tags:
        return "classic-ros2"
    if ros:
        return f"classic-{ros}"
    generations = {one.generation for one in find(name) if not one.removed}
    if len(generations) == 1 and generations <= {"classic-ros1", "classic-ros2"}:
        return generations.pop()
    if any(tag != tag.lower() for tag in tags):
        return "classic-ros1"
    return "classic-ros2" if any("_" in tag for tag in tags) else "classic-ros1"
