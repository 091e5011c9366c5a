from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")
pytest.importorskip("manifold3d")

from tests.meshed import SOUND, link, mesh, messages, reported
from tests.naming import naming
from urdfkit.mesh.samples import box, collada, stl
from urdfkit.text.editing.apply import apply_edits

HUGE = stl(box((0, 0, 0), (80, 60, 300)))
JOINT = (
    '<joint name="j" type="fixed"><parent link="base"/><child link="arm"/>'
    '<origin xyz="0 0 {}"/></joint>'
)


def robot(part: str, reach: float = 0.2) -> str:
    return link(name="base") + link(part) + JOINT.format(reach)


def test_a_part_of_300_m(tmp_path: Path) -> None:
    assert messages(tmp_path, "MSH012", robot(mesh("a.stl")), {"a.stl": HUGE}) == [
        naming("arm", "collision", "a.stl", "300 m", "0.2 m", "0.3 m")
    ]


@pytest.mark.parametrize("scale", ["", ' scale="1 1 1"', ' scale="0.5 0.5 -0.5"'])
def test_the_fix_is_a_thousandth_of_the_scale(tmp_path: Path, scale: str) -> None:
    text = robot(mesh("a.stl", more=scale))
    (found,) = reported(tmp_path, "MSH012", text, {"a.stl": HUGE})
    assert found.fix is not None
    assert not found.fix.safe
    expected = {"": "0.001 0.001 0.001", ' scale="1 1 1"': "0.001 0.001 0.001"}
    wanted = expected.get(scale, "0.0005 0.0005 -0.0005")
    after = apply_edits((tmp_path / "robot.urdf").read_bytes(), found.fix.edits).decode()
    assert f'<mesh filename="a.stl" scale="{wanted}"/>' in after


def test_the_rest_of_the_robot_decides(tmp_path: Path) -> None:
    files = {"a.stl": HUGE, "b.stl": SOUND}
    assert len(messages(tmp_path, "MSH012", robot(mesh("a.stl"), 14), files)) == 1
    assert messages(tmp_path, "MSH012", robot(mesh("a.stl"), 16), files) == []
    assert messages(tmp_path, "MSH012", robot(mesh("b.stl"), 0.001), files) == []
    assert messages(tmp_path, "MSH012", link(mesh("a.stl")), files) == []  # a landscape


def test_the_unit_of_the_file_and_the_scale_count(tmp_path: Path) -> None:
    small = mesh("a.stl", more=' scale="0.001 0.001 0.001"')
    assert messages(tmp_path, "MSH012", robot(small), {"a.stl": HUGE}) == []
    inches = collada('<unit meter="25.4"/>')
    found = messages(tmp_path, "MSH012", robot(mesh("a.dae")), {"a.dae": inches})
    assert ["25.4 m long" in message for message in found] == [True]


def test_scenery_has_no_measure(tmp_path: Path) -> None:
    """One link with a field of 300 m and a tree in it, as Clearpath's worlds are."""
    both = mesh("a.stl") + mesh("tree.stl")
    files = {"a.stl": HUGE, "tree.stl": stl(box((0, 0, 0), (0.5, 0.5, 2)))}
    assert messages(tmp_path, "MSH012", link(both), files) == []
    assert len(messages(tmp_path, "MSH012", robot(both), files)) == 1


FILES = {"a.stl": SOUND, "mm.stl": stl(box((0, 0, 0), (1.5, 2, 3)))}


def test_a_part_of_30_cm(tmp_path: Path) -> None:
    scaled = mesh("a.stl", more=' scale="0.001 0.001 0.001"')
    assert messages(tmp_path, "MSH012", link(scaled), FILES) == [
        naming("arm", "collision", "a.stl", "0.3 mm", "0.3 m", "without")
    ]


@pytest.mark.parametrize(
    "sound",
    [
        mesh("a.stl"),
        mesh("a.stl", more=' scale="0.01 0.01 0.01"'),  # 3 mm
        mesh("mm.stl", more=' scale="0.001 0.001 0.001"'),  # a pin
        mesh("a.stl", more=' scale="0 0 0"'),  # GEO001
    ],
)
def test_small_parts_and_other_scales(sound: str, tmp_path: Path) -> None:
    assert messages(tmp_path, "MSH012", link(sound), FILES) == []


@pytest.mark.parametrize(
    ("scale", "length", "found"),
    [
        ("0.01", 300, "3 m"),
        ("0.01", 30, ""),  # of about the size of the others
        ("0.0001", 300, "0.03 m"),
        ("0.02", 300, ""),  # no wrong decimal point
        ("0.001", 2000, ""),
    ],
)
def test_one_scale_with_a_wrong_decimal_point(
    tmp_path: Path, scale: str, length: float, found: str
) -> None:
    """Bodies in centimetres and small parts in millimetres are of similar size."""
    files = {f"{name}.stl": stl(box((0, 0, 0), (80, 60, 300))) for name in "abcd"}
    files["e.stl"] = stl(box((0, 0, 0), (8, 6, length)))
    shapes = [mesh(f"{name}.stl", more=' scale="0.001 0.001 0.001"') for name in "abcd"]
    shapes.append(mesh("e.stl", more=f' scale="{scale} {scale} {scale}"'))
    texts = messages(tmp_path, "MSH012", robot("".join(shapes), 14), files)
    assert texts == [naming("arm", "collision", "e.stl", found, scale, "0.001")] * bool(found)


@pytest.mark.parametrize(
    ("scale", "fingers", "is_found"), [("0.1", 4, True), ("0.3", 4, False), ("0.1", 3, False)]
)
def test_the_scale_of_one_finger(tmp_path: Path, scale: str, fingers: int, is_found: bool) -> None:
    """Next to a palm that is as long as the finger is with the wrong scale."""
    text = link(mesh("palm.stl", "visual", more=' scale="0.01 0.01 0.01"'), name="palm")
    for name in ("index", "middle", "ring", "pinky")[:fingers]:
        size = scale if name == "ring" else "0.01"
        shown = mesh("tip.stl", "visual", more=f' scale="{size} {size} {size}"')
        text += link(shown, name=f"{name}_tip")
        text += f'<joint name="{name}" type="fixed"><parent link="palm"/>'
        text += f'<child link="{name}_tip"/></joint>'
    meshes = {
        "palm.stl": stl(box((0, 0, 0), (10, 8, 30))),
        "tip.stl": stl(box((0, 0, 0), (1, 1, 3))),
    }
    found = messages(tmp_path, "MSH012", text, meshes)
    expected = naming("ring_tip", "visual", "tip.stl", "0.3 m", "0.1", "0.01")
    assert found == ([expected] if is_found else [])
