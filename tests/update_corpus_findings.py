"""What urdfkit finds in the real robots beside the checkout, as ``tests/corpus_findings.json``.

The file is the memory of what the rules say about robots that people use: a change of a rule
shows there as a diff to be read. Run ``python -m tests.update_corpus_findings`` after a change
that is meant, look at the diff, and commit it with the change.
"""

import json
import os
from collections import Counter
from pathlib import Path

from tests.conftest import CORPUS, SEARCH_PATHS, CorpusRobot, manifest
from urdfkit.lint import engine
from urdfkit.lint.report import Report

FILE = Path(__file__).with_name("corpus_findings.json")


def report_on(entry: CorpusRobot) -> Report:
    """All rules on one model."""
    return engine.check(entry.path, arguments=entry.arguments)


def counts(report: Report) -> dict[str, int]:
    """How often each code was found."""
    return dict(sorted(Counter(one.code for one in report.diagnostics).items()))


def read() -> dict[str, dict[str, int]]:
    """The findings as they were last written."""
    findings: dict[str, dict[str, int]] = json.loads(FILE.read_text(encoding="utf-8"))
    return findings


def main() -> None:
    for variable in SEARCH_PATHS:
        os.environ.pop(variable, None)
    if not CORPUS.is_dir():
        raise SystemExit("the corpus of real robots is not beside this checkout")
    findings = {str(entry): counts(report_on(entry)) for entry in manifest()}
    lines = (f"{json.dumps(name)}: {json.dumps(found)}" for name, found in sorted(findings.items()))
    FILE.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")
    total = sum(map(Counter, findings.values()), Counter[str]())
    print(f"{len(findings)} models: " + ", ".join(f"{c} {n}" for c, n in sorted(total.items())))


if __name__ == "__main__":
    main()
