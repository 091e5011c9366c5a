"""The options of a check, as one record."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping

from urdfkit.core.record import Record
from urdfkit.core.static_typing import TYPE_CHECKING, Any
from urdfkit.lint import rule_index
from urdfkit.lint.config import Config
from urdfkit.text.diagnostic import Confidence

if TYPE_CHECKING:
    from urdfkit.core.progress import Progress
    from urdfkit.lint.context import Simulate
    from urdfkit.lint.rules import Need


class Options(Record):
    """Options of a check.

    Attributes:
        arguments: xacro arguments, like ``name:=value`` on the command line.
        packages: directories of ROS packages by name; they override every search.
        select: rules to run, by code, prefix of codes, or name; all if empty.
        ignore: rules not to run, by code, prefix of codes, or name.
        targets: names of the programs to check for; detected from each model if empty.
        trust: do not sandbox the expressions of the model, and let it read any file.
        config: settings of the project; the other options override them.
        rules: additional packages of rules: names of installed entry points of the group
            ``urdfkit.lint.rules``, or names of modules to import.
        preview: True to run all preview rules, or their codes; if False, only those run that
            ``select`` contains by whole code or name.
        min_confidence: least confidence of reported findings: ``measured``, ``inferred`` or
            ``guessed``.
        variant: name of the only variant in the configuration to check; all if empty.
        changed: True if the files are changed files of any kind, to check all robots that use them.
        jobs: number of processes; 0 to choose it by the number of robots.
        as_launched: also check robots with the arguments that launch files pass.
        cache: cache the measures of mesh files for the next run.
        simulate: `urdfkit.simulate`, to also run the rules about simulations; None not to.
        only_errors: needs; rules with one of them run only if they may report errors.
        texts: contents that replace files on disk, by path, such as an editor's buffers.
        progress: called with the number of descriptions done and the number of all; for a single
            description, with those of its mesh files.
        is_cancelled: called before each rule; if it returns True, the check raises `Cancelled`.
    """

    arguments: Mapping[str, str] = {}
    packages: Mapping[str, str] = {}
    select: Collection[str] = ()
    ignore: Collection[str] = ()
    targets: Collection[str] = ()
    trust: bool = False
    config: Config = Config()
    rules: Collection[str] = ()
    preview: bool | Collection[str] = False
    min_confidence: str = ""
    variant: str = ""
    changed: bool = False
    jobs: int = 1
    as_launched: bool = True
    cache: bool = True
    simulate: Simulate | None = None
    only_errors: frozenset[Need] = frozenset()
    texts: Mapping[str, bytes] = {}
    progress: Progress | None = None
    is_cancelled: Callable[[], bool] | None = None

    def given(self, **named: Any) -> Options:
        """The options, overridden by the arguments that are not empty.

        Raises:
            TypeError: a list of words is a single string, an iterable of characters.
        """
        for name in named.keys() & {"select", "ignore", "targets"}:
            if isinstance(named[name], str):
                raise TypeError(f"{name} must be a list of words, such as [{named[name]!r}]")
            named[name] = tuple(named[name])
        return self._replace(**{name: value for name, value in named.items() if value})

    def with_config(self) -> Options:
        """The options with the packages, targets and trust of the configuration."""
        config = self.config
        return self._replace(
            packages={**config.packages, **self.packages},
            targets=tuple(self.targets) or config.targets,
            trust=self.trust or config.trust,
        )

    def for_one(self, arguments: Mapping[str, str]) -> Options:
        """The options for one robot with all of its arguments; call it after ``with_config``."""
        return self._replace(
            arguments=arguments, config=self.config._replace(robots=()), variant=""
        )

    def resolved(self) -> Options:
        """The options with the configuration, and the codes of all rules that run in ``select``.

        Raises:
            UnknownRule: a word of ``select`` or ``ignore`` matches no rule.
            UnknownTarget: a name is not a target.
            RuleError: a package of rules is missing or cannot be used.
        """
        external = external_codes(self)
        options = self.with_config()
        if options.targets:
            from urdfkit.ros.targets import parse

            parse(options.targets)
        select, ignore = self.select, self.ignore
        chosen = choose(select, ignore, self.config, external)
        if self.simulate is None:
            simulating = rule_index.of_family("simulation")
            chosen = [code for code in chosen if code not in simulating]
        return options._replace(
            select=tuple(chosen),
            ignore=(),
            config=_overridden(self.config, select, ignore, self.min_confidence),
            preview=previewed(self.preview, select, self.config),
        )

    def previews(self, code: str) -> bool:
        """True if a preview rule runs; call it after ``resolved``."""
        return self.preview is True or (self.preview is not False and code in self.preview)


def external_codes(options: Options) -> tuple[str, ...]:
    """Register the additional packages of rules; the codes of their rules."""
    return (*options.config.external_rules, *added_rules(options.rules))


def added_rules(packages: Iterable[str]) -> list[str]:
    """Register packages of rules; the codes of their rules."""
    names = tuple(packages)
    if not names:
        return []
    from urdfkit.lint.rule_packages import add

    return add(names, modules=True)


def _overridden(
    config: Config, select: Collection[str], ignore: Collection[str], min_confidence: str
) -> Config:
    """A configuration, overridden by the options of a check about its findings."""
    # Selected rules are reported even if the configuration ignores them.
    selected = {code for word in select for code in rule_index.matching(word)}
    but_errors = (config.but_errors - selected) | rule_index.ignored(ignore).but_errors
    config = config._replace(but_errors=but_errors)
    if min_confidence:
        config = config._replace(min_confidence=Confidence(min_confidence))
    return config


def choose(
    select: Iterable[str],
    ignore: Iterable[str],
    config: Config = Config(),
    external: Iterable[str] = (),
) -> list[str]:
    """The codes that match ``select`` and do not match ``ignore``.

    ``CFG003`` is included unless it is ignored: it reports robots that cannot be checked.

    Args:
        select: codes, prefixes of codes, or names; all of urdfkit's and ``external`` if empty.
        ignore: codes, prefixes of codes, or names.

    Raises:
        UnknownRule: a word matches no rule; skipping a typo would silently run other rules.
    """
    selected = {code for word in select for code in rule_index.matching(word)}
    ignored = rule_index.ignored(ignore)
    if ignored.unknown:
        raise ignored.unknown[0]
    # Selected rules run even if the configuration ignores them.
    excluded = ignored.codes | (config.ignore - selected)
    chosen = selected or config.select or {*rule_index.codes(), *external}
    return sorted((chosen | {rule_index.NOT_CHECKED}) - excluded)


def previewed(
    preview: bool | Collection[str], select: Iterable[str], config: Config
) -> bool | frozenset[str]:
    """The codes of the preview rules that run; True for all."""
    if not isinstance(preview, bool):
        return frozenset(preview)
    return preview or config.preview or rule_index.named(select) | config.named
