"""The outline of a file is the kinematic tree of what it makes."""

from pathlib import Path

from tests.conftest import MISSION
from tests.lsp.edited import XACRO, Edited
from tests.lsp.test_navigation import MACRO
from urdfkit.lsp.outline import MAX_DEPTH, OutlineEntry, outline


def shape(file: Edited) -> list[tuple[int, str, str, str]]:
    """Depth, kind, name and detail of all entries."""
    reported = []
    stack = [(0, entry) for entry in reversed(outline(file.robot, file.markup))]
    while stack:
        depth, entry = stack.pop()
        reported.append((depth, entry.kind, entry.name, entry.detail))
        stack += [(depth + 1, child) for child in reversed(entry.children)]
    return reported


def test_the_mission() -> None:
    reported = shape(Edited(MISSION, MISSION.read_text()))
    assert reported[:8] == [
        (0, "link", "dummy", ""),
        (1, "joint", "dummy_joint", "fixed"),
        (2, "link", "base_footprint", "0.0001 kg"),
        (3, "joint", "base_footprint_joint", "fixed"),
        (4, "link", "base_link", "8.2 kg"),
        (5, "joint", "base_to_wheel1", "continuous"),
        (6, "link", "wheel_1", "0.5 kg"),
        (5, "joint", "base_to_wheel2", "continuous"),
    ]
    kinds = [kind for _, kind, _, _ in reported]
    assert (kinds.count("link"), kinds.count("joint")) == (10, 9)
    assert (0, "macro", "default_inertial", "mass") in reported
    assert (0, "property", "length_wheel", "0.05") in reported


def test_what_a_macro_makes_is_at_its_call(tmp_path: Path) -> None:
    file = Edited(tmp_path / "r.xacro", MACRO)
    (base,) = [entry for entry in outline(file.robot, file.markup) if entry.name == "base"]
    assert [(joint.name, joint.span.line) for joint in base.children] == [
        ("left_hip", 12),
        ("right_hip", 13),
    ]
    assert [child.name for joint in base.children for child in joint.children] == [
        "left_leg",
        "right_leg",
    ]


def test_a_file_of_macros_has_its_own(tmp_path: Path) -> None:
    (tmp_path / "top.xacro").write_text(
        XACRO.format('<xacro:include filename="parts.xacro"/><xacro:leg p="a"/>')
    )
    parts = XACRO.format('<xacro:macro name="leg" params="p"><link name="${p}"/></xacro:macro>')
    (tmp_path / "parts.xacro").write_text(parts)
    file = Edited(tmp_path / "parts.xacro", parts)
    assert Path(file.robot.path).name == "top.xacro"
    assert shape(file) == [(0, "link", "a", ""), (0, "macro", "leg", "p")]


def test_a_broken_text_has_a_flat_one(tmp_path: Path) -> None:
    text = '<robot name="r"><link name="a"/><joint name="j"><parent link="a"/></joint><li'
    assert shape(Edited(tmp_path / "r.urdf", text)) == [(0, "link", "a", ""), (0, "joint", "j", "")]


def robot(*joints: tuple[str, str]) -> str:
    links = dict.fromkeys(name for joint in joints for name in joint)
    return (
        '<robot name="r">'
        + "".join(f'<link name="{name}"/>' for name in links)
        + "".join(
            f'<joint name="{a}-{b}" type="fixed"><parent link="{a}"/><child link="{b}"/></joint>'
            for a, b in joints
        )
        + "</robot>"
    )


def test_loops_and_two_parents_are_reported_once(tmp_path: Path) -> None:
    reported = shape(
        Edited(tmp_path / "r.urdf", robot(("a", "b"), ("b", "c"), ("c", "b"), ("x", "x")))
    )
    names = [name for _, _, name, _ in reported]
    assert sorted(names) == ["a", "a-b", "b", "b-c", "c", "c-b", "x", "x-x"]


def depth(entry: OutlineEntry) -> int:
    deepest, level = 0, [entry]
    while level:
        deepest += 1
        level = [child for one in level for child in one.children]
    return deepest


def test_a_chain_of_any_length_has_a_bounded_depth(tmp_path: Path) -> None:
    chain = [(f"l{i}", f"l{i + 1}") for i in range(1200)]
    file = Edited(tmp_path / "r.urdf", robot(*chain))
    entries = outline(file.robot, file.markup)
    assert max(map(depth, entries)) <= MAX_DEPTH + 2
    assert len(shape(file)) == 2401
