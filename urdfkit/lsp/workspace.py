"""The open texts of an editor, their robots, and the findings.

The module is independent of the protocol, and used by one thread.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from functools import cache
from typing import Any

from urdfkit.core import expansion_limits
from urdfkit.core.grouping import by_key
from urdfkit.core.record import Record
from urdfkit.errors import Cancelled, UrdfkitError
from urdfkit.lint import rule_index
from urdfkit.lint.argument_sets import as_launched
from urdfkit.lint.config import Config, RobotEntry
from urdfkit.lint.config_reader import load
from urdfkit.lint.context import Context
from urdfkit.lint.discovery import affected
from urdfkit.lint.engine import check_with
from urdfkit.lint.fix import fix
from urdfkit.lint.options import Options
from urdfkit.lint.plan import Job
from urdfkit.lint.rules import Need
from urdfkit.lsp.open_robot import OpenRobot
from urdfkit.text.diagnostic import Diagnostic
from urdfkit.text.editing.formatter import WIDTH, formatted
from urdfkit.text.file_kinds import is_launch
from urdfkit.text.source import Source
from urdfkit.workspace.config_file import nearest
from urdfkit.workspace.resolve import Resolver

#: Robots that are checked when a file of macros changes; the others are checked on their changes.
MAX_ROBOTS = 8
#: Suffixes of files that belong to robots but are not robots.
_NOT_ROBOTS = (".yaml", ".yml")
#: Needs of the rules that are too slow for each keystroke.
_SLOW = frozenset((Need.MESHES, Need.DYNAMICS, Need.COLLISIONS))


class CheckResult(Record):
    """The findings of the robots of a file."""

    diagnostics: dict[str, list[Diagnostic]]  # by real path of the file
    failure: str = ""  # why something was not checked; empty if all was


class Workspace:
    """The open texts of an editor, and the files on disk."""

    def __init__(self) -> None:
        self.texts: dict[str, bytes] = {}
        self._entries: dict[str, tuple[RobotEntry, ...]] = {}
        self._launched: dict[str, dict[str, str]] = {}
        self._configs: dict[str, tuple[Config, str]] = {}
        self._resolvers: dict[str, Resolver] = {}
        self._expansions: dict[object, Any] = {}  # of the current texts
        self._robots: dict[str, OpenRobot] = {}
        self._before: dict[str, OpenRobot] = {}
        self._diagnostics: dict[str, dict[str, list[Diagnostic]]] = {}

    def set_text(self, path: str, text: bytes) -> None:
        if self.texts.get(path) != text:
            self.texts[path] = text
            self._forget_robots()

    def close(self, path: str) -> dict[str, list[Diagnostic]]:
        """Close a file: its contents on disk count again.

        Returns:
            The remaining findings in files of robots that belong to no open file.
        """
        parts = {entry.file for entry in self.entries(path)}
        self.texts.pop(path, None)
        closed = parts - {entry.file for other in self.texts for entry in self.entries(other)}
        files = {file for root in closed for file in self._diagnostics.pop(root, ())}
        self.reload()
        return {file: list(self._findings(file)) for file in files}

    def reload(self) -> None:
        self._entries.clear()
        self._launched.clear()
        self._configs.clear()
        self._resolvers.clear()
        self._forget_robots()

    def _forget_robots(self) -> None:
        self._before.update(self._robots)
        self._robots.clear()
        self._expansions.clear()

    def config(self, path: str) -> tuple[Config, str]:
        """The configuration of a file, and its problems; trust settings are ignored."""
        directory = os.path.dirname(path)
        if directory not in self._configs:
            failure, config = "", Config()
            try:
                file = nearest(path)
                config = load(file, trusted=False) if file else config
                failure = "; ".join(config.warnings)
            except UrdfkitError as error:
                failure = str(error)
            self._configs[directory] = config, failure
        return self._configs[directory]

    def entries(self, path: str) -> tuple[RobotEntry, ...]:
        """The first robots that a file belongs to; the file itself if it may be a robot."""
        if path not in self._entries:
            self._entries[path] = self._find_entries(path)
        return self._entries[path]

    def _find_entries(self, path: str) -> tuple[RobotEntry, ...]:
        alone = (RobotEntry(path, "", {}),)
        if is_launch(path) or not os.path.isdir(os.path.dirname(path)):
            return alone
        config, _ = self.config(path)
        try:
            robots_of_file = affected([path], config, self._resolver(config)).robots
        except UrdfkitError:
            return alone
        own = tuple(robot for robot in robots_of_file if os.path.realpath(robot.file) == path)
        robots = own or robots_of_file or (() if path.endswith(_NOT_ROBOTS) else alone)
        return tuple(self._with_launch_arguments(robot, config) for robot in robots[:MAX_ROBOTS])

    def _with_launch_arguments(self, robot: RobotEntry, config: Config) -> RobotEntry:
        """A robot; missing arguments are taken from the first launch file that starts it."""
        if robot.arguments or not robot.file.endswith(".xacro"):
            return robot
        resolver = self._resolver(config)

        def read(job: Job) -> Context:
            return Context(resolver.admit_and_read(job.path), resolver, job.arguments)

        try:
            (job, _), *_ = as_launched(
                Job(robot.file, "", dict(config.arguments), may_fail=False), read
            )
        except UrdfkitError:
            return robot
        if not job.launched:
            return robot
        self._launched[robot.file] = job.arguments
        return robot._replace(arguments=job.arguments)

    def robot(self, path: str) -> OpenRobot:
        """The first robot that a file belongs to.

        Raises:
            UrdfkitError: there is none, or its file is unreadable.
        """
        if not self.entries(path):
            raise UrdfkitError(f"{path} is not part of a robot")
        return self._open(self.entries(path)[0], path)

    def other_robots(self, path: str) -> list[OpenRobot]:
        """The further robots that a file belongs to, without unreadable ones."""
        robots: list[OpenRobot] = []
        for entry in self.entries(path)[1:]:
            with suppress(UrdfkitError):
                robots.append(self._open(entry, path))
        return robots

    def _open(self, entry: RobotEntry, path: str) -> OpenRobot:
        """The robot of an entry to which a file belongs.

        Raises:
            UrdfkitError: its file is unreadable.
        """
        if entry.file not in self._robots:
            config, _ = self.config(path)
            before = self._before.pop(entry.file, None)
            self._robots[entry.file] = OpenRobot(entry, self._resolver(config), config, before)
        return self._robots[entry.file]

    def open_robots(self) -> Iterator[OpenRobot]:
        """The first robot of each open file, without repetitions."""
        robots: dict[str, OpenRobot] = {}
        for path in self.texts:
            try:
                robot = self.robot(path)
            except UrdfkitError:  # no robot, or an unreadable one
                continue
            robots[robot.path] = robot
        yield from robots.values()

    def _resolver(self, config: Config) -> Resolver:
        """The resolver; it caches directories, perhaps thousands, until files on disk change."""
        if config.path not in self._resolvers:
            self._resolvers[config.path] = resolver = Resolver(config.packages)
            resolver.expansions = self._expansions
        expansion_limits.allow(config.limits)
        return self._resolvers[config.path].with_texts(self.texts)

    def check(
        self, path: str, *, thorough: bool = False, is_cancelled: Callable[[], bool] | None = None
    ) -> CheckResult:
        """Check the robots of a file.

        Args:
            path: of the file.
            thorough: also run the rules that open meshes or compute dynamics, and check a robot
                with all sets of arguments of launch files, not only with the first.
            is_cancelled: called before each rule.

        Raises:
            Cancelled: ``is_cancelled`` is true; the findings of the last complete check remain.
        """
        config, failure = self.config(path)
        files_before = set(self._files())
        roots = dict.fromkeys(entry.file for entry in self.entries(path))
        for root in roots:
            try:
                diagnostics = self._check_root(root, config, thorough, is_cancelled)
            except Cancelled:
                raise
            except UrdfkitError as error:
                failure, diagnostics = failure or str(error), []
            self._diagnostics[root] = by_key(
                (os.path.realpath(finding.span.source.path), finding) for finding in diagnostics
            )
        files = files_before | set(self._files()) | {path}
        return CheckResult({file: list(self._findings(file)) for file in sorted(files)}, failure)

    def _check_root(
        self, root: str, config: Config, thorough: bool, is_cancelled: Callable[[], bool] | None
    ) -> Iterable[Diagnostic]:
        options = Options(
            arguments={} if thorough else self._launched.get(root, {}),
            config=config,
            texts=self.texts,
            ignore=() if thorough else slow_rules(),
            as_launched=thorough,
            is_cancelled=is_cancelled,
        )
        return check_with(options, [root], self._resolver(config)).diagnostics

    def fixed(self, path: str) -> dict[str, bytes]:
        """The texts changed by all safe fixes of a file's robots, by path.

        Raises:
            UrdfkitError: a robot is unreadable.
        """
        config, _ = self.config(path)
        roots = dict.fromkeys(entry.file for entry in self.entries(path))
        fixes = fix(*roots, options=Options(config=config, texts=self.texts))
        return {os.path.realpath(f.path): Source(f.path, f.after).data for f in fixes.files}

    def formatted_text(self, path: str) -> bytes:
        """The text of a file as formatted by ``urdfkit format``.

        Raises:
            UrdfkitError: the file is not XML, or not a robot.
        """
        config, _ = self.config(path)
        return formatted(self.robot(path).source(path), config.width or WIDTH)

    def _files(self) -> Iterator[str]:
        return (file for by_file in self._diagnostics.values() for file in by_file)

    def _findings(self, file: str) -> Iterator[Diagnostic]:
        """The findings in a file; a finding of several robots has the message of the first."""
        reported: set[tuple[str, int, int]] = set()
        for by_file in self._diagnostics.values():
            new = [finding for finding in by_file.get(file, ()) if _key(finding) not in reported]
            reported.update(map(_key, new))
            yield from new

    def diagnostics(self, path: str) -> list[Diagnostic]:
        """The findings of the last check in a file, if its text is unchanged."""
        text = self.texts.get(path)
        return [
            diagnostic
            for diagnostic in self._findings(path)
            if text is None or diagnostic.span.source.data == Source(path, text).data
        ]


@cache
def slow_rules() -> list[str]:
    """Codes of the rules that are too slow for each keystroke; imports all rules."""
    return [rule.code for rule in rule_index.all_rules() if rule.needs & _SLOW]


def _key(diagnostic: Diagnostic) -> tuple[str, int, int]:
    return (diagnostic.code, diagnostic.span.start, diagnostic.span.end)
