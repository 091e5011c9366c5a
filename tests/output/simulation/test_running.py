"""Robots that behave and robots that do not, in MuJoCo."""

import re
from pathlib import Path

import pytest

from tests.own_robots import ROVER, own_robots
from urdfkit import read
from urdfkit.core.spatial import Transform
from urdfkit.errors import UrdfkitError
from urdfkit.output.simulation import motion, simulate
from urdfkit.text.source import Source

mujoco = pytest.importorskip("mujoco")
for library in ("numpy", "trimesh"):
    pytest.importorskip(library)


def link(name: str, at: str = "0 0 0", mass: float = 1.0) -> str:
    """A box of 0.1 m, whose centre is at a place."""
    moment = mass / 600
    return (
        f'<link name="{name}"><inertial><origin xyz="{at}"/><mass value="{mass}"/>'
        f'<inertia ixx="{moment}" ixy="0" ixz="0" iyy="{moment}" iyz="0" izz="{moment}"/>'
        f'</inertial>\n<collision><origin xyz="{at}"/><geometry><box size="0.1 0.1 0.1"/>'
        "</geometry></collision></link>\n"
    )


def joint(
    name: str, parent: str, at: str, kind: str = "revolute", effort: float = 100, more: str = ""
) -> str:
    return (
        f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{name}"/>'
        f'<origin xyz="{at}"/><axis xyz="0 1 0"/>'
        f'<limit lower="-3" upper="3" effort="{effort}" velocity="1"/>{more}</joint>\n'
    )


def robot(*parts: str) -> Source:
    return Source(
        "r.urdf", f'<robot name="r">\n<link name="world"/>{"".join(parts)}</robot>'.encode()
    )


def failures(source: Source | Path, base: str = "auto") -> dict[str, tuple[str, ...]]:
    found = simulate(read(source), base=base)
    return {one.test: one.names for one in found.verdicts if not one.passes}


def warnings(source: Source | Path, base: str = "auto") -> dict[str, tuple[str, ...]]:
    found = simulate(read(source), base=base)
    return {one.test: one.names for one in found.verdicts if one.warns}


@own_robots
def test_sound_robots_behave(path: Path) -> None:
    assert failures(path) == {}


def test_links_in_one_another_push_each_other_away() -> None:
    pair = robot(
        link("a"), joint("a", "world", "0 0 0"), link("b"), joint("b", "world", "0.05 0 0")
    )
    found = {one.test: one for one in simulate(read(pair)).verdicts}
    assert found["overlap"].value == pytest.approx(0.05)
    assert found["overlap"].names == ("a", "b")
    assert found["overlap"].span is not None
    assert found["overlap"].span.line == 3
    assert found["energy"].value > found["energy"].bound
    assert found["energy"].names == ("a", "b")
    assert found["energy"].message.endswith("contacts: 'a' and 'b' push each other away")


def test_neighbours_of_what_is_welded_collide_in_mujoco() -> None:
    inside = robot(
        link("base"),
        joint("base", "world", "0 0 0", "fixed"),
        link("a"),
        joint("a", "base", "0 0 0"),
    )
    assert warnings(inside)["overlap"] == ("a", "base")
    (overlap,) = [one for one in simulate(read(inside)).verdicts if one.test == "overlap"]
    assert overlap.message.endswith("since the parent is welded to the world")
    floating = Source("r.urdf", inside.data.replace(b'"world"', b'"root"'))
    assert "overlap" not in warnings(floating, base="free"), "there MuJoCo leaves the pair out"


def test_an_effort_of_zero_moves_nothing() -> None:
    still = robot(link("arm"), joint("arm", "world", "0 0 0", effort=0))
    (verdict,) = [one for one in simulate(read(still)).verdicts if one.test == "drive"]
    assert verdict.message == "joint 'arm': its effort of 0 N·m cannot move it"
    assert verdict.rule == "JNT008"


def test_a_caster_has_no_motor() -> None:
    """Trossen's mobile_ai: JNT008 is silent about it."""
    caster = joint("caster", "world", "0 0 0", "continuous", effort=0)
    tests = {one.test for one in simulate(read(robot(link("caster"), caster))).verdicts}
    assert "drive" not in tests


