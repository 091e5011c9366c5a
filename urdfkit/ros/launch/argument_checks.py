"""Arguments of launch files: undeclared, unknown to the included file, or missing."""

import ast
import os
import re
from collections.abc import Callable, Collection, Iterable, Iterator, KeysView
from functools import lru_cache
from itertools import islice

from urdfkit.core.memo import LIMIT
from urdfkit.core.suggest import Suggester, did_you_mean, hint_for
from urdfkit.core.suggest import is_typo as is_one_letter_off
from urdfkit.ros.launch.collect import UNKNOWN
from urdfkit.ros.launch.signature import USE, Signature
from urdfkit.text import python_source
from urdfkit.text.comments import blank_comments, without_comments
from urdfkit.text.diagnostic import Problem, Severity
from urdfkit.text.document import CallFrame, Element
from urdfkit.text.file_kinds import is_launch
from urdfkit.text.source import Source, Span
from urdfkit.workspace.resolve import Resolver
from urdfkit.workspace.ros_packages import comes_with_ros

#: The end of the name of a launch file that begins with an expression, in XML or in Python.
_COMPUTED = re.compile(rb"""(?:[)}]|["'](?=[._-]))([\w.-]*\.launch[\w.]*)""")
#: The name in a declaration of an argument.
_DECLARED = re.compile(rb"""<arg\s[^<>]*?\bname\s*=\s*["']([^"'<>]*)["']""")
_WORD = re.compile(rb"\w+")
#: What stands before the name of an argument that a Python file reads, and before a computed one.
_READS = rb"(?:LaunchConfiguration(?:Equals)?|launch_configurations(?:\W+get)?|variable_name)"
_COMPUTED_NAME = rb"LaunchConfiguration\(\s*(?!variable_name\b)[^'\"\s]"
#: Comments and docstrings of Python, on lines of their own.
_PROSE = re.compile(rb"""(?m)^[ \t]*(?:#.*$|[rR]?(?:\"{3}(?s:.*?)\"{3}|'{3}(?s:.*?)'{3}))""")
#: Most files that are searched for includes, and most directories.
MAX_FILES, MAX_DIRECTORIES = 500, 2000


class ArgumentUses:
    """The arguments that a launch file uses, in the order of the file."""

    def __init__(self, declared: Iterable[str]) -> None:
        self._declared = dict.fromkeys(declared)
        #: The location of the first use of each, and the number of names declared before it.
        self._undeclared: dict[str, tuple[Span, int]] = {}

    @property
    def declared(self) -> KeysView[str]:
        """The names declared so far, with those of the including file."""
        return self._declared.keys()

    def declare(self, names: Iterable[str]) -> None:
        self._declared.update(dict.fromkeys(names))

    def use(self, element: Element, names: Iterable[str]) -> None:
        """Record arguments that attributes of these names use before a declaration.

        ``<arg name="a" default="$(arg a)"/>`` passes on what the including file gives.
        """
        is_passed_on = element.tag == "arg" and "default" in element.attributes
        own = element.get("name") if is_passed_on else None
        for name in names:
            attribute = element.attributes.get(name)
            for used in USE.findall(attribute.value) if attribute else ():
                if attribute and used not in self.declared and used != own:
                    self._undeclared.setdefault(used, (attribute.span, len(self.declared)))

    def problems(
        self,
        frame: CallFrame | None,
        *,
        carries_over: bool,
        is_sure: Callable[[], bool],
        is_lost: bool,
    ) -> Iterator[Problem]:
        """Problems of arguments that are used but not declared.

        Args:
            carries_over: declarations of an include apply to the following actions, as in ROS 2.
            is_sure: returns True if no other file can declare the arguments; otherwise only typos
                are reported.
            is_lost: the command line cannot set missing arguments.
        """
        missing = {
            name: use
            for name, use in self._undeclared.items()
            if not (carries_over and name in self.declared)
        }
        is_certain = bool(missing) and is_sure()
        for number, (name, (span, count)) in enumerate(missing.items()):
            suggested = ""
            if number < Suggester.MAX_WORDS:
                suggested = misspelt(name, tuple(islice(self._declared, count)), span.source)
            if not (is_certain or suggested):
                continue
            if name in self.declared:
                message = f"argument '{name}' is used before it is declared"
                yield Problem("LAU006", span, message, frame=frame)
            else:
                ros = 2 if carries_over else 1
                yield undeclared(name, suggested, span, frame, is_lost=is_lost, ros=ros)


def misspelt(name: str, declared: Collection[str], source: Source) -> str:
    """The declared argument that a file misspells; empty if there is none.

    An argument that the file declares and uses, or that another file declares, is similar by
    chance, unless the names differ in one letter only.
    """
    suggested = Suggester(declared).suggested(name)
    if not suggested:
        return ""
    word = rb"(?<![\w-])%b(?![\w-])" % re.escape(suggested.encode())
    is_unused = len(re.findall(word, source.data)) == 1
    return suggested if is_unused or is_one_letter_off(name, suggested) else ""


def undeclared(
    name: str, suggested: str, span: Span, frame: CallFrame | None, *, is_lost: bool, ros: int
) -> Problem:
    """The problem of an argument that is used but not declared.

    The command line may set it, unless the file is included without these arguments
    (``is_lost``), or the name is a typo. In ROS 1, this forces callers to set it.

    Args:
        suggested: the declared argument that it misspells; empty if there is none.
    """
    message = f"no argument '{name}' is declared{hint_for(suggested)}"
    severity = None
    if not (is_lost or suggested):
        severity = Severity.INFO if ros == 1 else Severity.WARNING
        message += "; the caller must pass it"
    return Problem("LAU006", span, message, frame=frame, severity=severity)


