"""One state of a robot: a file, or a file as git has it."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from functools import cached_property

from urdfkit.errors import UnreadableRobot
from urdfkit.lint.config import Config
from urdfkit.lint.engine import check
from urdfkit.lint.loading import subject_of
from urdfkit.lint.report import Report
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver
from urdfkit.workspace.revisions import locate
from urdfkit.workspace.snapshots import OldFile, as_it_was

#: Larger files of a revision are not looked at.
LARGEST = 64 * 1024 * 1024


class RobotState:
    """A description with what it takes to judge it.

    Attributes:
        word: as it was asked for.
        subject: the description.
    """

    def __init__(
        self,
        word: str,
        old: OldFile | None,
        folder: str,
        arguments: Mapping[str, str],
        packages: Mapping[str, str],
        targets: Iterable[str],
        trust: bool,
        config: Config | None,
    ) -> None:
        self.word = word
        self._folder = folder
        self._packages = old.packages if old else dict(packages)
        self._targets, self._trust, self._config = tuple(targets), trust, config
        source, resolver = Source.read(old.path if old else word), Resolver(self._packages)
        self.subject = subject_of(source, resolver, arguments, trust=trust)
        if self.subject.reading.document is None:
            reasons = dict.fromkeys(problem.message for problem in self.subject.reading.problems)
            raise UnreadableRobot(f"{word} cannot be read: {'; '.join(reasons)}")

    @cached_property
    def report(self) -> Report:
        """What ``urdfkit check`` says."""
        config = self._config
        if config is not None:
            config = config._replace(robots=(), packages=self._packages)
        return check(
            self.subject.source,
            arguments=self.subject.arguments,
            packages=self._packages,
            targets=self._targets,
            trust=self._trust,
            config=config,
        )

    def rename_sources(self) -> None:
        """Call files of a revision as the user did; the folder that held them goes away."""
        revision = self.word.partition(":")[0]
        known = {id(s): s for s in self.subject.document.sources}
        for finding in self.report.diagnostics:
            spans = [finding.span, *(related.span for related in finding.related)]
            spans += [step.span for call in finding.calls for step in call.via]
            known.update((id(span.source), span.source) for span in spans)
        for source in known.values():
            if source.path.startswith(os.path.join(self._folder, "")):
                path = os.path.relpath(source.path, self._folder)
                source.path = f"{revision}:{path.replace(os.sep, '/')}"


def read(
    word: str,
    folder: str,
    *,
    arguments: Mapping[str, str] | None,
    packages: Mapping[str, str] | None,
    targets: Iterable[str],
    trust: bool,
    config: Config | None,
    variant: str = "",
) -> RobotState:
    """The state that a word means; files of git go into a folder.

    Raises:
        UnreadableFile: file not found.
        UnreadableRobot: it cannot be read.
        ConfigError: the configuration has several variants of it, or none of this name.
        UrdfkitError: there is no such revision, or git is not there.
    """
    every = {**(config.packages if config else {}), **(packages or {})}
    old, path = None, word
    if ":" in word and not os.path.exists(word):
        revision, _, path = word.partition(":")
        path = locate(path, revision)
        old = as_it_was(path, revision, folder, every, LARGEST)
    values = (config or Config()).entry(path, arguments, variant).arguments
    return RobotState(word, old, folder, values, every, targets, trust, config)
