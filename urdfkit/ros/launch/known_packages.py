"""The launch files and executables of ROS packages: ``catalog/launch.json``."""

import os
from collections.abc import Iterable, Iterator, Sequence

from urdfkit.core.suggest import SIMILAR, SIMILAR_FILE, TYPO, did_you_mean, hint_for, nearest
from urdfkit.errors import PackageNotFound
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.contents import GivenParameters, IncludedFile, StartedProgram, Word
from urdfkit.text.diagnostic import Problem, Severity
from urdfkit.workspace.executables import missing_executable, script_of
from urdfkit.workspace.file_head import read_head
from urdfkit.workspace.install_rules import build_file
from urdfkit.workspace.manifest import manifest_of
from urdfkit.workspace.resolve import Resolver

#: Names of the world argument in other launch files, which gz sim's launch file does not read.
_WORLDS = ("world", "world_name", "world_file")
_SIM_TIME = "use_sim_time"
#: Words that make a switch of a name: ``use_namespace`` is not ``namespace``.
_OF_SWITCHES = ("enable", "use")
#: The former name of ``robot_state_publisher``, an alias until ROS Melodic.
_FORMER = "robot_state_publisher/state_publisher"


def wrong_references(
    programs: Iterable[StartedProgram], included: Iterable[IncludedFile], resolver: Resolver
) -> Iterator[Problem]:
    """Problems of references that do not exist in these packages; included files are ignored.

    A workspace may have packages of these names with other contents.
    """
    for program in programs:
        if program.frame is not None:
            continue
        if _is_own(program.package, program, resolver):
            yield from _own_executable(program, resolver)
            continue
        problem = (
            _former_executable(program) or unknown_executable(program) or _former_package(program)
        )
        if problem:
            yield problem
    for file in included:
        if file.frame is None and not _is_own(_name(file)[0], file, resolver):
            yield from filter(None, [unknown_file(file)])
            yield from unknown_arguments(file)
            yield from missing_arguments(file)


def shipped_nodes(included: IncludedFile) -> Iterator[StartedProgram]:
    """The nodes that a launch file of ROS 2 starts; empty if it is not in the catalogue."""
    package, name = _name(included)
    shipped = data("launch")["shipped"].get(f"{package}/launch/{name}")
    arguments = included.arguments
    if shipped is None or arguments is None:
        return
    file, time = arguments.get(shipped["parameters"]), arguments.get(_SIM_TIME)
    files = (file.text,) if file and file.text and os.path.isabs(file.text) else ()
    values = {_SIM_TIME: time.text if time else None}
    is_whole = bool(files) or (file is None and shipped["is_default"])
    for node in shipped["nodes"].split():
        conditions: dict[str, str] = shipped["only_if"].get(node, {})
        if any(_differs(arguments.get(name), value) for name, value in conditions.items()):
            continue
        path, _, name_of_node = node.partition("=")
        package_of_node, _, executable = path.partition("/")
        yield StartedProgram(
            package_of_node,
            executable,
            (),
            included.span,
            included.frame,
            included.is_sure,
            parameters=GivenParameters(values, files, is_whole),
            name=name_of_node,
        )


def _differs(argument: Word | None, default: str) -> bool:
    """True for an argument that has, or may have, another value than its default."""
    return argument is not None and (argument.text or "").lower() != default


def _is_own(package: str, by: StartedProgram | IncludedFile, resolver: Resolver) -> bool:
    """True for a package of the workspace."""
    near = by.span.source.path
    try:
        directory = resolver.package(package, near)
    except PackageNotFound:
        return False
    return directory.startswith(resolver.packages.workspace(near))


