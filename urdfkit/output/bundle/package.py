"""Build files of a bundle that is a ROS 2 package: package.xml and CMakeLists.txt."""

import re
from collections.abc import Iterable, Iterator

from urdfkit.core.grouping import by_key
from urdfkit.lint.context import Context
from urdfkit.output.bundle.meshes import BundledFile
from urdfkit.workspace.manifest import manifest_of

#: Elements that are copied from the original package of the robot.
_KEPT = rb"<(version|maintainer|license)\b[^<>]*>[^<]*</\1>"
_DEFAULT = {
    "version": "<version>0.0.0</version>",
    "maintainer": '<maintainer email="todo@example.com">todo</maintainer>',
    "license": "<license>TODO</license>",
}


def package_files(name: str, robot: Context, directories: Iterable[str]) -> Iterator[BundledFile]:
    """The build files of a package.

    Args:
        robot: the version, maintainers and licences of its package are copied.
    """
    manifest = manifest_of(robot.resolver, robot.source.path)
    matches = re.finditer(_KEPT, manifest.data if manifest else b"")
    copied = by_key((match[1].decode(), match[0].decode("utf-8", "replace")) for match in matches)
    lines = [line for tag, default in _DEFAULT.items() for line in copied.get(tag, [default])]
    version, *others = lines
    body = "\n  ".join(
        (
            f"<name>{name}</name>",
            version,
            f"<description>The robot {name} with its meshes</description>",
            *others,
            "<buildtool_depend>ament_cmake</buildtool_depend>",
            "<export><build_type>ament_cmake</build_type></export>",
        )
    )
    text = f'<?xml version="1.0"?>\n<package format="3">\n  {body}\n</package>\n'
    yield BundledFile("package.xml", text.encode(), "")
    build = (
        "cmake_minimum_required(VERSION 3.8)",
        f"project({name})",
        "find_package(ament_cmake REQUIRED)",
        f"install(DIRECTORY {' '.join(directories)} DESTINATION share/${{PROJECT_NAME}})",
        "ament_package()",
    )
    yield BundledFile("CMakeLists.txt", "\n".join((*build, "")).encode(), "")
