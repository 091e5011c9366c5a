"""A launch file names a file that does not exist.

RViz starts with an empty view when its configuration is missing; a missing parameter file or launch
file stops the launch, and Gazebo does not start without its world. Also reported:

- An executable or launch file that a ROS package does not have (info if an earlier release of ROS 2
  had it, and none of the files is for Jazzy or later), or an executable that a package of the
  workspace does not install, if its build file names all of them; or a Python script without `#!`.
  A package of ROS 1, or one that Jazzy does not have if a file is for Jazzy.
- A Nav2 map whose image is missing, or whose image is given instead of its YAML file. slam_toolbox
  adds `.posegraph` to the name of a map itself.
- In Python, a file that a function of the launch file reads from a package, such as
  `load_yaml("arm", "config/limits.yaml")`.
- In Python, a path relative to the directory in which launch is started.
- `xacro.py`, and the `state_publisher` of `robot_state_publisher`, which were removed in Noetic
  (info in a launch file of ROS 1).
- A path in the home directory of another computer, of a file that a package of the workspace has.
- In Python, a path component that begins with a slash: `os.path.join` and `PathJoinSubstitution`
  drop everything before it (error). Or a path
  that follows the directory of a package without a slash (error).

Not reported: files that the build of a package may generate, files that git ignores, files named
after a launch file that passes its own path to a program, which may write them, and other absolute
paths outside the repository or workspace, such as `/etc/clearpath`, which may exist on the robot.

Sources:
    roslaunch, XML: http://wiki.ros.org/roslaunch/XML
    ros/xacro#239: https://github.com/ros/xacro/pull/239
    ros/robot_state_publisher#87: https://github.com/ros/robot_state_publisher/pull/87
"""

import os
import re

from urdfkit.checks.launch.paths_of_other_computers import paths_of_other_computers
from urdfkit.core import disk
from urdfkit.core.suggest import is_typo, nearest_file
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Severity, reported, rule
from urdfkit.ros.catalog import data
from urdfkit.ros.gazebo.worlds import shipped_worlds
from urdfkit.ros.launch.collect import UNKNOWN
from urdfkit.ros.launch.contents import MAP, MENTIONED, POSE_GRAPH, FileUse
from urdfkit.ros.launch.known_packages import last_release
from urdfkit.ros.launch.releases import is_for_jazzy
from urdfkit.ros.launch.worlds import GZ, StartedWorld, worlds
from urdfkit.ros.node_parameters import nodes_in_files
from urdfkit.text.located_yaml import Value, load, mapping, scalar
from urdfkit.text.source import Span
from urdfkit.workspace.gitignore import is_ignored
from urdfkit.workspace.install_rules import InstallRules, is_built
from urdfkit.workspace.resolve import OUTSIDE

NAME = "robot.launch"
BAD = '<launch><rosparam file="$(dirname)/config/controler.yaml"/></launch>'
GOOD = BAD.replace("controler", "controllers")
FILES = {"config/controllers.yaml": b"arm_controller:\n  joint: elbow\n"}

#: Suffixes of map images that map_server reads.
_IMAGES = (".pgm", ".png", ".bmp")
#: Parameters of slam_toolbox and map_server that name a map.
_OF_SLAM, _OF_SERVER = "map_file_name", "yaml_filename"
_GRAPH = ".posegraph"
#: Suffixes with which the map of slam_toolbox is written, although it has none.
_OF_MAPS = (_GRAPH, ".data", ".yaml", *_IMAGES)
#: Directories of a workspace that are searched for a world without a path.
_MAX_DIRECTORIES = 2000


@rule(Severity.WARNING, needs=(Need.LAUNCH,), help="create the file, or fix its name")
def check(context: Context) -> Findings:
    known = {file.path for file in context.launch.files if file.purpose != MENTIONED}
    known |= {world.name for world in worlds(context.launch)}
    for file in context.launch.files:
        if file.purpose == MENTIONED and file.path in known:
            continue
        if file.is_outside:
            yield _outside_workspace(f"{file.purpose} {file.path}", file.span)
        elif file.purpose == POSE_GRAPH:
            yield from _pose_graph(context, file)
        elif file.purpose == MAP and file.path.endswith(_IMAGES):
            yield _image_as_map(file.path, file.span)
        elif not file.exists and not _may_exist_elsewhere(context, file.path):
            yield _not_found(context, file.purpose, file.path, file.span)
        elif file.exists and file.purpose == MAP:
            yield from _missing_image(context, file)
    yield from _in_parameters(context)
    yield from _worlds(context)
    yield from _removed_packages(context)
    yield from paths_of_other_computers(context)
    for finding in reported(context, "LAU003"):
        is_former = finding.severity is Severity.INFO and _was_removed(context, finding)
        yield finding._replace(severity=None) if is_former else finding


