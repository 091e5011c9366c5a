"""The build file calls the package otherwise than its package.xml does.

ROS finds a package by the name in package.xml, and the build installs its files below the name of
the CMake project. Where the two differ, `package://` and `$(find ...)` lead to folders that the
build never makes, or catkin stops: "package name does not match project name". That a folder has
another name than its package is no defect; a reference that takes it for the name is reported as
not found.

Sources:
    REP 149, package.xml: https://www.ros.org/reps/rep-0149.html
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

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

NAME = "urdf/bad.urdf"
BAD = """\
<robot name="bad">
  <link name="base">
    <visual>
      <geometry><mesh filename="package://bot_description/meshes/base.stl"/></geometry>
    </visual>
  </link>
</robot>
"""
GOOD = BAD.replace("package://bot_description", "..")
FILES = {
    "package.xml": b"<package><name>bot_description</name></package>",
    "CMakeLists.txt": b"cmake_minimum_required(VERSION 3.8)\nproject(bot_descripton)\n",
    "meshes/base.stl": PLATE,
}

#: Where each build file gives the name, as far as it is written out.
_NAMES = {
    "CMakeLists.txt": rb"(?im)^[^#\n]*?\bproject\s*\(\s*\"?([A-Za-z][\w-]*)",
    "setup.py": rb"(?m)^[ \t]*(?:package_name|PACKAGE_NAME)\s*=\s*[\"']([\w-]+)[\"']",
}


@rule("PKG003", "name-differs", Severity.WARNING, help="give both the same name")
def check(subject: Subject) -> Iterator[Finding]:
    home = subject.resolver.packages.enclosing(subject.source.path)
    sources = subject.document.sources
    if home is None or not any(b"package://" in s.data or b"$(find" in s.data for s in sources):
        return
    name, folder = home
    for file, pattern in _NAMES.items():
        try:
            source = Source.read(os.path.join(folder, file))
        except UnreadableFile:
            continue
        found = re.search(pattern, source.data)
        if found and found.group(1).decode() != name:
            yield Finding(
                Location(Span(source, *found.span(1))),
                f"{file} calls the package '{found.group(1).decode()}', and package.xml calls it "
                f"'{name}'",
            )
        return
