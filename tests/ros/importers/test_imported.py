"""Bodies, masses, orders and index maps of small robots, as each program has them."""

import pytest

from urdfkit.lint.context import Context
from urdfkit.lint.loading import read
from urdfkit.ros.importers.changes import changes
from urdfkit.ros.importers.facts import IMPORTERS, UnknownImporter, facts_of
from urdfkit.ros.importers.index_map import NoIndexMap, index_map
from urdfkit.text.source import Source

INERTIAL = (
    '<inertial><mass value="2"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>'
    "</inertial>"
)


def robot(*parts: str) -> Context:
    return read(Source("r.urdf", f'<robot name="r">{"".join(parts)}</robot>'.encode()))


def link(name: str, inside: str = INERTIAL) -> str:
    return f'<link name="{name}">{inside}</link>'


def joint(name: str, parent: str, child: str, kind: str = "continuous", more: str = "") -> str:
    ends = f'<parent link="{parent}"/><child link="{child}"/>'
    return f'<joint name="{name}" type="{kind}">{ends}{more}</joint>'


#: A base with legs z and b, and a leg a below a plate; links and joints in orders of their own.
LEGGED = robot(
    *map(link, ["base", "a_leg", "plate", "b_leg", "b_foot", "z_leg", "z_foot"]),
    joint("m_foot", "z_leg", "z_foot"),
    joint("z", "base", "z_leg"),
    joint("b", "base", "b_leg"),
    joint("plate", "base", "plate", "fixed"),
    joint("a", "plate", "a_leg"),
    joint("c_foot", "b_leg", "b_foot"),
)

#: Orders that the programs themselves gave; Isaac's by Isaac Lab's resolver of PhysX's order.
ORDERS = {
    "drake": "z m_foot b c_foot a",
    "genesis": "z m_foot b c_foot a",
    "isaac": "a b z c_foot m_foot",
    "isaac-sim": "b z c_foot a m_foot",
    "mujoco": "z m_foot b c_foot a",
    "newton": "z m_foot b c_foot a",
    "pinocchio": "b c_foot a z m_foot",
    "pybullet": "z m_foot b c_foot a",
    "yourdfpy": "m_foot z b a c_foot",
}


@pytest.mark.parametrize("name", IMPORTERS)
def test_orders(name: str) -> None:
    found = [one.joint.name for one in LEGGED.imported(name).joints]
    assert found == ORDERS[name].split()


@pytest.mark.parametrize("name", IMPORTERS)
def test_merged_links(name: str) -> None:
    found = LEGGED.imported(name)
    merged = {"mujoco", "pinocchio", "isaac", "genesis"}
    assert ("plate" in {one.name for one in found.bodies}) is (name not in merged)


def test_continuous_joints_have_two_positions_in_pinocchio() -> None:
    found = LEGGED.imported("pinocchio").joints
    assert [(one.q, one.nq, one.v, one.nv) for one in found[:2]] == [(0, 2, 0, 1), (2, 2, 1, 1)]


def test_coordinates_follow_those_of_a_free_root() -> None:
    assert [LEGGED.imported(name).joints[0].q for name in ("pybullet", "genesis")] == [7, 7]
    welded = robot(link("world", ""), link("a"), joint("j", "world", "a"))
    assert welded.imported("pybullet").root_is_free is False
    assert welded.imported("pybullet").joints[0].q == 7
    assert welded.imported("genesis").joints[0].q == 0


BOX = '<collision><geometry><box size="1 1 0.5"/></geometry></collision>'


@pytest.mark.parametrize(
    ("name", "mass"), [("mujoco", 500), ("newton", 500), ("pinocchio", 0), ("pybullet", 1)]
)
def test_computed_and_default_masses(name: str, mass: float) -> None:
    one = robot(link("base"), link("arm", BOX), joint("j", "base", "arm")).imported(name)
    assert {body.name: body.mass for body in one.bodies}["arm"] == pytest.approx(mass)
    texts = [change.text for change in changes(one)]
    assert any("'arm' with no <inertial> gets" in text for text in texts) is bool(mass)


def test_isaac_computes_only_missing_masses() -> None:
    one = robot(link("base"), link("tool", ""), joint("j", "base", "tool", "fixed"))
    (body,) = one.imported("isaac").bodies
    assert (body.name, body.mass) == ("base", 2)
    assert [part.mass for part in one.imported("isaac-sim").bodies] == [2, None]


