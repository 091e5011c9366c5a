"""Libraries of another version, such as those of a sourced ROS."""

import sys
from pathlib import Path
from types import ModuleType

import pytest

from tests.shipped import ARM
from urdfkit.cli import main
from urdfkit.errors import Unavailable
from urdfkit.lint.requirements import need_coal


@pytest.mark.parametrize(
    ("command", "module", "version", "least"),
    [("statics", "pinocchio", "2.6.21", 4), ("collisions", "coal", "2.4", 3)],
)
def test_an_older_version_is_named_with_its_place(
    command: str,
    module: str,
    version: str,
    least: int,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    old = ModuleType(module)
    vars(old).update(__version__=version, __file__="/opt/ros/old/__init__.py")
    monkeypatch.setitem(sys.modules, module, old)
    assert main([command, ARM]) == 2
    error = " ".join(capsys.readouterr().err.split())
    assert f"{version} at /opt/ros/old/__init__.py is older than {least}: " in error
    assert error.endswith("or take it off PYTHONPATH")


def test_an_unknown_version_is_tried(monkeypatch: pytest.MonkeyPatch) -> None:
    own = ModuleType("coal")
    vars(own).update(__version__="devel")
    monkeypatch.setitem(sys.modules, "coal", own)
    need_coal()
    monkeypatch.setitem(sys.modules, "coal", None)
    with pytest.raises(Unavailable, match="coal is not installed"):
        need_coal()


def test_an_older_mujoco_is_named_with_its_place(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    old = ModuleType("mujoco")
    vars(old).update(__version__="3.2.7", __file__="/env/mujoco/__init__.py")
    monkeypatch.setitem(sys.modules, "mujoco", old)
    simulated = ["check", ARM, "--simulate"]
    for words in (
        simulated,
        ["simulate", ARM],
        ["convert", ARM, "--to", "mjcf", "-o", str(tmp_path / "m")],
    ):
        assert main(words) == 2
        error = " ".join(capsys.readouterr().err.split())
        assert "needs mujoco 4, not 3.2.7 at /env/mujoco/__init__.py: " in error
