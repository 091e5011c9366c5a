from pathlib import Path

import pytest

from tests.workspaces import add_package
from urdfkit.text.source import Source
from urdfkit.workspace.package_references import package_references, references_of_package
from urdfkit.workspace.resolve import Resolver


def found(text: str) -> list[tuple[str, str, str]]:
    source = Source("r.xacro", text.encode())
    return [(one.package, one.relative, one.span.text) for one in package_references(source)]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ('"package://arm/meshes/a.stl"', ("arm", "meshes/a.stl", "package://arm/meshes/a.stl")),
        ("'$(find arm)/urdf/a.xacro'", ("arm", "urdf/a.xacro", "$(find arm)/urdf/a.xacro")),
        ("<p>$(find  arm )/c.yaml</p>", ("arm", "c.yaml", "$(find  arm )/c.yaml")),
        ('"$(find arm)"', ("arm", "", "$(find arm)")),
        (
            '"package://arm/meshes/${type}/a.stl"',
            ("arm", "meshes", "package://arm/meshes/${type}/"),
        ),
        ('"$(find arm)/urdf/${x}.xacro"', ("arm", "urdf", "$(find arm)/urdf/${x}.xacro")),
        ('"package://${arm}/a.stl"', None),
        ('"$(find $(arg p))/a.xacro"', None),
        ("<!-- package://arm/a.stl -->", None),
        ("<!-- \n$(find arm) -- > -->", None),
    ],
)
def test_what_is_mentioned(text: str, expected: tuple[str, str, str] | None) -> None:
    result = found(text)
    if expected is None:
        assert result == []
    else:
        assert [one[:2] for one in result] == [expected[:2]]
        assert result[0][2].startswith(expected[2])


def test_only_the_texts_of_the_own_package_count(tmp_path: Path) -> None:
    arm, hand = add_package(tmp_path / "arm", "arm"), add_package(tmp_path / "hand", "hand")
    sources = (
        Source(str(arm / "a.xacro"), b"$(find hand)/h.xacro"),
        Source(str(hand / "h.xacro"), b"$(find motors)/m.xacro"),
    )
    packages = Resolver(environment={}).packages
    assert [one.package for one in references_of_package(sources, packages)] == ["hand"]
    assert [one.package for one in references_of_package(sources[1:], packages)] == ["motors"]
