"""A description or a launch file uses a package that its own `package.xml` does not declare.

The file works only on machines where that package is installed. On other machines rosdep does not
install it, colcon and catkin build in the wrong order, and `$(find ...)`, `package://` and the
launch file fail with "package not found". In a launch file it is an info (a warning if all others
of several packages are declared). In launch files of ROS 2, packages of the ROS distribution are
reported, too: a smaller installation lacks `xacro`, `ros_gz_sim`, or MoveIt's solvers and planners
(a warning if it is the only one that is not declared, of several that the launch file starts, or
next to many in `package.xml`). So are the control plugin of Gazebo and the controllers of its
robots, with the plugins of their kinematics, if neither their own packages declare them, nor those
of the workspace on which the launch file depends: "class diff_drive_controller/DiffDriveController
does not exist". All of these are infos in a launch file that asks which packages are installed.

A package that is found only by the name of its directory has another name in its `package.xml`: ROS
does not find it. A dependency may have a typo in the name of a package that a launch file starts:
rosdep cannot resolve it.

Sources:
    REP 149, package.xml: https://www.ros.org/reps/rep-0149.html
"""

import os
from collections.abc import Iterator

from urdfkit.checks.package.build_files import is_registered
from urdfkit.checks.package.samples import robot_of_package
from urdfkit.core import disk
from urdfkit.core.suggest import is_typo
from urdfkit.errors import PackageNotFound
from urdfkit.lint.rules import Context, Finding, Findings, Fix, Related, Severity, rule
from urdfkit.mesh.samples import PLATE
from urdfkit.ros.catalog import data
from urdfkit.text.document import CallFrame, Element
from urdfkit.text.editing.edits import insert_after, insert_last
from urdfkit.text.file_kinds import is_launch
from urdfkit.text.source import Source, Span
from urdfkit.text.xml_reader import read_xml
from urdfkit.workspace.manifest import Manifest, depends_on, manifest_of
from urdfkit.workspace.package_references import references_of_package
from urdfkit.workspace.resolve import Resolver
from urdfkit.workspace.ros_packages import comes_with_ros

NAME = "bot_description/bot.urdf"
BAD = robot_of_package("bot_meshes")
GOOD = BAD.replace("bot_meshes", "bot_description")
FILES = {
    "bot_description/package.xml": b"<package><name>bot_description</name></package>",
    "bot_description/meshes/base.stl": PLATE,
    "bot_meshes/package.xml": b"<package><name>bot_meshes</name></package>",
    "bot_meshes/meshes/base.stl": PLATE,
}
FIXED_FILES = {
    "bot_description/package.xml": b"<package><name>bot_description</name>"
    b"<run_depend>bot_meshes</run_depend></package>"
}

#: The parameter of a controller that names the plugin of its kinematics.
_SOLVER = "kinematics.plugin_name"
#: A class whose package has another name than its type.
_GRIPPER = "/GripperActionController"
_MOVE_GROUP = "moveit_ros_move_group"
#: Declared packages of ROS that a launch file starts, if another one was forgotten.
_DECLARED = 2
#: Declared packages of ROS, if one other that the launch file starts is enough.
_OF_CAREFUL_AUTHOR = 4
_KINEMATICS = "kinematics.yaml"
#: Packages of the planners whose classes begin with another name.
_PLANNERS = {
    "chomp_interface": "moveit_planners_chomp",
    "ompl_interface": "moveit_planners_ompl",
    "stomp_moveit": "moveit_planners_stomp",
}
#: In launch files that do without a package that is not installed.
_ASKED = (b"get_packages_with_prefixes", b"PackageNotFoundError")
#: colcon and catkin reject cyclic dependencies of packages.
_CYCLE = (
    "'{0}' depends on '{1}', so to declare it makes a cycle: move the file that is used to '{1}', "
    "or this one to '{0}'"
)


@rule(Severity.WARNING)
def check(context: Context) -> Findings:
    manifest = manifest_of(context.resolver, context.source.path)
    if manifest is None:
        return
    is_of_launch = is_launch(context.source.path)
    usual = manifest.dependency_tag
    seen = {manifest.package, *manifest.dependencies}
    if is_of_launch and manifest.ros == 2 and usual == "exec_depend":
        yield from _of_ros(context, manifest)
    for name, span in _launched(context) if is_of_launch else _referenced(context):
        if name in seen or comes_with_ros(name):
            continue
        seen.add(name)
        if other := _other_name(name, span, context.resolver):
            if is_registered(name, os.path.dirname(other.path)):
                continue  # its package.xml is wrong (PKG008)
            message = f"package '{name}' is called '{other.package}' in {other.path}"
            yield Finding(span, message, f"write {other.package}, or rename the package")
            continue
        tag = "test_depend" if _is_test(span.source.path, manifest) else usual
        help_, fix = f"add <{tag}>{name}</{tag}> to package.xml", None
        if not depends_on(name, manifest.package, span.source.path, context.resolver):
            fix = _fix(context.resolver.read(manifest.path), name, tag)
        elif is_of_launch:
            continue
        else:
            help_ = _CYCLE.format(name, manifest.package)
        yield Finding(
            span,
            f"package '{name}' is used but not declared in {manifest.path}",
            help_,
            fix,
            group_key="undeclared" if fix else "",
            severity=Severity.INFO
            if is_of_launch and not _is_only_one(context, manifest)
            else None,
        )