def _removed_packages(context: Context) -> Findings:
    """Packages that the release of ROS 2 of this package does not have any more."""
    removed: dict[str, str] = data("packages")["removed"]
    used = [use for use in context.launch.packages if use.name in removed]
    for use in used if used and _is_for_jazzy(context) else ():
        if use.span.source is context.source:
            message = f"Jazzy has no package '{use.name}'"
            yield Finding(use.span, message, f"write {removed[use.name]}", group_key=use.name)


def _was_removed(context: Context, finding: Finding) -> bool:
    """True for an executable that the release of ROS 2 of this package does not have any more."""
    place = finding.at.span if isinstance(finding.at, Location) else None
    former = (use for use in context.launch.programs if last_release(use))
    return any(use.span == place for use in former) and _is_for_jazzy(context)


def _is_for_jazzy(context: Context) -> bool:
    """True if the parameter files, or the pipelines of MoveIt, have names of Jazzy and later."""
    home = context.resolver.packages.enclosing(context.source.path)
    config = os.path.join(home[1], "config") if home else ""
    files = disk.names_or_empty(config)
    paths = [os.path.join(config, file) for file in files if file.endswith("_planning.yaml")]
    return is_for_jazzy(context.source.path, context.resolver, paths)


def _pose_graph(context: Context, file: FileUse) -> Findings:
    """A map of slam_toolbox, which are two files: NAME.posegraph and NAME.data."""
    if file.path.endswith(_OF_MAPS):
        yield _with_suffix(file.path, file.span)
    elif not disk.exists(file.path + _GRAPH) and not _may_exist_elsewhere(context, file.path):
        yield _not_found(context, file.purpose, file.path + _GRAPH, file.span)


def _with_suffix(path: str, span: Span) -> Finding:
    name = os.path.basename(path)
    message = f"slam_toolbox looks for {name}{_GRAPH}: it adds the suffix to map_file_name"
    return Finding(span, message, f"write {os.path.splitext(name)[0]}, without a suffix")


def _in_parameters(context: Context) -> Findings:
    """Maps in parameter files, whose paths are often those of another computer."""
    paths = (file.path for file in context.launch.parameters)
    for node in nodes_in_files(paths, context.resolver):
        for key in (_OF_SLAM, _OF_SERVER):
            value = scalar(node.values, key)
            if value is None:
                continue
            if key == _OF_SLAM and value.text.endswith(_OF_MAPS):
                yield _with_suffix(value.text, value.span)
            elif key == _OF_SERVER and value.text.endswith(_IMAGES):
                yield _image_as_map(value.text, value.span)


def _image_as_map(path: str, span: Span) -> Finding:
    name = os.path.basename(path)
    message = f"map_server reads the YAML file of a map, not its image {name}"
    return Finding(span, message, f"write {os.path.splitext(name)[0]}.yaml")


def _missing_image(context: Context, file: FileUse) -> Findings:
    """A missing image of a map, at which map_server stops."""
    source = context.resolver.readable(file.path)
    image = mapping(load(source)).get("image") if source else None
    if isinstance(image, Value) and image.text:
        path = os.path.join(os.path.dirname(file.path), image.text)
        if not disk.exists(path) and not _may_exist_elsewhere(context, path):
            stem = os.path.splitext(path)[0]
            suggested = next((kind for kind in _IMAGES if disk.is_file(stem + kind)), None)
            hint = f"write {os.path.splitext(image.text)[0]}{suggested}" if suggested else ""
            yield Finding(image.span, f"image of the map not found: {path}", hint)


def _not_found(context: Context, what: str, path: str, span: Span) -> Finding:
    suggested = nearest_file(path)
    is_own = suggested == os.path.basename(span.source.path)  # a file that includes itself
    help = f"did you mean '{suggested}'?" if suggested and not is_own else ""
    if moved := _in_other_directory(context, path):
        help = f"the package has it as {moved}"
    if directory := _before_missing_slash(path):
        help = f"write a slash after {directory}"
    return Finding(span, f"{what} not found: {path}", help)


def _in_other_directory(context: Context, path: str) -> str:
    """The path in its package of the only file with the name of a missing one; may be empty."""
    home = context.resolver.packages.enclosing(path)
    if home is None:
        return ""
    files = context.resolver.directories.files_below(home[1], _MAX_DIRECTORIES)
    own, name = os.path.abspath(context.source.path), os.path.basename(path)
    same = [file for file in files if os.path.basename(file) == name and file != own]
    return os.path.relpath(same[0], home[1]) if len(same) == 1 else ""


