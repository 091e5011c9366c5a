"""What a file is: xacro, a launch file, an SRDF, or a part of a robot."""

import os
import re

from urdfkit.text.comments import without_comments
from urdfkit.text.document import Element
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


def has_srdf_tags(root: Element) -> bool:
    """True for a semantic description (MoveIt's SRDF), whose root is ``<robot>``, too."""
    from urdfkit.text.schema import SRDF_TAGS

    return root.child("link") is None and any(one.tag in SRDF_TAGS for one in root.children)


def is_list_of_joints(root: Element) -> bool:
    """True for joints without links, parents and children: the settings of another program."""
    return bool(root.children) and all(
        joint.tag == "joint" and not (joint.child("parent") or joint.child("child"))
        for joint in root.children
    )


def is_extension(root: Element) -> bool:
    """True for joints without a robot's name and links, which a robot includes.

    Clearpath's robots include the file that an environment variable names; what is no element
    of URDF there is a call of a macro.
    """
    is_robot = root.get("name") is not None or root.child("link") is not None
    return not is_robot and root.child("joint") is not None
