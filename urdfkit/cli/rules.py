"""``urdfkit rules``."""

import json
from collections.abc import Sequence

import click

from urdfkit.cli import options, output
from urdfkit.cli.decorators import RULES, choice, described
from urdfkit.lint.rule_index import all_rules, matching
from urdfkit.lint.rule_packages import add, installed
from urdfkit.lint.rules import Rule


@described("rules")
@click.argument("words", nargs=-1, metavar="[CODE]...")
@choice("--format", "format", of=["text", "json"], help="Text table, or JSON with explanations.")
@RULES
def command(words: tuple[str, ...], format: str, rules: tuple[str, ...]) -> int:
    """List all rules: those of urdfkit and those of other packages.

    CODE is a code, a prefix of codes such as MSH, or a name: only these are listed. Installed
    rule packages are listed, and those of NAMES. Each line has the code, the severity, 'fix' if
    there is one, the name and the title.

    Exit codes: 0 done, 2 unknown rule, or a rule package cannot be read.

    Examples:
        urdfkit rules
        urdfkit rules MSH
        urdfkit rules --format json
    """
    add(installed(), modules=False)
    options.add_rules({"rules": rules})
    codes = {code for word in words for code in matching(word)}
    selected = [rule for rule in all_rules() if not words or rule.code in codes]
    output.write((_json if format == "json" else _text)(selected))
    return 0


def _text(rules: Sequence[Rule]) -> str:
    """A line for each rule; a terminal that is too narrow gets the title below it."""
    longest = max(len(rule.name) for rule in rules)
    titles = ["(preview) " * rule.preview + _summary(rule) for rule in rules]
    is_narrow = output.is_terminal() and 24 + longest + max(map(len, titles)) > output.width()
    text = ""
    for rule, title in zip(rules, titles, strict=True):
        severity = output.colored(f"{rule.severity.value:<7}", output.SEVERITIES)
        text += f"{rule.code}  {severity}  {'fix' if rule.fixable else '   '}  "
        if is_narrow:
            below = output.indented(title, " " * 8, " " * 8)
            text += "\n".join((rule.name, *below, ""))
        else:
            text += f"{rule.name:<{longest}}  {title}\n"
    return text


def _summary(rule: Rule) -> str:
    """The first paragraph of the explanation, on one line."""
    return " ".join(rule.explanation.partition("\n\n")[0].split())


def _json(rules: Sequence[Rule]) -> str:
    document = [
        {
            "code": rule.code,
            "name": rule.name,
            "severity": rule.severity.value,
            "by_target": {name: severity.value for name, severity in rule.severities.items()},
            "status": "preview" if rule.preview else "stable",
            "since": rule.since,
            "options": dict(rule.options),
            "needs": sorted(need.value for need in rule.needs),
            "fixable": rule.fixable,
            "help": rule.help,
            "explanation": rule.explanation,
            "sources": rule.sources,
        }
        for rule in rules
    ]
    return json.dumps(document, ensure_ascii=False, indent=2) + "\n"
