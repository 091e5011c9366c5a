"""Whether the build of a package installs a path of the source tree.

The answer is True if the build file contains commands that are not understood here.
"""

import os
import posixpath
import re
from fnmatch import fnmatch
from functools import cached_property

from urdfkit.core import disk
from urdfkit.core.paths import upwards
from urdfkit.text.comments import without_comments
from urdfkit.workspace.cmake import cmake_text
from urdfkit.workspace.file_head import head_text, read_head
from urdfkit.workspace.installs import built_targets, known_variables, read_rules

#: Commands with unknown results that may install files: other CMake files, functions of packages.
_UNCLEAR = (
    r"(?i)\badd_subdirectory\s*\(|\binclude\s*\([^()]*[/.]"
    r"|\b(?!(?:catkin_install_python|ament_python_install_\w+|install)\s*\()(?=\w*install)\w+\s*\("
)
#: Commands that create files that are not in the source tree.
_MAKES = (
    r"(?i:\b(?:configure_file|add_custom_\w+|xacro_\w+)\s*\("
    r"|\bfile\s*\(\s*(?!GLOB|READ|REMOVE|STRINGS|TO_))"
)
_SUBDIRECTORY = r"(?i:\badd_subdirectory\s*\(\s*)([^\s()]*)"
_INSTALLS_FILES = r"(?i:\binstall\s*\(\s*(?:DIRECTORY|FILES|PROGRAMS)\b)"
#: Such commands with their arguments, among which are the names of the files.
_MADE = (
    r"(?i)\b(?:execute_process|add_custom_\w+|configure_file|\w*download\w*"
    r"|file\s*\(\s*(?:DOWNLOAD|GENERATE|WRITE|ARCHIVE_EXTRACT))\b[^()]*(?:\([^()]*)?"
)
#: A call of a macro that makes another file of a name.
_GENERATED = r"(?i)\b(?:generate|convert)_\w+\s*\([^()]*\b{}\.\w+"
_MACRO = r"(?is)\b(?:macro|function)\s*\(\s*(\w+)(.*)"
_MAX_MACROS = 100
_END_OF_MACRO = r"(?i)\bend(?:macro|function)\b"
_AFTER_VARIABLE = r"\$\{\w+\}([\w.-]+)"
_COMMAND = r"(?i)\b(set|foreach|install)\s*\(([^()]*)\)"
_VARIABLE = r"\$\{(\w+)\}"
_IS_PYTHON = rb"<build_type\b[^<>]*>\s*ament_python\s*<"
#: Words of a setup.py that lists its files at build time.
_WALK = r"\b(?:walk|rglob|scandir|isdir|is_dir)\b|\*\*"


def build_file(directory: str) -> str:
    """Path of the build file of a package; empty if there is none.

    For a package of type ament_python, colcon reads setup.py even next to a CMakeLists.txt.
    """
    names = ["CMakeLists.txt", "setup.py"]
    manifest = read_head(os.path.join(directory, "package.xml"))
    if b"ament_python" in manifest and re.search(_IS_PYTHON, without_comments(manifest)):
        names.reverse()
    paths = (os.path.join(directory, name) for name in names)
    return next(filter(disk.is_file, paths), "")


