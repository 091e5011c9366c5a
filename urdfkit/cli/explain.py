"""``urdfkit explain``."""

import re
from textwrap import fill, indent

import click

from urdfkit.cli import options, output
from urdfkit.cli.decorators import RULES, described
from urdfkit.core.words import listed
from urdfkit.errors import UnknownRule
from urdfkit.lint.rule_index import FAMILIES, find_rule, note
from urdfkit.lint.rules import Need, Rule
from urdfkit.text.diagnostic import Severity

_NEEDS = {
    Need.XACRO: "a xacro that expands",
    Need.MODEL: "a readable robot model",
    Need.FILES: "the files that the robot references",
    Need.MESHES: "readable meshes (extra 'meshes')",
    Need.LAUNCH: "a launch file",
    Need.SRDF: "an SRDF of the robot",
    Need.DYNAMICS: "Pinocchio (extra 'dynamics')",
    Need.COLLISIONS: "coal (extra 'dynamics')",
    Need.SIMULATION: "--simulate, and MuJoCo (extra 'simulate')",
}


#: Placeholder of a non-breaking space.
_HARD = "\0"


@described("explain")
@click.argument("words", nargs=-1, required=True, metavar="RULE...")
@RULES
def command(words: tuple[str, ...], rules: tuple[str, ...]) -> int:
    """Explain a rule: what it reports, why, and how to fix it.

    RULE is a code such as XML001 or a name such as not-well-formed.

    Exit codes: 0 done, 2 unknown rule.

    Examples:
        urdfkit explain MSH001
    """
    options.add_rules({"rules": rules})
    output.write("\n\n".join(map(render, map(_find, words))))
    return 0


def _find(word: str) -> Rule:
    if title := FAMILIES.get(word.upper()):
        family = f": a rule family ({title}); 'urdfkit rules {word.upper()}' lists its rules"
        raise UnknownRule(word, family)
    if rename_note := note(word):
        options.warn(rename_note)
    try:
        return find_rule(word)
    except UnknownRule:
        from urdfkit.lint.rule_packages import add, installed

        add(installed(), modules=False)
        return find_rule(word)


def render(rule: Rule) -> str:
    needs = ", ".join(words for need, words in _NEEDS.items() if need in rule.needs)
    has_fix = "with a fix" if rule.fixable else "without a fix"
    parts = [
        _fill(f"{rule.code} {rule.name} ({severities(rule)}, {has_fix})"),
        *map(_fill, rule.explanation.split("\n\n")),
        _fill(f"Needs: {needs or 'the text of the file'}"),
    ]
    if rule.preview:
        parts.append("Preview: runs with --preview, or if it is selected by its code or name.")
    if rule.options:
        defaults = ", ".join(f"{name} = {value:g}" for name, value in rule.options.items())
        parts.append(_fill(f"Options in [rules.{rule.code}] of the configuration: {defaults}"))
    if rule.help:
        parts.append(_fill(f"Help: {rule.help}"))
    for title, example in _robots(rule).items():
        parts.append(f"{title}:\n\n{indent(example.strip(), '    ')}")
    for name, text in rule.example_files.items():
        parts.append(f"{name} in the same package:\n\n{indent(text.strip(), '    ')}")
    if rule.sources:
        parts.append("\n".join(["Sources:", "", *(f"    {source}" for source in rule.sources)]))
    return "\n\n".join(parts) + "\n"


def severities(rule: Rule) -> str:
    """Such as ``info, error for gz-harmonic and gz-jetty``."""
    parts = [rule.severity.value]
    for severity in Severity:
        names = [name for name, level in rule.severities.items() if level is severity]
        if names and severity is not rule.severity:
            parts.append(f"{severity.value} for {listed(names)}")
    return ", ".join(parts)


def _robots(rule: Rule) -> dict[str, str]:
    """The examples of a rule by title, without duplicates."""
    bad, good, fixed = map(rule.example, ("BAD", "GOOD", "FIXED"))
    accepted = "Good, after the fix" if good == fixed else "Good"
    examples = {"Bad": bad, accepted: good, "Fixed": None if good == fixed else fixed}
    return {title: text for title, text in examples.items() if text}


def _fill(paragraph: str) -> str:
    """A paragraph or list at 80 columns or fewer; examples are unchanged, code is not broken."""
    if paragraph.startswith("- "):
        return "\n".join(_filled(item, "  ") for item in re.split(r"\n(?=- )", paragraph))
    if any(line.startswith((" ", "-", "*", "|")) for line in paragraph.splitlines()):
        return paragraph
    return _filled(paragraph)


def _filled(text: str, indentation: str = "") -> str:
    """A text in lines.

    Args:
        indentation: of all lines but the first.
    """
    line = re.sub(r"`[^`]{,60}`", lambda code: _HARD.join(code[0].split()), " ".join(text.split()))
    width = min(output.width(), 80)
    filled = fill(
        line, width, subsequent_indent=indentation, break_long_words=False, break_on_hyphens=False
    )
    return filled.replace(_HARD, " ")
