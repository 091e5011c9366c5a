from pathlib import Path

import pytest

from tests.jointed import joint, robot
from tests.naming import naming
from tests.reported import fixed, messages, places, reported
from tests.urdfdom import needs_check_urdf, urdfdom_reads
from urdfkit.text.schema import JOINT_TYPES

LIMIT = '<limit lower="-1" upper="1" effort="1" velocity="1"/>'


@pytest.mark.parametrize(
    ("kind", "suggested"),
    [
        ("Revolute", "revolute"),
        (" fixed", "fixed"),
        ("continous", "continuous"),
        ("PRISMATIC", "prismatic"),
        ("spherical", None),
        ("hinge", None),
        ("ball", None),
        ("", None),
    ],
)
def test_an_unknown_type_is_reported_and_fixed_if_it_is_a_typo(
    kind: str, suggested: str | None
) -> None:
    text = robot(joint("j", kind, LIMIT))
    assert messages("JNT001", text) == [naming("j", kind, *([suggested] if suggested else []))]
    assert places("JNT001", text) == [(4, kind)]
    if suggested:
        assert f'type="{suggested}"' in fixed("JNT001", text)
    else:
        assert reported("JNT001", text)[0].fix is None


@pytest.mark.parametrize("kind", JOINT_TYPES)
def test_the_types_of_urdf_are_known(kind: str) -> None:
    assert reported("JNT001", robot(joint("j", kind, LIMIT))) == []


def test_other_rules_tell_a_missing_type_and_an_expression() -> None:
    assert reported("JNT001", robot(joint("j", "fixed")).replace(' type="fixed"', "")) == []
    assert reported("JNT001", robot(joint("j", "${kind}"))) == []


@needs_check_urdf
@pytest.mark.parametrize("kind", ["Revolute", " fixed", "spherical", "", *JOINT_TYPES])
def test_urdfdom_agrees(kind: str, tmp_path: Path) -> None:
    text = robot(joint("j", kind, LIMIT))
    assert urdfdom_reads(text, tmp_path) == (reported("JNT001", text) == [])
