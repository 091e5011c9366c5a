"""JNT033: see the rule."""

from pathlib import Path

import pytest

from tests import meshed
from tests.growth import executed_lines
from tests.naming import naming
from tests.reported import messages, places
from urdfkit.mesh import samples

WHEEL = """\
<link name="base"/><link name="{name}"><collision><origin rpy="{rpy}"/>
<geometry><cylinder radius="0.1" length="{length}"/></geometry></collision></link>
<joint name="j" type="{kind}"><parent link="base"/><child link="{name}"/>
<axis xyz="{axis}"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>"""


def robot(
    axis: str = "0 1 0",
    rpy: str = "1.5708 0 0",
    name: str = "wheel",
    kind: str = "continuous",
    length: str = "0.04",
) -> str:
    return WHEEL.format(axis=axis, rpy=rpy, name=name, kind=kind, length=length)


def test_the_axis_or_the_shape_lies_across() -> None:
    (message,) = messages("JNT033", robot("1 0 0"))
    assert message == naming("j", "wheel", "1 0 0", "collision", "0 -1 0")
    assert messages("JNT033", robot("0 0 1"))
    assert messages("JNT033", robot(rpy="0 0 0"))


@pytest.mark.parametrize("name", ["left_propeller", "prop_1", "rotor2"])
def test_a_propeller_across_its_disc(name: str) -> None:
    """The propellers of a WAM-V, whose disc lies across the boat."""
    (message,) = messages("JNT033", robot("0 0 1", "0 1.5708 0", name))
    assert message == naming("j", name, "0 0 1", "collision", "1 0 0")
    assert messages("JNT033", robot("1 0 0", "0 1.5708 0", name)) == []
    assert messages("JNT033", robot("0 0 1", "0 1.5708 0", "proposal")) == []


@pytest.mark.parametrize(
    "sound",
    [
        robot(),
        robot("0 -1 0"),
        robot("0 0 1", "0 0 0"),
        robot("0 0 1", kind="revolute"),  # it is steered
        robot(kind="revolute", name="arm"),
        robot(kind="revolute").replace('lower="-1" upper="1"', 'lower="-1e3" upper="1e3"'),
        robot("0 0 1", name="caster_wheel"),
        robot("1 0 0", name="arm"),
        robot("1 0 0", length="0.5"),  # a roller, or a leg
    ],
)
def test_what_rolls_or_is_steered_is_calm(sound: str) -> None:
    assert messages("JNT033", sound) == []


@pytest.mark.parametrize(
    ("edges", "axis", "reported"),
    [
        ((0.2, 0.05, 0.2), "1 0 0", True),
        ((0.2, 0.05, 0.2), "0 1 0", False),
        ((0.2, 0.05, 0.21), "1 0 0", True),
        ((0.2, 0.05, 0.3), "1 0 0", False),  # no wheel alone
        ((0.2, 0.19, 0.2), "1 0 0", False),  # a ball, or a drum
    ],
)
def test_the_short_edge_of_a_mesh_is_its_axle(
    edges: tuple[float, float, float], axis: str, reported: bool, tmp_path: Path
) -> None:
    for library in ("numpy", "lxml", "manifold3d"):
        pytest.importorskip(library)
    low, high = ((s * edges[0], s * edges[1], s * edges[2]) for s in (-0.5, 0.5))
    wheel = meshed.link(meshed.mesh("wheel.stl"), name="wheel")
    joint = (
        '<link name="base"/><joint name="j" type="continuous"><parent link="base"/>'
        f'<child link="wheel"/><axis xyz="{axis}"/></joint>'
    )
    files = {"wheel.stl": samples.stl(samples.box(low, high))}
    said = meshed.messages(tmp_path, "JNT033", wheel + joint, files)
    assert said == ([naming("j", "wheel", "1 0 0", "collision", "0 1 0")] if reported else [])


def test_a_wheel_with_position_limits() -> None:
    text = robot(kind="revolute")
    (message,) = messages("JNT033", text)
    assert message == naming("j", "wheel", "revolute", "[-1, 1] rad")
    assert [at for _, at in places("JNT033", text)] == ["revolute"]


def test_the_wheels_of_a_link_are_compared_with_few_others() -> None:
    """3,000 wheels on one link took 17 s."""

    def lines(number: int) -> int:
        text = '<link name="base"/>' + "".join(
            f'<link name="wheel_{n}"><collision><geometry><cylinder radius="0.1" length="0.04"/>'
            f'</geometry></collision></link><joint name="j{n}" type="continuous">'
            f'<parent link="base"/><child link="wheel_{n}"/><origin xyz="{n} 0 0"/>'
            '<axis xyz="0 1 0"/></joint>'
            for n in range(number)
        )
        return executed_lines(lambda: messages("JNT033", text))

    assert lines(400) < 50 * lines(10)
