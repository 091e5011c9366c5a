"""What programs make of real robots, as ``tests/consumers/verdicts.json`` and ``docs/targets.md``.

Run ``python -m tests.consumers.update [PROGRAM...]`` after a change of what ``--target`` reports,
look at the difference, and commit it with the change. A program that is not installed keeps what
was written of it.
"""

import json
import sys
from importlib.metadata import version
from pathlib import Path

from tests.conftest import CORPUS, ROOT
from tests.consumers.comparison import label, robots, verdict
from tests.consumers.reading import PROGRAMS, is_installed, oracle

FILE = Path(__file__).with_name("verdicts.json")
PAGE = ROOT / "docs" / "targets.md"
BEGIN, END = "<!-- table -->\n", "<!-- end of the table -->\n"

HEAD = (
    "| `--target`: program | robots | rejected | cause reported | loaded with an error "
    "| mass differs |"
)

#: Of each program its version, and what was said of each robot.
Verdicts = dict[str, dict[str, dict[str, str]]]


def read() -> Verdicts:
    """The verdicts as they were last written."""
    found: Verdicts = json.loads(FILE.read_text(encoding="utf-8")) if FILE.is_file() else {}
    return found


def asked(name: str) -> dict[str, dict[str, str]]:
    """What a program and urdfkit say today."""
    found = {label(robot): str(one) for robot in robots() if (one := verdict(name, robot))}
    return {"versions": {oracle(name).PACKAGE: version(oracle(name).PACKAGE)}, "robots": found}


def table(verdicts: Verdicts) -> str:
    """The verdicts as a table in Markdown, a row for each program."""
    lines = [HEAD, "| --- | ---: | ---: | ---: | ---: | ---: |"]
    for name in sorted(verdicts):
        ((package, number),) = verdicts[name]["versions"].items()
        said = list(verdicts[name]["robots"].values())
        rejected = [one for one in said if one.startswith("refused")]
        taken = [one for one in said if one.startswith("taken")]
        cells = (
            f"`{name}`: {package} {number}",
            len(said),
            len(rejected),
            sum("not told" not in one for one in rejected),
            sum("error" in one for one in taken),
            sum("mass" in one for one in taken),
        )
        lines.append(f"| {' | '.join(map(str, cells))} |")
    return "\n".join(lines) + "\n"


def page(verdicts: Verdicts) -> str:
    """The page of the targets with the table."""
    before, _, rest = PAGE.read_text(encoding="utf-8").partition(BEGIN)
    return before + BEGIN + table(verdicts) + END + rest.partition(END)[2]


def main(names: list[str]) -> None:
    if not CORPUS.is_dir():
        sys.exit(f"no corpus at {CORPUS}")
    verdicts = read()
    for name in names or PROGRAMS:
        if is_installed(name):
            verdicts[name] = asked(name)
    FILE.write_text(json.dumps(verdicts, indent=1, sort_keys=True) + "\n", encoding="utf-8")
    PAGE.write_text(page(verdicts), encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