@pytest.mark.parametrize(("effort", "holds"), [(4.8, False), (5.0, True)])
def test_a_joint_holds_with_its_effort(effort: float, holds: bool) -> None:
    """A mass of 1 kg at 0.5 m needs 4.905 N·m."""
    arm = robot(link("arm", at="0.5 0 0"), joint("arm", "world", "0 0 0", effort=effort))
    (verdict,) = [one for one in simulate(read(arm)).verdicts if one.test == "hold"]
    assert verdict.passes is holds
    if not holds:
        assert "needs 4.91 N·m, its effort is 4.8 N·m" in verdict.message


def test_a_joint_that_is_too_weak_in_another_pose() -> None:
    """An upright arm of 1 kg at 0.5 m needs 4.905 N·m when it is horizontal."""
    upright = robot(link("arm", at="0 0 0.5"), joint("arm", "world", "0 0 0", effort=1))
    (verdict,) = [one for one in simulate(read(upright)).verdicts if one.test == "hold"]
    assert verdict.warns
    assert verdict.message == (
        "joint 'arm' needs 4.91 N·m to hold its load at arm 1.57, its effort is 1 N·m"
    )
    assert verdict.value == pytest.approx(4.905)
    assert verdict.bound == 1


@pytest.mark.parametrize(("effort", "holds"), [(9, False), (10, True)])
def test_a_slide_that_is_too_weak_to_rise_from_its_lower_end(effort: float, holds: bool) -> None:
    slide = joint("slide", "world", "0 0 0", "prismatic", effort).replace("0 1 0", "0 0 1")
    source = robot(link("slide"), slide.replace('lower="-3"', 'lower="0"'))
    assert failures(source) == ({} if holds else {"hold": ("slide",)})


def gripper(mimic: str, lower: float = 0, upper: float = 0.1) -> Source:
    """Two fingers on slides; the first one moves by 0.2 m."""
    limits = 'lower="-3" upper="3"'
    first = joint("a", "world", "0 0 0", "prismatic").replace(limits, 'lower="0" upper="0.2"')
    second = joint("b", "world", "0 1 0", "prismatic", more=f'<mimic joint="a" {mimic}/>')
    own = f'lower="{lower}" upper="{upper}"'
    return robot(link("a"), first, link("b"), second.replace(limits, own))


@pytest.mark.parametrize(
    ("source", "reason"),
    [
        (gripper(""), "[0, 0.2] m, its own range is [0, 0.1]: 'a' can only move from 0 to 0.1 m"),
        (gripper('multiplier="-1"'), "[-0.2, 0] m, its own range is [0, 0.1]: 'a' cannot move"),
        (
            gripper('offset="1"'),
            "[1, 1.2] m, its own range is [0, 0.1]: no position of 'a' is within it",
        ),
    ],
)
def test_a_mimic_joint_that_its_leader_drives_beyond_its_range(source: Source, reason: str) -> None:
    (verdict,) = [one for one in simulate(read(source)).verdicts if one.test == "mimic"]
    assert not verdict.passes
    assert verdict.message == f"joint 'b': its <mimic> of 'a' drives it through {reason}"


@pytest.mark.parametrize(
    "source", [gripper('multiplier="0.5"'), gripper("", upper=0.197), gripper('multiplier="0"')]
)
def test_a_mimic_joint_within_its_range(source: Source) -> None:
    assert failures(source) == {}


def test_what_follows_starts_where_its_leader_takes_it() -> None:
    """From zero it would be thrown there: a gain of 14 J."""
    follower = joint("b", "world", "0 2 0", more='<mimic joint="a" offset="0.8"/>')
    arms = link("a", at="0.5 0 0"), joint("a", "world", "0 0 0"), link("b", at="0.5 0 0"), follower
    lenient = *arms[:3], follower.replace('upper="3"', 'upper="4"')
    assert failures(robot(*lenient)) == {}
    assert failures(robot(*arms)) == {"mimic": ("b",)}, "it is to go to 3.8 rad"


def test_contacts_beyond_the_memory_of_mujoco(monkeypatch: pytest.MonkeyPatch) -> None:
    """Thousands of overlapping shapes have millions."""

    def fail(*_: object) -> None:
        raise mujoco.FatalError("mj_stackAlloc: insufficient memory")

    monkeypatch.setattr(mujoco, "mj_step", fail)
    with pytest.raises(UrdfkitError, match=r"MuJoCo cannot simulate it: mj_stackAlloc"):
        simulate(read(ROVER))


