"""Texts as an editor has them: ``|`` is the cursor."""

import os
from pathlib import Path

from tests.conftest import MISSION
from urdfkit.lsp.markup import Markup
from urdfkit.lsp.open_robot import OpenRobot
from urdfkit.lsp.workspace import Workspace

XACRO = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">\n{}\n</robot>\n'


class Edited:
    """A file while it is edited.

    Attributes:
        workspace: that holds it.
        path: of the file.
        offset: of the cursor in bytes.
    """

    def __init__(self, path: Path, text: str, workspace: Workspace | None = None) -> None:
        self.workspace = workspace or Workspace()
        self.path = os.path.realpath(path)
        self.offset = 0
        self.type(text)

    def type(self, text: str) -> None:
        """Change the text; where it has a ``|``, that is the cursor."""
        before, _, after = text.partition("|")
        self.offset = len(before.encode())
        self.workspace.set_text(self.path, (before + after).encode())

    @property
    def robot(self) -> OpenRobot:
        return self.workspace.robot(self.path)

    @property
    def markup(self) -> Markup:
        return self.robot.markup(self.path)


def mission(before: str, after: str = "") -> str:
    """The mission's model with the cursor between two pieces of its text."""
    text = MISSION.read_text(encoding="utf-8")
    assert before + after in text
    return text.replace(before + after, f"{before}|{after}", 1)
