"""Summary of the results of a scan: rule rates, duplicates, outliers, failures."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from math import log10
from operator import itemgetter
from statistics import quantiles
from typing import Any

from urdfkit.core.record import Record

#: Listed examples of each entry.
MAX_EXAMPLES = 3
#: Rows of one list.
MAX_ROWS = 20
#: Facts whose outliers are listed, with their units; `_RATIOS` are compared on a log scale.
FACTS = {
    "mass": "kg", "size_x": "m", "size_y": "m", "size_z": "m", "dof": "", "links": "",
    "cpu_seconds": "s",
}  # fmt: skip
_RATIOS = frozenset(("mass", "size_x", "size_y", "size_z", "cpu_seconds"))
#: Interquartile ranges from the middle half: Tukey's "far out".
_FAR_OUT = 3.0
#: Fewer values have no outliers.
_MIN_VALUES = 8


class RuleRate(Record):
    """Frequency of the findings of a rule."""

    #: code, rule, severity: of the rule; the worst severity.
    code: str
    rule: str
    severity: str
    #: findings and models: number of findings, and of models with them.
    findings: int
    models: int
    examples: tuple[str, ...]  # names of models


class Outlier(Record):
    """A model with an unusual value."""

    fact: str  # one of `FACTS`
    value: float  # of the model
    #: low and high: range of the middle half of the models.
    low: float
    high: float
    model: str  # its name


class Summary(Record):
    """The results of a scan on one page."""

    models: int  # number of models
    statuses: dict[str, int]  # number of models by status
    #: with_errors, with_warnings, clean: models with an error; with a warning and no error; sound
    #: models without either.
    with_errors: int
    with_warnings: int
    clean: int
    cpu_seconds: float  # of all checks
    rules: tuple[RuleRate, ...]  # rules with findings, by decreasing number of models
    duplicates: tuple[tuple[str, ...], ...]  # models with the same content, largest groups first
    redundant: int  # number of models that are copies of another one
    outliers: tuple[Outlier, ...]  # the most extreme ones of each fact
    #: The models that are not ``ok``, by name with status and reason.
    failures: tuple[tuple[str, str, str], ...]


def summarise(rows: Iterable[dict[str, Any]]) -> Summary:
    """The summary of the rows of a scan, from one pass over the journal."""
    statuses: Counter[str] = Counter()
    kinds: Counter[str] = Counter()
    rules: dict[str, RuleRate] = {}
    copies: dict[str, list[str]] = {}
    values: dict[str, list[tuple[float, str]]] = {fact: [] for fact in FACTS}
    failures: list[tuple[str, str, str]] = []
    seconds = 0.0
    for row in rows:
        name = row["model"]
        statuses[row["status"]] += 1
        kinds[_kind(row)] += 1
        seconds += row["cpu_seconds"]
        _count_rules(rules, row)
        if row["hash"]:
            copies.setdefault(row["hash"], []).append(name)
        for fact, entries in values.items():
            if row[fact] is not None:
                entries.append((row[fact], name))
        if row["status"] != "ok" and len(failures) < MAX_ROWS:
            failures.append((name, row["status"], row["reason"]))
    groups = sorted(copies.values(), key=lambda group: (-len(group), group))
    return Summary(
        statuses.total(),
        dict(statuses.most_common()),
        kinds["error"],
        kinds["warning"],
        kinds["clean"],
        seconds,
        tuple(sorted(rules.values(), key=lambda rate: (-rate.models, rate.code))),
        tuple(tuple(group) for group in groups[:MAX_ROWS] if len(group) > 1),
        sum(len(group) - 1 for group in groups),
        tuple(outlier for fact, entries in values.items() for outlier in _outliers(fact, entries)),
        tuple(failures),
    )


def _kind(row: dict[str, Any]) -> str:
    if row["errors"]:
        return "error"
    if row["warnings"]:
        return "warning"
    return "clean" if row["status"] == "ok" else "failed"


def _count_rules(rules: dict[str, RuleRate], row: dict[str, Any]) -> None:
    counts = Counter(finding["code"] for finding in row["findings"])
    for finding in row["findings"]:
        code = finding["code"]
        new = RuleRate(code, finding["rule"], finding["severity"], 0, 0, ())
        rate = rules.setdefault(code, new)
        worst = min(rate.severity, finding["severity"], key=("error", "warning", "info").index)
        rules[code] = rate._replace(severity=worst)
    for code, count in counts.items():
        rate = rules[code]
        examples = (*rate.examples, row["model"])[:MAX_EXAMPLES]
        rules[code] = rate._replace(
            findings=rate.findings + count, models=rate.models + 1, examples=examples
        )


def _outliers(fact: str, values: list[tuple[float, str]]) -> list[Outlier]:
    """The most extreme values; the `_RATIOS` on a log scale."""
    scaled = [
        (log10(value) if fact in _RATIOS else value, value, name)
        for value, name in values
        if value > 0 or fact not in _RATIOS
    ]
    if len(scaled) < _MIN_VALUES:
        return []
    low, _, high = quantiles(map(itemgetter(0), scaled), n=4)
    spread = _FAR_OUT * (high - low)
    far = [entry for entry in scaled if not low - spread <= entry[0] <= high + spread]
    far.sort(key=lambda entry: (-abs(entry[0] - (low + high) / 2), entry[2]))
    ends = [10**end if fact in _RATIOS else end for end in (low, high)]
    return [Outlier(fact, value, ends[0], ends[1], name) for _, value, name in far[:MAX_EXAMPLES]]