def test_progress_counts_the_tests() -> None:
    counts: list[tuple[int, int]] = []
    simulate(read(robot()), progress=lambda *count: counts.append(count))
    assert counts == [(done, 8) for done in range(8)]


def test_a_joint_starts_within_its_range() -> None:
    arm = robot(link("arm", at="0.5 0 0"), joint("arm", "world", "0 0 0"))
    lifted = Source("r.urdf", arm.data.replace(b'lower="-3"', b'lower="1"'))
    assert failures(lifted) == {}


#: Two links on continuous joints, which fall into a motion that takes short steps.
PENDULUM = (
    link("a", at="0.5 0 0"), joint("a", "world", "0 0 0", "continuous"),
    link("b", at="0.5 0 0"), joint("b", "a", "1 0 0", "continuous"),
)  # fmt: skip


@pytest.mark.parametrize(("step", "test"), [(0.02, "energy"), (0.1, "stability")])
def test_steps_that_are_too_coarse_are_blamed(
    step: float, test: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    from urdfkit.output.simulation import release

    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(release, "STEP", step)
    (failure,) = [one for one in simulate(read(robot(*PENDULUM))).verdicts if not one.passes]
    assert failure.test == test
    assert failure.message.endswith("but not with steps of 0.5 ms")
    assert failure.names == (("a",) if test == "stability" else ())
    assert list(tmp_path.iterdir()) == [], "MuJoCo writes no log"


def light_chain(mass: float) -> Source:
    """Four small links on hinges about different axes, of which the last one has 10 kg."""
    parts, axes = [], ("1 0 0", "0 1 0", "0 0 1", "1 0 0")
    for number, axis in enumerate(axes):
        part = link(f"k{number}", "0 0 0.05", 10 if number == 3 else mass)
        hinge = joint(f"k{number}", f"k{number - 1}" if number else "world", "0 0 0.1")
        hinge = hinge.replace("<origin", '<origin rpy="0.3 0.4 0"').replace("0 1 0", axis)
        parts += [part.replace("collision", "visual"), hinge]
    small = re.sub(rb'(ixx|iyy|izz)="[^"]*"', rb'\1="1e-9"', robot(*parts).data)
    return Source("r.urdf", small)


def test_links_that_are_too_light_are_the_cause_of_a_divergence() -> None:
    verdicts = {verdict.test: verdict for verdict in simulate(read(light_chain(1e-3))).verdicts}
    cause = ": link 'k0' has less than 0.0001 of the mass that it carries"
    stability, timestep = verdicts["stability"], verdicts["timestep"]
    assert not stability.passes
    assert stability.message.endswith(f", and with steps of 1 ms it diverges, too{cause}")
    assert stability.names == ("k0",)
    assert stability.span is not None
    assert stability.span.line == 2
    assert timestep.warns
    assert timestep.message.startswith("energy error without bound with steps of 2 ms, ")
    assert timestep.message.endswith(cause)


def test_the_energy_error_is_halved_with_the_step() -> None:
    arm = robot(link("arm", at="0.5 0 0"), joint("arm", "world", "0 0 0"))
    (verdict,) = [one for one in simulate(read(arm)).verdicts if one.test == "timestep"]
    errors = [float(number) for number in re.findall(r"([\d.]+) %", verdict.message)]
    assert errors[0] == pytest.approx(100 * verdict.value, rel=0.05)
    assert errors[1] == pytest.approx(errors[0] / 2, rel=0.1)


@pytest.mark.parametrize(("collision", "fails"), [("collision", True), ("visual", False)])
def test_a_robot_that_is_a_thousand_times_too_small(collision: str, fails: bool) -> None:
    """Lengths in mm that were divided by 1000 twice; without collisions its size is unknown."""
    arm = link("arm", at="0.0005 0 0").replace("0.1 0.1 0.1", "0.0001 0.0001 0.0001")
    source = robot(arm.replace("collision", collision), joint("arm", "world", "0 0 0"))
    assert ("size" in failures(source)) is fails


def test_what_coarse_steps_add_to_a_fast_motion_is_no_failure(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    from urdfkit.output.simulation import release

    monkeypatch.setattr(release, "STEP", 0.005)
    (energy,) = [one for one in simulate(read(robot(*PENDULUM))).verdicts if one.test == "energy"]
    assert energy.passes
    assert energy.value > 4 * energy.bound
    assert energy.message.endswith("but not with steps of 0.5 ms instead of 5")


def test_a_robot_on_wheels_stands_on_a_floor() -> None:
    assert simulate(ROVER).is_free
    assert not simulate(ROVER, base="fixed").is_free


def pendulum(
    effort: float = 100, more: str = "", moment: float = 0.01, mass: float = 1.0
) -> Source:
    """A link on a hinge, with its centre of mass on the axis."""
    moments = f'ixx="{moment}" ixy="0" ixz="0" iyy="{moment}" iyz="0" izz="{moment}"'
    arm = f'<link name="a"><inertial><mass value="{mass}"/><inertia {moments}/></inertial></link>'
    return robot(arm, joint("a", "world", "0 0 0", effort=effort, more=more))


@pytest.mark.parametrize(
    ("source", "fails"),
    [
        (pendulum(effort=100), False),
        (pendulum(effort=100, moment=600), False),
        (pendulum(effort=100, moment=6000), True),
        (pendulum(effort=0), True),
        (pendulum(effort=5, more='<dynamics friction="4"/>'), False),
        (pendulum(effort=5, more='<dynamics friction="6"/>'), True),
        (pendulum(effort=5, more='<dynamics damping="4"/>'), False),
        (pendulum(effort=5, more='<dynamics damping="500"/>'), True),
        (pendulum(effort=100, moment=1e-4), False),
        (pendulum(effort=100, moment=1e-9, mass=1e-6), True),
    ],
)
def test_a_joint_is_moved_by_its_effort_and_not_thrown(source: Source, fails: bool) -> None:
    found = failures(source)
    assert found == ({"drive": ("a",)} if fails else {})


def test_an_effort_that_equals_the_friction_is_a_warning() -> None:
    source = pendulum(effort=5, more='<dynamics friction="5"/>')
    assert failures(source) == {}
    assert warnings(source) == {"drive": ("a",)}


def test_a_joint_whose_simulation_diverges_has_no_speed() -> None:
    found = simulate(read(pendulum(effort=1e300)))
    (verdict,) = [one for one in found.verdicts if one.test == "drive"]
    assert verdict.message == (
        "joint 'a': driven by its effort of 1e+300 N·m, its simulation diverges"
    )


def test_negative_damping_drives_a_joint_even_at_its_equilibrium() -> None:
    arm = link("a", at="0 0 0"), joint("a", "world", "0 0 0", more='<dynamics damping="-1"/>')
    found = simulate(read(robot(*arm)))
    (verdict,) = [one for one in found.verdicts if not one.passes]
    assert verdict.message == "joint 'a' is driven by its damping of -1 N·m·s/rad"
    assert verdict.names == ("a",)


@pytest.mark.parametrize(("away", "jammed"), [(0.03, False), (0.01, True)])
def test_a_joint_that_links_jam(away: float, jammed: bool) -> None:
    """A slide of 6 m between two walls."""
    walls = [
        part
        for name, x in (("back", -0.1 - away), ("front", 0.1 + away))
        for part in (link(name), joint(name, "world", f"{x} 0 0", "fixed"))
    ]
    cart = link("cart"), joint("cart", "world", "0 0 0", "prismatic").replace("0 1 0", "1 0 0")
    data = robot(*walls, *cart).data.replace(b'"-3" upper="3"', b'"-2" upper="2"')
    found = [one for one in simulate(read(Source("r.urdf", data))).verdicts if one.test == "sweep"]
    (verdict,) = found
    assert verdict.passes is not jammed
    if jammed:
        assert set(verdict.names) in ({"back", "cart"}, {"cart", "front"})
        assert "joint 'cart' is jammed: at -0.02 m" in verdict.message


def dropped(*parts: str) -> tuple[bool, str]:
    text = f'<robot name="r">{"".join(parts)}</robot>'
    found = simulate(read(Source("r.urdf", text.encode())), base="free")
    (verdict,) = [one for one in found.verdicts if one.test == "drop"]
    return verdict.passes, verdict.message


def wheel(name: str, at: str) -> str:
    return link(name) + joint(name, "body", at, "continuous")


def test_a_robot_that_is_dropped() -> None:
    four = [wheel(f"w{x}{y}", f"{x} {y} -0.2") for x in (-0.3, 0.3) for y in (-0.3, 0.3)]
    passes, message = dropped(link("body"), *four)
    assert passes
    assert message.startswith("dropped from 50 mm, the robot lies on the floor after 3 s")
    passes, message = dropped(link("body", at="1.5 0 0.5", mass=100), *four)
    assert not passes
    assert "the robot tips over by" in message
    bare = link("body").replace("collision", "visual")
    assert dropped(bare) == (False, "no link has a <collision>: it falls through every floor")


def test_a_balancing_robot_may_fall() -> None:
    two = [wheel(f"w{y}", f"0 {y} -0.2") for y in (-0.3, 0.3)]
    assert dropped(link("body", at="0 0 1"), *two)[0]


def test_the_moments_of_a_release() -> None:
    arm = read(robot(link("a", at="0.5 0 0"), joint("a", "world", "0 0 0")))
    moments = motion(arm, base="auto", images=5)
    assert len(moments) == 5
    heights = [frames["a"].apply((0.5, 0, 0))[2] for frames in moments]
    assert heights[0] == pytest.approx(0)
    assert min(heights) < -0.3
    assert moments[0]["world"] == Transform()


@pytest.mark.parametrize(("height", "thrown"), [(0.2, True), (0.42, False)])
def test_links_that_overlap_are_a_warning_unless_they_throw_the_robot(
    height: float, thrown: bool, tmp_path: Path
) -> None:
    """A bowl with a ball in it, which its hull meets and the bowl itself does not."""
    trimesh = pytest.importorskip("trimesh")
    bowl = trimesh.creation.revolve([(0.4, -0.4), (0.5, -0.4), (0.5, 0.4), (0.4, 0.4), (0.4, -0.4)])
    bowl.export(tmp_path / "bowl.stl")
    mesh = '<collision><geometry><mesh filename="bowl.stl"/></geometry></collision></link>'
    parts = [
        link("a").replace("</link>", mesh),
        joint("a", "world", "0 0 0", "fixed"),
        link("b"),
        joint("b", "world", f"0 0 {height}", "prismatic").replace("0 1 0", "0 0 1"),
    ]
    (tmp_path / "r.urdf").write_bytes(robot(*parts).data)
    found = simulate(read(tmp_path / "r.urdf"), base="fixed").verdicts
    verdicts = {verdict.test: verdict for verdict in found}
    overlap, energy = verdicts["overlap"], verdicts["energy"]
    assert overlap.warns
    assert overlap.message.startswith("convex hulls of links 'a' and 'b' overlap by ")
    assert (energy.passes, energy.warns) == (not thrown, not thrown)
    assert energy.value > energy.bound
    assert "'a' and 'b' push each other away" in energy.message


def test_a_joint_that_another_joint_frees_is_not_jammed() -> None:
    """An arm that hangs between two walls, on a torso: lifted, it lets the torso turn."""
    walls = [
        part
        for name, x in (("back", -0.13), ("front", 0.13))
        for part in (link(name), joint(name, "world", f"{x} 0 -1", "fixed"))
    ]
    torso = joint("torso", "world", "0 0 0")
    arm = joint("arm", "torso", "0 0.2 0").replace("0 1 0", "1 0 0")
    parts = link("torso"), torso, link("arm", at="0 -0.2 -1"), arm
    (verdict,) = [
        one for one in simulate(read(robot(*walls, *parts))).verdicts if one.test == "sweep"
    ]
    assert verdict.passes
    fixed = arm.replace('type="revolute"', 'type="fixed"')
    (verdict,) = [
        one
        for one in simulate(read(robot(*walls, *parts[:3], fixed))).verdicts
        if one.test == "sweep"
    ]
    assert not verdict.passes
    assert "joint 'torso' is jammed: at -0.1 rad 'arm' and 'front'" in verdict.message


def test_visuals_are_not_loaded() -> None:
    mesh = '<visual><geometry><mesh filename="none.stl"/></geometry></visual></link>'
    arm = robot(link("arm").replace("</link>", mesh), joint("arm", "world", "0 0 0"))
    assert failures(arm) == {}


def test_a_root_without_mass_is_welded() -> None:
    """An arm that hangs below its mount does not stand on the floor."""
    arm = robot(link("arm", at="0 0 -0.5"), joint("arm", "mount", "0 0 0"), '<link name="mount"/>')
    hanging = Source("r.urdf", arm.data.replace(b'<link name="world"/>', b""))
    assert not simulate(read(hanging)).is_free
