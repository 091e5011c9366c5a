from tests.massive import context
from urdfkit.robot.assets.colours import Colours

RED = '<color rgba="1 0 0 1"/>'
BLUE = '<color rgba="0 0 1 1"/>'
TEXTURE = '<texture filename="t.png"/>'


def material(name: str, look: str = "") -> str:
    named = f' name="{name}"' if name else ""
    return f"<material{named}>{look}</material>"


def seen(name: str, paint: str = "") -> str:
    ball = '<geometry><sphere radius="1"/></geometry>'
    return f'<link name="{name}"><visual>{ball}{paint}</visual></link>'


def looks(text: str) -> list[tuple[str, tuple[float, ...] | None, str | None]]:
    """Link, colour and texture of every visual that has one."""
    return [
        (
            link.name,
            material.rgba.value if material.rgba else None,
            material.texture.value if material.texture else None,
        )
        for link, _, material in Colours(context(text).model).visuals()
    ]


def test_the_first_definition_of_a_name_holds_everywhere() -> None:
    assert looks(
        seen("a", material("paint"))
        + seen("b", material("paint", RED))
        + seen("c", material("paint", BLUE))
    ) == [(name, (1, 0, 0, 1), None) for name in "abc"]


def test_the_top_of_the_robot_comes_first() -> None:
    robot = seen("a", material("paint", RED)) + material("paint", BLUE)
    assert looks(robot) == [("a", (0, 0, 1, 1), None)]


def test_what_has_an_empty_name_stands_for_itself() -> None:
    paints = (f'<material name="">{look}</material>' for look in (RED, BLUE))
    robot = "".join(seen(name, paint) for name, paint in zip("ab", paints, strict=True))
    assert looks(robot) == [("a", (1, 0, 0, 1), None), ("b", (0, 0, 1, 1), None)]


def test_materials_without_a_name_or_a_look() -> None:
    assert looks(
        seen("a", material("", RED))
        + seen("b", material("unknown"))
        + seen("c")
        + seen("d", material("m", TEXTURE))
    ) == [("a", (1, 0, 0, 1), None), ("d", None, "t.png")]
