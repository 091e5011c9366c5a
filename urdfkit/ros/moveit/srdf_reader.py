"""The SRDF of a robot: which file it is, and its contents with the arguments of the robot."""

import os
from collections.abc import Iterable, Iterator, Mapping
from itertools import islice

from urdfkit.errors import UrdfkitError
from urdfkit.ros import RosDescription
from urdfkit.ros.moveit.srdf import Srdf, is_srdf
from urdfkit.text.diagnostic import Problem, Severity
from urdfkit.text.document import Document
from urdfkit.text.file_kinds import is_xacro
from urdfkit.text.source import Source
from urdfkit.text.xml_reader import read_as_tinyxml, read_xml
from urdfkit.workspace.manifest import manifest_of
from urdfkit.workspace.resolve import Resolver
from urdfkit.workspace.srdf_files import (
    has_robot_name,
    is_of_namesake,
    other_srdf_files,
    srdf_files,
    srdf_in,
)

#: Most SRDFs of a directory that are read for one robot.
_MAX_READ = 32


def find(robot: RosDescription) -> Srdf | None:
    """The SRDF of a robot, if there is exactly one readable SRDF for it.

    An SRDF with another robot name is accepted if it references the links and joints of the robot;
    an SRDF in a MoveIt package for several robots, if it fits this robot. An SRDF with the same
    file name as another robot in the same directory belongs to that robot, and so does an SRDF with
    the robot name of another file, if this robot lacks links or joints of it. Of very many SRDFs,
    such as for each combination of two hands, only those with the name of the robot are read.
    """
    chosen = candidates(robot)
    return chosen[0] if len(chosen) == 1 else None


def candidates(robot: RosDescription) -> list[Srdf]:
    """The SRDFs that may be for a robot, such as those of its variants."""
    path, name, resolver = robot.source.path, robot.model.name, robot.resolver
    files = [
        file for file in srdf_files(path, resolver) if not is_of_namesake(file, path, resolver)
    ]
    if len(files) > _MAX_READ:
        files = [file for file in files if _stem(file) in (_stem(path), name)]
    readable = _read_all(files, robot)
    with_name = [srdf for srdf in readable if srdf.root.get("name") == name]
    chosen = with_name or [
        srdf
        for srdf in readable
        if srdf.refers_to_robot and not (srdf.unknown and _is_of_neighbour(srdf, path, resolver))
    ]
    named = [srdf for srdf in chosen if _stem(srdf.path) == _stem(path)]
    if len(chosen) > 1 and named:  # MoveIt's builder reads the SRDF with the file name of the robot
        chosen = named
    if not readable:
        others = other_srdf_files(path, name, resolver)
        chosen = [srdf for srdf in _read_all(others, robot) if srdf.fits_robot]
    if not with_name:
        for srdf in chosen:
            srdf.is_shared = srdf.is_shared or _is_of_neighbour(srdf, path, resolver)
    return chosen


def _read_all(files: Iterable[str], robot: RosDescription) -> list[Srdf]:
    """The readable SRDFs; of one and the xacro that it was made of, the xacro."""
    readable = filter(None, (read(file, robot) for file in files))
    return list({srdf.path.removesuffix(".xacro"): srdf for srdf in readable}.values())


def _is_of_neighbour(srdf: Srdf, path: str, resolver: Resolver) -> bool:
    """True if another URDF beside a robot has the robot name of an SRDF."""
    name = srdf.root.get("name") or ""
    directory, own_file = os.path.split(os.path.abspath(path))
    return name != "" and any(
        file != own_file and has_robot_name(os.path.join(directory, file), name)
        for file in resolver.directories.entries(directory) or ()
    )


def neighbours(srdf: Srdf, robot: RosDescription) -> Iterator[Srdf]:
    """The other SRDFs in the directory of an SRDF, without those after very many."""
    for path in islice(srdf_in([os.path.dirname(srdf.path)], robot.resolver), _MAX_READ):
        if path != srdf.path and (other := read(path, robot)):
            yield other


