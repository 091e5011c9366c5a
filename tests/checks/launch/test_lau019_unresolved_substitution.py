"""LAU019: see the rule."""

from pathlib import Path

import pytest

from tests.launched import reported

ROS_1 = '<rosparam command="load" file="$(dirname)/../c.yaml"/><arg name="a" doc="b"/>'
ROS_2 = (
    '<node pkg="a" exec="b"><param from="$(dirname)/../c.yaml"/></node><let name="a" value="b"/>'
)


@pytest.mark.parametrize(
    ("launch", "yaml", "switch"),
    [
        (ROS_1, "frame: $(arg prefix)base\n", "subst_value"),
        (ROS_1, "file: '$(find pkg)/x'\n", "subst_value"),
        (ROS_2, "frame: $(var prefix)base\n", "allow_substs"),
    ],
)
def test_unresolved_text(tmp_path: Path, launch: str, yaml: str, switch: str) -> None:
    (tmp_path / "c.yaml").write_text(yaml)
    (found,) = reported(tmp_path, "LAU019", "a.launch", launch)
    assert found.help.partition(", and declare")[0] == f'write {switch}="true"'
    mended = launch.replace('c.yaml"', f'c.yaml" {switch}="true"')
    assert reported(tmp_path, "LAU019", "a.launch", mended) == []


@pytest.mark.parametrize("yaml", ["a: 1\n", "a: 1 # $(arg x)\n", "a: $(other x)\n", "# $(arg x)"])
def test_files_without_substitutions_are_calm(tmp_path: Path, yaml: str) -> None:
    (tmp_path / "c.yaml").write_text(yaml)
    assert reported(tmp_path, "LAU019", "a.launch", ROS_1) == []