def test_settings_of_mujocos_compiler() -> None:
    compiler = '<mujoco><compiler fusestatic="false" boundmass="3" discardvisual="false"/></mujoco>'
    parts = link("base"), link("arm"), joint("j", "base", "arm")
    one = robot(compiler, *parts).imported("mujoco")
    assert [(body.name, body.mass) for body in one.bodies] == [("base", 3), ("arm", 3)]
    assert one.drops_visuals is False


def test_locations_of_changes() -> None:
    found = [(one.at.get("name"), one.text) for one in changes(LEGGED.imported("mujoco"))]
    assert found == [
        ("base", "link 'base' is merged into world; its 2 kg have no effect"),
        ("plate", "link 'plate' is merged into world; its 2 kg have no effect"),
    ]


def test_an_index_map() -> None:
    found = index_map(LEGGED.imported("isaac"), LEGGED.imported("mujoco"))
    assert [one.joint.name for one in found.joints] == ORDERS["mujoco"].split()
    values = ORDERS["isaac"].split()
    assert [values[index] for index in found.indices] == ORDERS["mujoco"].split()
    free = index_map(LEGGED.imported("pybullet"), LEGGED.imported("mujoco"))
    assert free.indices == (0, 1, 2, 3, 4)


def test_joints_missing_in_one_program() -> None:
    one = robot(link("a"), link("b"), joint("j", "a", "b", "floating"))
    with pytest.raises(NoIndexMap, match=r"joint 'j' has coordinates in mujoco, not in pyb"):
        index_map(one.imported("mujoco"), one.imported("pybullet"))
    with pytest.raises(NoIndexMap, match=r"joint 'j' is floating"):
        index_map(one.imported("mujoco"), one.imported("pinocchio"))


def test_names() -> None:
    with pytest.raises(UnknownImporter, match=r"did you mean 'mujoco'"):
        facts_of("mujoko")


def test_robots_without_a_valid_tree() -> None:
    loop = robot(link("a"), link("b"), joint("i", "a", "b"), joint("j", "b", "a"))
    for name in IMPORTERS:
        found = loop.imported(name)
        assert len(found.joints) <= 2
        assert list(changes(found)) is not None
    nothing = robot()
    assert all(nothing.imported(name).bodies == () for name in IMPORTERS)


#: Robots with floating joints, and the positions that Drake gave to each joint and free body.
FREED = {
    "one of two links": ("a b c", "j a b; k a c floating", "j 7; c 8"),
    "two trees": ("a b c d", "k a b floating; j b c; m a d", "m 7; b 8; j 15"),
    "the root is written last": ("b a c d", "k a b floating; j b c; m a d", "b 0; j 7; m 15"),
    "the root has more joints": (
        "b a c d e",
        "k a b floating; j b c; m a d; n a e",
        "m 7; n 8; b 9; j 16",
    ),
    "the root has no other joint": (
        "a c b d e",
        "k a b floating; l a c floating; m c d; n b e",
        "c 0; m 7; b 8; n 15",
    ),
    "the world": ("world b a c d", "w world a; k a b floating; j b c; m a d", "w 0; m 1; b 2; j 9"),
}


@pytest.mark.parametrize("case", FREED)
def test_drake_frees_the_child_of_a_floating_joint(case: str) -> None:
    links, joints, positions = FREED[case]
    made = robot(*map(link, links.split()), *(joint(*one.split()) for one in joints.split("; ")))
    found = [f"{one.names[0]} {one.q}" for one in made.imported("drake").joints]
    assert "; ".join(sorted(found, key=lambda one: int(one.split()[1]))) == positions


def test_mujoco_and_pybullet_have_ball_joints() -> None:
    made = robot(*map(link, "abc"), joint("ball", "a", "b", "spherical"), joint("turn", "b", "c"))
    found = [(one.names, one.q, one.v) for one in made.imported("mujoco").joints]
    assert found == [(("ball",), 0, 0), (("turn",), 4, 3)]
    # as PyBullet 3.2.7 numbers the joints of a humanoid with 17 of them, after its root
    found = [(one.names, one.q, one.v) for one in made.imported("pybullet").joints]
    assert found == [(("ball",), 7, 6), (("turn",), 11, 9)]
