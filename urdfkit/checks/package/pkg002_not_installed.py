"""The build of the package does not install a file that is used.

In the source tree the file exists. After `colcon build` or `catkin_make install` it is not under
`share/`, and `$(find ...)` and `package://` refer to a missing file: RViz shows the robot without
meshes, xacro stops, "file 'robot.launch.py' was not found in the share directory". Install the
directory. `DESTINATION share` without `/${PROJECT_NAME}` installs the files elsewhere, and so does
a slash after the name of a directory, which installs only its contents, or `share/NAME` without the
directory in the `data_files` of a setup.py. A macro that is included from another package is
checked with that package's build file. In ROS 1 it is an info: most users work with catkin's devel
space, which finds packages in the source tree.

Sources:
    REP 122, installed files: https://ros.org/reps/rep-0122.html
    ros2/demos#353: https://github.com/ros2/demos/issues/353
"""

import os
from collections.abc import Iterable, Iterator
from itertools import islice

from urdfkit.checks.package.samples import robot_of_package
from urdfkit.core import disk
from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.mesh.samples import PLATE
from urdfkit.text.file_kinds import has_launch_name, is_launch
from urdfkit.text.source import Source, Span
from urdfkit.workspace.install_rules import InstallRules
from urdfkit.workspace.manifest import manifest_of
from urdfkit.workspace.package_references import package_references

NAME = "urdf/bot.urdf"
BAD = robot_of_package("bot_description")
GOOD = BAD.replace("meshes/", "models/")
FILES = {
    "package.xml": b"<package><name>bot_description</name></package>",
    "CMakeLists.txt": b"project(bot_description)\n"
    b"install(DIRECTORY urdf models DESTINATION share/${PROJECT_NAME})\n",
    "meshes/base.stl": PLATE,
    "models/base.stl": PLATE,
}


@rule(Severity.WARNING)
def check(context: Context) -> Findings:
    packages = context.resolver.packages
    if is_launch(context.source.path):
        enclosing = packages.enclosing(context.source.path)
        for package, named in _launched(context).items():
            # Of another package, each launch file would repeat all that its build leaves out.
            found = _uninstalled(context, *package, named)
            yield from found if package == enclosing else islice(found, 1)
        return
    sources: dict[tuple[str, str], list[Source]] = {}
    for source in context.document.sources:
        if home := packages.enclosing(source.path):
            sources.setdefault(home, []).append(source)
    for home, own in sources.items():
        used = (*_referenced(own, home[0]), *_included(context, home[1]))
        yield from _uninstalled(context, *home, used)


def _uninstalled(
    context: Context, name: str, directory: str, used: Iterable[tuple[str, Span]]
) -> Findings:
    """The first file of each directory of a package that is used and not installed."""
    rules = InstallRules(directory, name)
    manifest = manifest_of(context.resolver, os.path.join(directory, "package.xml"))
    has_devel_space = manifest is not None and manifest.ros == 1
    severity = Severity.INFO if has_devel_space else None
    reported: set[str] = set()
    for relative, span in used:
        top = relative.partition("/")[0]
        is_there = disk.exists(os.path.join(directory, relative))
        if top in reported or not is_there:
            continue
        is_itself = not (span.start or span.end)
        misplaced = rules.misplaced(relative)
        if is_itself and misplaced.startswith(f"share/{name}/"):
            continue  # ros2 launch searches all directories of the package
        if is_itself or disk.is_directory(os.path.join(directory, relative)):
            misplaced = ""
        message = f"'{relative}' is not installed by {rules.file}"
        if misplaced:
            message = f"{rules.file} installs '{relative}' as {misplaced}"
            message += f", not as share/{name}/{relative}"
        if misplaced or not rules.installs(relative):
            reported.add(top)
            help = rules.advice(top)
            if misplaced and rules.file.endswith(".py"):
                help = f"write share/{name}/{os.path.dirname(relative)} as their directory"
            yield Finding(span, message, help, severity=severity)


def _referenced(sources: Iterable[Source], name: str) -> Iterator[tuple[str, Span]]:
    """The files of a package that its own descriptions refer to, relative to the package."""
    for source in sources:
        for mention in package_references(source):
            if mention.package == name and mention.relative.partition("/")[0]:
                yield os.path.normpath(mention.relative), mention.span


def _included(context: Context, directory: str) -> Iterator[tuple[str, Span]]:
    """The files of a package that other files include, by any path, relative to the package."""
    xacro = context.reading.xacro
    for definition in (*xacro.macros, *xacro.properties) if xacro else ():
        frame, path = definition.frame, definition.tag.source.path
        relative = os.path.relpath(path, directory)
        if frame and frame.kind == "include" and not relative.startswith(os.pardir):
            including = os.path.relpath(frame.call.source.path, directory)
            if including.partition(os.sep)[0] != relative.partition(os.sep)[0]:
                yield relative, frame.call.attribute_spans().get("filename", frame.call.span)


def _launched(context: Context) -> dict[tuple[str, str], list[tuple[str, Span]]]:
    """A launch file, and the files that it names, relative to their packages, by package."""
    from urdfkit.ros.launch.worlds import worlds

    packages = context.resolver.packages
    own = os.path.abspath(context.source.path)
    home = packages.enclosing(own)
    if home is None or not os.path.relpath(own, home[1]).startswith("launch"):
        return {}  # a test or an example, which stay in the source tree
    named = [(file.path, file.span) for file in context.launch.files if file.exists]
    named += [(world.name, world.span) for world in worlds(context.launch) if not world.frame]
    itself = [(own, Span(context.source, 0, 0))] if has_launch_name(own) else []
    found: dict[tuple[str, str], list[tuple[str, Span]]] = {}
    for path, span in (*itself, *named):
        package = packages.enclosing(path) if os.path.isabs(path) else None
        relative = os.path.relpath(path, package[1]) if package else ""
        if package and (os.sep in relative or _is_filled(path, package[1])):
            found.setdefault(package, []).append((relative, span))
    return found


def _is_filled(path: str, package: str) -> bool:
    """True for a directory in a package with files, such as one for Gazebo's resource path."""
    is_below = os.path.normpath(path) != os.path.normpath(package)
    return is_below and disk.is_directory(path) and bool(disk.names_or_empty(path))
