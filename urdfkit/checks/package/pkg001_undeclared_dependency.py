"""A description or a launch file uses a package that its own `package.xml` does not declare.

It works on the machine where that package happens to be installed. Elsewhere rosdep does not
install it, colcon and catkin build in the wrong order, and `$(find ...)`, `package://` and the
launch file end with "package not found". In a launch file it is an info. Packages that come with
ROS are not reported.

Sources:
    REP 149, package.xml: https://www.ros.org/reps/rep-0149.html
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.checks.package.samples import robot_of_package
from urdfkit.errors import PackageNotFound
from urdfkit.lint.rules import Context, Finding, Findings, Fix, Location, Severity, rule
from urdfkit.mesh.samples import PLATE
from urdfkit.text.editing.edits import insert_after, insert_last
from urdfkit.text.file_kinds import is_launch
from urdfkit.text.source import Source, Span
from urdfkit.text.xml_reader import read_xml
from urdfkit.workspace.manifest import depends_on, manifest_of
from urdfkit.workspace.package_references import of_package
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
    b"<run_depend>bot_meshes</run_depend></package>",
}

#: colcon and catkin reject cyclic dependencies of packages.
_CYCLE = "move the file to '{1}' or to '{0}': '{0}' depends on '{1}', so the reverse makes a cycle"


@rule(Severity.WARNING)
def check(subject: Context) -> Findings:
    manifest = manifest_of(subject.resolver, subject.source.path)
    if manifest is None:
        return
    is_of_launch = is_launch(subject.source.path)
    tag = manifest.dependency_tag
    seen = {manifest.package, *manifest.dependencies}
    for name, span in _launched(subject) if is_of_launch else _referenced(subject):
        if name in seen or comes_with_ros(name):
            continue
        seen.add(name)
        help_, fix = f"add <{tag}>{name}</{tag}> to package.xml", None
        if not depends_on(name, manifest.package, span.source.path, subject.resolver):
            fix = _fix(subject.resolver.read(manifest.path), name, tag)
        elif is_of_launch:
            continue
        else:
            help_ = _CYCLE.format(name, manifest.package)
        yield Finding(
            Location(span),
            f"package '{name}' is used but not declared in {manifest.path}",
            help_,
            fix,
            group_key="undeclared" if fix else "",
            severity=Severity.INFO if is_of_launch else None,
        )


def _launched(subject: Context) -> Iterator[tuple[str, Span]]:
    """The packages that a launch file names itself and that are found; XAC011 has the others."""
    for package in subject.launch.packages:
        if package.searched is None and package.span.source.path == subject.source.path:
            yield package.name, package.span


def _referenced(subject: Context) -> Iterator[tuple[str, Span]]:
    """The packages that a description refers to and that are found; XAC011 has the others."""
    for mention in of_package(subject.document.sources, subject.resolver.packages):
        try:
            subject.resolver.package(mention.package, mention.span.source.path)
        except PackageNotFound:
            continue
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
