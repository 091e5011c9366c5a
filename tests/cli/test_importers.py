"""``urdfkit importers``."""

import json
from pathlib import Path

import pytest

from tests.shipped import ARM
from urdfkit.cli import main

LOOP = (
    '<robot name="r"><link name="a"/><link name="b"/><link name="c"/>'
    '<joint name="i" type="fixed"><parent link="a"/><child link="c"/></joint>'
    '<joint name="j" type="fixed"><parent link="b"/><child link="c"/></joint></robot>'
)


def test_all_programs_in_one_table(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["importers", ARM]) == 0
    lines = capsys.readouterr().out.splitlines()
    rows = {line.split()[0]: line.split()[1:] for line in lines[3:12]}
    assert rows["mujoco"] == ["2", "2.2", "2", "A", "welded"]
    assert rows["pybullet"] == ["4", "6.2", "2", "A", "free"]
    assert lines[13] == "A: shoulder, elbow"
    assert lines[15:] == [
        "masses differ:",
        "  isaac-sim: 1 body has no mass: PhysX computes it from the collision shapes",
        "  mujoco, pinocchio: 3 kg of links welded to the world have no effect",
        "  pybullet: 1 link without <inertial> gets 1 kg by default",
    ]
    assert all(len(line) <= 80 for line in lines)


def test_masses_of_links_without_inertial_and_the_same_sum_in_another_order(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    masses = "".join(
        f'<link name="l{n}"><inertial><mass value="{mass}"/><inertia ixx="1" ixy="0" ixz="0" '
        f'iyy="1" iyz="0" izz="1"/></inertial></link><joint name="j{n}" type="fixed"><parent '
        f'link="b"/><child link="l{n}"/></joint>'
        for n, mass in enumerate((0.1, 0.2, 0.3, 51.53485))
    )
    shapes = '<collision><geometry><box size="1 1 1"/></geometry></collision>' * 2
    file = tmp_path / "a.urdf"
    file.write_text(f'<robot name="r"><link name="b">{shapes}</link>{masses}</robot>')
    assert main(["importers", str(file)]) == 0
    out = capsys.readouterr().out
    rows = {line.split()[0]: line.split()[2] for line in out.splitlines()[3:12]}
    assert rows["drake"] == rows["genesis"] == rows["yourdfpy"]
    assert "  newton: 1 link without <inertial> gets 2000 kg from collision shapes\n" in out


def test_a_robot_that_is_no_tree_is_told_above_the_table(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "a.urdf"
    file.write_text(LOOP)
    assert main(["importers", str(file)]) == 0
    assert capsys.readouterr().out.startswith("programs may reject this robot:")


def test_one_program(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["importers", ARM, "--for", "mujoco"]) == 0
    out = capsys.readouterr().out
    assert "4 links become 2 bodies, 2.2 kg" in out
    assert "    13  link 'base' is merged into world; its 3 kg have no effect" in out
    assert "    1    1  elbow" in out


def test_json_has_locations(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["importers", ARM, "--for", "pybullet,isaac", "--format", "json"]) == 0
    first, second = json.loads(capsys.readouterr().out)["importers"]
    assert (first["name"], second["name"]) == ("pybullet", "isaac")
    assert first["errors"] == []
    change, tensors = first["changes"]
    assert "tensors are not read: 3 in all" in tensors["text"]
    assert (change["line"], "1 kg by default" in change["text"]) == (11, True)
    assert [(joint["name"], joint["q"], joint["v"]) for joint in first["joints"]] == [
        ("shoulder", 7, 6),
        ("elbow", 8, 7),
    ]


def test_maps(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["importers", ARM, "--map", "isaac-sim:mujoco"]) == 0
    names: dict[str, object] = {}
    exec(capsys.readouterr().out, names)
    assert names["isaac_sim_to_mujoco"] == [0, 1]
    assert main(["importers", ARM, "--map", "isaac:mujoco", "--format", "csv"]) == 0
    assert capsys.readouterr().out == "joint,mujoco,isaac\nshoulder,0,0\nelbow,1,1\n"
    assert main(["importers", ARM, "--map", "isaac:mujoco", "--format", "json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert (found["joints"], found["indices"]) == (["shoulder", "elbow"], [0, 1])


def test_gazebo_is_the_gazebo_command(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["gazebo", ARM]) == 0
    expected = capsys.readouterr().out
    assert main(["importers", ARM, "--for", "gazebo"]) == 0
    assert capsys.readouterr().out == expected


def test_errors_come_first(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    robot = tmp_path / "robot.urdf"
    robot.write_text(LOOP)
    for name in ("mujoco", "newton"):
        assert main(["importers", str(robot), "--for", name]) == 0
        out = capsys.readouterr().out
        assert "may reject this robot" in out.splitlines()[0]
        assert "TRE004" in out
        assert "Without these errors:" in out


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--for", "mujoko"], "unknown importer 'mujoko'; did you mean 'mujoco'?"),
        (["--map", "mujoco"], "expected FROM:TO, such as isaac:mujoco"),
        (["--map", "isaac:mujoko"], "did you mean 'mujoco'?"),
        (["--map", "gazebo:mujoco"], "gazebo has no joint order"),
        (["--map", "isaac:mujoco", "--for", "drake"], "cannot be combined"),
        (["--for", "gazebo,mujoco"], "--for gazebo allows no other"),
        (["--format", "csv"], "--format csv needs --for or --map"),
    ],
)
def test_usage_errors(words: list[str], message: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["importers", ARM, *words]) == 2
    assert message in capsys.readouterr().err
