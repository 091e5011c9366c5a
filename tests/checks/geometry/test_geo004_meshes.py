"""GEO004 with a mesh: a sign of an origin, the mesh of another link, a diameter."""

import re
from itertools import pairwise
from pathlib import Path

import pytest

from tests import meshed
from tests.massive import joint, shape
from tests.naming import naming
from tests.xacros import xacro
from urdfkit import check
from urdfkit.mesh import samples


@pytest.fixture(autouse=True)
def _measured() -> None:
    for library in ("numpy", "lxml", "manifold3d"):
        pytest.importorskip(library)


SHANK = samples.stl(samples.box((-0.05, -0.04, -0.3), (0.05, 0.04, 0.02)))
BLOCK = '<box size="0.08 0.06 0.1"/>'


@pytest.mark.parametrize(
    ("xyz", "is_found"),
    [
        ("0 0 0.15", True),
        ("0 0 0.055", True),  # also in the part around the joint, as the calf of a Go1
        ("0 0 -0.15", False),
        ("0 0 0.02", False),  # partly inside
        ("0 0 0.35", False),  # not inside with the other sign either
        ("0.1 0 0.15", False),  # a motor next to it
    ],
)
def test_the_other_sign(tmp_path: Path, xyz: str, is_found: bool) -> None:
    robot = meshed.link(meshed.mesh("shank.stl", "visual"), shape("collision", BLOCK, xyz))
    found = meshed.reported(tmp_path, "GEO004", robot, {"shank.stl": SHANK})
    assert [one.help for one in found] == ([naming("for z", "<origin>")] if is_found else [])


FILES = {
    "upper.stl": samples.stl(samples.box((0, 0, 0), (0.05, 0.05, 0.3))),
    "lower.stl": samples.stl(samples.box((0, 0, 0), (0.2, 0.12, 0.05))),
}


def arm(lower: str, more: str = "", collision: str = "lower.stl") -> str:
    links = [
        meshed.link(meshed.mesh(seen, "visual"), meshed.mesh(touched), name=name)
        for name, seen, touched in (
            ("upper", "upper.stl", "upper.stl"),
            ("lower", lower, collision),
        )
    ]
    return "".join(links) + joint("upper", "lower", "revolute") + more


def test_the_mesh_of_another_link(tmp_path: Path) -> None:
    assert meshed.reported(tmp_path, "GEO004", arm("lower.stl"), FILES) == []
    (found,) = meshed.reported(tmp_path, "GEO004", arm("upper.stl"), FILES)
    assert found.message == naming("lower", "collision", "visual", "7%", "34%", "visual", "upper")
    assert found.help == naming("lower")
    assert found.span.text.startswith("<visual>")


@pytest.mark.parametrize("call", ['<xacro:arm side="r"/>', ""])
def test_the_mesh_of_a_macro_is_of_both_arms(tmp_path: Path, call: str) -> None:
    """Dynaarm: the base of a second arm has the same visual, which is turned in both."""
    for name, low in (("a", 0.0), ("b", -0.3)):
        wedge = samples.box((-0.04, -0.05, low), (0.04, 0.05, low + 0.3))
        (tmp_path / f"{name}.stl").write_bytes(samples.stl(wedge))
    body = meshed.link(meshed.mesh("a.stl", "visual"), meshed.mesh("b.stl"), name="${side}_b")
    text = f'<xacro:macro name="arm" params="side">{body}</xacro:macro><xacro:arm side="l"/>{call}'
    joints = joint("l_b", "r_b", "fixed") if call else ""
    (tmp_path / "r.urdf.xacro").write_text(xacro(text + joints))
    (found,) = check(tmp_path / "r.urdf.xacro", select=["GEO004"]).diagnostics
    assert "the mesh of" not in found.message


