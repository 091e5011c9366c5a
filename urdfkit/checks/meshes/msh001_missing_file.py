"""A mesh file does not exist.

RViz shows the link white or not at all and reports an error; Gazebo omits the shape, so that a link
without its collision falls through the floor; Pinocchio and MuJoCo reject the model. The package
was found, but the file in it was not: the name is misspelt, a directory was moved, or the file was
never committed. XAC011 reports packages that are not found. Also reported:

- A name that differs from the file's name in upper and lower case: Windows and most Macs find the
  file, Linux does not.
- Backslashes, which separate directories only on Windows. Write `/`. Drives, as in `C:/arm.stl`.
- A third slash, as in `package:///arm/arm.stl`, or a file alone, as in `package://arm.stl`: the
  package is missing. Only PyBullet searches for the rest next to the URDF, and Pinocchio if its
  directory is among `package_dirs` (a warning if it is there).
- A file outside the workspace of the model and of the packages that are found: it exists on this
  computer only, and urdfkit does not read it (a warning).
- A file of an installation of ROS, as in `file:///opt/ros/...`, on a computer without it: urdfkit
  cannot check whether it exists (a warning).
- A file of a git submodule that is not checked out (a warning): run `git submodule update --init`.
- A file that git ignores: it is downloaded or generated, or was never committed (a warning).
- A file that a command in the CMakeLists.txt of its package creates (an info): build the workspace.
- A path with a name between two `@`, which CMake replaces (an info).
- An absolute path that is found as a relative one: only PyBullet ignores the first slash (a
  warning).
- A relative path that is found from a parent directory: only PyBullet and Isaac search there (a
  warning); in a xacro, the path is relative to the directory where the expanded URDF is written (an
  info).
- A name that only MuJoCo finds, by `<mujoco><compiler meshdir="..."/></mujoco>` in the URDF (an
  info).
- One slash after a scheme, as in `package:/arm/arm.stl`.
- An unknown scheme: only `package://`, `model://` and `file://` refer to files. Meshes on the web,
  which only RViz downloads, are not reported.

Sources:
    URDF, link: https://wiki.ros.org/urdf/XML/link
    RViz, robot_link.cpp: https://github.com/ros2/rviz/blob/rolling/rviz_default_plugins/src/rviz_default_plugins/robot/robot_link.cpp
    PyBullet, BulletUrdfImporter.cpp: https://github.com/bulletphysics/bullet3/blob/master/examples/Importers/ImportURDFDemo/BulletUrdfImporter.cpp
    Isaac, urdf-importer-extension: https://github.com/isaac-sim/urdf-importer-extension
    Pinocchio, URDF geometry: https://github.com/stack-of-tasks/pinocchio/blob/devel/src/parsers/urdf/geometry.cpp
    MuJoCo, user_mesh.cc: https://github.com/google-deepmind/mujoco/blob/main/src/user/user_mesh.cc
    measured: 60 of 548 public models with meshes
"""

import os
import re

from urdfkit.core import disk
from urdfkit.core.suggest import nearest
from urdfkit.lint.rules import Context, Finding, Findings, Fix, Need, Severity, rule
from urdfkit.mesh.samples import PLATE
from urdfkit.robot.assets.mesh_files import MeshReference
from urdfkit.robot.assets.mesh_suggestions import MeshSuggestions, Suggestion
from urdfkit.robot.samples import mesh_xml
from urdfkit.text.editing.edits import replace_value
from urdfkit.text.file_kinds import is_xacro
from urdfkit.text.source import shown
from urdfkit.workspace.install_rules import is_built
from urdfkit.workspace.references import ResolvedReference
from urdfkit.workspace.resolve import OUTSIDE
from urdfkit.workspace.submodules import absent_submodules

BAD = mesh_xml("visual", "package://arm_description/meshes/forarm.stl")
FIXED = GOOD = BAD.replace("forarm", "forearm")
FILES = {
    "package.xml": b"<package><name>arm_description</name></package>",
    "meshes/forearm.stl": PLATE,
}

_SCHEMES = ("package", "model", "file")
#: A scheme without its colon or one of its slashes.
_CUT_SCHEME = r"(package|model)(?::/?|//)(?=[^/:])"
#: A drive of Windows, also as a URI.
_DRIVE = r"(?:file:/*)?[A-Za-z]:[\\/]"
#: Number of parent directories to search for relative paths: description/urdf/parts.
_MAX_LEVELS = 3
#: Installation directories of ROS packages: `/opt/ros/humble`, `/opt/pal/ferrum`.
_INSTALLATION = r"/+(opt/[^/]+/[^/]+|usr/(local/)?share/[^/]+)/"
#: A variable that ``configure_file`` of CMake replaces.
_VARIABLE = r"@[A-Za-z_]\w*@"
#: Schemes that some programs download, and urdfkit does not.
_REMOTE = ("http", "https", "ftp", "fuel")


