"""The build of a package with messages, services or actions stops.

A file does not exist, package.xml has no `<member_of_group> rosidl_interface_packages`, or
CMakeLists.txt does not find a package of DEPENDENCIES. Packages on which that of the file depends
are checked, too.

Only launch files, with the packages of the nodes that they start, and descriptions that refer to
packages are checked.

Sources:
    ros2/rosidl, rosidl_generate_interfaces.cmake: https://github.com/ros2/rosidl/blob/rolling/rosidl_cmake/cmake/rosidl_generate_interfaces.cmake
"""

import os
import posixpath
import re
from collections.abc import Iterator
from itertools import takewhile

from urdfkit.checks.package.build_files import (
    INTERFACES,
    is_missing,
    package_file,
    packages_to_build,
    packages_with_interfaces,
)
from urdfkit.checks.package.samples import robot_of_package
from urdfkit.core import disk
from urdfkit.core.suggest import nearest
from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.mesh.samples import PLATE
from urdfkit.text.comments import blank_comments
from urdfkit.text.source import Source, Span
from urdfkit.workspace.cmake import blank_cmake_comments

NAME = "urdf/bot.urdf"
BAD = robot_of_package("bot_description")
GOOD = BAD.replace("package://bot_description", "..")
FILES = {
    "package.xml": b"""\
<package format="3">
  <name>bot_description</name>
  <member_of_group>rosidl_interface_packages</member_of_group>
</package>
""",
    "CMakeLists.txt": b"""\
project(bot_description)
find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces(${PROJECT_NAME} "msg/Load.msg")
ament_package()
""",
    "meshes/base.stl": PLATE,
}

_FOUND = rb"\bfind_package\s*\(\s*([\w-]+)"
#: What finds packages in another way, or creates files.
_OTHER = rb"\b(ament_auto_\w+|configure_file|file|foreach|include|macro)\s*\("
_KEYWORDS = (
    "ADD_LINTER_TESTS", "DEPENDENCIES", "LIBRARY_NAME", "SKIP_GROUP_MEMBERSHIP_CHECK",
    "SKIP_INSTALL",
)  # fmt: skip
_SUFFIXES = (".action", ".idl", ".msg", ".srv")
_GROUP = "rosidl_interface_packages"
#: Packages that bring no messages along, or only those of time and of actions.
_WITHOUT_OTHERS = r"ament_\w+|rosidl_\w+|builtin_interfaces|std_msgs|action_msgs"
_BROUGHT = ("action_msgs", "builtin_interfaces", "service_msgs", "unique_identifier_msgs")


@rule(Severity.ERROR, help="fix the CMakeLists.txt")
def check(context: Context) -> Findings:
    directories = (*packages_to_build(context).values(), *packages_with_interfaces(context))
    for directory in dict.fromkeys(directories):
        yield from _not_generated(directory)


def _not_generated(directory: str) -> Findings:
    """What stops the build of a package with interfaces."""
    build, manifest = (package_file(directory, file) for file in ("CMakeLists.txt", "package.xml"))
    if build is None or manifest is None or b"rosidl_" not in build.data:
        return
    text = blank_cmake_comments(build.data)
    call = re.search(INTERFACES, text)
    if call is None:
        return
    words = list(_words(call, build))
    names = [word for word, _ in words]
    if "SKIP_INSTALL" not in names and "SKIP_GROUP_MEMBERSHIP_CHECK" not in names:
        yield from _not_in_group(manifest, Span(build, call.start(), call.start(1)))
    if re.search(_OTHER, text) or any("$" in name for name in names):
        return
    yield from _missing_files(directory, words)
    if "DEPENDENCIES" in names:
        listed = words[names.index("DEPENDENCIES") + 1 :]
        found = {match[1].decode() for match in re.finditer(_FOUND, text)}
        yield from _not_found(listed, found)


def _missing_files(directory: str, words: list[tuple[str, Span]]) -> Findings:
    """Files of interfaces that do not exist."""
    for path, span in _until_keyword(words):
        if path.endswith(_SUFFIXES) and is_missing(directory, path):
            folder = posixpath.dirname(path)
            files = disk.names_or_empty(os.path.join(directory, folder))
            match = nearest(path, [posixpath.join(folder, file) for file in files])
            message = f"interface '{path}' does not exist: the build fails"
            help = f"write {match}" if match else f"create {path}, or remove it here"
            yield Finding(span, message, help)


def _not_found(listed: list[tuple[str, Span]], found: set[str]) -> Findings:
    """Packages on which the interfaces depend, and which CMakeLists.txt does not find."""
    are_known = all(re.fullmatch(_WITHOUT_OTHERS, name) for name in found)
    for name, span in _until_keyword(listed) if are_known else ():
        if name not in found and name not in _BROUGHT:
            message = f"CMakeLists.txt does not find {name}, on which the interfaces depend"
            yield Finding(span, message, f"write find_package({name} REQUIRED) above")


def _until_keyword(words: list[tuple[str, Span]]) -> Iterator[tuple[str, Span]]:
    return takewhile(lambda word: word[0] not in _KEYWORDS, words)


def _words(call: re.Match[bytes], build: Source) -> Iterator[tuple[str, Span]]:
    """The arguments of a call without their quotes."""
    for word in re.finditer(rb"[^\s\";]+", call[1]):
        start = call.start(1) + word.start()
        yield word[0].decode("utf-8", "replace"), Span(build, start, start + len(word[0]))


def _not_in_group(manifest: Source, span: Span) -> Findings:
    data = blank_comments(manifest.data)
    if not re.search(rb"<member_of_group\b[^<>]*>\s*%s\s*<" % _GROUP.encode(), data):
        message = (
            f"package.xml has no <member_of_group> {_GROUP}: the build of the interfaces stops"
        )
        help = f"add <member_of_group>{_GROUP}</member_of_group>, which format 3 has"
        yield Finding(span, message, help)
