import pytest

from tests.massive import BOX, link, shape
from tests.naming import naming
from tests.reported import messages, places, reported
from urdfkit.text.diagnostic import Severity


@pytest.mark.parametrize(
    ("geometry", "expected"),
    [
        ('<box size="1 -2 -3"/>', ("<box>", "size", "1 -2 -3 m")),
        ('<sphere radius="-0.1"/>', ("<sphere>", "radius", "-0.1 m")),
        ('<cylinder radius="1" length="-2"/>', ("<cylinder>", "length", "-2 m")),
        ('<cylinder radius="-1"/>', ("<cylinder>", "radius", "-1 m")),
        ('<capsule radius="2" length="-1"/>', ("<capsule>", "length", "-1 m")),
    ],
)
def test_every_primitive(geometry: str, expected: tuple[str, str, str]) -> None:
    assert messages("GEO001", link("arm", shape("collision", geometry))) == [
        naming("arm", expected[0], "collision", *expected[1:])
    ]


def test_the_place_is_the_value_of_each() -> None:
    robot = link("arm", shape("visual", '<cylinder radius="-1" length="-2"/>'))
    assert places("GEO001", robot) == [(2, "-1"), (2, "-2")]


@pytest.mark.parametrize(
    "geometry",
    [
        '<box size="1 2 -"/>',  # URD005
        '<box size="-1 2"/>',  # URD006
        '<sphere radius="1" length="-1"/>',  # URD002
    ],
)
def test_what_another_rule_reports(geometry: str) -> None:
    assert messages("GEO001", link("arm", shape("collision", geometry))) == []


EMPTY = link("tool", shape("collision", '<box size="0 0 0"/>'))


@pytest.mark.parametrize(
    ("geometry", "expected"),
    [
        ('<box size="0 0 0"/>', ("<box>", "size", "0 0 0 m")),
        ('<box size="1 1 0"/>', ("<box>", "size", "1 1 0 m")),
        ('<sphere radius="0"/>', ("<sphere>", "radius", "0 m")),
        ('<cylinder radius="1" length="0"/>', ("<cylinder>", "length", "0 m")),
        ('<capsule radius="1" length="0"/>', ("<capsule>", "length", "0 m")),
    ],
)
def test_zero(geometry: str, expected: tuple[str, str, str]) -> None:
    assert messages("GEO001", link("tool", shape("collision", geometry))) == [
        naming("tool", expected[0], "collision", *expected[1:])
    ]


def test_the_place_of_zero() -> None:
    assert places("GEO001", EMPTY) == [(2, "0 0 0")]


@pytest.mark.parametrize("geometry", ['<box size="1 1 1e-9"/>', ""])
def test_a_small_extent(geometry: str) -> None:
    assert messages("GEO001", link("tool", shape("collision", geometry))) == []


@pytest.mark.parametrize(
    ("target", "severity"),
    [("drake", Severity.INFO), ("gz-harmonic", Severity.INFO), ("mujoco", Severity.ERROR)],
)
def test_the_severity_of_zero(target: str, severity: Severity) -> None:
    (found,) = reported("GEO001", EMPTY, targets=(target,))
    assert found.severity is severity


def mesh(scale: str) -> str:
    return link("arm", shape("collision", f'<mesh filename="a.stl" scale="{scale}"/>'))


def test_a_zero_scale() -> None:
    assert messages("GEO001", mesh("0.001 0 0.001")) == [
        naming("arm", "<mesh>", "collision", "0.001 0 0.001")
    ]
    assert places("GEO001", mesh("0 0 0")) == [(2, "0 0 0")]


@pytest.mark.parametrize("scale", ["1 1 1", "1e-9 1 1", "0", "0 1", "x 0 0"])
def test_other_scales(scale: str) -> None:
    assert messages("GEO001", mesh(scale)) == []
    assert (
        messages("GEO001", link("a", shape("visual", BOX.replace("/>", ' scale="0 0 0"/>')))) == []
    )
