"""The simulate command: what it prints, and its exit codes."""

import json
from pathlib import Path
from xml.etree import ElementTree

import pytest

from tests.conftest import ARM
from urdfkit.cli import main
from urdfkit.cli.simulate import _page
from urdfkit.physics.verdicts import Simulation, Verdict

for library in ("mujoco", "trimesh"):
    pytest.importorskip(library)


SRDF = '<robot name="r"><disable_collisions link1="a" link2="b" reason="Never"/></robot>'
INERTIA = '<inertia ixx="0.002" ixy="0" ixz="0" iyy="0.002" iyz="0" izz="0.002"/>'
BODY = (
    f'<inertial><mass value="1"/>{INERTIA}</inertial>'
    '<collision><geometry><box size="0.1 0.1 0.1"/></geometry></collision>'
)
#: Two boxes that overlap by 50 mm.
BOXES = (
    '<robot name="r"><link name="world"/>\n'
    + "".join(
        f'<link name="{name}">{BODY}</link><joint name="{name}" type="continuous">'
        f'<parent link="world"/><child link="{name}"/><origin xyz="{x} 0 0"/><axis xyz="0 1 0"/>'
        "</joint>"
        for name, x in (("a", "0"), ("b", "0.05"))
    )
    + "</robot>"
)


def test_a_robot_without_faults(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["simulate", str(ARM)]) == 0
    assert capsys.readouterr().out.splitlines()[:2] == [
        "its root is welded to the world",
        "  passes size: the robot weighs 5.2 kg and measures 0.774 m",
    ]


def test_a_robot_with_faults(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "boxes.urdf"
    file.write_text(BOXES)
    assert main(["simulate", str(file)]) == 1
    text = capsys.readouterr().out
    assert "warns overlap: links 'a' and 'b' overlap" in text
    assert "FAILS energy: released" in text
    assert main(["simulate", str(file), "--format", "json"]) == 1
    found = json.loads(capsys.readouterr().out)
    assert (found["base"], found["passes"]) == ("fixed", False)
    keys = ("test", "passes", "warns", "line")
    assert [[one[key] for key in keys] for one in found["verdicts"][1:3]] == [
        ["overlap", True, True, 2],
        ["energy", False, False, 2],
    ]
    assert main(["simulate", str(file), "--format", "junit"]) == 1
    (suite,) = ElementTree.fromstring(capsys.readouterr().out)
    assert suite.get("tests") == str(len(found["verdicts"]))
    assert suite.get("failures") == str(sum(not one["passes"] for one in found["verdicts"]))
    warning, failure = suite[1], suite[2]
    assert (warning.get("name"), warning.get("line")) == ("overlap a b", "2")
    assert (warning[0].tag, failure[0].tag) == ("system-out", "failure")
    assert "overlap by" in (warning[0].text or "")
    assert "push each other away" in failure[0].attrib["message"]


def test_pairs_that_an_srdf_disables(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    robot, srdf = tmp_path / "robot" / "urdf" / "r.urdf", tmp_path / "other" / "r.srdf"
    for file, text in ((robot, BOXES), (srdf, SRDF)):
        file.parent.mkdir(parents=True)
        file.write_text(text)
    assert main(["simulate", str(robot)]) == 1
    capsys.readouterr()
    assert main(["simulate", str(robot), "--srdf", str(srdf)]) == 0
    disabled, _, overlap = capsys.readouterr().out.splitlines()[1:4]
    assert disabled.endswith("r.srdf disables do not collide")
    assert overlap == "  passes overlap: no links overlap at the start"
    assert main(["simulate", str(robot), "--srdf", str(robot)]) == 2
    assert capsys.readouterr().err.endswith("r.urdf: not an SRDF file\n")
    assert main(["simulate", str(robot), "--srdf", str(tmp_path / "none.srdf")]) == 2


def test_the_srdf_of_a_sibling_directory(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A repository of robots, each with directories urdf and srdf, is a single package."""
    (tmp_path / "package.xml").write_text("<package><name>robots</name></package>")
    robot, srdf = tmp_path / "r" / "urdf" / "r.urdf", tmp_path / "r" / "srdf" / "r.srdf"
    for file, text in ((robot, BOXES), (srdf, SRDF)):
        file.parent.mkdir(parents=True)
        file.write_text(text)
    assert main(["simulate", str(robot), "--format", "json"]) == 0
    assert json.loads(capsys.readouterr().out)["srdf"].endswith("r.srdf")


def test_collision_shapes_are_drawn_if_there_are_no_visuals(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    image = pytest.importorskip("PIL.Image")
    file, png = tmp_path / "r.urdf", tmp_path / "r.png"
    file.write_text(BOXES)
    main(["simulate", str(file), "-o", str(png)])
    assert "no link has a <visual>: collision shapes are drawn" in capsys.readouterr().err
    with image.open(png) as picture:
        assert len(picture.convert("L").getcolors(256)) > 50
    file.write_text(BOXES.replace("collision>", "other>"))
    assert main(["simulate", str(file), "-o", str(png)]) == 2
    assert "nothing to draw" in capsys.readouterr().err


def test_robots_that_cannot_be_simulated(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "two.urdf").write_text('<robot name="r"><link name="a"/><link name="b"/></robot>')
    assert main(["simulate", str(tmp_path / "two.urdf")]) == 2
    assert "do not form one tree" in capsys.readouterr().err


def test_image_and_animation_of_the_release(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    image = pytest.importorskip("PIL.Image")
    from urdfkit.cli import simulate
    from urdfkit.render import animation

    monkeypatch.setattr(simulate, "SIZE", (64, 40))
    monkeypatch.setattr(simulate, "MOVING", (64, 40))
    monkeypatch.setattr(animation, "FRAMES", 4)
    gif, png = tmp_path / "a.gif", tmp_path / "a.png"
    assert main(["simulate", str(ARM), "-o", str(gif), "-o", str(png)]) == 0
    assert capsys.readouterr().out.splitlines()[-2:] == [f"wrote {gif}", f"wrote {png}"]
    with image.open(gif) as moving, image.open(png) as still:
        assert (moving.format, moving.size) == ("GIF", (64, 40))
        assert (still.format, still.size) == ("PNG", (64, 40))
    assert main(["simulate", str(ARM), "-o", str(tmp_path / "a.xyz")]) == 2


def test_many_alike_results_are_counted() -> None:
    """The links of a hand whose meshes are in millimetres overlapped in 300 pairs, on 600 lines."""
    alike = [Verdict("overlap", True, f"pair {n}", 1.0, 0.0, warns=True) for n in range(12)]
    others = [Verdict("drop", True, "it lies", 1.0, 0.0)]
    lines = [*_page(Simulation(is_free=True, verdicts=(*alike, *others)))]
    assert lines[1:11] == [f"  warns overlap: pair {n}" for n in range(10)]
    assert lines[11:] == [
        "  and 2 more like these; --format json has all",
        "  passes drop: it lies",
    ]