def _is_only_one(context: Context, manifest: Manifest) -> bool:
    """True if all packages of the workspace that a launch file uses are declared, except one."""
    used = {name for name, _ in _launched(context) if not comes_with_ros(name)}
    used.discard(manifest.package)
    is_forgotten = len(used - manifest.dependencies) == 1 and len(used) > _DECLARED
    return is_forgotten and not _asks_for_packages(context.source)


def _asks_for_packages(source: Source) -> bool:
    """True for a launch file that asks which packages are installed: it may do without them."""
    return any(name in source.data for name in _ASKED)


def _other_name(name: str, span: Span, resolver: Resolver) -> Manifest | None:
    """The manifest of a package that is only found by the name of its directory; None otherwise."""
    try:
        directory = resolver.package(name, span.source.path)
    except PackageNotFound:
        return None
    manifest = manifest_of(resolver, os.path.join(directory, "package.xml"))
    if manifest is None or manifest.package in ("", name):
        return None
    is_own = disk.real(os.path.dirname(os.path.abspath(manifest.path))) == disk.real(directory)
    return manifest if is_own else None  # else that of the package around it


def _is_test(path: str, manifest: Manifest) -> bool:
    """True for a file in the tests of a package."""
    relative = os.path.relpath(path, os.path.dirname(manifest.path))
    return relative.partition(os.sep)[0] in ("test", "tests")


def _of_ros(context: Context, manifest: Manifest) -> Findings:
    """The packages of ROS that a launch file starts, and that its package does not declare."""
    own = context.source.path
    used = [(use.name, use.span) for use in context.launch.packages if comes_with_ros(use.name)]
    used += [
        ("xacro", description.frame.call.span)
        for description in context.launch.descriptions
        # A helper of another package, which declares it, may load the description.
        if description.path.endswith(".xacro") and b"xacro" in context.source.data
    ]
    used += _loaded(context)
    used += _solvers(context, os.path.dirname(manifest.path))
    places: dict[str, Span] = {}
    for name, span in used:
        if name != manifest.package and span.source.path == own:
            places.setdefault(name, span)
    missing = [name for name in places if not _is_brought(name, manifest.dependencies)]
    others = len(places) - 1
    is_careful = sum(map(comes_with_ros, manifest.dependencies)) >= _OF_CAREFUL_AUTHOR
    is_forgotten = len(missing) == 1 and others >= (1 if is_careful else _DECLARED)
    is_forgotten = is_forgotten and not _asks_for_packages(context.source)
    for name in missing:
        if misspelt := _misspelt(name, context, manifest):
            message = f"dependency '{misspelt.text.strip()}' is not a package of ROS; "
            related = (Related(places[name], f"'{name}' is started here"),)
            message += f"did you mean '{name}'?"
            yield Finding(misspelt, message, f"write {name}", related=related)
            continue
        line = f"<exec_depend>{name}</exec_depend>"
        yield Finding(
            places[name],
            f"package '{name}' is started but not declared in {manifest.path}",
            f"add {line} to package.xml",
            _fix(context.resolver.read(manifest.path), name, "exec_depend"),
            group_key="undeclared",
            severity=None if is_forgotten else Severity.INFO,
        )


def _misspelt(name: str, context: Context, manifest: Manifest) -> Element | None:
    """The dependency with a typo in the name of a package; None if there is none."""
    typos = {other for other in manifest.dependencies if is_typo(other, name)}
    known = context.resolver.packages.known(manifest.path) if typos else {}
    typos = {other for other in typos if other not in known and not comes_with_ros(other)}
    root = read_xml(context.resolver.read(manifest.path))[0] if typos else None
    children = root.root.children if root else ()
    return next((child for child in children if child.text.strip() in typos), None)


