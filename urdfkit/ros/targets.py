"""Targets: the programs that read the robot, on which severities depend.

A root link with inertia, for example, makes KDL warn, but Gazebo requires it. Targets are given by
the user, or detected from the plugins and namespaces of the model and the build system of its
package.
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

#: Names of targets; each has a file of facts. ROS is first, as most others use its parsers.
TARGETS = tuple(sorted(names("targets"), key=lambda name: (not name.startswith("ros"), name)))

#: URDF readers of ROS, which other targets may use as well.
ROS = ("ros1", "ros2")
CLASSIC = ("classic-ros1", "classic-ros2")
GZ = ("gz-fortress", "gz-harmonic", "gz-jetty")
#: All generations of Gazebo, which convert URDF to SDF with the same library.
GAZEBO = (*CLASSIC, *GZ)

#: Prefixes of the packages and plugins of each generation.
_CLASSIC_PACKAGES = ("gazebo_ros", "gazebo_plugins")
_GZ_PACKAGES = ("ros_gz", "ros_ign", "gz_", "ign_")
#: Types of sensors that only one generation has.
_CLASSIC_SENSORS = ("depth", "gps", "gpu_ray", "multicamera", "ray", "sonar")
_GZ_SENSORS = ("depth_camera", "gpu_lidar", "lidar", "navsat", "rgbd_camera")
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
        """False if all targets are known to ignore the units of COLLADA files."""
        return not self.all_are("ignores_units")

    @property
    def facts(self) -> tuple[TargetFacts, ...]:
        return tuple(map(facts_of, self.names))

    def that(self, fact: str) -> tuple[str, ...]:
        """The targets for which a fact is true."""
        return tuple(target.name for target in self.facts if getattr(target, fact))

    def all_are(self, fact: str) -> bool:
        """True if there are targets, and a fact is true for all of them."""
        return bool(self.names) and all(getattr(target, fact) for target in self.facts)

    def ignore(self, family: str) -> bool:
        """True if there are targets, and none of them reads the elements of a family of rules."""
        return bool(self.names) and all(family in target.unread for target in self.facts)


class TargetFacts(Record):
    """Differences between a program and urdfdom with RViz in reading a robot."""

    name: str  # of the target
    title: str  # in messages
    unread: tuple[str, ...] = ()  # families of rules about elements that it does not read
    #: Mesh formats that it loads; empty if unknown, or dependent on the computer.
    meshes: tuple[str, ...] = ()
    leaves_out_visuals: bool = False  # True if it ignores visuals in other formats
    drops_visuals: bool = False  # True if it loads no visuals by default
    loads_first_object: bool = False  # True if it loads only the first object or group of an OBJ
    collides_hulls: bool = False  # True if the convex hulls of meshes collide, not their triangles
    #: True if a link collides with its parent link if that is welded to the world.
    collides_with_welded: bool = False
    #: Severities by code of rules that have another severity for it: ``error`` if it rejects the
    #: robot.
    severities: Mapping[str, str] = {}
    simulates: bool = False  # True if forces move the links, so that they need a mass
    #: True if it builds a KDL tree of the robot, which lacks the inertia of the root.
    builds_kdl: bool = False
    finds_packages: bool = True  # False if it does not resolve packages
    #: True if it searches a path in the directory of the URDF and its parent directories.
    searches_above: bool = False
    #: True if it finds a package by a directory of that name in the path of the URDF.
    searches_own_package: bool = False
    ignores_units: bool = False  # True if it ignores the units of COLLADA files
    ignores_limits: bool = False  # True if ``<limit>``, effort and velocity are optional
    reads_capsules: bool = False  # True if it reads ``<capsule>`` in all versions of URDF
    ignores_quaternions: bool = False  # True if it does not read ``quat_xyzw`` in any version
    reads_ball_joints: bool = False  # True if it reads joints of the type ``spherical``
    #: True if floating and ball joints and limits must be valid in MJCF.
    reads_joints_as_mjcf: bool = False
    #: True if it reads numbers as C does: hexadecimal, with any white space, ``inf`` in limits.
    reads_c_numbers: bool = False
    ignores_unknown_leaders: bool = False  # True if it accepts a mimic of a missing joint
    #: Tags of elements that may have the same name: ``joint``, ``material``.
    repeatable_names: tuple[str, ...] = ()
    rejects_recoloured: bool = False  # True if it rejects a material with two colours
    ignores_interfaces: bool = False  # True if it does not read the interfaces of transmissions
    reads_type_attributes: bool = False  # True if the type of a transmission may be an attribute
    #: True if it rejects a robot with a transmission without name, type, joint or actuator.
    requires_whole_transmissions: bool = False
    reads_drake_joints: bool = False  # True if ``<drake:joint>`` connects links
    reads_planes: bool = False  # True if it reads the shape ``<plane>``
    reads_unnamed_materials: bool = False  # True if a material needs no name
    reads_one_scale: bool = False  # True if one number scales a mesh in all directions
    reserves_world: bool = False  # True if a link ``world`` is the world itself
    adds_world: bool = False  # True if joints may reference the world without a link for it
    #: True if it rejects a mimic of a joint without exactly one degree of freedom.
    needs_movable_mimic: bool = False
    needs_usd_names: bool = False  # True if names must be valid in USD: no digit first
    rejects_repeated: bool = False  # True if it rejects a repeated element
    rejects_massless: bool = False  # True if it rejects a moving link without mass
    #: Density in kg/m³ of the collisions of a link without ``<inertial>``; 0 if not computed.
    density: float = 0.0
    default_mass: float = 0.0  # in kg, of a link without ``<inertial>``
    #: True if moments must satisfy the triangle inequality without tolerance.
    rejects_rounding: bool = False
    least_moment: float = 0.0  # in kg·m²; it rejects lower moments. 0 without a bound
    rejects_empty_shapes: bool = False  # True if it rejects a collision with an edge of 0
    least_volume: float = 0.0  # in m³; it rejects smaller collision meshes. 0 without a bound
    most_triangles: int = 0  # in an STL file that it loads; 0 without a bound


@cache
def facts_of(name: str) -> TargetFacts:
    return record(TargetFacts, data(f"targets/{name}"), name=name)


def parse(names: Iterable[str]) -> Targets:
    """Targets by name.

    Raises:
        UnknownTarget: a name is unknown; suggests the nearest name.
    """
    chosen = set(names)
    for name in chosen:
        if name not in TARGETS:
            hint = did_you_mean(name, TARGETS)
            raise UnknownTarget(f"unknown target '{name}'{hint} ({', '.join(TARGETS)})")
    return Targets(tuple(name for name in TARGETS if name in chosen))


def infer(model: RobotModel, manifest: Manifest | None) -> Targets:
    """The targets detected from a model and its package.xml, with the reasons."""
    evidence = list(_evidence(model, manifest))
    excluded = _contradicted(evidence, manifest, model)
    reasons: dict[str, str] = {}
    for line in evidence:
        if line.target not in excluded:
            reasons.setdefault(line.target, line.reason)
    names = tuple(name for name in TARGETS if name in reasons)
    return Targets(names, tuple(f"{name}: {reasons[name]}" for name in names))


class _Evidence(Record):
    """A line from which a target is detected, and its weight."""

    target: str
    reason: str
    weight: int = 0


#: Weights: Gazebo loads a plugin, but the control plugin looks up a hardware plugin by name.
_PLUGIN, _HARDWARE = 2, 1


def _evidence(model: RobotModel, manifest: Manifest | None) -> Iterator[_Evidence]:
    ros = f"ros{manifest.ros}" if manifest and manifest.ros else None
    if ros:
        yield _Evidence(ros, "package.xml")
    if model.ros2_controls:
        yield _Evidence("ros2", "<ros2_control>")
    if "xmlns:drake" in model.root.attributes:
        yield _Evidence("drake", "xmlns:drake")
    for element in (*model.gazebo, *model.ros2_controls):
        for plugin in element.walk():
            # in ros2_control, the text is the hardware plugin
            name = plugin.get("filename") or plugin.text.strip()
            if plugin.tag == "plugin" and (target := target_of_plugin(name, plugin, ros)):
                weight = _PLUGIN if "filename" in plugin.attributes else _HARDWARE
                yield _Evidence(target, f"plugin {name}", weight)


def _contradicted(
    evidence: list[_Evidence], manifest: Manifest | None, model: RobotModel
) -> tuple[str, ...]:
    """Gazebo Classic or gz-sim, if one line implies it and more evidence implies the other.

    Rules report that line as the mistake. The types of sensors only tip the scales: many robots
    with a sensor of the other Gazebo are for both.
    """
    kinds = {part.get("type") for block in model.gazebo for part in block.walk()}
    weights = []
    lines = []
    for family, prefixes, types in (
        (CLASSIC, _CLASSIC_PACKAGES, _CLASSIC_SENSORS),
        (GZ, _GZ_PACKAGES, _GZ_SENSORS),
    ):
        own = {line.reason: line.weight for line in evidence if line.target in family}
        names = manifest.dependencies if manifest else ()
        of_sensors = len(kinds.intersection(types))
        lines.append(len(own))
        depends = any(name.startswith(prefixes) for name in names)
        weights.append(sum(own.values()) + depends + of_sensors)
    if lines[0] == 1 and weights[0] < weights[1]:
        return CLASSIC
    return GZ if lines[1] == 1 and weights[1] < weights[0] else ()


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
    """The generation by a ``<ros>`` block of ROS 2, else the package, the library, or the tags.

    The package precedes library and tags: those of ROS 1 in a package of ROS 2 are a mistake, and
    many plugins of ROS 1 also have tags in snake_case.
    """
    from urdfkit.ros.catalog.plugins import find  # loads the catalogue

    tags = {child.tag for child in plugin.children}
    if "ros" in tags:
        return "classic-ros2"
    if ros:
        return f"classic-{ros}"
    generations = {plugin.generation for plugin in find(name) if not plugin.removed}
    if len(generations) == 1 and generations <= {"classic-ros1", "classic-ros2"}:
        return generations.pop()
    if any(tag != tag.lower() for tag in tags):
        return "classic-ros1"
    return "classic-ros2" if any("_" in tag for tag in tags) else "classic-ros1"