@rule(
    Severity.ERROR,
    needs=(Need.MODEL, Need.FILES),
    help="add the file, or generate one: urdfkit mesh generate --model ROBOT",
    about_files=True,
)
def check(context: Context) -> Findings:
    missing = set(map(id, context.files.missing))
    suggestions = MeshSuggestions(context.files)
    for mesh in context.files.meshes:
        scheme, colon, rest = mesh.at.value.partition("://")
        if "\\" in mesh.at.value or (id(mesh) in missing and re.match(_DRIVE, mesh.at.value)):
            yield _of_windows(context, mesh, suggestions)
        elif id(mesh) in missing and (match := re.match(_CUT_SCHEME, mesh.at.value)):
            yield _cut_scheme(mesh, match)
        elif colon and scheme not in _SCHEMES and scheme.lower() not in _REMOTE:
            yield _unknown_scheme(mesh, scheme, rest)
        elif mesh.located.package == "":
            yield _without_package(context, mesh, suggestions)
        elif mesh.located.outside:
            message = f"{mesh.who} {OUTSIDE}: not read"
            help = "move it into the package, name its directory with --package, or pass --trust"
            yield Finding(mesh.at, message, help, severity=Severity.WARNING)
        elif id(mesh) in missing:
            yield (
                _of_installation(mesh)
                or _of_submodule(context, mesh)
                or _of_cmake(mesh)
                or _of_build(mesh)
                or _missing(context, mesh, suggestions)
            )


def _of_windows(context: Context, mesh: MeshReference, suggestions: MeshSuggestions) -> Finding:
    """Finding about a path with backslashes, or on a drive."""
    path = mesh.at.value.replace("\\", "/")
    drive = re.match(_DRIVE, path)
    located = context.resolver.locate(path[drive.end() - 1 :] if drive else path, context.files.top)
    what = "is on a drive of Windows" if drive else "has backslashes"
    message = f"{mesh.who} {what}: not found on Linux"
    is_sought = located.path is None and located.tried
    suggested = suggestions.nearest(mesh._replace(located=located)) if is_sought else None
    if suggested:
        return _with_suggestion(mesh, message, suggested, what)
    if drive:
        return Finding(mesh.at, message, "write package://PACKAGE/...", group_key=what)
    fix = _fix(mesh, path, "write / instead of backslashes")
    return Finding(mesh.at, message, "write / instead", fix)


def _without_package(
    context: Context, mesh: MeshReference, suggestions: MeshSuggestions
) -> Finding:
    """Finding about ``package:///name/...``, with an empty package, and ``package://file.stl``."""
    scheme, _, rest = mesh.at.value.partition("://")
    path, right = rest.lstrip("/"), f"{scheme}://PACKAGE/..."
    where = f"between '{scheme}://' and " + ("the next '/'" if "/" in rest else "the file")
    message = f"{mesh.who} names no package {where}"
    if disk.is_file(os.path.join(os.path.dirname(context.files.top), path)):
        message += "; only PyBullet and Pinocchio find it, next to the URDF"
        help, fix = f"write {path}, or {right}", _fix(mesh, path, f"refer to {path}")
        return Finding(
            mesh.at, message, help, fix, group_key="next to the URDF", severity=Severity.WARNING
        )
    reference = f"{scheme}://{path}"
    if context.resolver.locate(reference, context.files.top).path is not None:
        fix = _fix(mesh, reference, "remove the third slash")
        return Finding(mesh.at, message, f"write {right}", fix, group_key=scheme)
    relative = context.resolver.locate(path, context.files.top)
    if suggested := suggestions.nearest(mesh._replace(located=relative)):
        return _with_suggestion(mesh, message, suggested, "suggested")
    help = f"write the path relative to the URDF, or {right}"
    return Finding(mesh.at, message, help, group_key=scheme)


def _cut_scheme(mesh: MeshReference, match: re.Match[str]) -> Finding:
    """Finding about ``package:/name/...``, which programs read as a relative path."""
    right = f"{match[1]}://"
    message = f"{mesh.who} begins with '{match[0]}', not with '{right}'"
    fix = _fix(mesh, right + mesh.at.value[match.end() :], f"write {right}")
    return Finding(mesh.at, message, f"write {right}", fix, group_key=match[0])


