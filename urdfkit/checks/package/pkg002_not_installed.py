"""A description refers to a directory of its own package that is not installed.

From the source tree everything works. After `colcon build` or `catkin_make install` the folder is
not under `share/`, and `$(find ...)` and `package://` lead to files that are not there: RViz
shows the robot without meshes, xacro stops. Install the directory.

Sources:
    REP 122, installed files: https://ros.org/reps/rep-0122.html
    ros2/demos#353: https://github.com/ros2/demos/issues/353
"""

from __future__ import annotations

import os

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Location, rule
from urdfkit.mesh.samples import PLATE
from urdfkit.text.diagnostic import Severity
from urdfkit.workspace.install_rules import InstallRules
from urdfkit.workspace.package_references import of_package

NAME = "urdf/bot.urdf"
BAD = """\
<robot name="bot">
  <link name="base">
    <visual>
      <geometry><mesh filename="package://bot_description/meshes/base.stl"/></geometry>
    </visual>
  </link>
</robot>
"""
GOOD = BAD.replace("meshes/", "models/")
FILES = {
    "package.xml": b"<package><name>bot_description</name></package>",
    "CMakeLists.txt": b"project(bot_description)\n"
    b"install(DIRECTORY urdf models DESTINATION share/${PROJECT_NAME})\n",
    "meshes/base.stl": PLATE,
    "models/base.stl": PLATE,
}


@rule(Severity.WARNING)
def check(subject: Subject) -> Findings:
    packages = subject.resolver.packages
    home = packages.enclosing(subject.source.path)
    if home is None:
        return
    name, folder = home
    shipping = InstallRules(folder, name)
    reported: set[str] = set()
    for mention in of_package(subject.document.sources, packages):
        top = mention.relative.partition("/")[0]
        if mention.package != name or not top or top in reported:
            continue
        there = os.path.exists(os.path.join(folder, mention.relative))
        if there and not shipping.installs(mention.relative):
            reported.add(top)
            yield Finding(
                Location(mention.span),
                f"'{mention.relative}' is not installed by {shipping.file}",
                shipping.remedy(top),
            )
