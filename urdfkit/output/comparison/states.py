"""A state of a robot: a file, or a file at a revision in git."""

import os
from collections.abc import Iterable
from functools import cached_property

from urdfkit.core.paths import is_within
from urdfkit.errors import UnreadableRobot
from urdfkit.lint.engine import check
from urdfkit.lint.loading import context_of, require_robot
from urdfkit.lint.options import Options
from urdfkit.lint.report import Report
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver
from urdfkit.workspace.revisions import locate
from urdfkit.workspace.snapshots import check_out_snapshot

#: Size in bytes above which files of a revision are ignored.
MAX_BYTES = 64 * 1024 * 1024


class RobotState:
    """A robot description with its configuration.

    Args:
        word: a file, or ``REVISION:PATH``.
        directory: destination of files from git.

    Raises:
        UnreadableFile: file not found.
        UnreadableRobot: the robot cannot be read, or the file describes none.
        ConfigError: the configuration has several variants of it, or lacks this variant.
        UrdfkitError: the revision does not exist, or git is not installed.
    """

    def __init__(self, word: str, directory: str, options: Options) -> None:
        self.word = word  # as passed
        self._directory = directory
        options = options.with_config()
        path = found = word
        if ":" in word and not os.path.exists(word):
            revision, _, path = word.partition(":")
            path = locate(path, revision)
            old = check_out_snapshot(path, revision, directory, options.packages, MAX_BYTES)
            found, options = old.path, options._replace(packages=old.packages)
        values = options.config.entry(path, options.arguments, options.variant).arguments
        source, resolver = Source.read(found), Resolver(options.packages)
        self.context = context_of(source, resolver, values, trust=options.trust)  # the description
        self._require_links()
        config = options.config._replace(packages=options.packages)
        self._options = options._replace(config=config).for_one(self.context.arguments)

    def _require_links(self) -> None:
        """Reject a file that is no robot, which would differ from a robot in every link."""
        reading = self.context.reading
        if reading.document is None or not self.context.model.links:
            self._rename([self.context.source, *(p.span.source for p in reading.problems)])
        require_robot(self.context)
        if not self.context.model.links:
            raise UnreadableRobot(self.context.tree.unsound)

    @cached_property
    def report(self) -> Report:
        return check(self.context.source, options=self._options)

    def rename_sources(self) -> None:
        """Rename files to ``REVISION:PATH``, as their temporary directory is removed."""
        known = {id(s): s for s in self.context.document.sources}
        for finding in self.report.diagnostics:
            spans = [finding.span, *(related.span for related in finding.related)]
            spans += [step.span for call in finding.calls for step in call.via]
            known.update((id(span.source), span.source) for span in spans)
        self._rename(known.values())

    def _rename(self, sources: Iterable[Source]) -> None:
        revision = self.word.partition(":")[0]
        for source in sources:
            if is_within(source.path, self._directory):
                path = os.path.relpath(source.path, self._directory)
                source.path = f"{revision}:{path.replace(os.sep, '/')}"
