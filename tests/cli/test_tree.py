"""The tree command."""

from __future__ import annotations

import pytest

from tests.conftest import MODELS
from urdfkit.cli import main
from urdfkit.diagrams import FORMATS

GRIPPER = str(MODELS / "good" / "gripper.urdf")


@pytest.mark.parametrize("form", FORMATS)
def test_every_format_names_every_link(form: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["tree", GRIPPER, "--format", form]) == 0
    drawn = capsys.readouterr().out
    assert all(name in drawn for name in ("mount", "palm", "left_finger", "right_finger"))


def test_it_cannot_draw_what_is_not_there(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["tree", "no.urdf"]) == 2
    assert capsys.readouterr().out == ""
