"""Gazebo cannot find the meshes of the package: no resource path is set.

RViz finds `package://arm_description/meshes/...` through ROS. Gazebo reads it as
`model://arm_description/meshes/...` and searches its own resource path: "Unable to find file with
URI", and the robot is invisible. Gazebo of ROS 1 resolves packages; Gazebo of ROS 2 and gz-sim
require the parent directory of the package in `GZ_SIM_RESOURCE_PATH` or `GAZEBO_MODEL_PATH`, most
simply by an export in package.xml, which gazebo_ros and ros_gz_sim read; or a launch file replaces
`package://` by a path. A launch file that sets the variable to the directory of the package itself
is reported, too; so are hooks that add only other directories. For Harmonic and later,
`IGN_GAZEBO_RESOURCE_PATH` does not count. A URDF that no launch file refers to, such as an expanded
copy, is not reported: Gazebo does not load it.

Sources:
    Gazebo, finding resources: https://github.com/gazebosim/gz-sim/blob/main/tutorials/resources.md
    gazebo_ros_paths.py: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_ros/scripts/gazebo_ros_paths.py
    ros_gz_sim, gz_sim.launch.py: https://github.com/gazebosim/ros_gz/blob/ros2/ros_gz_sim/launch/gz_sim.launch.py.in
    gazebosim/ros_gz#132: https://github.com/gazebosim/ros_gz/issues/132
    gazebosim/gz-sim#1518: https://github.com/gazebosim/gz-sim/pull/1518
    SherbyRobotics/racecar#44: https://github.com/SherbyRobotics/racecar/pull/44
"""

import os
from collections.abc import Callable

from urdfkit.core import disk
from urdfkit.lint.rules import Context, Finding, Findings, Need, Related, Severity, rule
from urdfkit.mesh.samples import PLATE
from urdfkit.robot.assets.mesh_files import MeshReference
from urdfkit.robot.samples import element_xml, visual_xml
from urdfkit.ros.gazebo.paths import FORMER, survey
from urdfkit.ros.gazebo.samples import gazebo_xml, plugin_xml, solid_xml
from urdfkit.text.file_kinds import is_launch
from urdfkit.text.source import Span

NAME = "urdf/bot.urdf"
_VISUAL = visual_xml('<mesh filename="package://bot_description/meshes/base.stl"/>')
_POSES = plugin_xml("gz::sim::systems::PosePublisher", "gz-sim-pose-publisher-system")
BAD = element_xml('robot name="bot"', solid_xml("base", _VISUAL), gazebo_xml(_POSES))
GOOD = BAD.replace("package://bot_description/meshes", "../meshes")
FILES = {
    "package.xml": b'<package format="3"><name>bot_description</name></package>',
    "launch/sim.launch.py": b"IncludeLaunchDescription(share('ros_gz_sim') / 'gz_sim.launch.py')\n",
    "meshes/base.stl": PLATE,
}

_GZ = ("gz-fortress", "gz-harmonic", "gz-jetty")
#: The targets that read the former name of the variable.
_WITH_FORMER = ("gz-fortress", "classic-ros2")
_VARIABLES = ("GZ_SIM_RESOURCE_PATH", "IGN_GAZEBO_RESOURCE_PATH", "GAZEBO_MODEL_PATH", "SDF_PATH")


@rule(
    Severity.WARNING,
    needs=(Need.MODEL, Need.FILES),
    by_target=dict.fromkeys(("classic-ros2", *_GZ), Severity.WARNING),
)
def check(context: Context) -> Findings:
    if is_launch(context.source.path):
        return
    if not (context.model.gazebo or context.given_targets) or context.is_part:
        return
    if not context.targets.any_of(("classic-ros2", *_GZ)):
        return
    packages = context.resolver.packages
    found = _of_packages(context)
    if not found or any(True for _ in packages.gazebo_model_paths(context.source.path)):
        return
    is_former = context.targets.any_of(_WITH_FORMER)
    root, directories = packages.workspace(context.source.path), context.resolver.directories
    seen = survey(root, directories, () if is_former else FORMER)
    if seen.mentions and seen.is_whole and not seen.replaces:
        yield from _within_package(context, found, seen.mentions)
        yield from _in_other_hooks(context, found, seen.mentions)
    if seen.is_mentioned or seen.starter is None:
        return
    from urdfkit.ros.launch.robot_arguments import is_not_started  # for few robots

    if not context.given_targets and is_not_started(context.source, context.resolver):
        return
    starter = context.resolver.readable(seen.starter)
    if starter is None:  # a link that leads outside
        return
    variable = "GZ_SIM_RESOURCE_PATH" if context.targets.any_of(_GZ) else "GAZEBO_MODEL_PATH"
    for package, meshes in found.items():
        more = f", nor {len(meshes) - 1} more of this package" if len(meshes) > 1 else ""
        first = next(iter(meshes.values()))
        yield Finding(
            first.at,
            f"Gazebo cannot find '{first.at.value}'{more}: nothing in the "
            f"workspace sets {variable} or exports gazebo_model_path",
            f'write <gazebo_ros gazebo_model_path="${{prefix}}/.."/> into the <export> of the '
            f"package.xml of {package}, or set {variable} in the launch file",
            related=(Related(Span(starter, 0, 0), "this launch file starts Gazebo"),),
        )