def _own_executable(program: StartedProgram, resolver: Resolver) -> Iterator[Problem]:
    """An executable that a package of the workspace does not install."""
    name, near = program.executable, program.span.source.path
    directory = resolver.package(program.package, near)
    manifest = manifest_of(resolver, os.path.join(directory, "package.xml"))
    # launch takes an absolute path as it is.
    is_named = bool(name) and not os.path.isabs(name)
    if not is_named or manifest is None or manifest.ros != 2 or not program.is_ros_2:
        return
    missing = missing_executable(directory, program.package, name)
    if missing is None:
        yield from _no_shebang(program, script_of(directory, program.package, name))
        return
    file = os.path.basename(build_file(directory))
    if missing.place:
        message = f"{file} of '{program.package}' installs '{name}' to {missing.place}"
        help = "write DESTINATION lib/${PROJECT_NAME}, where ros2 looks for executables"
    elif missing.is_built:
        message = f"{file} of '{program.package}' builds '{name}', but does not install it"
        help = f"write install(TARGETS {name} DESTINATION lib/${{PROJECT_NAME}})"
    else:
        message = f"{file} of '{program.package}' has no executable '{name}'"
        similar = nearest(name, missing.others, SIMILAR_FILE)
        message += hint_for(similar)
        command = "console_scripts" if file.endswith(".py") else "install(PROGRAMS ...)"
        help = f"fix the name, or add it to {command}"
    yield Problem("LAU003", program.span, message, help, program.frame)


def _no_shebang(program: StartedProgram, script: str) -> Iterator[Problem]:
    """A script that the system cannot start: it does not say which program interprets it."""
    if script and (head := read_head(script, 2)) and head != b"#!":
        message = f"'{program.executable}' does not begin with #!: exec format error"
        help = "write #!/usr/bin/env python3 as its first line"
        yield Problem("LAU003", program.span, message, help, program.frame)


def _former_package(program: StartedProgram) -> Problem | None:
    """A package of ROS 1 in a launch file of ROS 2."""
    former: dict[str, str] = data("packages")["former"]
    if program.package not in former or not program.is_ros_2:
        return None
    successor = former[program.package]
    help = f"write {successor}, and check its arguments" if successor else "remove the node"
    message = f"ROS 2 has no package '{program.package}'"
    return Problem("LAU003", program.span, message, help, program.frame)


def unknown_executable(program: StartedProgram) -> Problem | None:
    """An executable that a package of ROS does not have."""
    catalogue = "executables" if program.is_ros_2 else "ros1_executables"
    known = data("launch")[catalogue].get(program.package, "").split()
    name = program.executable
    if not known or not name or name in known or os.path.isabs(name):
        return None
    catalogued = data("launch")[catalogue].items()
    others = [package for package, names in catalogued if name in names.split()]
    owner = others[0] if len(others) == 1 else ""
    hint = f", which {owner} has" if owner else did_you_mean(name, known)
    message = f"package '{program.package}' has no executable '{name}'{hint}"
    severity = Severity.WARNING
    if release := last_release(program):
        message, severity = f"{message} (supported up to {release})", Severity.INFO
    help = f"write {owner} as its package" if owner else f"write one of {', '.join(known)}"
    return Problem("LAU003", program.span, message, help, program.frame, severity=severity)


def last_release(program: StartedProgram) -> str:
    """The last release of ROS 2 that has an executable; empty if it was not removed."""
    for release, packages in data("launch")["former_executables"].items():
        if program.executable in packages.get(program.package, "").split():
            return str(release)
    return ""


def _former_executable(program: StartedProgram) -> Problem | None:
    """An executable that ROS 1 has no more: roslaunch stops."""
    if program.key != _FORMER or program.is_ros_2:
        return None
    message = f"'{program.executable}' was removed in ROS Noetic"
    help = f'write type="{program.package}"'
    return Problem("LAU003", program.span, message, help, severity=Severity.INFO)


