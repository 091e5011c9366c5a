"""The render command: an image in a file, and what cannot be drawn by name."""

import subprocess
import sys
from functools import partial
from pathlib import Path

import pytest

pytest.importorskip("PIL")
pytest.importorskip("numpy")

import numpy as np
from PIL import Image

from tests.conftest import ROOT
from tests.shipped import ARM, MISSION
from urdfkit import render
from urdfkit.cli import main
from urdfkit.core.installation import install_command

SMALL = ["--size", "160x90", "--quality", "draft"]


def test_an_image_is_written_and_a_missing_mesh_is_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "robot.png"
    assert main(["render", MISSION, "-o", str(path), *SMALL]) == 0
    captured = capsys.readouterr()
    assert captured.out == f"wrote {path}\n"
    assert captured.err.startswith("note: drawn as a striped box: the visual mesh of 'laser_frame'")
    with Image.open(path) as image:
        assert image.size == (160, 90)
        r, g, b = np.moveaxis(np.asarray(image.convert("RGB")), -1, 0)
    assert ((r > 140) & (g > 60) & (b < 60)).sum() > 10  # its orange


def test_the_reason_of_a_broken_mesh_names_its_file_once(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "broken.stl").write_bytes(b"solid x")
    robot = tmp_path / "robot.urdf"
    visual = '<visual><geometry><mesh filename="broken.stl"/></geometry></visual>'
    robot.write_text(f'<robot name="r"><link name="a">{visual}</link></robot>')
    assert main(["render", str(robot), "-o", str(tmp_path / "robot.png"), *SMALL]) == 0
    (note,) = capsys.readouterr().err.splitlines()
    assert "broken.stl (broken.stl " in note
    assert str(tmp_path) not in note


