"""One rule per file, named by its code: the listing of a family's directory is its catalogue.

A rule is imported only where its family applies, see `APPLIES`.
"""

from collections.abc import Callable, Collection

from urdfkit.lint import rule_index
from urdfkit.lint.context import Context
from urdfkit.robot.joint import DEGREES_OF_FREEDOM
from urdfkit.text.file_kinds import is_launch, is_list_of_joints, is_parameter_file
from urdfkit.workspace.package_references import have_references
from urdfkit.workspace.srdf_files import has_srdf_files

#: The rules about parameters, which also hold for a file that no launch file loads.
_OF_PARAMETERS = frozenset(
    "LAU023 LAU024 LAU025 LAU026 LAU032 LAU039 LAU040 LAU044 LAU045 LAU046".split()
)


def _may_overlap(context: Context) -> bool:
    """True if collision geometries of two links may overlap."""
    return (
        sum(bool(link.collisions) for link in context.model.links) > 1
        and not context.is_part
        and bool(context.collisions.contacts.pairs)
    )


def _has_wheels_or_drives(context: Context) -> bool:
    """True if there are wheels, plugins of Gazebo or parameter files of controllers."""
    model = context.model
    names = [*(link.name for link in model.links), *(joint.name for joint in model.joints)]
    has_wheels = any("wheel" in name.lower() for name in names)
    return has_wheels or bool(context.parameters) or bool(model.gazebo and context.plugins)


def _has_dynamics(context: Context) -> bool:
    """True if a joint moves and a link has a mass, or Pinocchio is a target."""
    model = context.model
    if "pinocchio" in context.given_targets:
        return True
    return any(joint.kind in DEGREES_OF_FREEDOM for joint in model.joints) and any(
        link.mass for link in model.links
    )


def _has_sensors(context: Context) -> bool:
    """True if a ``<gazebo>`` element contains a sensor."""
    return any(part.tag == "sensor" for block in context.model.gazebo for part in block.walk())


def _is_robot(context: Context) -> bool:
    """True for a document that contains a robot: links alone can have wrong origins, too."""
    is_robot = bool(context.model.joints or context.model.links)
    return is_robot and not is_list_of_joints(context.document.root)


def _concerns_packages(context: Context) -> bool:
    """True for a launch file, and for a description that refers to packages or includes files."""
    if is_launch(context.source.path) or context.problems("XAC011"):
        return True
    document = context.reading.document
    sources = document.sources if document else (context.source,)
    if len(sources) > 1 or have_references(sources):
        return True
    return any(b"model://" in source.data for source in sources)


def _is_controlled(context: Context) -> bool:
    """True if there are transmissions, ros2_control or plugins that run controllers."""
    model = context.model
    if model.transmissions or model.ros2_controls or context.parameters:
        return True
    plugins = (plugin for block in model.gazebo for plugin in block.all("plugin"))
    return any("control" in (plugin.get("filename") or "") for plugin in plugins)


def _has_srdf_files(context: Context) -> bool:
    """True if there is an SRDF in the package of the robot or next to it."""
    return has_srdf_files(context.source.path, context.model.name, context.resolver)


def _starts_gazebo(context: Context) -> bool:
    """True for a launch file that mentions Gazebo."""
    words = (b"gazebo", b"gz_", b"gz", b"ign")
    return is_launch(context.source.path) and any(word in context.source.data for word in words)


def _has_xacro(context: Context) -> bool:
    """True for a xacro, and for a plain file with expressions or tags of xacro."""
    reading = context.reading
    if reading.xacro is not None or any(
        problem.code.startswith("XAC") for problem in reading.problems
    ):
        return True
    return any(sign in context.source.data for sign in (b"${", b"$(", b"<xacro:"))


#: Whether the rules of a family may have something to report on a description. That of simulations
#: raises `Unavailable` for a robot that cannot be simulated, which CFG003 reports.
APPLIES: dict[str, Callable[[Context], bool]] = {
    "bringup": lambda context: context.is_bringup,
    "checking": lambda _: True,  # the runner decides when each of its rules runs
    "collision": _may_overlap,
    "controllers": lambda context: context.names_parameters,
    "drives": _has_wheels_or_drives,
    "dynamics": _has_dynamics,
    "gazebo": lambda context: bool(context.model.gazebo),
    "gazebo_plugins": lambda context: bool(context.plugins),
    "gazebo_sensors": _has_sensors,
    "geometry": lambda context: bool(context.model.links),
    "grammar": lambda context: bool(context.deviations),
    "inertia": lambda context: bool(context.model.links),
    "joints": _is_robot,
    "launch": lambda context: is_launch(context.source.path),
    "mesh_contents": lambda context: any(mesh.facts for mesh in context.files.meshes),
    "meshes": lambda context: any(shape.filename for shape in context.model.shapes),
    "mimic": lambda context: any(joint.mimic for joint in context.model.joints),
    "names": lambda context: bool(context.model.links or context.model.joints),
    "package": _concerns_packages,
    "reading": lambda context: bool(context.reading.problems),
    "ros2_control": _is_controlled,
    "simulation": lambda context: context.simulation is not None,
    "srdf": lambda context: _has_srdf_files(context) and not context.other_variant,
    "srdf_match": _has_srdf_files,
    "transmissions": lambda context: bool(context.model.transmissions),
    "tree": lambda context: context.document.root.tag == "robot",
    "worlds": _starts_gazebo,
    "xacro": _has_xacro,
    "xml": lambda _: True,
}


def _of_simulation(context: Context) -> set[str]:
    """The rules whose tests the robot fails."""
    from urdfkit.checks.simulation.reported import RULES, reported

    return {RULES[verdict.test] for verdict in reported(context)}


def _of_bringup(context: Context) -> Collection[str]:
    is_loaded = not is_parameter_file(context.source)
    return rule_index.of_family("bringup") if is_loaded else _OF_PARAMETERS


#: The rules of a family that may have something to report, where it is known beforehand.
CODES: dict[str, Callable[[Context], Collection[str]]] = {
    "bringup": _of_bringup,
    "grammar": lambda context: context.deviations,
    "reading": lambda context: {problem.code for problem in context.reading.problems},
    "simulation": _of_simulation,
}