def read(path: str, robot: RosDescription) -> Srdf | None:
    """An SRDF file of a robot; None if it cannot be read.

    A xacro is expanded with the arguments of the robot that have the same names, and with the
    arguments from launch files, unless it then fits the robot worse. Where both pass an argument
    that changes no link and no joint, such as the name of a group, the launch file decides.
    """
    srdf, names = expanded(path, robot, robot.arguments)
    others = names - robot.arguments.keys()
    for arguments in _launched(path, robot, others) if others else ():
        launched, _ = expanded(path, robot, {**arguments, **robot.arguments})
        if launched and (srdf is None or len(launched.unknown) <= len(srdf.unknown)):
            srdf = launched
            break
    shared = names & robot.arguments.keys()
    for arguments in _launched(path, robot, shared) if srdf and shared else ():
        launched, _ = expanded(path, robot, {**robot.arguments, **arguments})
        if launched and srdf and launched.named == srdf.named:
            launched.is_shared = any(robot.arguments[key] != arguments[key] for key in arguments)
            return launched
    return srdf


def read_named(path: str, robot: RosDescription) -> Srdf:
    """An SRDF file that the user names.

    Raises:
        UrdfkitError: it cannot be read, or is not an SRDF.
    """
    robot.resolver.admit_and_read(path)
    srdf = read(path, robot)
    if srdf is None or not is_srdf(srdf.root):
        raise UrdfkitError(f"{path}: not an SRDF file")
    return srdf


def expanded(
    path: str, robot: RosDescription, arguments: Mapping[str, str]
) -> tuple[Srdf | None, set[str]]:
    """An SRDF file with arguments, and the names of its arguments; None if it cannot be read."""
    document, names = _parsed(path, robot.resolver, robot.trust, arguments)
    if document is None or document.root.tag != "robot":
        return None, names
    if path.endswith(".xacro") and not document.root.children:
        return None, set()  # only macros for other files
    return Srdf(path, document.root, robot.tree), names


def _launched(path: str, robot: RosDescription, names: set[str]) -> Iterator[dict[str, str]]:
    """The arguments that launch files pass to an SRDF: all of them, and all but one.

    The robot may be checked with the default of an argument such as a prefix.
    """
    from urdfkit.ros.launch.robot_arguments import passed_arguments

    for launched in passed_arguments(path, (), robot.resolver):
        whole = {name: value for name, value in launched.arguments.items() if name in names}
        if launched.frame:
            yield whole
            for left_out in whole:
                yield {name: whole[name] for name in whole if name != left_out}


def unreadable(path: str, name: str, resolver: Resolver) -> Iterator[Problem]:
    """Why the SRDF of a robot cannot be read: the only SRDF, or an SRDF with the robot's name.

    A xacro is ignored: a launch file may pass its required arguments.
    """
    paths = srdf_files(path, resolver) or other_srdf_files(path, name, resolver)
    for candidate in paths:
        if len(paths) == 1 or _stem(candidate) in (name, _stem(path)):
            source = resolver.readable(candidate)
            if source is None or is_xacro(source):
                continue
            document, problems = read_xml(source)
            if document is None and _read(source) is None:
                yield from problems
            elif document is None:  # xacro, which MoveIt's builder of ROS 2 uses, rejects it
                manifest = manifest_of(resolver, candidate)
                severity = Severity.WARNING if manifest and manifest.ros == 1 else None
                yield from (problem._replace(severity=severity) for problem in problems)


def _stem(path: str) -> str:
    return os.path.basename(path).partition(".")[0]


def _parsed(
    path: str, resolver: Resolver, trust: bool, arguments: Mapping[str, str]
) -> tuple[Document | None, set[str]]:
    """The document of a file, if it can be read, and the names of its xacro arguments.

    Those are the declared ones, and others without which it does not expand.
    """
    source = resolver.readable(path)
    if source is None:
        return None, set()
    if is_xacro(source):
        from urdfkit.xacro import expand

        xacro = expand(source, resolver, arguments, trust=trust)
        missing = {problem.argument for problem in xacro.problems if problem.argument}
        return xacro.document, xacro.defaults.keys() | missing
    return _read(source), set()


def _read(source: Source) -> Document | None:
    """The document of a file, read as by MoveIt's parser; None if it is not well-formed."""
    return read_as_tinyxml(source)[0]
