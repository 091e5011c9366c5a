import pytest

from tests.massive import context, inertial, joint, link
from urdfkit.robot.rigid_bodies import rigid_bodies

ROBOT = (
    link("root")
    + link("base", inertial(2, (1, 1, 1), "1 0 0"))
    + link("mast", inertial(1, (1, 2, 3), rpy="0 0 1.5707963267948966"))
    + link("wheel", inertial(0.5, (1, 1, 1)))
    + link("hub")
    + joint("root", "base")
    + joint("base", "mast", xyz="0 0 3")
    + joint("mast", "wheel", "continuous")
    + joint("wheel", "hub", xyz="0 1 0")
)


def bodies(text: str, preserved: tuple[str, ...] = ()) -> list[tuple[str, list[str]]]:
    """The joint above each body and its links."""
    return [
        (body.joint.name if body.joint else "", [one.name for one, _ in body.links])
        for body in rigid_bodies(context(text).tree, frozenset(preserved))
    ]


def test_fixed_joints_make_links_one() -> None:
    assert bodies(ROBOT) == [("", ["root", "base", "mast"]), ("wheel_joint", ["wheel", "hub"])]
    assert bodies(ROBOT, ("mast_joint",)) == [
        ("", ["root", "base"]),
        ("mast_joint", ["mast"]),
        ("wheel_joint", ["wheel", "hub"]),
    ]


def test_mass_and_centre_are_those_of_all_links() -> None:
    base, wheel = rigid_bodies(context(ROBOT).tree)
    assert (base.top.name, base.mass, wheel.mass) == ("root", 3, 0.5)
    properties = base.properties
    assert properties.center == pytest.approx((2 / 3, 0, 1))
    # The tensor of the mast, turned by a quarter; both bodies off their common centre.
    assert properties.tensor.ixx == pytest.approx(1 + 2 + 2 * 1 + 1 * 2**2)
    assert properties.tensor.iyy == pytest.approx(1 + 1 + 2 * (1 + 1 / 9) + (2**2 + 4 / 9))
    assert properties.tensor.izz == pytest.approx(1 + 3 + 2 / 9 + 4 / 9)


def test_what_is_fixed_to_the_world_is_ground() -> None:
    robot = link("world") + link("rail") + link("cart")
    robot += joint("world", "rail") + joint("rail", "cart", "prismatic")
    assert [body.is_ground for body in rigid_bodies(context(robot).tree)] == [True, False]
    assert not any(body.is_ground for body in rigid_bodies(context(ROBOT).tree))


def test_a_link_without_a_number_weighs_nothing() -> None:
    (plain, bad) = context(link("a") + link("b", inertial(float("nan"), (1, 1, 1)))).model.links
    assert (plain.mass, bad.mass) == (0, 0)


@pytest.mark.parametrize(
    ("joints", "expected"),
    [
        (joint("a", "b") + joint("b", "a"), []),  # a loop without a root
        (joint("a", "b") + joint("b", "c") + joint("a", "c"), [("", ["a", "b", "c"])]),
        (joint("a", "a") + joint("x", "b"), [("", ["a"]), ("", ["b"])]),
        (  # a link that two joints hold is in one body
            joint("a", "b", "continuous") + joint("c", "b", "continuous"),
            [("", ["a"]), ("", ["c"]), ("b_joint", ["b"])],
        ),
    ],
)
def test_every_graph(joints: str, expected: list[tuple[str, list[str]]]) -> None:
    found = bodies(link("a") + link("b") + link("c") + joints)
    names = {name for _, links in expected for name in links}
    assert [(above, links) for above, links in found if names.intersection(links)] == expected


def test_a_long_chain() -> None:
    count = 3000
    text = "".join(link(f"l{i}") for i in range(count)) + "".join(
        joint(f"l{i}", f"l{i + 1}") for i in range(count - 1)
    )
    ((_, links),) = bodies(text)
    assert len(links) == count