def _unknown_scheme(mesh: MeshReference, scheme: str, rest: str) -> Finding:
    message = f"{mesh.who} has the unknown scheme '{scheme}://'"
    if (right := nearest(scheme.lower(), _SCHEMES)) is None:
        return Finding(mesh.at, message, "write package://PACKAGE/path")
    fix = _fix(mesh, f"{right}://{rest}", f"write {right}://")
    return Finding(mesh.at, message, f"did you mean '{right}://'?", fix)


def _of_installation(mesh: MeshReference) -> Finding | None:
    """Finding about a file of an installation that does not exist on this computer; else None."""
    located = mesh.located
    match = re.match(_INSTALLATION, located.tried[0]) if located.scheme == "absolute" else None
    if match is None or disk.is_directory(match[0]):
        return None
    directory = match[0].rstrip("/")
    message = f"{mesh.who} is in {directory}, which is not on this computer: not checked"
    help = "write package://PACKAGE/..., which is found wherever the package is installed"
    return Finding(mesh.at, message, help, severity=Severity.WARNING, group_key=directory)


def _of_submodule(context: Context, mesh: MeshReference) -> Finding | None:
    """Finding about a file of a git submodule that is not checked out; else None."""
    repository = context.resolver.packages.root(context.source.path).directory
    for directory in absent_submodules(repository):
        if any(path.startswith(os.path.join(directory, "")) for path in mesh.located.tried):
            name = os.path.relpath(directory, repository)
            message = f"{mesh.who} is in git submodule '{name}', which is not there: not checked"
            help = "run git submodule update --init"
            severity = Severity.WARNING
            return Finding(mesh.at, message, help, group_key=directory, severity=severity)
    return None


def _of_cmake(mesh: MeshReference) -> Finding | None:
    """Finding about a path with a variable that CMake replaces; else None."""
    match = re.search(_VARIABLE, mesh.at.value)
    if match is None:
        return None
    message = f"{mesh.who} has {match[0]}, which CMake replaces: not checked"
    help = "check the file that the build writes"
    return Finding(mesh.at, message, help, group_key=match[0], severity=Severity.INFO)


def _of_build(mesh: MeshReference) -> Finding | None:
    """Finding about a file that the build creates; else None."""
    if not any(map(is_built, mesh.located.tried)):
        return None
    message = f"{mesh.who} is created by the build, which has not run: not checked"
    return Finding(mesh.at, message, "build the workspace", severity=Severity.INFO)


def _missing(context: Context, mesh: MeshReference, suggestions: MeshSuggestions) -> Finding:
    located = mesh.located
    if spelling := suggestions.spelling_on_disk(mesh):
        message = f"{mesh.who} is called '{spelling.reference}' on disk: not found on Linux"
        fix = _fix(mesh, spelling.reference, "write the name as on disk")
        return Finding(mesh.at, message, "write the name as it is on disk", fix)
    if directory := _directory_above(context, located):
        return _found_above(context, mesh, directory)
    if directory := _directory_of_mujoco(context, mesh):
        message = f"{mesh.who} is found by MuJoCo alone, which looks in {shown(directory)}"
        help = "for other programs, write a path relative to the URDF, or package://PACKAGE/..."
        return Finding(mesh.at, message, help, group_key=directory, severity=Severity.INFO)
    if finding := _of_working_directory(context, mesh) or _without_slash(context, mesh):
        return finding
    where = f" in package '{located.package}'" if located.package else ""
    # An absolute path in the message is the path that was tried.
    tried = "" if located.scheme == "absolute" else f"; tried {located.tried_paths}"
    message = f"{mesh.who} does not exist{where}{tried}"
    suggested = suggestions.nearest(mesh)
    if model := _model(mesh, suggested, suggestions):
        help = f"export it from {model}, which is there, as STL, COLLADA (.dae) or OBJ"
        return Finding(mesh.at, message, help, group_key=f"model {_missing_directory(located)}")
    if suggested is None and context.files.is_ignored(mesh):
        message += "; git ignores it"
        help = "download or generate it as the README says, or let git track it: git add -f FILE"
        key = f"ignored {_missing_directory(located)}"
        return Finding(mesh.at, message, help, group_key=key, severity=Severity.WARNING)
    if suggested is None:
        installed = suggestions.installed_reference(located)
        help = f"write {installed}, and add the package" if installed else ""
        written = mesh.at.span.text
        is_found = "$(find" in written or ("${" in written and _is_of_package(context, located))
        if not installed and located.scheme == "absolute" and not is_found:
            help = "add the file, and write package://PACKAGE/..., which all computers find"
        return Finding(mesh.at, message, help, group_key=_missing_directory(located))
    finding = _with_suggestion(mesh, message, suggested, "")
    group_key = f"{'fixed' if finding.fix else 'suggested'} {_missing_directory(located)}"
    return finding._replace(group_key=group_key)


