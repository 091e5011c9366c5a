"""The setup.py of a Python package of ROS 2 does not build it, or ROS does not find it.

- The `package_name` is another one than in package.xml (warning).
- The executables are installed where `ros2 run` does not find them: setup.cfg does not set
  `install_scripts` to `$base/lib/NAME`. Or their module or function does not exist (warning).
- setup.py is not a Python program, or uses a name that it does not import, such as `glob`. It names
  a directory of modules that does not exist; or `find_packages()` misses a directory without
  `__init__.py`, or a pattern for installed files matches none (warning). Or a file that it installs
  does not exist.
- The package is not registered. `ros2 launch`, `package://` and `$(find ...)` find it
  only if setup.py installs an existing file of its name into
  `share/ament_index/resource_index/packages`. If setup.py does not mention that directory, colcon
  creates the file with a deprecation warning; a Debian package lacks it (warning).
  Without `<build_type>ament_python</build_type>` in `<export>`, colcon looks for a CMakeLists.txt.

Only launch files, with the packages of the nodes that they start, and descriptions that refer to
packages are checked.

Sources:
    colcon/colcon-ros#79: https://github.com/colcon/colcon-ros/pull/79
    ROS 2, developing a package: https://docs.ros.org/en/rolling/How-To-Guides/Developing-a-ROS-2-Package.html
"""

import os
import re

from urdfkit.checks.package.build_files import other_name, package_file, packages_to_build
from urdfkit.checks.package.samples import robot_of_package
from urdfkit.core import disk
from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.mesh.samples import PLATE
from urdfkit.text.source import Source, Span
from urdfkit.workspace.install_rules import build_file

NAME = "urdf/bot.urdf"
BAD = robot_of_package("bot_description")
GOOD = BAD.replace("package://bot_description", "..")
FILES = {
    "package.xml": b"""\
<package format="3">
  <name>bot_description</name>
  <export><build_type>ament_python</build_type></export>
</package>
""",
    "setup.py": b"""\
from setuptools import setup

package_name = "bot_description"
setup(
    name=package_name,
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/" + package_name]),
    ],
)
""",
    "meshes/base.stl": PLATE,
}

_INDEX = "share/ament_index/resource_index/packages"


@rule(Severity.ERROR, help="fix the setup.py")
def check(context: Context) -> Findings:
    for name, directory in packages_to_build(context).items():
        if build_file(directory).endswith(".txt"):
            continue
        others = list(other_name(name, directory))
        yield from others or _not_registered(name, directory)  # which has the name of package.xml
        if build_file(directory).endswith(".py"):
            from urdfkit.checks.package.python_executables import not_runnable  # for few robots

            yield from not_runnable(name, directory, has_other_name=bool(others))


def _not_registered(name: str, directory: str) -> Findings:
    """A Python package of ROS 2 that ROS or colcon does not find."""
    manifest, setup = (package_file(directory, file) for file in ("package.xml", "setup.py"))
    if manifest is None or setup is None:
        return
    named = re.search(rb"<build_type\b[^<>]*>\s*(\w*)", manifest.data)
    if named and named.group(1) == b"ament_python":
        yield from _unregistered(setup, directory, name)
    elif not named and _INDEX.encode() in setup.data:
        message = "no build type: colcon looks for a CMakeLists.txt"
        help = "add <export><build_type>ament_python</build_type></export>"
        yield Finding(Span(manifest, 0, 0), message, help)


def _unregistered(setup: Source, directory: str, name: str) -> Findings:
    if b"resource_index" not in setup.data:
        message = (
            f"nothing is installed into {_INDEX}: ROS finds the package '{name}' only where colcon "
            "adds the entry, with a warning"
        )
        help = f"add ('{_INDEX}', ['resource/{name}']) to data_files, and create that empty file"
        yield Finding(Span(setup, 0, 0), message, help, severity=Severity.WARNING)
        return
    marker = re.search(rb"[\"']resource/|[\"']resource[\"']\s*,", setup.data)
    if marker and not disk.exists(os.path.join(directory, "resource", name)):
        message = f"file not found: resource/{name}, which setup.py installs"
        yield Finding(Span(setup, *marker.span()), message, "create it; it may be empty")
