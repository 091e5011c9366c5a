"""Standing and tipping over: closed forms of boxes, wheels and casters."""

from math import atan2, pi, sqrt
from pathlib import Path

import pytest

from tests.conftest import ARM, CORPUS, MOBILE_BASE, needs_corpus
from tests.massive import inertial, joint, link, shape
from tests.output.test_overview import of
from urdfkit.lint.loading import read
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.robot.stability import stand, standing_verdict

TALL = shape("collision", '<box size="0.4 0.2 1"/>')


def test_a_tall_box_tips_across_its_narrow_side() -> None:
    found = stand(of(link("box", TALL, inertial(3, (1, 1, 1), xyz="0 0 0.1"))))
    assert found is not None
    assert found.links == ("box",)
    assert set(found.polygon) == {(-0.2, -0.1), (0.2, -0.1), (0.2, 0.1), (-0.2, 0.1)}
    assert found.ground == -0.5
    assert found.margin == pytest.approx(0.1, rel=1e-12)
    assert found.angle == pytest.approx(atan2(0.1, 0.6), rel=1e-12)
    assert not found.tips


def test_a_mesh_stands_as_the_box_that_it_is(tmp_path: Path) -> None:
    trimesh = pytest.importorskip("trimesh")
    trimesh.creation.box((0.4, 0.2, 1)).export(tmp_path / "box.stl")
    inside = shape("collision", '<mesh filename="box.stl"/>') + inertial(
        3, (1, 1, 1), xyz="0 0 0.1"
    )
    (tmp_path / "r.urdf").write_text(whole_robot(link("box", inside)))
    found = stand(read(tmp_path / "r.urdf"))
    assert found is not None
    assert [round(value, 6) for corner in sorted(found.polygon) for value in corner] == [
        *(-0.2, -0.1, -0.2, 0.1),
        *(0.2, -0.1, 0.2, 0.1),
    ]
    assert found.ground == pytest.approx(-0.5)
    assert found.margin == pytest.approx(0.1)
    assert found.angle == pytest.approx(atan2(0.1, 0.6))
    assert stand(read(tmp_path / "r.urdf"), meshes=False) is None


def test_a_floating_joint_fixes_nothing_to_the_world() -> None:
    body = link("world") + link("box", TALL, inertial(3, (1, 1, 1), xyz="0 0 0.1"))
    for kind, verdict in (("floating", "stands"), ("fixed", "fixed")):
        assert standing_verdict(of(body + joint("world", "box", kind))).verdict == verdict


def test_a_missing_mesh_may_reach_the_ground(tmp_path: Path) -> None:
    """A submarine stood on its sensor, 19 cm in front of its centre of mass."""
    wheel = link("wheel", shape("collision", '<mesh filename="missing.stl"/>'))
    text = link("box", TALL, inertial(3, (1, 1, 1), xyz="0.25 0 0")) + wheel + joint("box", "wheel")
    (tmp_path / "r.urdf").write_text(whole_robot(text))
    robot = read(tmp_path / "r.urdf")
    found = standing_verdict(robot)
    assert (found.verdict, found.links, found.unread) == ("unknown", (), ("wheel",))
    assert standing_verdict(robot, contacts=["box"]).verdict == "tips-unless-bolted"


def test_it_falls_where_its_mass_hangs_out() -> None:
    found = stand(of(link("box", TALL, inertial(3, (1, 1, 1), xyz="0.25 0 0"))))
    assert found is not None
    assert found.tips
    assert found.margin == pytest.approx(-0.05, rel=1e-12)
    assert found.tip_direction == "forwards (+x)"
    assert found.angle == pytest.approx(-atan2(0.05, 0.5), rel=1e-12)


def test_a_payload_moves_the_centre() -> None:
    box = of(
        link("box", TALL, inertial(3, (1, 1, 1)))
        + link("tray")
        + joint("box", "tray", xyz="0 0.4 0")
    )
    light, heavy = (standing_verdict(box, payload={"tray": mass}).stability for mass in (0.5, 3.0))
    assert light is not None
    assert heavy is not None
    assert light.center[1] == pytest.approx(0.5 * 0.4 / 3.5)
    assert (light.tips, heavy.tips, heavy.tip_direction) == (False, True, "to its left (+y)")


