"""Checks of robots with fixed texts in memory, and the identity of findings and edits in them."""

import os
from collections.abc import Iterable, Iterator, Mapping
from functools import cached_property

from urdfkit.core import disk
from urdfkit.lint import rule_index
from urdfkit.lint.context import Context
from urdfkit.lint.engine import check_with, contexts
from urdfkit.lint.options import Options
from urdfkit.lint.processes import Workers
from urdfkit.lint.report import Report
from urdfkit.lint.rules import Need
from urdfkit.text.diagnostic import Diagnostic, Edit
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

#: Identity of a finding across rounds: code, file and message, but no place, since edits move it.
FindingKey = tuple[str, str, str]

#: Identity of an edit across robots: real path, first and last byte, new text.
EditKey = tuple[str, int, int, str]

#: Needs that take long to compute. The rules with these needs have no fix.
SLOW = frozenset((Need.DYNAMICS, Need.COLLISIONS))


class Checker:
    """Checks robots with texts in memory that replace files on disk.

    Args:
        options: see ``check``.
        codes: codes of all rules whose findings are fixed, or must not be added by a fix.
    """

    def __init__(
        self, files: Iterable[str | os.PathLike[str]], options: Options, codes: Iterable[str]
    ) -> None:
        self._files = tuple(files)
        self._options = options
        self._codes = frozenset(codes)
        self.config = options.config
        self.resolver = Resolver(options.with_config().packages, texts=options.texts)
        self.workers = Workers()

    def report(self, texts: Mapping[str, bytes]) -> Report:
        """The report for the user, of the selected rules."""
        return check_with(self._with_texts(texts), self._files, self.resolver, workers=self.workers)

    def guard(
        self, texts: Mapping[str, bytes], files: Iterable[str | os.PathLike[str]] | None = None
    ) -> Report:
        """The report that fixes are taken from and compared with; without slow rules.

        Args:
            files: some of the robots; all if None.
        """
        checked = self._files if files is None else files
        return self._check(checked, texts, self._codes, only_errors=SLOW)

    def guard_others(self, texts: Mapping[str, bytes], files: Iterable[str]) -> Report:
        """The report on the errors of robots other than the checked ones."""
        return self._check(files, texts, self._errors)

    def proposals(
        self, texts: Mapping[str, bytes], files: Iterable[str], codes: Iterable[str]
    ) -> tuple[tuple[Edit, ...], ...]:
        """The edits that rules propose, for each robot."""
        return self._check(files, texts, codes).proposals

    def robots(
        self, texts: Mapping[str, bytes], files: Iterable[str] | None = None
    ) -> Iterator[Context | None]:
        """The robots of a check, in its order."""
        return contexts(self._with_texts(texts), self._files if files is None else files)

    def _check(
        self,
        files: Iterable[str | os.PathLike[str]],
        texts: Mapping[str, bytes],
        codes: Iterable[str],
        *,
        only_errors: frozenset[Need] = frozenset(),
    ) -> Report:
        # Ignored rules are not among the codes, but the errors of a former code are.
        former = tuple(filter(rule_index.redirect, self._options.ignore))
        options = self._with_texts(texts)._replace(select=tuple(codes), ignore=former)
        options = options._replace(only_errors=only_errors)
        return check_with(options, files, self.resolver, workers=self.workers)

    def _with_texts(self, texts: Mapping[str, bytes]) -> Options:
        return self._options._replace(texts={**self._options.texts, **texts})

    @cached_property
    def _errors(self) -> list[str]:
        """The rules that may report errors."""
        severities = self.config.severities
        rules = map(rule_index.get, self._codes)
        return [rule.code for rule in rules if rule.may_report_errors(severities.get(rule.code))]


def finding_key(diagnostic: Diagnostic) -> FindingKey:
    """The identity of a finding across rounds."""
    return (diagnostic.code, real_path(diagnostic.span.source), diagnostic.message)


def edit_key(edit: Edit) -> EditKey:
    """The identity of an edit, independent of links to its file."""
    return (real_path(edit.span.source), *edit.span[1:], edit.text)


def real_path(source: Source) -> str:
    """The real path of the file of a source."""
    return disk.real(source.path)
