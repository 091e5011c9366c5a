"""Small xacro models with errors, and what is reported of them, in short."""

from pathlib import Path

from tests.xacro import models
from urdfkit.text.diagnostic import Problem
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver
from urdfkit.xacro import Xacro, expand


def run(directory: Path, body: str, arguments: dict[str, str] | None = None, **parts: str) -> Xacro:
    """Expand a model whose body begins in line 2; ``part="..."`` is ``part.xacro``."""
    for name, text in {"robot": body, **parts}.items():
        is_yaml = name.startswith("yaml")
        file = directory / f"{name}.{'yaml' if is_yaml else 'xacro'}"
        file.write_text(text if is_yaml else models.document(f"\n{text}\n"), encoding="utf-8")
    return expand(Source.read(directory / "robot.xacro"), Resolver({}, {}), arguments)


def brief(problem: Problem) -> str:
    """File, line, column, and the text there."""
    span = problem.span
    return f"{Path(span.source.path).name}:{span.line}:{span.column} {span.text}"


def briefs(xacro: Xacro) -> list[str]:
    return [brief(problem) for problem in xacro.problems]


def way(problem: Problem) -> list[str]:
    """The calls and includes that led to a problem, outermost first."""
    steps = problem.frame.steps() if problem.frame else ()
    return [f"{Path(s.name).name} {s.span.line}:{s.span.column}" for s in steps]


def related(problem: Problem) -> list[str]:
    return [f"{one.span.line}:{one.span.column} {one.message}" for one in problem.related]