def test_the_collision_of_another_link(tmp_path: Path) -> None:
    robot = arm("lower.stl", collision="upper.stl")
    (found,) = meshed.reported(tmp_path, "GEO004", robot, FILES)
    assert found.message.endswith("; the collision is the mesh of 'upper'")
    assert found.help == "name the mesh of 'lower'"
    assert found.span.text.startswith("<collision>")


def test_the_collision_of_another_link_in_another_format(tmp_path: Path) -> None:
    """A collision in STL for each visual in OBJ."""
    files = {f"{name}.obj": OBJECT for name in ("upper", "lower")} | FILES
    own, other = (
        meshed.reported(
            tmp_path,
            "GEO004",
            re.sub(r"(<visual>\S+ filename=.\w+\.)stl", r"\1obj", arm("lower.stl", collision=name)),
            files,
        )
        for name in ("lower.stl", "upper.stl")
    )
    assert not any("the mesh of" in found.message for found in own)
    (found,) = [found for found in other if "'lower'" in found.message.partition(":")[0]]
    assert found.message.endswith("; the collision is the mesh of 'upper'")


@pytest.mark.parametrize(
    ("visual", "collision", "files", "unused"),
    [
        ("thumb_r.stl", "thumb_l_collision.stl", "thumb_r_collision.stl", "thumb_r_collision.stl"),
        ("thumb_r.stl", "thumb_r_collision.stl", "thumb_l_collision.stl", ""),
        ("thumb_r.stl", "thumb_l_collision.stl", "", ""),  # one collision for both sides
        ("thumb_r.stl", "palm_l_collision.stl", "thumb_r_collision.stl", ""),
    ],
)
def test_the_collision_of_the_other_side(
    tmp_path: Path, visual: str, collision: str, files: str, unused: str
) -> None:
    """The right hand of qbrobotics."""
    robot = meshed.link(meshed.mesh(visual, "visual"), meshed.mesh(collision), name="thumb")
    meshes = dict.fromkeys(filter(None, (visual, collision, files)), meshed.SOUND)
    found = meshed.messages(tmp_path, "GEO004", robot, meshes)
    assert found == ([naming("thumb", collision, visual, unused)] if unused else [])


@pytest.mark.parametrize(
    ("scale", "others", "is_found"),
    [
        ("1.1 1.1 1.1", ("upper", "lower"), True),
        ("1 -1 1", ("upper", "lower"), True),
        ("1 1 1", ("upper", "lower"), False),
        ("1.1 1.1 1.1", ("upper",), False),  # nothing to compare with
        ("1.1 1.1 1.1", (), False),
    ],
)
def test_one_mesh_at_two_scales(
    tmp_path: Path, scale: str, others: tuple[str, ...], is_found: bool
) -> None:
    robot = meshed.link(
        meshed.mesh("hand.stl", "visual"), meshed.mesh("hand.stl", more=f' scale="{scale}"')
    )
    for name in others:
        file = f"{name}.stl"
        robot += meshed.link(meshed.mesh(file, "visual"), meshed.mesh(file), name=name)
        robot += joint("arm", name, "revolute")
    found = meshed.reported(tmp_path, "GEO004", robot, FILES | {"hand.stl": meshed.SOUND})
    at_scale = [one.message for one in found if "scale" in one.message]
    assert at_scale == ([naming("arm", "collision", scale, "visual", "1 1 1")] if is_found else [])


@pytest.mark.parametrize(
    ("names", "is_found"),
    [
        (("lf", "rf", "lb", "rb"), True),
        (("lf", "rb"), False),
        (("lb", "lf", "rf", "rb"), False),  # of its counterpart, such as a wheel
    ],
)
def test_the_collision_of_a_similar_link(
    tmp_path: Path, names: tuple[str, ...], is_found: bool
) -> None:
    """Mangdang's Mini Pupper: the legs have similar shapes, so that the boxes do not tell it."""
    robot = '<link name="base"/>'
    for name in names:
        collision = f"{names[0]}.stl" if name == "rb" else f"{name}.stl"
        visual = meshed.mesh(f"{name}.stl", "visual")
        robot += meshed.link(visual, meshed.mesh(collision), name=name)
        robot += joint("base", name, "revolute")
    files = {f"{name}.stl": meshed.SOUND for name in names}
    (*found,) = meshed.reported(tmp_path, "GEO004", robot, files)
    expected = [(naming("rb", "lf", "3"), "write rb.stl")] if is_found else []
    assert [(one.message, one.help) for one in found] == expected


