"""GEO015: see the rule."""

from tests.reported import messages, places

BODY = '<collision><origin xyz="{} 0 0"/><geometry><sphere radius="0.1"/></geometry></collision>\n'


def link(*bodies: str) -> str:
    return f'<link name="a">\n{"".join(bodies)}</link>'


def test_one_shape_twice() -> None:
    text = link(BODY.format(1), BODY.format(2), BODY.format(1))
    assert messages("GEO015", text) == ["link 'a' has the same collision twice at one place"]
    assert [line for line, _ in places("GEO015", text)] == [5]


def test_a_visual_and_its_collision_are_calm() -> None:
    visual = BODY.format(1).replace("collision", "visual")
    assert messages("GEO015", link(BODY.format(1), visual)) == []
    assert messages("GEO015", link(BODY.format(1), BODY.format(2))) == []


def test_two_meshes_at_one_place_are_two_shapes() -> None:
    mesh = '<visual><geometry><mesh filename="{}.stl"/></geometry></visual>\n'
    assert messages("GEO015", link(mesh.format("a"), mesh.format("b"))) == []
    assert len(messages("GEO015", link(mesh.format("a"), mesh.format("a")))) == 1
