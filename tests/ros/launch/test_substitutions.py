"""``$(eval ...)``: what is known without running it."""

import pytest

from urdfkit.ros.launch.substitutions import evaluate

ARGUMENTS = {"model": "cart", "sim": "true", "count": "2", "prefix": "", "rate": "1.5"}


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("find(arg('model') + '_description')", "/ws/cart_description"),
        ("model == 'cart'", "True"),
        ("arg('sim')", "True"),
        ("not sim", "False"),
        ("sim == true", "True"),
        ("sim == 'true'", "False"),  # roslaunch makes a bool of it first
        ("prefix != ''", "False"),
        ("count == 2", "True"),
        ("rate == 1.5 and model", "cart"),
        ("prefix or 'none'", "none"),
        ("'a' if sim else unknown", "a"),
        ("unknown", None),
        ("arg('unknown')", None),
        ("__import__('os')", None),
        ("().__class__", None),
        ("env('HOME')", None),
        ("rate * count", "3.0"),
        ("arg", None),
        ("'a' * 10**9", None),
        ("'a' + 1", None),
        ("(" * 5000, None),
        ("x = 1", None),
        ("", None),
        ("+".join(["'" + "a" * 1000 + "'"] * 9), None),
    ],
)
def test_the_value_of_an_expression(text: str, value: str | None) -> None:
    assert evaluate(text, ARGUMENTS, {"find": lambda name: f"/ws/{name}"}) == value