def _before_missing_slash(path: str) -> str:
    """The directory behind which a slash is missing, as in ``$(find arm)worlds/a.world``."""
    parent = os.path.dirname(path)
    while parent != os.path.dirname(parent) and not disk.is_directory(parent):
        parent = os.path.dirname(parent)
    rest = path[len(parent) :].lstrip("/")
    for name in disk.names_or_empty(parent):
        if rest.startswith(name) and disk.is_file(f"{parent}/{name}/{rest[len(name) :]}"):
            return name
    return ""


def _outside_workspace(subject: str, span: Span) -> Finding:
    help = "move it into the package, or pass --trust"
    return Finding(span, f"{subject} {OUTSIDE}: not read", help)


def _worlds(context: Context) -> Findings:
    """Missing world files, and misspelt names of Gazebo's own worlds."""
    for world in worlds(context.launch):
        if world.span.source is not context.source:
            yield from _passed_world(context, world)
        elif world.glued_to:
            message = f"missing space between '{world.glued_to}' and the world '{world.name}'"
            yield Finding(world.span, message, f"write '{world.glued_to} ' with a space")
        elif os.path.isabs(world.name):
            if not world.name.startswith(UNKNOWN):
                yield from _world_file(context, world)
        elif world.generation == GZ and world.name and not world.is_shipped:
            yield from _unknown_world(context, world)


def _passed_world(context: Context, world: StartedWorld) -> Findings:
    """A missing world whose name this launch file passes to an included one."""
    if not os.path.isabs(world.name) or world.name.startswith(UNKNOWN):
        return
    name = re.escape(os.path.basename(world.name).encode())
    if match := re.search(rb"(?<![\w.-])%s(?![\w.-])" % name, context.source.data):
        passed = Span(context.source, *match.span())
        yield from _world_file(context, world._replace(span=passed))
    elif place := _place_of_path(context, world.name):
        yield from _world_file(context, world._replace(span=place))


def _place_of_path(context: Context, path: str) -> Span | None:
    """Where this launch file passes a path that it joins of parts."""
    own = context.source
    for included in context.launch.includes:
        for word in (included.arguments or {}).values() if included.span.source is own else ():
            if word.text == path and word.span.source is own and word.span != included.span:
                return word.span
    return None


def _world_file(context: Context, world: StartedWorld) -> Findings:
    path = world.name
    exists = disk.exists(path) or context.resolver.installed(path)
    if disk.is_file(path) and not context.resolver.admits(path):
        yield _outside_workspace(f"world {path}", world.span)
    elif not exists and not _may_exist_elsewhere(context, path):
        yield _not_found(context, "world", path, world.span)


def _unknown_world(context: Context, world: StartedWorld) -> Findings:
    """A misspelt name of a world that comes with gz sim, unless the workspace has such a file."""
    name = world.name
    in_classic = f"{os.path.splitext(name)[0]}.sdf"  # Gazebo Classic has empty.world
    suggested = next(
        (known for known in shipped_worlds() if is_typo(name, known) or known == in_classic), None
    )
    root = context.resolver.packages.workspace(context.source.path)
    files = context.resolver.directories.files_below(root, _MAX_DIRECTORIES)
    if suggested and not any(path.endswith(f"/{name}") for path in files):
        hint = f"did you mean '{suggested}'?"
        yield Finding(world.span, f"Gazebo has no world '{name}'", hint)


def _is_written(context: Context, path: str) -> bool:
    """True for ``NAME_spawner.launch`` in ``NAME.launch`` that passes its own path to a program."""
    own = context.source.path
    stem = os.path.splitext(own)[0]
    if not path.startswith(f"{os.path.abspath(stem)}_"):
        return False
    name = re.escape(os.path.basename(own).encode())
    return re.search(rb"\bargs\s*=\s*[\"'][^\"'<>]*/%s\b" % name, context.source.data) is not None


def _may_exist_elsewhere(context: Context, path: str) -> bool:
    """True if a build or a user generates the file, or it may exist on the robot's computer.

    Also if the name is unknown: an argument is empty by default (``$(arg model).yaml``), or is a
    sentence that says to pass one, or arguments result in an expression (``$(arg dollar)(find
    robot)``).
    """
    name = os.path.basename(path)
    is_unknown = name.startswith(".") or "$(" in path or (name.count(" ") > 1 and "." not in name)
    if is_unknown or is_ignored(path) or is_built(path) or _is_written(context, path):
        return True
    packages = context.resolver.packages
    home = packages.enclosing(path)
    if home is None:
        return not packages.searches(path, context.source.path)
    return InstallRules(home[1], home[0]).makes_files
