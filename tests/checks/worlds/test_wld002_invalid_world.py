"""WLD002: see the rule."""

from pathlib import Path

import pytest

from tests.checks.worlds.started import (
    CLASSIC,
    WORLD,
    findings,
    messages,
    only_finding,
)
from tests.naming import naming
from urdfkit import Severity

CODE = "WLD002"


@pytest.mark.parametrize(
    ("model", "words"),
    [
        ("<link name='l'><static>true</static></link>", ["<static>", "<link>", "<model>"]),
        ("<static>1</static><link name='l'><mass>2</mass></link>", ["<mass>", "<link>"]),
        ("<static>1</static><link name='l'><own>2</own></link>", []),
        ("<static>1</static><link name='l'/>", []),
        ("<static>1</static><plugin name='p' filename='p'><mass>2</mass></plugin>", []),
    ],
)
def test_elements_of_another_level(tmp_path: Path, model: str, words: list[str]) -> None:
    world = f'<model name="m">{model}</model>'
    found = [one for one in messages(tmp_path, CODE, world=world) if "is not read" in one]
    assert len(found) == bool(words)
    assert all(word in one for one in found for word in words)


PLANE = (
    '<model name="floor">{}<link name="link"><{shape} name="s">'
    "<geometry><plane><normal>0 0 1</normal></plane></geometry></{shape}></link></model>"
)


@pytest.mark.parametrize(
    ("state", "shape", "count"),
    [
        ("<static>true</static>", "collision", 0),
        ("<static>1</static>", "collision", 0),
        ("", "collision", 1),
        ("<static>false</static>", "collision", 1),
        ("", "visual", 0),
        ('<joint name="j" type="fixed"/>', "collision", 0),  # to the world
        ('<link name="l"><gravity>false</gravity></link>', "collision", 0),
    ],
)
def test_a_ground_that_falls(tmp_path: Path, state: str, shape: str, count: int) -> None:
    world = PLANE.format(state, shape=shape)
    found = findings(tmp_path, CODE, world=world)
    words = naming("floor", "not static")
    assert [(one.span.line, one.message) for one in found] == [(3, words)] * count
    assert findings(tmp_path, CODE, world=f"<gravity>0 0 0</gravity>{world}") == []


@pytest.mark.parametrize(
    ("tag", "count"),
    [("gz_frame_id", 0), ("ignition_frame_id", 0), ("frame_id", 0), ("fram_id", 1)],
)
def test_the_frame_of_a_sensor(tmp_path: Path, tag: str, count: int) -> None:
    """gz-sensors reads elements that SDF does not have."""
    sensor = f'<sensor name="s" type="camera"><{tag}>camera</{tag}></sensor>'
    world = f'<model name="m"><static>true</static><link name="l">{sensor}</link></model>'
    assert len(findings(tmp_path, CODE, world=world)) == count


def test_files_that_are_not_worlds(tmp_path: Path) -> None:
    path = tmp_path / "worlds/hall.sdf"
    reported = only_finding(tmp_path, CODE, world="<model>")
    assert reported.message == naming("hall.sdf", "<model>", "before", "</world>")
    assert reported.span.source.path == str(path)
    path.write_text("<sdf><light name='l'/></sdf>")
    (none,) = messages(tmp_path, CODE)
    assert none == naming("hall.sdf", "<world>", "<sdf>")
    path.write_text(f"<% n = 3 %>{WORLD.format('')}")
    assert messages(tmp_path, CODE) == []


@pytest.mark.parametrize(
    ("text", "severity", "words"),
    [
        ("<pose>0 0 0.5 0 0 0</pose>", None, ""),
        ("<pose>0 0 0.5</pose>", Severity.ERROR, "<pose> is '0 0 0.5', must be 6 numbers"),
        ('<pose degrees="true">0 0 0 0 0 90</pose>', None, ""),
        ("<pose/>", None, ""),
        ("<pose>0 0 0.5 0.0, 0.0, 0.0</pose>", None, ""),
        ("<pose>0 0 0,5 0 0 0</pose>", Severity.WARNING, "only numbers"),
        ("<pose>0 0 a 0 0 0</pose>", Severity.ERROR, "must be 6 numbers"),
        ("<static>yes</static>", Severity.ERROR, "true or false"),
        ("<link name='l'><inertial><mass>2,5</mass></inertial></link>", Severity.WARNING, "as 2"),
        ("<link name='l'><inertial><mass>two</mass></inertial></link>", Severity.ERROR, "a number"),
        ("<link/>", Severity.ERROR, "<link> has no name"),
        ("<joint name='j' type='hinge'/>", Severity.ERROR, "'hinge' of <joint>"),
    ],
)
def test_values(tmp_path: Path, text: str, severity: Severity | None, words: str) -> None:
    found = findings(tmp_path, CODE, world=f'<model name="m">{text}</model>')
    assert [one.severity for one in found] == ([severity] if severity else [])
    assert all(words in one.message for one in found)


@pytest.mark.parametrize(
    ("text", "severity"),
    [
        ("<pose>0 0 0.5 0.0, 0.0, 0.0</pose>", Severity.WARNING),
        ("<pose>0 0 0.5</pose>", Severity.WARNING),
        ("<static>yes</static>", Severity.ERROR),
    ],
)
def test_gazebo_classic_reads_as_far_as_it_can(
    tmp_path: Path, text: str, severity: Severity
) -> None:
    found = findings(tmp_path, CODE, world=f'<model name="m">{text}</model>', launch=CLASSIC)
    assert [one.severity for one in found] == [severity]
    assert ("Gazebo Classic" in found[0].message) is (severity is Severity.WARNING)


BOX = """<model name="m">{}<link name="l"><inertial><mass>1</mass><inertia><ixx>0.02</ixx>
<iyy>0.02</iyy><izz>{}</izz>{}</inertia></inertial></link></model>"""


@pytest.mark.parametrize(
    ("state", "izz", "more", "count"),
    [
        ("", "0.03", "", 0),
        ("", "0.04", "", 0),  # a plate
        ("", "0.2", "", 1),
        ("", "0.2", "<ixy>0</ixy>", 1),
        ("", "0.2", "<ixy>0.01</ixy>", 0),  # the principal moments are others
        ("<static>true</static>", "0.2", "", 0),
    ],
)
def test_inertia_of_a_model(tmp_path: Path, state: str, izz: str, more: str, count: int) -> None:
    found = findings(tmp_path, CODE, world=BOX.format(state, izz, more))
    assert [one.span.text for one in found] == ["<izz>"] * count
    assert all(one.severity is Severity.WARNING for one in found)
