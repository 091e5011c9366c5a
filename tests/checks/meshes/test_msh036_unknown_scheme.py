"""MSH036: see the rule."""

import pytest

from tests.reported import fixed, messages
from tests.workspaces import mesh_link


def test_a_slip_is_told_and_mended() -> None:
    text = mesh_link("packge://p/meshes/arm.stl")
    (message,) = messages("MSH036", text)
    assert message.startswith("link 'arm': the visual mesh 'packge://p/meshes/arm.stl' begins with")
    assert message.endswith("'packge://', which no reader knows")
    assert 'filename="package://p/meshes/arm.stl"' in fixed("MSH036", text)


def test_capitals_are_another_scheme() -> None:
    text = mesh_link("Package://p/meshes/arm.stl")
    assert len(messages("MSH036", text)) == 1
    assert 'filename="package://p/meshes/arm.stl"' in fixed("MSH036", text)


def test_one_that_is_like_none_is_told_without_a_remedy() -> None:
    assert len(messages("MSH036", mesh_link("s3://bucket/arm.stl"))) == 1


@pytest.mark.parametrize(
    "name",
    ["package://p/a.stl", "model://a.stl", "file:///a.stl", "https://x.org/a.stl", "meshes/a.stl"],
)
def test_what_readers_know_is_calm(name: str) -> None:
    assert messages("MSH036", mesh_link(name)) == []
