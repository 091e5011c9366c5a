from __future__ import annotations

from collections import Counter

import pytest

from tests.reported import messages, reported
from urdfkit.checks.tree.tre009_deep_chain import MAX_DEPTH
from urdfkit.lint.runner import MAX_FINDINGS
from urdfkit.robot.tree import MAX_LOOPS


def chain(depth: int) -> str:
    return '<link name="l0"/>' + "".join(
        f'<link name="l{n}"/><joint name="j{n}" type="continuous">'
        f'<parent link="l{n - 1}"/><child link="l{n}"/></joint>\n'
        for n in range(1, depth + 1)
    )


@pytest.mark.parametrize(("depth", "count"), [(MAX_DEPTH, 0), (MAX_DEPTH + 1, 1)])
def test_the_bound(depth: int, count: int) -> None:
    assert messages("TRE009", chain(depth)) == count * [
        (
            f"link 'l{depth}' is {depth} joints below 'l0'; more than 1000 are too many for some "
            "programs"
        )
    ]


def test_many_joints_side_by_side_are_not_deep() -> None:
    joints = "".join(
        f'<link name="l{n}"/><joint name="j{n}" type="fixed">'
        f'<parent link="l0"/><child link="l{n}"/></joint>'
        for n in range(1, 3000)
    )
    assert reported("TRE009", f'<link name="l0"/>{joints}') == []


def test_a_long_chain_has_no_other_finding_of_the_tree() -> None:
    """Of a hundred thousand links the tests of bad input tell."""
    found = reported("TRE", chain(10_000))
    assert [(one.code, one.element) for one in found] == [("TRE009", "link/l10000")]


def test_as_many_loops_as_links_through_every_rule_of_the_tree() -> None:
    size = 5_000
    back = "".join(
        f'<joint name="back{n}" type="fixed"><parent link="l{n}"/><child link="l0"/></joint>'
        for n in range(1, size + 1)
    )
    found = Counter(one.code for one in reported("TRE", chain(size) + back))
    assert found == {"TRE003": MAX_LOOPS, "TRE004": MAX_FINDINGS}
