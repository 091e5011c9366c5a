from __future__ import annotations

import pytest

from tests.massive import BOX, link, shape
from tests.reported import messages, places


def mesh(scale: str) -> str:
    return link("arm", shape("collision", f'<mesh filename="a.stl" scale="{scale}"/>'))


def test_the_factors_are_told() -> None:
    assert messages("GEO005", mesh("0.001 0 0.001")) == [
        "link 'arm': the mesh of its collision is scaled by 0.001 0 0.001"
    ]
    assert places("GEO005", mesh("0 0 0")) == [(2, "0 0 0")]


@pytest.mark.parametrize("scale", ["1 1 1", "1e-9 1 1", "-1 1 1", "0", "0 1", "x 0 0"])
def test_what_is_all_right_or_another_rule_s(scale: str) -> None:
    assert messages("GEO005", mesh(scale)) == []
    assert (
        messages("GEO005", link("a", shape("visual", BOX.replace("/>", ' scale="0 0 0"/>')))) == []
    )
