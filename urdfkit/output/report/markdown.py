"""The report as Markdown, for a pull request."""

from collections.abc import Iterable, Iterator
from typing import Any

from urdfkit.output.report.document import ReportDocument
from urdfkit.output.report.translations import PLURALS, Translator
from urdfkit.text.markdown import code, escape, fitted, table

_SIGNS = {"error": "🔴", "warning": "🟡", "info": "🔵"}
_VERDICTS = {"passes": "🟢", "passes with warnings": "🟡", "fails": "🔴"}


def render(document: ReportDocument, translator: Translator) -> str:
    """Summary, verdicts, findings, and then tables."""
    return fitted(_sections(document, translator))


def _sections(document: ReportDocument, _: Translator) -> Iterator[str]:
    robot, summary = document["robot"], document["summary"]
    counts = ", ".join(_counted(summary[key], key, _) for key in ("error", "warning", "info"))
    title = robot["name"] if robot else document["file"]
    yield f"## {escape(title)}\n\n{code(document['file'])}: **{counts}**\n"
    if robot:
        rows = [
            [_("Links"), str(robot["links"])],
            [_("Joints"), str(robot["joints"])],
            [_("Degrees of freedom"), str(robot["degrees_of_freedom"])],
            [_("Mass"), f"{robot['mass']:g} kg"],
            [_("Centre of mass"), f"{_vector(robot['center'] or [None] * 3)} m"],
        ]
        yield table(["", ""], rows)
    if document["targets"]:
        header = [_("Target"), _("Verdict"), _("error"), _("warning"), _("info")]
        yield table(header, (_target(target, _) for target in document["targets"]))
    if document["findings"]:
        header = ["", _("Where"), _("What")]
        yield f"### {_('Findings')}\n\n" + table(header, _findings(document["gathered"], _))
    if document["links"]:
        header = [_("Link"), f"{_('Mass')} / kg", _("Principal moments") + " / kg·m²"]
        yield f"### {_('Masses')}\n\n" + table(header, map(_link, document["links"]))


def _counted(count: int, noun: str, _: Translator) -> str:
    return f"{count} {_(noun if count == 1 else PLURALS[noun])}"


def _target(target: dict[str, Any], _: Translator) -> list[str]:
    verdict = f"{_VERDICTS[target['verdict']]} {_(target['verdict'])}"
    counts = [str(target[key]) for key in ("error", "warning", "info")]
    return [target["name"], verdict, *counts]


def _findings(findings: Iterable[dict[str, Any]], _: Translator) -> Iterator[list[str]]:
    for finding in sorted(findings, key=lambda item: list(_SIGNS).index(item["severity"])):
        place = f"{finding['path']}:{finding['line']}:{finding['column']}"
        kind = f"{_SIGNS[finding['severity']]} {finding['code']}"
        yield [kind, code(place), escape(finding["message"])]


def _link(link: dict[str, Any]) -> list[str]:
    mass = "" if link["mass"] is None else f"{link['mass']:g}"
    return [code(link["name"]), mass, _vector(link["moments"] or ())]


def _vector(values: Iterable[float | None]) -> str:
    return " ".join("?" if value is None else f"{round(value, 12) + 0.0:.4g}" for value in values)
