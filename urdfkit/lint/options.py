"""The options of a check: one record, which is passed on whole."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping

from urdfkit.core.record import Record
from urdfkit.core.static_typing import TYPE_CHECKING, Any
from urdfkit.lint import rule_index
from urdfkit.lint.config import Config
from urdfkit.text.diagnostic import Confidence

if TYPE_CHECKING:
    from urdfkit.core.progress import Progress
    from urdfkit.lint.rules import Need


class Options(Record):
    """How descriptions are checked.

    Attributes:
        arguments: xacro arguments, as ``name:=value`` gives them on the command line.
        packages: directories of ROS packages by name; they win over every search.
        select: codes, beginnings of codes or names; only these rules run. All if empty.
        ignore: codes, beginnings of codes or names of rules that do not run.
        targets: names of the programs to check for; inferred from each model if empty.
        trust: do not sandbox the expressions of the model, and let it read any file.
        config: settings of the project; the other options win over them.
        rules: packages of rules that run, too: names under which they are installed (entry
            points of the group ``urdfkit.lint.rules``), or of modules, which are imported.
        preview: run preview rules, too: all, or those of these codes; without it, those that
            ``select`` names by their whole code or name.
        min_confidence: leave out findings that are less sure: ``measured``, ``inferred`` or
            ``guessed``.
        variant: the name of the only one, of those in the configuration, that is checked.
        changed: the files are changed files of any kind; the robots that they are part of are
            checked, each once.
        jobs: processes that check at the same time; 0 for as many as are worth while.
        as_launched: check robots also with the arguments that launch files start them with.
        cache: keep the measures of mesh files for the next run.
        only_errors: of the rules that need one of these, only those that may report errors run.
        texts: files whose bytes are not those on disk, by path, such as an editor's buffers.
        progress: called with the number of descriptions done and of all; of a single one, with
            those of its mesh files.
        is_cancelled: asked before each rule; the check raises `Cancelled` once it is true.
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
    only_errors: frozenset[Need] = frozenset()
    texts: Mapping[str, bytes] = {}
    progress: Progress | None = None
    is_cancelled: Callable[[], bool] | None = None

    def given(self, **named: Any) -> Options:
        """The options with those of a call that are not empty."""
        return self._replace(**{name: value for name, value in named.items() if value})

    def with_config(self) -> Options:
        """The options with what the configuration adds to them."""
        config = self.config
        return self._replace(
            packages={**config.packages, **self.packages},
            targets=tuple(self.targets) or config.targets,
            trust=self.trust or config.trust,
        )

    def for_one(self, arguments: Mapping[str, str]) -> Options:
        """Those for one robot with all of its arguments; of options with the configuration."""
        return self._replace(
            arguments=arguments, config=self.config._replace(robots=()), variant=""
        )

    def resolved(self) -> Options:
        """The options with codes for words: ``select`` has those of all rules that run.

        Raises:
            UnknownRule: a word of ``select`` or ``ignore`` means no rule.
            UnknownTarget: a name is no target.
            RuleError: a package of rules is missing or cannot be used.
        """
        external = external_codes(self)
        options = self.with_config()
        if options.targets:
            from urdfkit.ros.targets import parse

            parse(options.targets)
        select, ignore = self.select, self.ignore
        return options._replace(
            select=tuple(choose(select, ignore, self.config, external)),
            ignore=(),
            config=_overridden(self.config, select, ignore, self.min_confidence),
            preview=previewed(self.preview, select, self.config),
        )

    def previews(self, code: str) -> bool:
        """True if a preview rule runs; of resolved options."""
        return self.preview is True or (self.preview is not False and code in self.preview)


def words(name: str, given: Iterable[str]) -> tuple[str, ...]:
    """The words of an argument; one text is none, though it can be iterated over.

    Raises:
        TypeError: the words are one text.
    """
    if isinstance(given, str):
        raise TypeError(f"{name} must be a list of words, such as [{given!r}]")
    return tuple(given)


def external_codes(options: Options) -> tuple[str, ...]:
    """The codes of the rules of other packages that run, which are known from now on."""
    return (*options.config.external_rules, *added_rules(options.rules))


def added_rules(packages: Iterable[str]) -> list[str]:
    """The codes of packages of rules, which are known from now on."""
    names = tuple(packages)
    if not names:
        return []
    from urdfkit.lint.rule_packages import add

    return add(names, modules=True)


def _overridden(
    config: Config, select: Collection[str], ignore: Collection[str], min_confidence: str
) -> Config:
    """A configuration with what the options of a check say of its findings."""
    # What the call selects is reported, whatever the configuration leaves out.
    selected = {code for word in select for code in rule_index.matching(word)}
    kept = config.but_errors - selected
    config = config._replace(but_errors=kept | rule_index.ignored(ignore).but_errors)
    if min_confidence:
        config = config._replace(min_confidence=Confidence(min_confidence))
    return config


def choose(
    select: Iterable[str],
    ignore: Iterable[str],
    config: Config = Config(),
    external: Iterable[str] = (),
) -> list[str]:
    """The codes that one of ``select`` means and none of ``ignore``.

    ``CFG003`` is one of them unless it is ignored: of a robot that is not checked, no selection
    of rules finds anything.

    Args:
        select: codes, beginnings of codes or names; all of urdfkit's and ``external`` if empty.
        ignore: codes, beginnings of codes or names.

    Raises:
        UnknownRule: one of the words means no rule. To ignore a typo would check with other
            rules than were asked for, and say nothing.
    """
    selected = {code for word in select for code in rule_index.matching(word)}
    left_out = rule_index.ignored(ignore)
    if left_out.unknown:
        raise left_out.unknown[0]
    # What the call selects runs, whatever the configuration leaves out.
    ignored = left_out.codes | (config.ignore - selected)
    chosen = selected or config.select or {*rule_index.codes(), *external}
    return sorted((chosen | {rule_index.NOT_CHECKED}) - ignored)


def previewed(
    preview: bool | Collection[str], select: Iterable[str], config: Config
) -> bool | frozenset[str]:
    """The codes of the preview rules that run; True for all."""
    if not isinstance(preview, bool):
        return frozenset(preview)
    return preview or config.preview or rule_index.named(select) | config.named