OBJECT = b"v 0 0 0\nv 0.2 0 0\nv 0 0.12 0\nv 0 0 0.05\nf 1 2 3\nf 1 3 4\n"


def test_one_part_in_two_formats(tmp_path: Path) -> None:
    """The masters of a dVRK, of which both arms have one part."""
    robot = arm("lower.stl").replace('filename="lower.stl"', 'filename="upper.stl"')
    seen = '<visual><geometry><mesh filename="upper.'
    robot = robot.replace(f"{seen}stl", f"{seen}obj")
    assert meshed.reported(tmp_path, "GEO004", robot, FILES | {"upper.obj": OBJECT}) == []


def test_a_placeholder_of_several_links(tmp_path: Path) -> None:
    third = meshed.link(meshed.mesh("upper.stl", "visual"), name="third") + joint("lower", "third")
    assert meshed.reported(tmp_path, "GEO004", arm("upper.stl", third), FILES) == []


@pytest.mark.parametrize(
    ("radius", "length", "is_found"),
    [("0.2", "0.1", True), ("0.1", "0.1", False), ("0.15", "0.1", False), ("0.2", "0.2", False)],
)
def test_a_diameter(tmp_path: Path, radius: str, length: str, is_found: bool) -> None:
    cylinder = f'<cylinder radius="{radius}" length="{length}"/>'
    tyre = samples.stl(samples.box((-0.1, -0.05, -0.1), (0.1, 0.05, 0.1)))
    turned = shape("collision", cylinder, rpy="1.5707963 0 0")
    robot = meshed.link(meshed.mesh("tyre.stl", "visual"), turned)
    found = meshed.messages(tmp_path, "GEO004", robot, {"tyre.stl": tyre})
    expected = naming("arm", "radius", "collision", "0.2 m", "twice", "visual", "0.1 m")
    assert found == ([expected] if is_found else [])


def legs(right: str, others: tuple[str, ...] = ("hip", "knee"), scale: str = "") -> str:
    text = '<link name="base"/>'
    for name in (*others, "foot"):
        for side in ("left", "right"):
            is_right_foot = (name, side) == ("foot", "right")
            file = right if is_right_foot else f"{side}_{name}.stl"
            visual = meshed.mesh(file, "visual", scale if is_right_foot else "")
            text += meshed.link(visual, name=f"{side}_{name}")
            text += joint("base", f"{side}_{name}", "revolute")
    return text


BOTH = {
    f"{side}_{name}.stl": meshed.SOUND
    for side in ("left", "right")
    for name in ("hip", "knee", "foot")
}


def test_the_mesh_of_the_other_side(tmp_path: Path) -> None:
    assert meshed.reported(tmp_path, "GEO004", legs("right_foot.stl"), BOTH) == []
    (finding,) = meshed.reported(tmp_path, "GEO004", legs("left_foot.stl"), BOTH)
    assert finding.message == naming("right_foot", "visual", "left_foot", "right_foot.stl")
    assert finding.help == naming("right_foot.stl")
    assert finding.span.text == "left_foot.stl"
    assert meshed.reported(tmp_path, "GEO004", legs("left_foot.stl", ("hip",)), BOTH) == []
    mirrored = legs("left_foot.stl", scale=' scale="1 -1 1"')
    assert meshed.reported(tmp_path, "GEO004", mirrored, BOTH) == []
    (tmp_path / "right_foot.stl").unlink()
    without = {name: data for name, data in BOTH.items() if name != "right_foot.stl"}
    assert meshed.reported(tmp_path, "GEO004", legs("left_foot.stl"), without) == []


