from __future__ import annotations

from pathlib import Path

from tests.conftest import CORPUS, needs_corpus
from tests.srdfs import findings
from urdfkit import Diagnostic, check


def reported(folder: Path, *joints: str, place: str = "joint_limits.yaml") -> list[Diagnostic]:
    lines = "".join(f"  {name}:\n    max_velocity: 1.0\n" for name in joints)
    (folder / place).parent.mkdir(exist_ok=True)
    (folder / place).write_text(f"joint_limits:\n{lines}")
    return findings(folder, "", "SRD014")


def test_a_slip(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, "shoulder", "shuolder")
    assert found.message == "limits for joint 'shuolder', which is not in the model"
    assert found.help == "did you mean 'shoulder'?"
    assert found.span.source.path == str(tmp_path / "joint_limits.yaml")
    assert (found.span.line, found.span.text) == (4, "shuolder")


def test_limits_of_another_robot_are_told_once(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, "a", "b", "c")
    assert "'a'" in found.message


def test_known_joints_and_files_that_say_nothing(tmp_path: Path) -> None:
    assert reported(tmp_path, "shoulder", "wrist") == []
    for text in ("", "joint_limits: 3", "joint_limits:\n  elbow: 3", "- a", "joint_limits: ["):
        (tmp_path / "joint_limits.yaml").write_text(text)
        assert findings(tmp_path, "", "SRD014") == []


@needs_corpus
def test_real_files() -> None:
    panda = CORPUS / "moveit_resources" / "panda_description" / "urdf" / "panda.urdf"
    assert check(panda, select=["SRD014", "SRD015"]).diagnostics == ()
