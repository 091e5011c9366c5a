"""A description uses a package that its own `package.xml` does not declare.

It works on the machine where that package happens to be. Elsewhere rosdep does not install it,
colcon and catkin build in the wrong order, and `$(find ...)` or `package://` leads nowhere.
Packages that come with ROS are not reported.

Sources:
    REP 149, package.xml: https://www.ros.org/reps/rep-0149.html
"""

from __future__ import annotations

from urdfkit.errors import PackageNotFound
from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Location, rule
from urdfkit.mesh.samples import PLATE
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import insert_after, insert_last
from urdfkit.text.source import Source
from urdfkit.text.xml_reader import read_xml
from urdfkit.workspace.manifest import depends_on, manifest_of
from urdfkit.workspace.package_references import of_package
from urdfkit.workspace.resolve import Resolver
from urdfkit.workspace.ros_packages import comes_with_ros

NAME = "bot_description/bot.urdf"
BAD = """\
<robot name="bot">
  <link name="base">
    <visual>
      <geometry><mesh filename="package://bot_meshes/base.stl"/></geometry>
    </visual>
  </link>
</robot>
"""
GOOD = BAD.replace("package://bot_meshes/", "package://bot_description/")
FILES = {
    "bot_description/package.xml": b"<package><name>bot_description</name></package>",
    "bot_description/base.stl": PLATE,
    "bot_meshes/package.xml": b"<package><name>bot_meshes</name></package>",
    "bot_meshes/base.stl": PLATE,
}
FIXED_FILES = {
    "bot_description/package.xml": b"<package><name>bot_description</name>"
    b"<run_depend>bot_meshes</run_depend></package>",
}

#: colcon and catkin reject cyclic dependencies of packages.
_CYCLE = "'{}' depends on '{}', and the reverse would be a cycle: move the file to one of the two"


@rule(Severity.WARNING)
def check(subject: Subject) -> Findings:
    packages = subject.resolver.packages
    manifest = manifest_of(subject.resolver, subject.source.path)
    if manifest is None:
        return
    reported = {manifest.package, *manifest.dependencies}
    for mention in of_package(subject.document.sources, packages):
        name = mention.package
        if name in reported or comes_with_ros(name):
            continue
        reported.add(name)
        near = mention.span.source.path
        if not _is_found(subject.resolver, name, near):
            continue
        message = f"package '{name}' is used but not declared in {manifest.path}"
        if depends_on(name, manifest.package, near, subject.resolver):
            yield Finding(Location(mention.span), message, _CYCLE.format(name, manifest.package))
            continue
        tag = manifest.dependency_tag
        help_ = f"add <{tag}>{name}</{tag}> to package.xml"
        fix = _fix(subject.resolver.read(manifest.path), name, tag)
        yield Finding(Location(mention.span), message, help_, fix, alike="undeclared")


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


def _is_found(resolver: Resolver, name: str, near: str) -> bool:
    """False for a package that is not there; MSH005 and XAC011 report that."""
    try:
        resolver.package(name, near)
    except PackageNotFound:
        return False
    return True