@pytest.mark.parametrize(
    ("collision", "is_found"), [("own.stl", True), ("lf_simple.stl", False), ("rb.stl", True)]
)
def test_the_visual_of_another_link(tmp_path: Path, collision: str, is_found: bool) -> None:
    robot = '<link name="base"/>'
    for name in ("lf", "rf", "lb"):
        robot += meshed.link(
            meshed.mesh(f"{name}.stl", "visual"), meshed.mesh(f"{name}.stl"), name=name
        )
        robot += joint("base", name, "revolute")
    robot += meshed.link(meshed.mesh("lf.stl", "visual"), meshed.mesh(collision), name="rb")
    robot += joint("base", "rb", "revolute")
    files = dict.fromkeys(("lf.stl", "rf.stl", "lb.stl", collision), meshed.SOUND)
    found = meshed.messages(tmp_path, "GEO004", robot, files)
    assert found == ([naming("rb", "lf", "3")] if is_found else [])


def test_the_mesh_of_another_finger(tmp_path: Path) -> None:
    def hand(pinky: str, *fingers: str) -> str:
        text = '<link name="palm"/>'
        for name in fingers:
            file = pinky if name == "pinky" else f"{name}_tip.stl"
            text += meshed.link(meshed.mesh(file, "visual"), name=f"{name}_tip")
            text += joint("palm", f"{name}_tip", "revolute")
        return text

    fingers = ("index", "middle", "ring", "pinky")
    files = {f"{name}_tip.stl": meshed.SOUND for name in fingers}
    assert meshed.reported(tmp_path, "GEO004", hand("pinky_tip.stl", *fingers), files) == []
    (found,) = meshed.reported(tmp_path, "GEO004", hand("ring_tip.stl", *fingers), files)
    assert found.message == naming("pinky_tip", "visual", "ring_tip", "pinky_tip.stl")
    assert found.span.text == "ring_tip.stl"
    three = hand("ring_tip.stl", *fingers[1:])
    assert meshed.reported(tmp_path, "GEO004", three, files) == []
    (tmp_path / "pinky_tip.stl").unlink()
    del files["pinky_tip.stl"]
    assert meshed.reported(tmp_path, "GEO004", hand("ring_tip.stl", *fingers), files) == []


def lined_up(*collisions: str) -> str:
    """A chain of links with a mesh for visual and collision each, with origins of the latter."""
    names = "abcdef"[: len(collisions)]
    links = [
        meshed.link(
            meshed.mesh(f"visual/{name}.stl", "visual"),
            meshed.mesh(f"collision/{name}.stl", origin=origin),
            name=name,
        )
        for name, origin in zip(names, collisions, strict=True)
    ]
    joints = (joint(above, name, "revolute") for above, name in pairwise(names))
    return "".join((*links, *joints))


MOVED = '<origin xyz="0 0 0.02"/>'


@pytest.mark.parametrize(
    ("origins", "count"),
    [
        (("", "", MOVED, "", ""), 1),
        (("", "", MOVED, ""), 0),  # few others
        (("", MOVED, MOVED, "", "", ""), 0),
        (("", "", '<origin xyz="0 0 0.0005"/>', "", ""), 0),  # rounding
        (("", "", '<origin rpy="0 0 1" xyz="0 0 0.02"/>', "", ""), 0),  # other axes
    ],
)
def test_one_link_whose_meshes_have_two_origins(
    tmp_path: Path, origins: tuple[str, ...], count: int
) -> None:
    files = {f"{role}/{name}.stl": SHANK for role in ("visual", "collision") for name in "abcdef"}
    found = meshed.reported(tmp_path, "GEO004", lined_up(*origins), files)
    assert [one.message for one in found] == [
        naming("c", "<origin>", "0 0 0.02 m", "4", "<origin>")
    ] * count
    assert [one.span.text for one in found] == [MOVED] * count
