"""What a file of a robot is: xacro, by its content, or a launch file, by its name."""

import os
import re

from urdfkit.text.comments import without_comments
from urdfkit.text.source import Source

# Compiled when needed, which is seldom.
_OWN_TAG = rb"<xacro:(macro|include|property|arg|if|unless|insert_block|element|attribute|call)\b"


def is_xacro(source: Source) -> bool:
    """Decide by content whether a file is xacro.

    17 of 676 public models are xacro in a ``.urdf``, and many a plain URDF still declares the
    namespace of the xacro it once came from, or holds a call that no macro answers any more:
    URDF parsers ignore those. A file whose name says xacro is taken at its word.
    """
    if ".xacro" in os.path.basename(source.path).lower():
        return True
    data = source.data
    has_tags, has_namespace = b"<xacro:" in data, b"xmlns:xacro" in data
    if not has_tags and not has_namespace:
        return False
    text = without_comments(data)
    if has_tags and re.search(_OWN_TAG, text):
        return True
    return has_namespace and re.search(rb"\$[{(]", text) is not None


_LAUNCH = (
    ".launch", ".launch.xml", "_launch.xml", ".launch.py", "_launch.py",
    ".launch.yaml", "_launch.yaml", ".launch.yml", "_launch.yml",
)  # fmt: skip


def is_launch(path: str) -> bool:
    """True for the names that launch files have."""
    return path.endswith(_LAUNCH)
