"""``urdfkit explain``."""

from __future__ import annotations

from textwrap import fill, indent

import click

from urdfkit.cli import options, output
from urdfkit.cli.epilog import examples
from urdfkit.errors import UnknownRule
from urdfkit.rules import FAMILIES, Need, Rule, find_rule

_NEEDS = {
    Need.XACRO: "a xacro that expands",
    Need.MODEL: "a robot that can be read",
    Need.FILES: "the files that the robot names",
    Need.MESHES: "meshes that can be read (pip install 'urdfkit[meshes]')",
    Need.SRDF: "an SRDF beside the robot",
    Need.DYNAMICS: "Pinocchio (pip install 'urdfkit[dynamics]')",
    Need.COLLISIONS: "coal (pip install 'urdfkit[dynamics]')",
}


@click.command(
    "explain",
    epilog=examples(
        "urdfkit explain MSH001",
    ),
)
@click.argument("words", nargs=-1, required=True, metavar="RULE...")
@click.option("--rules", multiple=True, metavar="NAMES", help="Packages of other rules.")
def command(words: tuple[str, ...], rules: tuple[str, ...]) -> int:
    """Explain a rule: what it finds, why it matters, what to do.

    RULE is a code such as XML001 or a name such as not-well-formed.

    Exit codes: 0 done, 2 there is no such rule.
    """
    options.add_rules({"rules": rules})
    output.write("\n\n".join(map(render, map(_find, words))))
    return 0


def _find(word: str) -> Rule:
    if about := FAMILIES.get(word.upper()):
        raise UnknownRule(
            word, f": it is the family about {about}; 'urdfkit rules' lists its rules"
        )
    try:
        return find_rule(word)
    except UnknownRule:
        from urdfkit.rule_packages import add, installed

        add(installed(), modules=False)
        return find_rule(word)


def render(rule: Rule) -> str:
    """The page of a rule."""
    severities = [rule.severity.value]
    severities += [f"{severity.value} for {name}" for name, severity in rule.by_target.items()]
    severities.append("with a fix" if rule.fixable else "without a fix")
    needs = ", ".join(words for need, words in _NEEDS.items() if need in rule.needs)
    parts = [
        f"{rule.code} {rule.name} ({', '.join(severities)})",
        *map(_fill, rule.explanation.split("\n\n")),
        f"Needs: {needs or 'the text of the file'}",
    ]
    if rule.help:
        parts.append(_fill(f"Help: {rule.help}"))
    for title, which in (("Bad", "BAD"), ("Good", "GOOD"), ("Fixed", "FIXED")):
        if example := rule.example(which):
            parts.append(f"{title}:\n\n{indent(example.strip(), '    ')}")
    for name, text in rule.beside.items():
        parts.append(f"{name} beside it:\n\n{indent(text.strip(), '    ')}")
    if rule.sources:
        parts.append("\n".join(["Sources:", "", *(f"    {source}" for source in rule.sources)]))
    return "\n\n".join(parts) + "\n"


def _fill(paragraph: str) -> str:
    """A paragraph at 80 columns, or fewer; a list or an example stays as it is."""
    lines = paragraph.splitlines()
    if any(line.startswith((" ", "-", "*", "|")) for line in lines):
        return paragraph
    return fill(paragraph, min(output.width(), 80), break_long_words=False, break_on_hyphens=False)
