"""What each rule says about its BAD, message and help, as ``tests/wording.txt``.

Other tests assert names and values (``tests/naming.py``), so that a change of wording is one diff.
Run ``python -m tests.update_wording`` after a change that is meant, read the diff, and commit it.
"""

import re
import tempfile
from collections.abc import Iterable
from functools import cache
from pathlib import Path

import urdfkit
from urdfkit.lint import rule_examples, rule_index
from urdfkit.text.diagnostic import Diagnostic

FILE = Path(__file__).with_name("wording.txt")

#: The directory in which an example was checked.
_SCRATCH = re.compile(re.escape(tempfile.gettempdir()) + r"/tmp\w+")


def wording(found: Iterable[Diagnostic]) -> str:
    """Messages and helps, each once."""
    lines = [f"{one.code}  {one.message}\n        {one.help}\n" for one in found]
    return _SCRATCH.sub(rule_examples.DIRECTORY, "".join(dict.fromkeys(lines)))


@cache
def read() -> dict[str, str]:
    """The wording of each rule by its code, as it was last written."""
    parts = re.split(r"^(?=(\w+)  )", FILE.read_text(encoding="utf-8"), flags=re.MULTILINE)
    texts: dict[str, str] = {}
    for code, text in zip(parts[1::2], parts[2::2], strict=True):
        texts[code] = texts.get(code, "") + text
    return texts


def main() -> None:
    texts = []
    for rule in map(rule_index.get, rule_index.codes()):
        bad = rule.example("BAD") or ""
        found = rule_examples.diagnose_example(rule, bad, simulate=urdfkit.simulate)
        texts.append(wording(found))
    FILE.write_text("".join(texts), encoding="utf-8")


if __name__ == "__main__":
    main()
