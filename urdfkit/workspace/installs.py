"""Install rules of a CMakeLists.txt: the source files of paths in the installed package.

``$(find pkg)/urdf/x`` refers to the installed package. Most packages install a directory under its
own name; others rename directories, and then the path exists only after a build.
"""

from __future__ import annotations

import os
import posixpath
import re
from collections.abc import Iterable, Iterator, Mapping

from urdfkit.core.record import Record
from urdfkit.workspace.file_head import MAX_BYTES, head_text

MAX_COMMANDS = 20_000

#: Macros of ros2_canopen that install the directory ``config/<name>`` of a bus, from
#: lely_core_libraries/cmake/lely_core_libraries-extras.cmake.
_INSTALL_BUSES = ("cogen_dcf", "generate_dcf")

#: Stands for the build directory in the sources of install rules.
BUILT = "<build>"
_BUILD_DIRECTORIES = ("CMAKE_BINARY_DIR", "CMAKE_CURRENT_BINARY_DIR", "PROJECT_BINARY_DIR")

_TOKEN = r"""(?sx)\#\[(=*)\[.*?\]\1\]        # a bracket comment
      | \#[^\n]*                   # a comment
      | "((?:[^"\\]|\\.)*)"        # a quoted argument
      | ([()])
      | ([^\s()#"]+)
    """
_VARIABLE = r"\$\{([^${}]*)\}"
_END_OF_SOURCES = frozenset(
    "COMPONENT CONFIGURATIONS EXCLUDE EXCLUDE_FROM_ALL FILES_MATCHING FILE_PERMISSIONS "
    "DIRECTORY_PERMISSIONS MESSAGE_NEVER OPTIONAL PATTERN PERMISSIONS REGEX RENAME TYPE "
    "USE_SOURCE_PERMISSIONS".split()
)


class Installed(Record):
    """One install rule for a file or directory."""

    source: str  # path below the package's directory
    target: str  # path below the install prefix

    def place(self, path: str) -> str:
        """Installed path of a path below the package's directory; empty if it is not installed."""
        if path == self.source or path.startswith(f"{self.source}/"):
            return posixpath.normpath(self.target + path[len(self.source) :])
        return ""


class _Command(Record):
    name: str
    arguments: tuple[tuple[str, bool], ...]  # text, and whether it is quoted


def source_paths(rules: Iterable[Installed], package: str, relative: str) -> list[str]:
    """The paths in a source tree that may be installed at ``share/<package>/<relative>``."""
    wanted = posixpath.normpath(f"share/{package}/{relative}")
    paths = []
    for rule in rules:
        if wanted == rule.target or wanted.startswith(f"{rule.target}/"):
            rest = wanted[len(rule.target) :]
            paths.append(posixpath.normpath(rule.source + rest))
    return paths


def read_rules(
    directory: str, package: str, variables: Mapping[str, str] | None = None
) -> list[Installed]:
    """Install rules of the CMakeLists.txt of a package; conditions are assumed to be true.

    Args:
        variables: additional variables with their values.
    """
    text = head_text(os.path.join(directory, "CMakeLists.txt"))
    reader = _CMakeReader({**known_variables(package), **(variables or {})})
    for command in _commands(text):
        reader.read(command)
    return reader.rules


def built_targets(directory: str) -> list[str]:
    """Paths of files that the build creates, below ``share/<package>`` where they are installed."""
    built = dict.fromkeys(_BUILD_DIRECTORIES, BUILT)
    rules = read_rules(directory, "package", built)
    targets = (rule.target for rule in rules if rule.source.startswith(f"{BUILT}/"))
    return ["/".join(target.split("/")[2:]) for target in targets]


def known_variables(package: str) -> dict[str, str]:
    """Variables that CMake or catkin sets, as paths below the install prefix."""
    share = f"share/{package}"
    return {
        "PROJECT_NAME": package,
        "CMAKE_PROJECT_NAME": package,
        "CMAKE_SOURCE_DIR": ".",
        "CMAKE_CURRENT_SOURCE_DIR": ".",
        "CMAKE_CURRENT_LIST_DIR": ".",
        "PROJECT_SOURCE_DIR": ".",
        "CMAKE_INSTALL_PREFIX": ".",
        "CMAKE_INSTALL_DATADIR": "share",
        "CMAKE_INSTALL_DATAROOTDIR": "share",
        "CMAKE_INSTALL_FULL_DATADIR": "share",
        "CATKIN_PACKAGE_SHARE_DESTINATION": share,
        "CATKIN_PACKAGE_BIN_DESTINATION": f"lib/{package}",
        "CATKIN_PACKAGE_INCLUDE_DESTINATION": f"include/{package}",
        "CATKIN_PACKAGE_LIB_DESTINATION": "lib",
        "CATKIN_GLOBAL_SHARE_DESTINATION": "share",
    }


