"""GEO004, size: see the rule."""

from pathlib import Path

import pytest

from tests import meshed
from tests.massive import joint, link, shape
from tests.naming import naming
from tests.reported import messages, places
from urdfkit.core.spatial import Vector
from urdfkit.mesh.samples import box, stl
from urdfkit.text.diagnostic import Severity

HAND = '<box size="0.1 0.2 0.3"/>'


def pair(seen: str, touched: str) -> str:
    return link("a", shape("visual", seen), shape("collision", touched))


@pytest.mark.parametrize(
    ("seen", "larger", "factor", "smaller", "size"),
    [
        ('<box size="100 200 300"/>', "visual", "1000", "collision", "100 x 200 x 300 m"),
        ('<box size="2.54 5.08 7.62"/>', "visual", "25.4", "collision", "2.54 x 5.08 x 7.62 m"),
        ('<box size="0.01 0.02 0.03"/>', "collision", "10", "visual", "0.01 x 0.02 x 0.03 m"),
        ('<box size="0.6 1.2 1.8"/>', "visual", "6", "collision", "0.6 x 1.2 x 1.8 m"),
    ],
)
def test_a_factor_in_every_direction(
    seen: str, larger: str, factor: str, smaller: str, size: str
) -> None:
    (message,) = messages("GEO004", pair(seen, HAND))
    shapes = (size, "visual", "0.1 x 0.2 x 0.3 m", "collision")
    assert message == naming("a", larger, factor, smaller, *shapes)


@pytest.mark.parametrize(
    "seen",
    [
        '<box size="0.4 0.8 1.2"/>',  # a margin
        '<box size="0.1 2 3"/>',  # a beam, and a pad on it
        '<box size="0.005 0.005 0.005"/>',  # a marker
        '<box size="100 200 0"/>',
        "",
    ],
)
def test_what_may_be_intended(seen: str) -> None:
    assert messages("GEO004", pair(seen, HAND)) == []


def test_the_one_that_is_not_of_the_size_of_the_robot_is_named() -> None:
    rest = link("b") + joint("a", "b", xyz="0 0 0.3")
    for seen, touched in ((HAND, '<box size="100 200 300"/>'), ('<box size="1 2 3"/>', HAND)):
        ((_, text),) = places("GEO004", pair(seen, touched) + rest)
        assert text == (touched if seen == HAND else seen)


def test_two_meshes_of_one_part_differ_less(tmp_path: Path) -> None:
    for library in ("numpy", "lxml", "manifold3d"):
        pytest.importorskip(library)

    def said(more: str) -> list[str]:
        robot = meshed.link(meshed.mesh("a.stl", "visual", more), meshed.mesh("b.stl"))
        files = {"a.stl": meshed.SOUND, "b.stl": meshed.SOUND}
        return meshed.messages(tmp_path, "GEO004", robot, files)

    sizes = ("0.2 x 0.2 x 0.6 m", "visual", "0.1 x 0.1 x 0.3 m", "collision")
    assert said(' scale="2 2 2"') == [naming("arm", "visual", "2", "collision", *sizes)]
    assert said(' scale="0.001 0.001 0.001"')[0].startswith("link 'arm': the collision is")
    assert said(' scale="1.4 1.4 1.4"') == said(' scale="2 2 2.5"') == []


@pytest.mark.parametrize(
    ("size", "severity"),
    [(0.015, Severity.INFO), (0.01, Severity.WARNING), (2.0, Severity.WARNING)],
)
def test_a_primitive_that_is_small_on_purpose(
    tmp_path: Path, size: float, severity: Severity
) -> None:
    """Unitree's H1-2: a cylinder of 2 cm in place of the mesh of the hip, and no unit confused."""
    for library in ("numpy", "lxml", "manifold3d"):
        pytest.importorskip(library)
    cube = stl(box((0, 0, 0), (0.1, 0.1, 0.1)))
    small = shape("collision", f'<box size="{size} {size} {size}"/>', xyz="0.05 0.05 0.05")
    robot = meshed.link(meshed.mesh("a.stl", "visual"), small)
    (found,) = meshed.reported(tmp_path, "GEO004", robot, {"a.stl": cube})
    assert found.severity is severity


@pytest.mark.parametrize(
    ("factor", "why"),
    [
        (1000, "millimetres"),
        (100, "centimetres"),
        (39.37, "inches read as metres"),
        (25.4, "inches read as millimetres"),
        (10, "a decimal point"),
    ],
)
def test_the_units_that_were_confused(factor: float, why: str) -> None:
    def said(times: float) -> str:
        (message,) = messages(
            "GEO004", pair(f'<box size="{0.1 * times} {0.2 * times} {0.3 * times}"/>', HAND)
        )
        return message

    assert f", as by {why}" in said(factor)
    assert why in said(1.05 * factor)
    assert why in said(factor / 1.05)
    assert "as by" not in said(1.12 * factor)
    assert "as by" not in said(factor / 1.12)


@pytest.mark.parametrize(
    ("box", "found"),
    [
        ("0.0001 0.0002 0.0003", 1),
        ("0.00012 0.0002 0.0002", 1),  # a similar shape
        ("0.001 0.001 0.001", 0),  # a marker
        ("0.0002 0.0002 0.0002", 0),
        ("0.0003 0.0002 0.0001", 0),
    ],
)
def test_a_shape_that_is_a_thousand_times_too_small(box: str, found: int) -> None:
    seen = '<box size="0.1 0.2 0.3"/>'
    assert len(messages("GEO004", pair(seen, f'<box size="{box}"/>'))) == found


@pytest.mark.parametrize(("size", "count"), [((5e-4, 5e-4, 5e-4), 0), ((1e-4, 2e-4, 3e-4), 1)])
def test_a_tiny_cube_is_a_placeholder(tmp_path: Path, size: Vector, count: int) -> None:
    """Unitree's B2: the visual of its head is a cube of half a millimetre."""
    for library in ("numpy", "lxml", "manifold3d"):
        pytest.importorskip(library)
    robot = meshed.link(meshed.mesh("a.stl", "visual"), shape("collision", HAND))
    files = {"a.stl": stl(box((0, 0, 0), size))}
    assert len(meshed.messages(tmp_path, "GEO004", robot, files)) == count
