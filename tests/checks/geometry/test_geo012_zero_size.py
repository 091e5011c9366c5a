from __future__ import annotations

import pytest

from tests.massive import link, shape
from tests.reported import messages, places
from urdfkit.lint import engine
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source

EMPTY = link("tool", shape("collision", '<box size="0 0 0"/>'))


@pytest.mark.parametrize(
    ("geometry", "expected"),
    [
        ('<box size="0 0 0"/>', "the <box> in its collision has size 0 0 0 m"),
        ('<box size="1 1 0"/>', "the <box> in its collision has size 1 1 0 m"),
        ('<sphere radius="0"/>', "the <sphere> in its collision has radius 0 m"),
        ('<cylinder radius="1" length="0"/>', "the <cylinder> in its collision has length 0 m"),
        ('<capsule radius="1" length="0"/>', "the <capsule> in its collision has length 0 m"),
    ],
)
def test_every_primitive(geometry: str, expected: str) -> None:
    assert messages("GEO012", link("tool", shape("collision", geometry))) == [
        f"link 'tool': {expected}"
    ]


def test_the_place_is_the_value() -> None:
    assert places("GEO012", EMPTY) == [(2, "0 0 0")]


@pytest.mark.parametrize("geometry", ['<box size="1 1 1e-9"/>', '<box size="0 -1 1"/>', ""])
def test_what_has_an_extent_or_is_another_rule_s(geometry: str) -> None:
    assert messages("GEO012", link("tool", shape("collision", geometry))) == []


@pytest.mark.parametrize(
    ("target", "severity"),
    [("drake", Severity.INFO), ("gz-harmonic", Severity.INFO), ("mujoco", Severity.ERROR)],
)
def test_who_suffers(target: str, severity: Severity) -> None:
    source = Source("robot.urdf", whole_robot(EMPTY).encode())
    (found,) = engine.check(source, select=["GEO012"], targets=[target]).diagnostics
    assert found.severity is severity