class InstallRules:
    """The install rules of a package."""

    def __init__(self, directory: str, package: str) -> None:
        self._directory = directory
        self._package = package

    @cached_property
    def file(self) -> str:
        """The build file; empty if there is none."""
        return build_file(self._directory)

    def installs(self, relative: str) -> bool:
        """True if a path below the package is, or may be, installed."""
        if not self.file:
            return True
        if self.file.endswith(".py"):
            return self._is_data(relative)
        return any(_overlap(relative, target) for target in self._targets) or self._is_unclear

    def misplaced(self, relative: str) -> str:
        """Target of a path that is not installed below ``share/<package>`` as in the source tree.

        Empty if it is installed there, not at all, or if that is unknown.
        """
        wanted = f"share/{self._package}/{relative}"
        if self.file.endswith(".py") and not re.search(_WALK, self._text):
            from urdfkit.workspace.python_installs import place_of  # for Python packages

            place = place_of(self._directory, self._package, relative)
            return "" if place == wanted else place
        if not self.file.endswith(".txt") or self._has_unclear_commands:
            return ""
        rules = read_rules(self._directory, self._package)
        places = [place for rule in rules if (place := rule.place(relative))]
        return "" if wanted in places else "".join(places[:1])

    def _is_data(self, relative: str) -> bool:
        """True if a setup.py may list a path among its data files."""
        top = relative.partition("/")[0]
        if re.search(_WALK, self._text):
            return True
        if top not in self._text:
            return False
        listed = [path for path in self._literal_paths if path.startswith(f"{top}/")]
        if disk.is_directory(os.path.join(self._directory, relative)):
            return not listed or any(path.startswith(f"{relative.rstrip('/')}/") for path in listed)
        return not listed or any(fnmatch(relative, path) or path == f"{top}/" for path in listed)

    @cached_property
    def _literal_paths(self) -> list[str]:
        """The paths and patterns that are literals in a setup.py."""
        import ast  # not needed for CMake

        from urdfkit.text import python_source

        try:
            nodes = list(ast.walk(python_source.parse(self._text)))
        except SyntaxError:
            return []
        paths = []
        for node in nodes:
            parts = [node]
            if isinstance(node, ast.Call) and getattr(node.func, "attr", "") == "join":
                parts = list(node.args)
            words = [text for part in parts if (text := python_source.string(part)) is not None]
            if len(words) == len(parts):
                paths.append(posixpath.join(*words).removeprefix("./"))
        return paths

    @cached_property
    def makes_files(self) -> bool:
        """True if the build creates files, or installs files of other directories."""
        if re.search(_MAKES, self._text):
            return True
        names = re.findall(_SUBDIRECTORY, self._text)
        files = (os.path.join(self._directory, name, "CMakeLists.txt") for name in names)
        texts = map(cmake_text, files)
        return any(
            not text or re.search(f"{_MAKES}|{_INSTALLS_FILES}|{_SUBDIRECTORY}", text)
            for text in texts
        )

    def advice(self, top: str) -> str:
        if self.file.endswith(".py"):
            return f"add the files of {top} to data_files in setup.py"
        return f"write install(DIRECTORY {top} DESTINATION share/${{PROJECT_NAME}})"

    @cached_property
    def _text(self) -> str:
        """The text of the build file, without the comments of CMake."""
        return head_text(self.file) if self.file.endswith(".py") else cmake_text(self.file)

    @cached_property
    def _targets(self) -> list[str]:
        """Installed paths, relative to ``share/<package>``."""
        share = f"share/{self._package}"
        targets = [rule.target for rule in read_rules(self._directory, self._package)]
        return [t[len(share) + 1 :] for t in targets if t == share or t.startswith(f"{share}/")]

    @cached_property
    def _is_unclear(self) -> bool:
        """True if the CMake file has no known install rules, or unknown commands as well."""
        return not self._targets or self._has_unclear_commands

    @cached_property
    def _has_unclear_commands(self) -> bool:
        """True if other commands of the CMake file may install files."""
        if re.search(_UNCLEAR, self._text):
            return True
        known = set(known_variables(self._package))
        for command, arguments in re.findall(_COMMAND, self._text):
            if not known.issuperset(re.findall(_VARIABLE, arguments)):
                return True
            if command.lower() != "install":
                known.update(arguments.split()[:1])
        return False


def _cmake_file(path: str) -> str:
    """The nearest CMake file above a path; empty if there is none."""
    directories = upwards(os.path.dirname(path))
    files = (os.path.join(directory, "CMakeLists.txt") for directory in directories)
    return next(filter(disk.is_file, files), "")


def is_built(path: str) -> bool:
    """True if the nearest CMake file above a missing file creates it.

    It installs the file from the build directory, or names it in a command that creates files, in a
    call of a macro with such commands, or of one that is called ``generate_...`` or ``convert_...``
    and gets a file of the same name in another format.
    """
    file = _cmake_file(path)
    if not file:
        return False
    text = cmake_text(file)
    needed = ("BINARY_DIR", os.path.basename(path), "endmacro", "endfunction", "generate", "conver")
    if not any(word in text for word in needed):
        return False
    directory = os.path.dirname(file)
    relative = os.path.relpath(path, directory).replace(os.sep, "/")
    targets = built_targets(directory)
    if any(relative == target or relative.startswith(f"{target}/") for target in targets):
        return True
    name = rf"""(?:^|[\s/"'(]){re.escape(os.path.basename(path))}(?![\w-])"""
    if any(re.search(name, command) for command in re.findall(_MADE, text)):
        return True
    stem = re.escape(os.path.basename(path).partition(".")[0])
    if re.search(_GENERATED.format(stem), text):
        return True
    return _is_made_by_macro(os.path.basename(path), text)


def _is_made_by_macro(name: str, text: str) -> bool:
    """True if a macro or function of a CMake file creates files, and a call of it names this one.

    The name is an argument, or an argument and what follows a variable in the macro:
    ``${robot}_body.urdf``.
    """
    for part in re.split(_END_OF_MACRO, text, maxsplit=_MAX_MACROS)[:-1]:
        definition = re.search(_MACRO, part)
        if definition is None or not re.search(_MADE, definition[2]):
            continue
        endings = {"", *re.findall(_AFTER_VARIABLE, definition[2])}
        for call in re.findall(rf"(?i)\b{definition[1]}\s*\(([^()]*)\)", text):
            words = [word.strip('"') for word in call.split()]
            if any(f"{word}{ending}" == name for word in words for ending in endings):
                return True
    return False


def is_expanded(path: str) -> bool:
    """True if the nearest CMake file above a xacro expands it, as with ``xacro_add_files``."""
    name = re.escape(os.path.basename(path))
    command = rf"""\bxacro_add\w*\s*\([^()]*(?<=[\s/"(]){name}\b"""
    return re.search(command, cmake_text(_cmake_file(path))) is not None


def _overlap(path: str, target: str) -> bool:
    """True if one of two paths contains the other."""
    if not target or path == target:
        return True
    return path.startswith(f"{target}/") or target.startswith(f"{path}/")
