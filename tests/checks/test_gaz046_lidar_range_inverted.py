"""GAZ046: see the rule."""

import pytest

from tests.sensing import findings, scan


@pytest.mark.parametrize(
    ("least", "most", "count"), [(10, 0.1, 1), (1, 1, 1), (0.1, 10, 0), (0, 0.5, 0)]
)
def test_the_least_must_be_below_the_greatest(least, most, count):
    found = findings("GAZ046", "ray", scan(-1, 1, least=least, most=most))
    assert len(found) == count
    assert all(finding.span.text == "<min>" for finding in found)
