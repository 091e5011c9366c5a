"""The git submodules of a repository."""

import os
import re

from urdfkit.core import disk
from urdfkit.workspace.file_head import read_head

_PATH = rb"(?m)^[ \t]*path[ \t]*=(.*)$"


def absent_submodules(repository: str) -> list[str]:
    """The directories of the submodules that are not checked out: empty or missing."""
    text = read_head(os.path.join(repository, ".gitmodules"))
    paths = (
        os.path.join(repository, os.fsdecode(path.strip())) for path in re.findall(_PATH, text)
    )
    return [path for path in paths if not disk.names_or_empty(path)]
