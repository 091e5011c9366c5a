"""What the results of a scan say together: rates per rule, duplicates, outliers, failures."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from math import log10
from operator import itemgetter
from statistics import quantiles
from typing import Any

from urdfkit.core.record import Record

#: Examples that are named of each thing.
EXAMPLES = 3
#: Rows of one list.
MAX_ROWS = 20
#: Facts whose outliers are listed, with their units; those on a scale of ratios are compared so.
FACTS = {
    "mass": "kg", "size_x": "m", "size_y": "m", "size_z": "m", "dof": "", "links": "",
    "cpu_seconds": "s",
}  # fmt: skip
_RATIOS = frozenset(("mass", "size_x", "size_y", "size_z", "cpu_seconds"))
#: Interquartile ranges from the middle half: Tukey's "far out".
_FAR = 3.0
#: With fewer values there are no outliers.
_FEWEST = 8


class RuleRate(Record):
    """How often a rule found something."""

    #: code, rule, severity: of it; the worst severity.
    code: str
    rule: str
    severity: str
    #: findings and models: how many findings, in how many models.
    findings: int
    models: int
    examples: tuple[str, ...]  # names of models


class Outlier(Record):
    """A model far from the others."""

    fact: str  # one of `FACTS`
    value: float  # of the model
    #: low and high: between which the middle half of the models is.
    low: float
    high: float
    model: str  # its name


class Summary(Record):
    """The results of a scan on one page."""

    models: int  # how many
    statuses: dict[str, int]  # how many of each status
    #: with_errors, with_warnings, clean: models with an error; with a warning and no error; read,
    #: and without either.
    with_errors: int
    with_warnings: int
    clean: int
    cpu_seconds: float  # of all checks
    rules: tuple[RuleRate, ...]  # those that found something, in most models first
    duplicates: tuple[tuple[str, ...], ...]  # models with the same content, most first
    redundant: int  # how many models are copies of another one
    outliers: tuple[Outlier, ...]  # the farthest of each fact
    #: The models that are not ``ok``, by name with status and reason.
    failures: tuple[tuple[str, str, str], ...]


def summarise(rows: Iterable[dict[str, Any]]) -> Summary:
    """The summary of the rows of a scan, as the journal has them; it reads them once."""
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
        for fact, known in values.items():
            if row[fact] is not None:
                known.append((row[fact], name))
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
        tuple(one for fact, known in values.items() for one in _outliers(fact, known)),
        tuple(failures),
    )


def _kind(row: dict[str, Any]) -> str:
    if row["errors"]:
        return "error"
    if row["warnings"]:
        return "warning"
    return "clean" if row["status"] == "ok" else "failed"


def _count_rules(rules: dict[str, RuleRate], row: dict[str, Any]) -> None:
    counts = Counter(found["code"] for found in row["findings"])
    for found in row["findings"]:
        code = found["code"]
        new = RuleRate(code, found["rule"], found["severity"], 0, 0, ())
        known = rules.setdefault(code, new)
        worst = min(known.severity, found["severity"], key=("error", "warning", "info").index)
        rules[code] = known._replace(severity=worst)
    for code, count in counts.items():
        known = rules[code]
        examples = (*known.examples, row["model"])[:EXAMPLES]
        rules[code] = known._replace(
            findings=known.findings + count, models=known.models + 1, examples=examples
        )


def _outliers(fact: str, known: list[tuple[float, str]]) -> list[Outlier]:
    """The values that are farthest out, in ratios where these count."""
    scaled = [
        (log10(value) if fact in _RATIOS else value, value, name)
        for value, name in known
        if value > 0 or fact not in _RATIOS
    ]
    if len(scaled) < _FEWEST:
        return []
    low, _, high = quantiles(map(itemgetter(0), scaled), n=4)
    spread = _FAR * (high - low)
    far = [one for one in scaled if not low - spread <= one[0] <= high + spread]
    far.sort(key=lambda one: (-abs(one[0] - (low + high) / 2), one[2]))
    ends = [10**end if fact in _RATIOS else end for end in (low, high)]
    return [Outlier(fact, value, ends[0], ends[1], name) for _, value, name in far[:EXAMPLES]]
