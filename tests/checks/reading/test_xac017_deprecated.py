import pytest

from tests.naming import naming
from tests.reported import fixed
from tests.xacros import reported, xacro


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("sorted([2, 1])[0]", "python.sorted([2, 1])[0]"),
        ("[x for x in range(3)][1]", "[x for x in python.range(3)][1]"),
        ("dotify(dict(a=1)).a", "xacro.dotify(dict(a=1)).a"),
    ],
)
def test_a_function_that_moved(old: str, new: str) -> None:
    robot = xacro(f'<link name="l${{{old}}}"/>')
    (found,) = reported("XAC017", f'<link name="l${{{old}}}"/>')
    name = found.span.text
    assert found.message == naming(f"{name}()", "without")
    assert found.fix is not None
    assert found.fix.safe
    after = fixed("XAC017", robot, "robot.xacro")
    assert after == robot.replace(old, new)
    assert fixed("XAC017", after, "robot.xacro") == after


def test_functions_that_stay() -> None:
    assert reported("XAC017", '<link name="l${len([1]) + int(sin(0)) + max(1, 2)}"/>') == []