def unknown_to_included(
    passed: Iterable[tuple[str, Span]],
    taken: Signature,
    source: Source,
    frame: CallFrame | None,
    *,
    ros: int,
) -> Iterator[Problem]:
    """Problems of arguments that an included file does not declare.

    In ROS 2 the file may use them without a declaration, and pass them on. A file that is not
    well-formed XML (LAU001) may declare them.
    """
    passed = list(passed)
    unused = set(taken.names).difference(name for name, _ in passed)
    known = {*taken.names, *_written_names(source)}
    unknown = [(name, span) for name, span in passed if name not in known]
    words = set(_WORD.findall(source.data)) if unknown else set()
    suggester = Suggester(frozenset(unused))
    for number, (name, span) in enumerate(unknown):
        is_used = ros == 2 and words.issuperset(_WORD.findall(name.encode()))
        is_used = is_used and not (taken.is_whole and _is_only_key(name, source))
        is_mistyped = bool(suggester.suggested(name))
        # Such as a directory 'worlds' in a file with the argument 'world'.
        is_used = is_used and (not is_mistyped or _may_read(name, source))
        if not is_used and (ros == 1 or taken.is_whole or is_mistyped):
            file = os.path.basename(source.path)
            hint = did_you_mean(name, unused) if number < Suggester.MAX_WORDS else ""
            message = f"'{file}': unknown argument '{name}'{hint}"
            severity = Severity.INFO if ros == 2 and not is_mistyped else None
            yield Problem("LAU005", span, message, frame=frame, severity=severity)


def _may_read(name: str, source: Source) -> bool:
    """True if a file contains a name where it reads an argument, or computes such names."""
    if name in USE.findall(source.data.decode("utf-8", "replace")):
        return True
    read = rb"%b\W+['\"]%b['\"]" % (_READS, re.escape(name.encode()))
    return re.search(rb"%b|%b" % (read, _COMPUTED_NAME), source.data) is not None


def _is_only_key(name: str, source: Source) -> bool:
    """True if a Python file has a name only as that of something else, such as a parameter."""
    if not source.path.endswith(".py"):
        return False
    nodes = python_source.nodes(python_source.parse(source.data))
    keys = {id(key) for node in nodes if isinstance(node, ast.Dict) for key in node.keys}
    texts = [
        node.value for node in nodes if isinstance(node, ast.Constant) and id(node) not in keys
    ]
    word = re.compile(rf"(?<![\w-]){re.escape(name)}(?![\w-])")
    return not any(isinstance(text, str) and word.search(text) for text in texts)


@lru_cache(maxsize=4)
def _written_names(source: Source) -> frozenset[str]:
    """The arguments that the text of a file declares, for XML that cannot be parsed."""
    names = _DECLARED.findall(blank_comments(source.data))
    return frozenset(name.decode("utf-8", "replace") for name in names)


def missing_in_include(
    known: Collection[str], taken: Signature, source: Source, span: Span, frame: CallFrame | None
) -> Iterator[Problem]:
    """The arguments without a default that are not passed to an included file."""
    for name in sorted(taken.required.difference(known)):
        message = f"'{os.path.basename(source.path)}' requires argument '{name}'"
        help = f"pass '{name}', or give it a default"
        yield Problem("LAU005", span, message, help, frame, severity=Severity.ERROR)


def declares_others(path: str) -> bool:
    """True if a missing launch file may declare arguments that the including file uses.

    The launch files of ROS do not.
    """
    package = path[len(UNKNOWN) + 1 :].partition("/")[0] if path.startswith(UNKNOWN) else ""
    return not comes_with_ros(package)


def is_included(path: str, resolver: Resolver, *, by_tests: bool = True) -> bool:
    """True if another launch file references this file, and so may pass arguments.

    A launch file of another package of the workspace must also contain the package name.

    Args:
        by_tests: whether launch files below a directory of tests count.
    """
    home = resolver.packages.enclosing(path)
    if home is None:
        return _is_named(path, os.path.dirname(os.path.abspath(path)), "", resolver, by_tests)
    package, directory = home
    return _is_named(path, directory, "", resolver, by_tests) or _is_named(
        path, resolver.packages.workspace(path), package, resolver, by_tests
    )


def _is_named(path: str, directory: str, package: str, resolver: Resolver, by_tests: bool) -> bool:
    """True if another launch file of a directory references this file, and its package."""
    name = os.path.basename(path)
    files = filter(is_launch, resolver.directories.files_below(directory, MAX_DIRECTORIES))
    siblings = [file for file in files if os.path.basename(file) != name]
    if not by_tests:
        siblings = [file for file in siblings if not _is_in_tests(os.path.relpath(file, directory))]
    return len(siblings) > MAX_FILES or any(
        _references(file, name.encode(), package.encode(), resolver) for file in siblings
    )


def _is_in_tests(relative: str) -> bool:
    return not {"test", "tests"}.isdisjoint(relative.split(os.sep))


def _references(path: str, name: bytes, package: bytes, resolver: Resolver) -> bool:
    """True if a launch file contains a file name, or computes a path with this end."""
    source = resolver.readable(path)
    text, ends = _code(source) if source else (b"", ())
    return package in text and (name in text or any(map(name.endswith, ends)))


@lru_cache(maxsize=LIMIT)  # each launch file of a workspace is looked for in all others
def _code(source: Source) -> tuple[bytes, tuple[bytes, ...]]:
    """A launch file without comments, and the ends of the names of launch files in it."""
    is_python = source.path.endswith(".py")
    text = _PROSE.sub(b"", source.data) if is_python else without_comments(source.data)
    return text, tuple(_COMPUTED.findall(text))
