"""The mass command: text, JSON, CSV, Markdown."""

import csv
import io
import json
from pathlib import Path

import pytest

from tests.massive import inertial, link
from tests.shipped import GRIPPER, MISSION
from urdfkit.cli import main
from urdfkit.lint.rule_examples import whole_robot


def run(capsys: pytest.CaptureFixture[str], *words: str) -> str:
    assert main(["mass", *words]) == 0
    return capsys.readouterr().out


def test_text(capsys: pytest.CaptureFixture[str]) -> None:
    lines = run(capsys, GRIPPER).splitlines()
    assert lines[1].split() == ["palm", "0.5", "89.3%", "0", "0", "0.02", "976.6"]
    assert any(line.split()[:2] == ["total", "0.56"] for line in lines)


def test_json(capsys: pytest.CaptureFixture[str]) -> None:
    document = json.loads(run(capsys, MISSION, "--format", "json"))
    assert document["total"]["mass"] == pytest.approx(10.2301)
    wheel = next(link for link in document["links"] if link["name"] == "wheel_1")
    assert wheel["shapes"]["source"] == "the collision"
    assert wheel["density"] == pytest.approx(884.19, rel=1e-4)
    assert wheel["principal_axes"] == [[1, 0, 0], [0, 1, 0], [0, 0, 1]]


def test_csv_has_a_line_for_each_link_and_the_total(
    capsys: pytest.CaptureFixture[str],
) -> None:
    rows = list(csv.DictReader(io.StringIO(run(capsys, GRIPPER, "--format", "csv"))))
    assert [row["link"] for row in rows] == ["palm", "left_finger", "right_finger", ""]
    assert sum(float(row["mass"]) for row in rows[:-1]) == pytest.approx(float(rows[-1]["mass"]))
    assert float(rows[0]["i3"]) == pytest.approx(float(rows[0]["shape_i3"]), rel=1e-4)


def test_markdown_is_a_table(capsys: pytest.CaptureFixture[str]) -> None:
    lines = run(capsys, GRIPPER, "--format", "markdown").splitlines()
    assert len(lines) == 6
    assert {line.count("|") for line in lines} == {6}


def test_a_pose(capsys: pytest.CaptureFixture[str]) -> None:
    words = (GRIPPER, "--format", "json", "--joint", "left_finger_joint=0.05")
    opened = json.loads(run(capsys, *words))["total"]["principal_moments"]
    closed = json.loads(run(capsys, *words[:3]))["total"]["principal_moments"]
    assert opened[2] > closed[2]


def test_a_robot_without_mass_is_reported_in_a_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    visual = '<visual><geometry><box size="1 1 1"/></geometry></visual>'
    text = f'<robot name="r"><link name="a">{visual}</link></robot>'
    (tmp_path / "r.urdf").write_text(text, encoding="utf-8")
    page = run(capsys, str(tmp_path / "r.urdf"))
    assert page == "no link has a mass; 'urdfkit inertia FILE --density KG/M^3' suggests values\n"


def test_unknown_values_fit_a_terminal(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    names = [f"a_frame_with_a_name_{number}" for number in range(8)]
    links = "".join(
        f'<link name="{name}"><inertial><mass value="1"/></inertial></link>' for name in names
    )
    (tmp_path / "frames.urdf").write_text(f'<robot name="r">{links}</robot>', encoding="utf-8")
    lines = run(capsys, str(tmp_path / "frames.urdf")).splitlines()
    notes = lines[-3:]
    assert notes[0].startswith(f"{names[0]}, {names[1]}")
    assert notes[-1].endswith(f"{names[-1]}: no shape")
    assert max(map(len, notes)) <= 80
    assert all(line == line.rstrip() for line in lines)


def test_long_names_are_above_their_numbers(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = Path(GRIPPER).read_text(encoding="utf-8").replace("left_finger", "left_finger" * 3)
    (tmp_path / "r.urdf").write_text(text, encoding="utf-8")
    lines = run(capsys, str(tmp_path / "r.urdf")).splitlines()
    assert max(map(len, lines)) <= 80
    at = lines.index("left_finger" * 3)
    assert lines[at + 1].split()[:2] == ["0.03", "5.4%"]


def test_a_total_without_a_centre_has_a_reason(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    text = link("a", inertial(2, (1, 1, 1))) + link("b", inertial(3, (1, 1, 1)))
    path = tmp_path / "r.urdf"
    path.write_text(whole_robot(text), encoding="utf-8")
    page = run(capsys, str(path))
    assert "\ntotal         5\n" in page
    assert "no joint connects the roots a, b" in " ".join(page.split())
    total = json.loads(run(capsys, str(path), "--format", "json"))["total"]
    assert total["mass"] == 5
    assert "center" not in total
    rows = list(csv.DictReader(io.StringIO(run(capsys, str(path), "--format", "csv"))))
    assert (rows[-1]["mass"], rows[-1]["cx"]) == ("5.0", "")
    assert "| **total** | **5** |" in run(capsys, str(path), "--format", "markdown")