def test_three_balls_make_a_triangle() -> None:
    """The margin of the centre of an equilateral triangle is half its outer radius."""
    ball = shape("collision", '<sphere radius="0.1"/>')
    legs = "".join(
        link(f"leg{n}", ball) + joint("base", f"leg{n}", xyz=f"{x} {y} 0")
        for n, (x, y) in enumerate(((1, 0), (-0.5, sqrt(0.75)), (-0.5, -sqrt(0.75))))
    )
    found = stand(of(link("base", inertial(1, (1, 1, 1))) + legs))
    assert found is not None
    assert found.margin == pytest.approx(0.5, rel=1e-12)
    assert found.ground == pytest.approx(-0.1)
    assert found.links == ("leg0", "leg1", "leg2")


@pytest.mark.parametrize("rpy", [f"{pi / 2} 0 0", f"{-pi / 2} 0.7 0"])
def test_a_wheel_touches_along_a_line(rpy: str) -> None:
    wheel = shape("collision", '<cylinder radius="0.06" length="0.05"/>', rpy=rpy)
    pair = link("left", wheel) + joint("base", "left", "continuous", "0 0.1 0")
    text = link("base", inertial(1, (1, 1, 1))) + pair
    found = stand(of(text + pair.replace("left", "right").replace('"0 0.1', '"0.3 -0.1')))
    assert found is not None
    ys = sorted(y for _, y in found.polygon)
    assert [ys[0], ys[-1]] == pytest.approx([-0.125, 0.125], abs=1e-9)
    assert found.ground == pytest.approx(-0.06)


@pytest.mark.parametrize(
    "wheel",
    [
        shape("collision", '<sphere radius="0.06"/>'),
        # doogie: the points near the lowest line of a small cylinder were contacts
        shape("collision", '<cylinder radius="0.015" length="0.02"/>', rpy="1.5708 0 0.001"),
    ],
)
def test_two_wheels_alone_balance(wheel: str) -> None:
    pair = link("left", wheel) + joint("base", "left", "continuous", "0 0.1 0")
    text = link("base", inertial(1, (1, 1, 1), xyz="0.5 0 0")) + pair
    assert stand(of(text + pair.replace("left", "right").replace('"0 0.1', '"0 -0.1'))) is None


def test_nothing_stands_without_a_mass_or_a_shape() -> None:
    assert stand(of(link("a", TALL))) is None
    assert stand(of(link("a", inertial(1, (1, 1, 1))))) is None


@pytest.mark.parametrize(("height", "links"), [(0.024, ("box", "foot")), (0.027, ("box",))])
def test_what_is_near_the_ground_stands_on_it(height: float, links: tuple[str, ...]) -> None:
    """Within 2 % of the size, which is 1.25 m here; wherever the root is."""
    foot = link("foot", shape("collision", '<box size="0.1 0.1 0.1"/>'))
    text = link("box", TALL, inertial(3, (1, 1, 1))) + foot
    for shift in (0, 7):
        found = stand(
            of(
                link("root")
                + text
                + joint("root", "box", xyz=f"0 0 {shift}")
                + joint("box", "foot", xyz=f"1 0 {height - 0.45}")
            )
        )
        assert found is not None
        assert found.links == links
        assert found.ground == pytest.approx(shift - 0.5)


def test_named_contacts() -> None:
    robot = read(MOBILE_BASE)
    found = stand(robot)
    assert found is not None
    assert found.links == ("left_wheel", "right_wheel", "caster")
    assert found.margin > 0
    assert stand(robot, contacts=["left_wheel", "right_wheel"]) is None
    left = stand(robot, contacts=["left_wheel", "caster"])
    assert left is not None
    assert left.links == ("left_wheel", "caster")
    assert left.margin < 0


def test_the_lowest_vertices_of_a_mesh_are_contacts() -> None:
    pytest.importorskip("numpy")
    arm = read(ARM)
    found = standing_verdict(arm, {"shoulder": 1.2}).stability
    assert found is not None
    assert found.links == ("base",)


@needs_corpus
@pytest.mark.parametrize(
    ("path", "feet"),
    [
        ("anymal_c_simple_description/urdf/anymal.urdf", 4),
        ("turtlebot3/turtlebot3_description/urdf/turtlebot3_burger.urdf", 3),
        ("nao_robot/nao_description/urdf/naoV50_generated_urdf/nao.urdf", 8),
    ],
)
def test_real_robots_stand(path: str, feet: int) -> None:
    found = stand(read(CORPUS / path), meshes=False)
    assert found is not None
    assert len(found.links) == feet
    assert found.margin > 0.004
