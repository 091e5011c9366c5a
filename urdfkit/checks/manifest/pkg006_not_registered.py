"""A Python package of ROS 2 leaves out what makes it a package for ROS.

It is found by `ros2 launch`, `package://` and `$(find ...)` only if its setup.py installs a file of
its name into `share/ament_index/resource_index/packages`, and that file has to exist under
`resource/`. And package.xml has to name the build type: without
`<build_type>ament_python</build_type>` in `<export>`, colcon looks for a CMakeLists.txt. Only
launch files, and descriptions that use packages, are asked for it.

Sources:
    ROS 2, developing a package: https://docs.ros.org/en/rolling/How-To-Guides/Developing-a-ROS-2-Package.html
    REP 149, build_type: https://www.ros.org/reps/rep-0149.html
    catkin_pkg, get_build_type: https://github.com/ros-infrastructure/catkin_pkg/blob/master/src/catkin_pkg/package.py
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.errors import UnreadableFile
from urdfkit.lint.rules import Finding, Location, rule
from urdfkit.mesh.samples import PLATE
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source, Span
from urdfkit.text.xml_reader import is_launch
from urdfkit.workspace.package_references import are_in

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

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
GOOD = BAD.replace("package://bot_description", "..")
FILES = {
    "package.xml": b"""\
<package format="3">
  <name>bot_description</name>
  <version>1.0.0</version>
  <description>A bot.</description>
  <maintainer email="bot@example.org">Bot</maintainer>
  <license>MIT</license>
  <export><build_type>ament_python</build_type></export>
</package>
""",
    "setup.py": b"setup(data_files=[('share/bot_description/meshes', ['meshes/base.stl'])])\n",
    "meshes/base.stl": PLATE,
}

_INDEX = "share/ament_index/resource_index/packages"


@rule("PKG006", "not-registered", Severity.ERROR)
def check(subject: Subject) -> Iterator[Finding]:
    home = subject.resolver.packages.enclosing(subject.source.path)
    if home is None or not (is_launch(subject.source.path) or are_in(subject.document.sources)):
        return
    name, folder = home
    if os.path.exists(os.path.join(folder, "CMakeLists.txt")):
        return
    try:
        manifest, setup = (
            subject.resolver.read(os.path.join(folder, file))
            for file in ("package.xml", "setup.py")
        )
    except UnreadableFile:
        return
    named = re.search(rb"<build_type\b[^>]*>\s*(\w*)", manifest.data)
    if named and named.group(1) == b"ament_python":
        yield from _unregistered(setup, folder, name)
    elif not named and _INDEX.encode() in setup.data:
        yield Finding(
            Location(Span(manifest, 0, 0)),
            "no build type: colcon looks for a CMakeLists.txt",
            "write <export><build_type>ament_python</build_type></export>",
        )


def _unregistered(setup: Source, folder: str, name: str) -> Iterator[Finding]:
    if b"resource_index" not in setup.data:
        yield Finding(
            Location(Span(setup, 0, 0)),
            f"nothing is installed into {_INDEX}: ROS will not find the package '{name}'",
            f"add ('{_INDEX}', ['resource/{name}']) to data_files, and make that empty file",
        )
        return
    marker = re.search(rb"[\"']resource/|[\"']resource[\"']\s*,", setup.data)
    if marker and not os.path.exists(os.path.join(folder, "resource", name)):
        message = f"setup.py installs 'resource/{name}', and there is no such file"
        yield Finding(Location(Span(setup, *marker.span())), message, "make it; it may be empty")
