"""``urdfkit gazebo`` says first that libsdformat rejects a robot, and knows what SDF adds to it."""

import json
from pathlib import Path

import pytest

from tests.libsdformat import convert
from tests.massive import inertial, joint, link
from urdfkit.cli import main
from urdfkit.lint.rule_examples import whole_robot

BODY = inertial(1, (1, 1, 1))
PAIR = link("a", BODY) + link("b", BODY) + joint("a", "b", "revolute")
COLOUR = '<material name="m"><color rgba="1 1 1 1"/></material>'

REJECTED = {
    "no effort": (PAIR.replace('effort="1" ', ""), "JNT002"),
    "no such type of joint": (PAIR.replace('"revolute"', '"spherical"'), "JNT001"),
    "material twice": (COLOUR + COLOUR + PAIR, "NAM001"),
    "a bad number in a joint": (PAIR.replace('xyz="0 0 0"', 'xyz="0 0"'), "URD005"),
    "a link that is not there": (PAIR.replace('child link="b"', 'child link="c"'), "REF001"),
    "a plugin without a name": (PAIR + '<gazebo><plugin filename="a.so"/></gazebo>', "GAZ010"),
}
READ = {
    "a sound robot": PAIR,
    "two colours of visuals with one name": "".join(
        link(
            name,
            BODY,
            '<visual><geometry><box size="1 1 1"/></geometry><material name="m">'
            f'<color rgba="{red} 1 1 1"/></material></visual>',
        )
        for name, red in (("a", 0), ("b", 1))
    )
    + joint("a", "b", "revolute"),
    "a bad number in a link": PAIR
    + link("c", BODY, '<visual><geometry><box size="1 1"/></geometry></visual>')
    + joint("a", "c"),
    "a noise without a type where nothing reads it": PAIR
    + '<gazebo reference="a"><sensor name="s" type="imu"><imu><angular_velocity><noise>'
    "<stddev>0.01</stddev></noise></angular_velocity></imu></sensor></gazebo>",
}


def rejected(text: str, directory: Path, capsys: pytest.CaptureFixture[str]) -> list[str]:
    (directory / "r.urdf").write_text(whole_robot(text), encoding="utf-8")
    assert main(["gazebo", "--format", "json", str(directory / "r.urdf")]) == 0
    return [one["code"] for one in json.loads(capsys.readouterr().out)["rejected"]]


@pytest.mark.parametrize(("text", "code"), REJECTED.values(), ids=REJECTED)
def test_what_rejects_a_robot(
    text: str, code: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert code in rejected(text, tmp_path, capsys)
    assert main(["gazebo", str(tmp_path / "r.urdf")]) == 0
    assert capsys.readouterr().out.startswith("libsdformat rejects this robot:\n")


@pytest.mark.parametrize("text", READ.values(), ids=READ)
def test_what_does_not(text: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert rejected(text, tmp_path, capsys) == []


@pytest.mark.parametrize("text", [text for text, _ in REJECTED.values()], ids=REJECTED)
def test_libsdformat_rejects_them(text: str, sdformat: Path, tmp_path: Path) -> None:
    assert not convert(sdformat, tmp_path, whole_robot(text)).links


@pytest.mark.parametrize("text", READ.values(), ids=READ)
def test_libsdformat_reads_them(text: str, sdformat: Path, tmp_path: Path) -> None:
    assert convert(sdformat, tmp_path, whole_robot(text)).links


def test_links_and_joints_of_sdf_belong_to_the_result(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """As the grippers of the PR2."""
    finger = (
        '<gazebo><link name="finger"><inertial><mass>0.17</mass></inertial></link>'
        '<joint name="slide" type="prismatic"><parent>b</parent><child>finger</child></joint>'
        '</gazebo><gazebo reference="a"><link name="ignored"/></gazebo>'
    )
    (tmp_path / "r.urdf").write_text(whole_robot(PAIR + finger), encoding="utf-8")
    assert main(["gazebo", str(tmp_path / "r.urdf")]) == 0
    page = capsys.readouterr().out
    assert page.startswith("2 links become 3, ")
    assert "finger       0.17  added as SDF by <gazebo>\n" in page
    assert page.endswith("1 joint becomes 2; 1 is added as SDF by <gazebo>\n")
    assert main(["gazebo", "--format", "json", str(tmp_path / "r.urdf")]) == 0
    added = json.loads(capsys.readouterr().out)["added"]
    assert added == {"links": ["finger"], "joints": ["slide"]}
