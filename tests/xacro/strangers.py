"""Expanding what a stranger wrote."""

from pathlib import Path

from tests.xacro import models
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver
from urdfkit.xacro import Xacro, expand

SECRET = "the secret of this machine"


def run(directory: Path, text: str, *, trust: bool = False, **files: str) -> Xacro:
    """Expand a model whose body, or whole text, is given; ``part="..."`` is ``part.xacro``."""
    for name, content in files.items():
        suffix = ".yaml" if name.startswith("yaml") else ".xacro"
        (directory / f"{name}{suffix}").write_text(content, encoding="utf-8")
    file = directory / "robot.xacro"
    file.write_text(text if text.startswith(("<?", "<!")) else models.document(text), "utf-8")
    return expand(Source.read(file), Resolver({}, {}), trust=trust)


def codes(xacro: Xacro) -> set[str]:
    """The rules that tell what was wrong."""
    return {problem.code for problem in xacro.problems}