def _commands(text: str) -> Iterator[_Command]:
    name = ""
    arguments: list[tuple[str, bool]] = []
    depth = 0
    for token in re.finditer(_TOKEN, text):
        _, quoted, bracket, word = token.groups()
        if bracket == "(":
            depth += 1
        elif bracket == ")":
            depth -= 1
            if depth <= 0:
                yield _Command(name.lower(), tuple(arguments))
                name, arguments, depth = "", [], 0
        elif depth == 0:
            name = word or ""
        elif quoted is not None or word:
            arguments.append((quoted if quoted is not None else word, quoted is not None))


class _CMakeReader:
    """Interprets the commands for install rules; the body of a loop is run for each item."""

    def __init__(self, variables: dict[str, str]) -> None:
        self.rules: list[Installed] = []
        self._variables = variables
        self._loops: list[tuple[str, list[str], list[_Command]]] = []
        self._count = 0

    def read(self, command: _Command) -> None:
        self._count += 1
        if self._count > MAX_COMMANDS:
            return
        if command.name == "foreach":
            self._loops.append((*_loop(command, self._variables), []))
        elif command.name == "endforeach":
            self._unroll()
        elif self._loops:
            self._loops[-1][2].append(command)
        elif command.name == "set":
            words = _expanded(command, self._variables)
            if words:
                self._variables[words[0]] = ";".join(words[1:])
        elif command.name == "install":
            self.rules += _install(_expanded(command, self._variables))
        else:
            self.rules += self._of_macro(command)

    def _of_macro(self, command: _Command) -> Iterable[Installed]:
        """What a macro of another package installs."""
        share = self._variables["CATKIN_PACKAGE_SHARE_DESTINATION"]
        words = _expanded(command, self._variables)
        if command.name == "ament_auto_package":
            return _install(["DIRECTORY", *_to_share(words), "DESTINATION", share])
        if command.name in _INSTALL_BUSES:
            return [Installed(f"config/{bus}", f"{share}/config/{bus}") for bus in words]
        return ()

    def _unroll(self) -> None:
        if not self._loops:
            return
        variable, items, body = self._loops.pop()
        for item in items:
            # Inside another loop, this extends the body of the outer loop.
            self.read(_Command("set", ((variable, False), (item, False))))
            for command in body:
                self.read(command)
            if self._count > MAX_COMMANDS:
                return


def _loop(command: _Command, variables: dict[str, str]) -> tuple[str, list[str]]:
    """The variable and the items of a foreach."""
    words = _expanded(command, variables)
    variable, rest = (words[0], words[1:]) if words else ("", [])
    if rest[:2] == ["IN", "ITEMS"]:
        return variable, rest[2:]
    if rest[:2] == ["IN", "LISTS"]:
        return variable, [i for name in rest[2:] for i in variables.get(name, "").split(";") if i]
    return variable, rest


def _expanded(command: _Command, variables: dict[str, str]) -> list[str]:
    """The arguments with their variables replaced; unknown variables do not change."""
    words: list[str] = []
    for text, quoted in command.arguments:
        value = text
        for _ in range(5):  # names of variables may contain variables
            replaced = re.sub(_VARIABLE, lambda m: variables.get(m.group(1), m.group()), value)
            if replaced == value or len(replaced) > MAX_BYTES:
                break
            value = replaced
        words += [value] if quoted else [part for part in value.split(";") if part]
    return words


def _to_share(words: list[str]) -> list[str]:
    """The directories of ``ament_auto_package(INSTALL_TO_SHARE ...)``."""
    if "INSTALL_TO_SHARE" not in words:
        return []
    directories = words[words.index("INSTALL_TO_SHARE") + 1 :]
    return [directory.rstrip("/") for directory in directories if not directory.isupper()]


def _install(words: list[str]) -> Iterator[Installed]:
    """The rules of ``install(DIRECTORY ...)`` and ``install(FILES ...)``."""
    if not words or words[0] not in ("DIRECTORY", "FILES", "PROGRAMS"):
        return
    if "DESTINATION" not in words[:-1]:
        return
    destination = words[words.index("DESTINATION") + 1]
    if "${" in destination:
        return
    for source in words[1:]:
        if source == "DESTINATION" or source in _END_OF_SOURCES:
            break
        if "${" in source or source.startswith("/"):
            continue
        target = destination
        if words[0] != "DIRECTORY" or not source.endswith("/"):
            target += "/" + posixpath.basename(posixpath.normpath(source))
        yield Installed(posixpath.normpath(source), posixpath.normpath(target))
