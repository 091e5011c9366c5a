"""Detection of file kinds: xacro, launch file, SRDF, or part of a robot."""

import os
import re
from functools import lru_cache

from urdfkit.text.comments import without_comments
from urdfkit.text.document import Element
from urdfkit.text.source import Source

# Compiled when needed, which is rare.
_OWN_TAG = rb"<xacro:(macro|include|property|arg|if|unless|insert_block|element|attribute|call)\b"


@lru_cache(maxsize=1)  # rules ask again for each of their findings in a file
def is_xacro(source: Source) -> bool:
    """True if a file is xacro, by its name or its content.

    17 of 676 public models are xacro in a ``.urdf``, and many plain URDFs still declare the
    namespace of the xacro they were generated from, or contain a call of a macro that no longer
    exists: URDF parsers ignore those. A file with ``.xacro`` in its name is always xacro.
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
    """True if a file has the name of a launch file."""
    return path.endswith(_LAUNCH)


def has_srdf_tags(root: Element) -> bool:
    """True for a semantic description (MoveIt's SRDF), whose root is also ``<robot>``."""
    from urdfkit.text.schema import SRDF_TAGS

    return root.child("link") is None and any(child.tag in SRDF_TAGS for child in root.children)


def is_list_of_joints(root: Element) -> bool:
    """True for joints without links, parents and children: settings of another program."""
    return bool(root.children) and all(
        joint.tag == "joint" and not (joint.child("parent") or joint.child("child"))
        for joint in root.children
    )


def is_extension(root: Element) -> bool:
    """True for a file with joints but neither a robot name nor links, which a robot includes.

    Clearpath's robots include the file that an environment variable names; elements of it that are
    not URDF are macro calls.
    """
    is_robot = root.get("name") is not None or root.child("link") is not None
    return not is_robot and root.child("joint") is not None