def _model(mesh: MeshReference, suggested: Suggestion | None, suggestions: MeshSuggestions) -> str:
    """The file of which a missing one may be an export; empty if a mesh is next to it, too."""
    directory = os.path.dirname(mesh.at.value)
    if suggested and os.path.dirname(suggested.reference) == directory:
        return ""
    return suggestions.model_of_other_format(mesh)


def _with_suggestion(
    mesh: MeshReference, message: str, suggested: Suggestion, group_key: str
) -> Finding:
    new = suggested.reference
    fix = _fix(mesh, new, f"refer to {new}") if suggested.sure else None
    return Finding(mesh.at, message, f"did you mean '{new}'?", fix, group_key=group_key)


def _is_of_package(context: Context, located: ResolvedReference) -> bool:
    """True if a path is in a package of the workspace, so that a property has $(find ...)."""
    packages = context.resolver.packages
    above = packages.enclosing(located.tried[0])
    return above is not None and above[1] in packages.known(context.source.path).values()


def _found_above(context: Context, mesh: MeshReference, directory: str) -> Finding:
    if is_xacro(context.source):
        message = f"{mesh.who} is found if the URDF is written to {shown(directory)}"
        help = "write package://PACKAGE/..., or write the URDF there"
        return Finding(mesh.at, message, help, group_key=directory, severity=Severity.INFO)
    message = f"{mesh.who} is found in {shown(directory)}, where only PyBullet and Isaac look, too"
    path = os.path.join(directory, mesh.located.reference)
    own = os.path.dirname(os.path.abspath(context.files.top))
    right = os.path.relpath(path, own).replace(os.sep, "/")
    fix = _fix(mesh, right, f"refer to {right}")
    help = f"write {right}"
    return Finding(mesh.at, message, help, fix, group_key=directory, severity=Severity.WARNING)


def _without_slash(context: Context, mesh: MeshReference) -> Finding | None:
    """Finding about a path that is absolute by mistake; None if the relative path has no file."""
    relative = mesh.located.reference.lstrip("/")
    path = os.path.join(os.path.dirname(os.path.abspath(context.files.top)), relative)
    if mesh.located.scheme != "absolute" or not disk.is_file(path):
        return None
    message, help = f"{mesh.who} is an absolute path, and does not exist", "remove the first slash"
    severity = None
    if not is_xacro(context.source):
        message += "; PyBullet alone finds it, next to the URDF"
        severity = Severity.WARNING
    fix = _fix(mesh, relative, help)
    return Finding(mesh.at, message, help, fix, group_key=help, severity=severity)


def _of_working_directory(context: Context, mesh: MeshReference) -> Finding | None:
    """Finding about a path that begins with ``$(cwd)``, next to the xacro; else None."""
    current, located = os.path.join(os.getcwd(), ""), mesh.located
    if located.scheme != "absolute" or not is_xacro(context.source):
        return None
    directory = os.path.dirname(os.path.abspath(context.files.top))
    of_current = [path for path in located.tried if path.startswith(current)]
    if not any(disk.is_file(directory + os.sep + path[len(current) :]) for path in of_current):
        return None
    message = f"{mesh.who} is found if xacro runs in {shown(directory)}"
    help = "write $(dirname) instead of $(cwd), or package://PACKAGE/..."
    return Finding(mesh.at, message, help, group_key=directory, severity=Severity.INFO)


def _directory_above(context: Context, located: ResolvedReference) -> str:
    """The parent directory of a robot in which a relative path exists; empty if there is none."""
    if located.scheme != "relative":
        return ""
    directory = os.path.dirname(os.path.abspath(context.files.top))
    for _ in range(_MAX_LEVELS):
        directory = os.path.dirname(directory)
        if disk.is_file(os.path.normpath(os.path.join(directory, located.reference))):
            return directory
    return ""


def _directory_of_mujoco(context: Context, mesh: MeshReference) -> str:
    """The ``meshdir`` of the URDF, if it contains the mesh; else empty."""
    if not context.mujoco.mesh_directory:
        return ""
    directory, name = context.mujoco.mesh_path(mesh.at.value, context.files.top)
    path = os.path.join(directory, name)
    is_found = context.resolver.admits(path) and disk.is_file(path)
    return os.path.normpath(directory) if is_found else ""


def _fix(mesh: MeshReference, reference: str, title: str) -> Fix | None:
    return Fix.of(title, replace_value(mesh.literal, reference) if mesh.literal else None)


def _missing_directory(located: ResolvedReference) -> str:
    """The topmost directory that does not exist; the directory of the file if all exist."""
    lost = os.path.dirname(os.path.abspath(located.tried[0]))
    while not disk.is_directory(above := os.path.dirname(lost)):
        lost = above
    return lost