def _within_package(
    context: Context, found: dict[str, dict[str, MeshReference]], mentions: tuple[str, ...]
) -> Findings:
    """A resource path of launch files that has the directory of a package, not the one around."""
    from urdfkit.ros.launch.robot_arguments import launches_of_workspace  # for few robots

    launches = launches_of_workspace(context.source.path, context.resolver)
    every = [setting for launch in launches for setting in launch.environment]
    settings = [setting for setting in every if setting.name in _VARIABLES]
    files = {os.path.abspath(setting.word.span.source.path) for setting in settings}
    if {*map(os.path.abspath, mentions)} != files:
        return  # another file may set it, too
    texts = [setting.word.text for setting in settings]
    known = [text for text in texts if text is not None]
    if len(known) < len(texts):
        return
    directories = {os.path.normpath(part) for text in known for part in text.split(":") if part}
    for package, meshes in found.items():
        own = context.resolver.package(package, context.source.path)
        if own not in directories or any(map(_has(package), directories)):
            continue
        first = next(iter(meshes.values()))
        wrong = next(one for one in settings if own in (one.word.text or "").split(":"))
        yield Finding(
            wrong.word.span,
            f"Gazebo looks for {package}/... in {wrong.name}, which has the directory of "
            f"'{package}' itself: it cannot find '{first.at.value}'",
            "write the directory around that of the package",
            related=(Related(first.at.span, "the mesh is named here"),),
        )


def _in_other_hooks(
    context: Context, found: dict[str, dict[str, MeshReference]], mentions: tuple[str, ...]
) -> Findings:
    """Environment hooks that alone set the resource path, to directories in packages."""
    from urdfkit.workspace.environment_hooks import SUFFIXES, HookEntry, entries  # for few robots

    directories: list[str] = []
    settings: list[HookEntry] = []
    for path in mentions:
        home = context.resolver.packages.enclosing(path)
        source = context.resolver.readable(path) if path.endswith(SUFFIXES) else None
        if home is None or source is None:
            return
        for entry in entries(source, home[0]):
            inside = entry.path.removeprefix(f"share/{home[0]}/")
            if entry.variable in _VARIABLES and inside == entry.path:
                return  # the directory around a package, or any other
            settings += [entry] if entry.variable in _VARIABLES else []
            directories.append(os.path.join(home[1], inside))
    for package, meshes in found.items() if settings else ():
        if not any(map(_has(package), directories)):
            first = next(iter(meshes.values()))
            yield Finding(
                first.at,
                f"Gazebo cannot find '{first.at.value}': {settings[0].variable} has "
                f"{settings[0].path}, but not the directory around {package}",
                f"add the line prepend-non-duplicate;{settings[0].variable};share to a hook of "
                f"{package}",
                related=(Related(settings[0].span, "the path is set here"),),
            )


def _has(package: str) -> Callable[[str], bool]:
    return lambda directory: disk.exists(os.path.join(directory, package))


def _of_packages(context: Context) -> dict[str, dict[str, MeshReference]]:
    """The meshes that are there and are named by a package: by the package, and by their names."""
    found: dict[str, dict[str, MeshReference]] = {}
    for mesh in context.files.meshes:
        if mesh.located.scheme == "package" and mesh.located.path and mesh.located.package:
            found.setdefault(mesh.located.package, {}).setdefault(mesh.at.value, mesh)
    return found
