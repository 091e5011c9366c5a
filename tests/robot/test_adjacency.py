"""Neighbours as MoveIt has them, and links that move as one."""

from itertools import combinations

from tests.physics.collision.robots import box, joint, link, revolute, robot
from urdfkit.robot.adjacency import Adjacency

BODY = box(1, 1, 1)


def adjacent(*parts: str) -> set[tuple[str, str]]:
    tree = robot(*parts).tree
    adjacency = Adjacency(tree)
    names = [link.name for link in tree.model.links]
    return {pair for pair in combinations(names, 2) if adjacency.is_adjacent(*pair)}


def test_a_joint_makes_neighbours() -> None:
    links = (link("a", BODY), link("b", BODY), link("c", BODY))
    assert adjacent(*links, joint("a", "b"), joint("b", "c")) == {("a", "b"), ("b", "c")}


def test_links_without_collision_do_not_part_neighbours() -> None:
    links = (link("a", BODY), link("x"), link("y"), link("b", BODY))
    joints = (joint("a", "x"), joint("x", "y"), joint("y", "b"))
    assert ("a", "b") in adjacent(*links, *joints)


def test_all_around_a_link_without_collision_are_neighbours() -> None:
    legs = [link(f"leg{number}", BODY) for number in range(3)]
    joints = [joint("base", f"leg{number}", "continuous") for number in range(3)]
    found = adjacent(link("base"), *legs, *joints)
    assert {("leg0", "leg1"), ("leg0", "leg2"), ("leg1", "leg2")} <= found


def test_two_gaps_are_not_one() -> None:
    links = (link("a", BODY), link("x"), link("b", BODY), link("y"), link("c", BODY))
    joints = (joint("a", "x"), joint("x", "b"), joint("b", "y"), joint("y", "c"))
    assert ("a", "c") not in adjacent(*links, *joints)


def test_fixed_joints_make_links_one_body() -> None:
    tree = robot(
        *(link(name, BODY) for name in "abc"),
        joint("a", "b"),
        joint("b", "c", "revolute", more=revolute(-1, 1)),
    ).tree
    adjacency = Adjacency(tree)
    assert adjacency.is_rigid("a", "b")
    assert not adjacency.is_rigid("b", "c")


def test_a_ring_of_links_is_no_obstacle() -> None:
    found = adjacent(link("a"), link("b", BODY), joint("a", "b"), joint("b", "a"))
    assert found == {("a", "b")}


def test_a_link_without_collision_is_a_neighbour_across_others() -> None:
    """Nothing but the second bare link lies between the first and the body."""
    links = (link("x"), link("y"), link("a", BODY), link("b", BODY))
    found = adjacent(*links, joint("x", "y"), joint("y", "a"), joint("a", "b"))
    assert found == {("x", "y"), ("x", "a"), ("y", "a"), ("a", "b")}