def _loaded(context: Context) -> Iterator[tuple[str, Span]]:
    """The control plugins and controllers of the robots, that their own packages do not declare."""
    from urdfkit.ros.launch.spawning import model_spawner
    from urdfkit.ros.ros_control import control_plugins

    launch = context.launch
    is_simulated = any(map(model_spawner, launch.programs))
    spawns = any(map(model_spawner, launch.started))
    for description, robot in context.described_robots if is_simulated else ():
        own = manifest_of(context.resolver, description.path)
        place = _place_in(context.source.path, description.frame)
        if own is None or place is None or not (spawns or place == description.frame.call.span):
            continue
        declared = own.dependencies | _declared_below(context)
        names = [plugin.kind for plugin in control_plugins(robot.model)]
        loaded = [controller for _, controller in robot.controllers if controller.ros == 2]
        plugins = [value.text for user in loaded for value in user.values([_SOLVER]) if value.text]
        types = [*(controller.type for controller in loaded), *plugins]
        names += [type.partition("/")[0] for type in types if not type.endswith(_GRIPPER)]
        for name in names if names and "ros2_controllers" not in declared else ():
            if comes_with_ros(name) and not _is_brought(name, declared):
                yield name, place


def _place_in(path: str, frame: CallFrame | None) -> Span | None:
    """Where a launch file describes a robot, or includes the file that does."""
    while frame is not None and frame.call.span.source.path != path:
        frame = frame.outer
    return frame.call.span if frame else None


def _declared_below(context: Context) -> set[str]:
    """What the packages of the workspace declare on which that of the launch file depends."""
    known = context.resolver.packages.known(context.source.path)
    own = manifest_of(context.resolver, context.source.path)
    stack, declared = list(own.dependencies if own else ()), set[str]()
    while stack:
        name = stack.pop()
        if name in known and name not in declared:
            manifest = manifest_of(context.resolver, os.path.join(known[name], "package.xml"))
            stack += manifest.dependencies if manifest else ()
        declared.add(name)
    return declared


def _solvers(context: Context, directory: str) -> Iterator[tuple[str, Span]]:
    """The packages of the solvers and planners that a move_group of this launch file loads."""
    started = [node for node in context.launch.programs if node.package == _MOVE_GROUP]
    if not started:
        return
    from urdfkit.ros.moveit.config import PIPELINES  # for launch files of MoveIt
    from urdfkit.text.located_yaml import Node, Value, load, mapping, scalars

    def settings(file: str) -> dict[str, Node]:
        source = context.resolver.readable(os.path.join(directory, "config", file))
        return mapping(load(source)) if source else {}

    solvers = [mapping(entry).get("kinematics_solver") for entry in settings(_KINEMATICS).values()]
    packages = [solver.text.partition("/")[0] for solver in solvers if isinstance(solver, Value)]
    for file in PIPELINES:
        plugins = scalars(settings(file).get("planning_plugins"))
        prefixes = (plugin.text.partition("/")[0] for plugin in plugins)
        packages += [_PLANNERS.get(prefix, prefix) for prefix in prefixes]
    yield from ((name, started[0].span) for name in packages if comes_with_ros(name))


def _is_brought(name: str, declared: frozenset[str]) -> bool:
    """True if a package is declared, or a metapackage that depends on it."""
    return name in declared or any(
        name.startswith(prefix.rstrip("*")) if prefix.endswith("*") else name == prefix
        for bringer, brought in data("packages")["brought"].items()
        if bringer in declared and f"-{name}" not in brought.split()
        for prefix in brought.split()
    )


def _launched(context: Context) -> Iterator[tuple[str, Span]]:
    """The packages that a launch file refers to and that are found; XAC011 reports the others."""
    for package in context.launch.packages:
        if package.searched is None and package.span.source.path == context.source.path:
            yield package.name, package.span


def _referenced(context: Context) -> Iterator[tuple[str, Span]]:
    """The packages that a description refers to and that are found; XAC011 reports the others.

    A directory without a manifest, as ``assets`` in ``package://assets/arm.stl``, is not a package.
    """
    for mention in references_of_package(context.document.sources, context.resolver.packages):
        try:
            directory = context.resolver.package(mention.package, mention.span.source.path)
        except PackageNotFound:
            continue
        if disk.is_file(os.path.join(directory, "package.xml")):
            yield mention.package, mention.span


def _fix(source: Source, name: str, tag: str) -> Fix | None:
    """The dependency behind the last of its kind, else of any, or at the end of the package."""
    root = read_xml(source)[0]
    if root is None or root.root.tag != "package":
        return None
    package = root.root
    line = f"<{tag}>{name}</{tag}>"
    others = [child for child in package.children if child.tag.endswith("depend")]
    others = [child for child in others if child.tag == tag] or others
    edits = insert_after(others[-1], (line,)) if others else insert_last(package, (line,))
    return Fix(f"add {line} to package.xml", edits)
