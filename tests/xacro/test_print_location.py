"""What a model prints by ``xacro.print_location()``, word for word as stock xacro does."""

import subprocess
import sys
from pathlib import Path

import pytest

from urdfkit import expand
from urdfkit.cli import main

OUTER = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:include filename="inner.xacro"/>
<xacro:macro name="outer"><xacro:inner/></xacro:macro>
<xacro:outer/>
<link name="b${xacro.print_location()}"/>
</robot>
"""
INNER = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:macro name="inner"><link name="a${xacro.print_location()}"/></xacro:macro>
</robot>
"""


def test_macros_and_files(tmp_path: Path) -> None:
    (tmp_path / "inner.xacro").write_text(INNER, encoding="utf-8")
    path = tmp_path / "outer.xacro"
    path.write_text(OUTER, encoding="utf-8")
    run = f"import sys, xacro; sys.argv = ['xacro', {str(path)!r}]; xacro.main()"
    stock = subprocess.run([sys.executable, "-c", run], capture_output=True, text=True, check=True)
    found = expand(path)
    assert "".join(f"{message.text}\n" for message in found.messages) == stock.stderr
    assert stock.stderr.startswith("when instantiating macro: inner (")


def test_the_command_keeps_its_lines(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "inner.xacro").write_text(INNER, encoding="utf-8")
    path = tmp_path / "outer.xacro"
    path.write_text(OUTER, encoding="utf-8")
    assert main(["expand", str(path)]) == 0
    assert capsys.readouterr().err.splitlines() == [one.text for one in expand(path).messages]