def unknown_file(included: IncludedFile) -> Problem | None:
    """A misspelt launch file of a package."""
    package, name = _name(included)
    known = data("launch")["launch_files"].get(package, {})
    suggested = nearest(name, known, TYPO) if name not in known else None
    if not suggested:
        return None
    message, help = f"package '{package}' has no launch file '{name}'", f"write {suggested}"
    same_format = [file for file in known if file.endswith(".py") == name.endswith(".py")]
    if suggested in same_format or not same_format:
        message += f"; did you mean '{suggested}'?"
    else:  # the suggestion is a launch file of the other ROS version
        help = f"write one of {', '.join(same_format)}"
    return Problem("LAU003", included.span, message, help, included.frame)


def unknown_arguments(included: IncludedFile) -> Iterator[Problem]:
    """Arguments that a launch file of these packages does not declare.

    roslaunch rejects them. ``ros2 launch`` ignores them: then only typos, former names, names with
    a word too many or too few, and a world that is not opened are reported.
    """
    package, name = _name(included)
    known = data("launch")["launch_files"].get(package, {}).get(name, "").split()
    is_ros_1 = name.endswith(".launch")
    has_args = any(passed.endswith("_args") for passed, _ in _passed(included))
    former: dict[str, list[str]] = data("node_parameters")["renamed"].get(package, {})
    free = [name for name in known if name not in (included.arguments or {})]
    for argument, word in _passed(included) if known else ():
        is_world = argument in _WORLDS and not has_args
        other = _with_another_word(argument, free)
        is_similar = nearest(argument, known, TYPO) or other
        is_reported = is_ros_1 or is_world or argument in former or is_similar
        if argument in known or not is_reported:
            continue
        similar = _similar(argument, known) or other
        suggested = former[argument][0] if argument in former else similar
        if is_world and not is_ros_1:
            suggested = "world" if "world" in known else "gz_args"
        message = f"'{name}': unknown argument '{argument}'{hint_for(suggested)}"
        severity = Severity.ERROR if is_ros_1 else Severity.WARNING
        yield Problem("LAU005", word.span, message, frame=included.frame, severity=severity)


def _with_another_word(argument: str, free: Iterable[str]) -> str | None:
    """The argument that is not passed and has a word more or less: ``params_file``, ``params``."""
    words = set(argument.split("_"))
    for name in free:
        different = words ^ set(name.split("_"))
        is_part = words < set(name.split("_")) or words > set(name.split("_"))
        if is_part and len(different) == 1 and different.isdisjoint(_OF_SWITCHES):
            return name
    return None


def _similar(argument: str, known: Sequence[str]) -> str | None:
    """The most similar known argument; a common ``rgb_camera.`` does not make two similar."""
    begin, dot, name = argument.rpartition(".")
    begin += dot
    inside = [other.removeprefix(begin) for other in known if other.startswith(begin)]
    similar = nearest(name, inside, TYPO if dot else SIMILAR)
    return begin + similar if similar else None


def missing_arguments(included: IncludedFile) -> Iterator[Problem]:
    """Arguments without which a launch file does not do what another argument asks of it."""
    package, name = _name(included)
    needs: dict[str, str] = data("launch")["needed_arguments"].get(f"{package}/{name}", {})
    passed = included.arguments or {}
    for argument, word in _passed(included):
        other = needs.get(argument)
        given = passed.get(other) if other else None
        is_off = given is None or (given.text or "true").lower() == "false"
        if other and word.text and is_off:
            into = f"the {argument} '{word.text}'"
            message = f"'{name}' up to Jazzy puts no node into {into} without {other}"
            help, severity = f"pass {other}: True", Severity.WARNING
            yield Problem("LAU005", word.span, message, help, included.frame, severity=severity)


def _passed(included: IncludedFile) -> Iterator[tuple[str, Word]]:
    """The arguments that are written in the include."""
    for name, word in (included.arguments or {}).items():
        if word.span != included.span:
            yield name, word


def _name(included: IncludedFile) -> tuple[str, str]:
    """The package and the name of a launch file in its directory."""
    package, _, name = included.path.removesuffix("/").rpartition("/launch/")
    return package.rpartition("/")[2], name
