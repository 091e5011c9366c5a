"""The gazebo command: a table for people, JSON for programs."""

import json
from pathlib import Path

import pytest

from tests.shipped import MISSION
from urdfkit.cli import main


def test_the_table_has_the_result_of_every_link(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["gazebo", MISSION]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith("10 links become 5")
    assert any(line.split() == ["laser_frame", "0.01", "merged", "into", "dummy"] for line in lines)
    assert lines[-1] == "9 joints become 4; 5 are merged or dropped"


def test_json_has_the_merged_properties(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["gazebo", MISSION, "--format", "json"]) == 0
    document = json.loads(capsys.readouterr().out)
    (dummy, *wheels) = document["links"]
    assert dummy["mass"] == pytest.approx(8.2301)
    assert [wheel["name"] for wheel in wheels] == ["wheel_1", "wheel_2", "wheel_3", "wheel_4"]
    assert document["merged"]["base_link"] == "dummy"
    assert document["joints"][0] == {
        "name": "base_to_wheel1",
        "urdf": "continuous",
        "sdf": "revolute",
        "parent": "dummy",
        "child": "wheel_1",
    }


@pytest.mark.parametrize("words", [["no.urdf"], [MISSION, MISSION]])
def test_usage_errors(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["gazebo", *words]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.startswith("error: ")


def test_names_are_aligned_and_escaped(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    links = "".join(
        f'<link name="{name}"><inertial><mass value="1"/></inertial></link>'
        for name in ("底盘", "a\u202eb")
    )
    (tmp_path / "r.urdf").write_text(f'<robot name="r">{links}</robot>', encoding="utf-8")
    assert main(["gazebo", str(tmp_path / "r.urdf")]) == 0
    rows = capsys.readouterr().out.splitlines()
    start = next(at for at, row in enumerate(rows) if row.startswith("link "))
    assert rows[start : start + 3] == [
        "link      mass / kg  after conversion",
        "底盘              1  kept",
        "a\\u202eb          1  kept",
    ]


def test_a_link_with_two_parents_is_told(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Gazebo merges such a link twice: a UR3 with two joints from the world had 4 kg for 2."""
    inertial = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1"/></inertial>'
    links = "".join(f'<link name="{name}">{inertial}</link>' for name in "abc")
    ends = (("i", "a", "b"), ("j", "b", "c"), ("k", "a", "c"))
    joints = "".join(
        f'<joint name="{name}" type="fixed"><parent link="{up}"/><child link="{down}"/></joint>'
        for name, up, down in ends
    )
    file = tmp_path / "r.urdf"
    file.write_text(f'<robot name="r">{links}{joints}</robot>')
    assert main(["gazebo", str(file)]) == 0
    assert capsys.readouterr().out.startswith("Gazebo may load another robot:")
