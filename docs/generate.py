"""Write the pages of the rules, ``docs/rules``, from the rules themselves.

Usage: python docs/generate.py
"""

import json
import re
import sys
import tempfile
from html import escape
from itertools import groupby
from pathlib import Path

from urdfkit import simulate
from urdfkit.cli.explain import severities
from urdfkit.lint.rule_examples import DIRECTORY as DIRECTORY_OF_EXAMPLES
from urdfkit.lint.rule_examples import diagnose_example
from urdfkit.lint.rule_index import FAMILIES, all_rules
from urdfkit.lint.rules import Rule
from urdfkit.ros.targets import TARGETS, facts_of
from urdfkit.text.terminal import wrap

DIRECTORY = Path(__file__).resolve().parent / "rules"

#: The directory in which an example was run.
_SCRATCH = re.compile(re.escape(tempfile.gettempdir()) + r"/tmp\w+")


def pages() -> dict[str, str]:
    """The text of every page by its file name."""
    rules = all_rules()
    return {"README.md": index(rules)} | {f"{rule.code}.md": page(rule) for rule in rules}


def index(rules: list[Rule]) -> str:
    """The list of all rules."""
    lines = [
        "# Rules",
        "",
        "`urdfkit explain CODE` says the same. A code is never reused or renamed.",
        "*error*: a mainstream program rejects the robot or simulates it wrongly; *warning*: it",
        "loads but is probably not intended; *info*: style or a hint.",
    ]
    for family, members in groupby(rules, key=lambda rule: rule.code[:3]):
        lines += ["", f"## {family}: {FAMILIES[family]}", ""]
        lines += ["| code | name | severity | finds |", "| --- | --- | --- | --- |"]
        lines += [
            f"| [{rule.code}]({rule.code}.md) | {rule.name} | {rule.severity.value} |"
            f" {summary(rule)} |"
            for rule in members
        ]
    data = json.dumps({name: for_target(name, rules) for name in TARGETS}, separators=(",", ":"))
    lines += ["", f'<script type="application/json" id="targets">{data}</script>']
    return "\n".join(lines) + "\n"


def for_target(name: str, rules: list[Rule]) -> dict[str, str]:
    """Severities for a target that are not the rule's, by code; empty for what it does not read."""
    unread = facts_of(name).unread
    own = {rule.code: rule.severities[name].value for rule in rules if name in rule.severities}
    return own | {rule.code: "" for rule in rules if rule.module.split(".")[2] in unread}


def summary(rule: Rule) -> str:
    """The first paragraph of the explanation, for a cell of a table."""
    return rule.explanation.partition("\n\n")[0].replace("\n", " ").replace("|", "\\|")


def page(rule: Rule) -> str:
    """The page of one rule."""
    parts = [
        f"# {rule.code} {rule.name}",
        f"Severity: {severities(rule)}.{remedy(rule)}",
        rule.explanation,
    ]
    if rule.help:
        parts.append(f"What to do: {escape(rule.help, quote=False)}.")
    if bad := rule.example("BAD"):
        said = [
            wrap(_SCRATCH.sub(DIRECTORY_OF_EXAMPLES, found.message), 80, indent=2)
            for found in diagnose_example(rule, bad, simulate=simulate)
        ]
        parts += ["## Reported", block("xml", bad), block("text", "\n".join(said))]
    good, fixed = rule.example("GOOD"), rule.example("FIXED")
    if good:
        title = "## Accepted, as the fix makes it" if good == fixed else "## Accepted"
        parts += [title, block("xml", good)]
    if fixed and fixed != good:
        parts += ["## After the fix", block("xml", fixed)]
    for name, text in rule.example_files.items():
        language = "yaml" if name.endswith("yaml") else "xml"
        parts += [f"## `{name}` in the same package", block(language, text)]
    for name, data in getattr(sys.modules[rule.module], "FIXED_FILES", {}).items():
        parts += [f"## `{name}` after the fix", block("xml", data.decode())]
    if rule.sources:
        parts += ["## Sources", "\n".join(map(reference, rule.sources))]
    return "\n\n".join(parts) + "\n"


def reference(source: str) -> str:
    """A source as an item of a list; what has an address leads there."""
    return re.sub(r"^- (.*): (https?:\S+)$", r"- [\1](\2)", f"- {source}")


def remedy(rule: Rule) -> str:
    """Whether there is a fix, and what it takes to have it applied."""
    bad = rule.example("BAD")
    if not rule.fixable or not bad:
        return ""
    fixes = [found.fix for found in diagnose_example(rule, bad, simulate=simulate) if found.fix]
    option = "" if all(fix.safe for fix in fixes) else " with `--unsafe-fixes`"
    return f" Comes with a fix, which [`urdfkit fix`](../commands/fix.md) applies{option}."


def block(language: str, text: str) -> str:
    """A block of code, fenced."""
    shown = text.strip().encode("utf-8", "backslashreplace").decode("utf-8")
    return f"```{language}\n{shown}\n```"


def main() -> None:
    """Write all pages, and remove those of rules that are no more."""
    DIRECTORY.mkdir(exist_ok=True)
    texts = pages()
    for old in DIRECTORY.glob("*.md"):
        if old.name not in texts:
            old.unlink()
    for name, text in texts.items():
        (DIRECTORY / name).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
