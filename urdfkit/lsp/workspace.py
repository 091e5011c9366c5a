"""The texts that an editor holds, the robots that they are part of, and what is wrong with those.

Nothing here speaks the protocol; one thread uses it.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator
from functools import cache

from urdfkit.core import expansion_limits
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

#: Robots that are checked when a file of macros changes; the others wait for their own turn.
MAX_ROBOTS = 8
#: Files that belong to robots of their package, and are none themselves.
_NO_ROBOTS = (".yaml", ".yml")
#: What takes too long for every key that is pressed.
_SLOW = frozenset((Need.MESHES, Need.DYNAMICS, Need.COLLISIONS))


class CheckedFile(Record):
    """What is wrong with the robots of a file."""

    diagnostics: dict[str, list[Diagnostic]]  # by real path, of every file in which there are some
    failure: str = ""  # why something could not be checked; empty if all was


class Workspace:
    """The texts that are open in an editor, and the files on disk."""

    def __init__(self) -> None:
        self.texts: dict[str, bytes] = {}
        self._entries: dict[str, tuple[RobotEntry, ...]] = {}
        self._launched: dict[str, dict[str, str]] = {}
        self._configs: dict[str, tuple[Config, str]] = {}
        self._resolvers: dict[str, Resolver] = {}
        self._robots: dict[str, OpenRobot] = {}
        self._before: dict[str, OpenRobot] = {}
        self._found: dict[str, dict[str, list[Diagnostic]]] = {}

    def set_text(self, path: str, text: bytes) -> None:
        if self.texts.get(path) != text:
            self.texts[path] = text
            self._forget_robots()

    def close(self, path: str) -> dict[str, list[Diagnostic]]:
        """A file is closed: what is on disk counts again.

        Returns:
            The findings left in files of robots that no open file is part of any more.
        """
        parts = {entry.file for entry in self.entries(path)}
        self.texts.pop(path, None)
        closed = parts - {entry.file for other in self.texts for entry in self.entries(other)}
        files = {file for root in closed for file in self._found.pop(root, ())}
        self.reload()
        return {file: list(self._of_file(file)) for file in files}

    def reload(self) -> None:
        self._entries.clear()
        self._launched.clear()
        self._configs.clear()
        self._resolvers.clear()
        self._forget_robots()

    def _forget_robots(self) -> None:
        self._before.update(self._robots)
        self._robots.clear()

    def config(self, path: str) -> tuple[Config, str]:
        """The configuration for a file, and what is wrong with it; never a trusting one."""
        directory = os.path.dirname(path)
        if directory not in self._configs:
            failure, found = "", Config()
            try:
                file = nearest(path)
                found = load(file, trusted=False) if file else found
                failure = "; ".join(found.warnings)
            except UrdfkitError as error:
                failure = str(error)
            self._configs[directory] = found, failure
        return self._configs[directory]

    def entries(self, path: str) -> tuple[RobotEntry, ...]:
        """The first robots that a file is part of; itself if there are none and it may be one."""
        if path not in self._entries:
            self._entries[path] = self._find_entries(path)
        return self._entries[path]

    def _find_entries(self, path: str) -> tuple[RobotEntry, ...]:
        alone = (RobotEntry(path, "", {}),)
        if is_launch(path) or not os.path.isdir(os.path.dirname(path)):
            return alone
        config, _ = self.config(path)
        try:
            found = affected([path], config, self._resolver(config)).robots
        except UrdfkitError:
            return alone
        own = tuple(robot for robot in found if os.path.realpath(robot.file) == path)
        robots = own or found or (() if path.endswith(_NO_ROBOTS) else alone)
        return tuple(self._started(robot, config) for robot in robots[:MAX_ROBOTS])

    def _started(self, robot: RobotEntry, config: Config) -> RobotEntry:
        """A robot; one that lacks arguments, with the first values that are found for them."""
        if robot.arguments or not robot.file.endswith(".xacro"):
            return robot
        resolver = self._resolver(config)

        def read(job: Job) -> Context:
            return Context(resolver.admit_and_read(job.path), resolver, job.arguments)

        try:
            (job, _), *_ = as_launched(
                Job(robot.file, "", dict(config.arguments), found=False), read
            )
        except UrdfkitError:
            return robot
        if not job.launched:
            return robot
        self._launched[robot.file] = job.arguments
        return robot._replace(arguments=job.arguments)

    def robot(self, path: str) -> OpenRobot:
        """The first robot that a file is part of.

        Raises:
            UrdfkitError: its file cannot be read.
        """
        if not self.entries(path):
            raise UrdfkitError(f"{path} is not part of a robot")
        entry = self.entries(path)[0]
        if entry.file not in self._robots:
            config, _ = self.config(path)
            before = self._before.pop(entry.file, None)
            self._robots[entry.file] = OpenRobot(entry, self._resolver(config), config, before)
        return self._robots[entry.file]

    def open_robots(self) -> Iterator[OpenRobot]:
        """The first robot of each open file, each once."""
        found: dict[str, OpenRobot] = {}
        for path in self.texts:
            try:
                robot = self.robot(path)
            except UrdfkitError:  # the file of none, or one that cannot be read
                continue
            found[robot.path] = robot
        yield from found.values()

    def _resolver(self, config: Config) -> Resolver:
        """Directories are listed once, until files on disk change: there may be thousands."""
        if config.path not in self._resolvers:
            self._resolvers[config.path] = Resolver(config.packages)
        expansion_limits.allow(config.limits)
        return self._resolvers[config.path].with_texts(self.texts)

    def check(
        self, path: str, *, thorough: bool = False, is_cancelled: Callable[[], bool] | None = None
    ) -> CheckedFile:
        """Check the robots of a file.

        Args:
            path: of the file.
            thorough: run the rules that open meshes or compute dynamics, too, and check a robot
                with each set of arguments that launch files start it with, not the first alone.
            is_cancelled: asked before each rule.

        Raises:
            Cancelled: it is true now; the findings stay those of the last whole check.
        """
        config, failure = self.config(path)
        before = set(self._files())
        roots = dict.fromkeys(entry.file for entry in self.entries(path))
        for root in roots:
            try:
                found = self._check_root(root, config, thorough, is_cancelled)
            except Cancelled:
                raise
            except UrdfkitError as error:
                failure, found = failure or str(error), []
            by_file: dict[str, list[Diagnostic]] = {}
            for diagnostic in found:
                file = os.path.realpath(diagnostic.span.source.path)
                by_file.setdefault(file, []).append(diagnostic)
            self._found[root] = by_file
        files = before | set(self._files()) | {path}
        return CheckedFile({file: list(self._of_file(file)) for file in sorted(files)}, failure)

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
        """The texts that change when all safe fixes of a file's robots are applied, by path.

        Raises:
            UrdfkitError: a robot cannot be read.
        """
        config, _ = self.config(path)
        roots = dict.fromkeys(entry.file for entry in self.entries(path))
        fixes = fix(*roots, options=Options(config=config, texts=self.texts))
        return {os.path.realpath(f.path): Source(f.path, f.after).data for f in fixes.files}

    def formatted_text(self, path: str) -> bytes:
        """The text of a file in the layout of ``urdfkit format``.

        Raises:
            UrdfkitError: it is no XML, or no robot.
        """
        config, _ = self.config(path)
        return formatted(self.robot(path).source(path), config.width or WIDTH)

    def _files(self) -> Iterator[str]:
        return (file for by_file in self._found.values() for file in by_file)

    def _of_file(self, file: str) -> Iterator[Diagnostic]:
        """The findings in a file; one that several robots share has the message of the first."""
        reported: set[tuple[str, int, int]] = set()
        for by_file in self._found.values():
            fresh = [one for one in by_file.get(file, ()) if _key(one) not in reported]
            reported.update(map(_key, fresh))
            yield from fresh

    def diagnostics(self, path: str) -> list[Diagnostic]:
        """What the last check found in a file, as far as its text is still the same."""
        text = self.texts.get(path)
        return [
            diagnostic
            for diagnostic in self._of_file(path)
            if text is None or diagnostic.span.source.data == Source(path, text).data
        ]


@cache
def slow_rules() -> list[str]:
    """The codes of the rules that are not run for every key; this imports all rules."""
    return [rule.code for rule in rule_index.all_rules() if rule.needs & _SLOW]


def _key(diagnostic: Diagnostic) -> tuple[str, int, int]:
    return (diagnostic.code, diagnostic.span.start, diagnostic.span.end)