def test_many_missing_meshes_are_counted(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    lost = '<visual><geometry><mesh filename="lost.stl"/></geometry></visual>'
    robot = tmp_path / "robot.urdf"
    robot.write_text(f'<robot name="r"><link name="a">{lost * 12}</link></robot>')
    assert main(["render", str(robot), "-o", str(tmp_path / "robot.png"), *SMALL]) == 0
    notes = capsys.readouterr().err.splitlines()
    assert len(notes) == 6
    assert notes[-1] == "note: drawn as striped boxes: 7 more meshes"


@pytest.mark.parametrize("suffix", ["png", "webp", "jpg"])
def test_the_same_robot_gives_the_same_bytes(suffix: str, tmp_path: Path) -> None:
    paths = [tmp_path / f"{name}.{suffix}" for name in "ab"]
    for path in paths:
        assert main(["render", ARM, "-o", str(path), *SMALL]) == 0
    assert paths[0].read_bytes() == paths[1].read_bytes()


def test_a_transparent_background_keeps_the_shadow(tmp_path: Path) -> None:
    path = tmp_path / "robot.png"
    assert main(["render", ARM, "-o", str(path), *SMALL, "--background", "transparent"]) == 0
    with Image.open(path) as image:
        alphas = np.unique(np.asarray(image)[..., 3])
    assert {0, 255} < set(alphas.tolist())


FEW = ["--size", "48x32", "--quality", "draft", "--background", "transparent"]


def test_formats_without_transparency_have_a_white_background(tmp_path: Path) -> None:
    """A GIF, too: test_a_turntable_and_a_sweep."""
    path = tmp_path / "robot.jpg"
    assert main(["render", ARM, "-o", str(path), *FEW]) == 0
    with Image.open(path) as image:
        assert min(np.asarray(image.convert("RGB"))[0, 0]) > 245


def test_a_joint_moves_the_robot(tmp_path: Path) -> None:
    paths = [tmp_path / "zero.png", tmp_path / "bent.png"]
    assert main(["render", ARM, "-o", str(paths[0]), *SMALL]) == 0
    assert main(["render", ARM, "-o", str(paths[1]), *SMALL, "--joint", "elbow=90deg"]) == 0
    assert paths[0].read_bytes() != paths[1].read_bytes()


@pytest.mark.parametrize(
    ("words", "reason"),
    [
        (["no.urdf"], "no.urdf"),
        ([ARM, ARM], "one file"),
        (
            [ARM, "--view", "above"],
            "unknown view; expected iso, front, back, left, right, top, bottom or all",
        ),
        ([ARM, "--size", "big"], "--size big"),
        ([ARM, "--size", "100000x100000"], "million pixels"),
        ([ARM, "--size", "1x1"], "16x16"),
        ([ARM, "--background", "mud"], "is not a colour"),
        ([ARM, "--joint", "elbow"], "--joint elbow"),
        ([ARM, "--joint", "knee=1"], "knee"),
        ([ARM, "--distance", "0"], "distance"),
        ([ARM, "--azimuth", "nan"], "angle"),
        ([ARM, "--elevation", "inf"], "angle"),
        ([ARM, "--turntable", "-o", "a.gif", "--size", "0x0"], "16x16"),
        ([ARM, "--turntable", "-o", "a.gif", "--size", "100000x100000"], "million pixels"),
        ([ARM, "--diff", ARM, "--size", "100000x100000"], "million pixels"),
        ([ARM, "--layers", "frame"], "did you mean"),
        ([ARM, "--diff"], "two files"),
        ([ARM, "--diff", "--thumbnail", ARM], "cannot be combined"),
        ([ARM, "--sweep", "knee"], "no joint 'knee'"),
        ([ARM, "--diff", ARM, "--view", "all"], "only one"),
    ],
)
def test_usage_errors(
    words: list[str], reason: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "robot.png"
    assert main(["render", *words, "-o", str(path)]) == 2
    captured = capsys.readouterr()
    assert captured.err.startswith("error: ")
    assert reason in captured.err
    assert not path.exists()


def test_a_file_name_without_image_suffix_is_rejected(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["render", ARM, "-o", str(tmp_path / "robot.txt"), *SMALL]) == 2
    assert "write .png" in capsys.readouterr().err


def test_missing_numpy_is_reported_with_the_install_command(tmp_path: Path) -> None:
    program = (
        "import sys; sys.modules['numpy'] = None\n"
        "from urdfkit.cli import main\n"
        "sys.exit(main(sys.argv[1:]))"
    )
    done = subprocess.run(
        [sys.executable, "-c", program, "render", ARM, "-o", str(tmp_path / "robot.png")],
        check=False,
        capture_output=True,
        text=True,
        cwd=ROOT,
    )
    assert done.returncode == 2
    assert install_command("render") in done.stderr


def test_no_graphics_library_is_loaded(tmp_path: Path) -> None:
    """Neither a GPU's nor a display's; and no mesh library that takes a second to import."""
    program = (
        "import sys\n"
        "from urdfkit.cli import main\n"
        "code = main(sys.argv[1:])\n"
        "maps = open('/proc/self/maps').read() if sys.platform == 'linux' else ''\n"
        "print(*sys.modules, *{line.split('/')[-1] for line in maps.splitlines() if '/' in line})\n"
        "sys.exit(code)"
    )
    done = subprocess.run(
        [sys.executable, "-c", program, "render", ARM, "-o", str(tmp_path / "robot.png"), *SMALL],
        check=True,
        capture_output=True,
        text=True,
        cwd=ROOT,
    )
    loaded = done.stdout.split()
    assert "numpy" in loaded
    assert {"trimesh", "scipy", "pinocchio", "coal"}.isdisjoint(loaded)
    graphics = ("libGL", "libEGL", "libOSMesa", "libX11", "libxcb.so", "libvulkan", "libgbm")
    assert [name for name in loaded if name.startswith(graphics)] == []


def test_a_missing_file_name_is_rejected(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["render", ARM]) == 2
    assert "-o" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ('<robot name="r"/>', "it has no link"),
        ('<robot name="r"><link name="a"/></robot>', "--layers frames,names"),
    ],
)
def test_an_empty_image_is_rejected(
    content: str, said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "r.urdf"
    path.write_text(content)
    assert main(["render", str(path), "-o", str(tmp_path / "r.png")]) == 2
    assert said in capsys.readouterr().err
    assert not (tmp_path / "r.png").exists()


BODY = "<{0}><geometry><sphere radius='{1}'/></geometry></{0}>"
TOP = """<link name="top">{}</link><joint name="j" type="fixed"><parent link="base"/>
<child link="top"/></joint><link name="end">{}</link><joint name="k" type="fixed">
<parent link="top"/><child link="end"/></joint>"""


@pytest.mark.parametrize(
    ("base", "links", "said"),
    [
        ("collision", "", "note: no link has a <visual>: collision shapes are drawn\n"),
        ("visual", "collision", "note: not drawn: 2 links with <collision> only; try --layers "),
        ("visual", "visual", ""),
    ],
)
def test_collisions_of_a_robot_with_few_visuals(
    base: str, links: str, said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "r.urdf"
    others = TOP.format(*[BODY.format(links, 0.1)] * 2) if links else ""
    path.write_text(
        f'<robot name="r"><link name="base">{BODY.format(base, 1)}</link>{others}</robot>'
    )
    assert main(["render", str(path), "-o", str(tmp_path / "r.png"), *SMALL]) == 0
    assert capsys.readouterr().err.startswith(said)
    assert (tmp_path / "r.png").exists()


def test_letters_without_a_font_are_reported(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "r.urdf"
    shape = '<visual><geometry><box size="1 1 1"/></geometry></visual>'
    path.write_text(f'<robot name="r"><link name="robot_🤖">{shape}</link></robot>')
    target = ["-o", str(tmp_path / "r.png"), "--layers", "visual,names", *SMALL]
    assert main(["render", str(path), *target]) == 0
    assert "note: no font here has" in capsys.readouterr().err


def test_layers_findings_and_several_views_can_be_combined(tmp_path: Path) -> None:
    path = tmp_path / "robot.png"
    words = ["--view", "iso,top", "--layers", "visual,collision,frames,names", "--findings"]
    assert main(["render", MISSION, "-o", str(path), *SMALL, *words]) == 0
    with Image.open(path) as image:
        assert image.size == (160, 90)


def test_a_turntable_and_a_sweep(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("orbit", "sweep"):
        monkeypatch.setattr(render, name, partial(getattr(render, name), frames=6))
    assert main(["render", ARM, "--turntable", "-o", str(tmp_path / "t.webp"), *FEW]) == 0
    assert main(["render", ARM, "--sweep", "elbow", "-o", str(tmp_path / "s.gif"), *FEW]) == 0
    for name in ("t.webp", "s.gif"):
        with Image.open(tmp_path / name) as image:
            assert (getattr(image, "n_frames", 1), image.size) == (6, (48, 32))
    with Image.open(tmp_path / "s.gif") as image:
        assert min(np.asarray(image.convert("RGB"))[0, 0]) > 245, "it knows no transparency"


def test_a_thumbnail_is_small_and_transparent(tmp_path: Path) -> None:
    path = tmp_path / "icon.png"
    assert main(["render", ARM, "-o", str(path), "--thumbnail"]) == 0
    with Image.open(path) as image:
        assert (image.size, image.mode) == ((256, 256), "RGBA")


def test_two_states_side_by_side(tmp_path: Path) -> None:
    path = tmp_path / "difference.png"
    assert main(["render", "--diff", ARM, ARM, "-o", str(path), "--size", "300x100"]) == 0
    with Image.open(path) as image:
        assert image.size == (300, 100)


def test_a_mesh_of_one_point_has_a_ground(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "point.obj").write_text("v 0 0 0\nf 1 1 1\n")
    robot = tmp_path / "r.urdf"
    robot.write_text(
        '<robot name="r"><link name="a"><visual><geometry><mesh filename="point.obj"/></geometry>'
        "</visual></link></robot>"
    )
    assert main(["render", str(robot), "-o", str(tmp_path / "r.png"), "--size", "64x64"]) == 0
    assert capsys.readouterr().err == ""
