"""Substitutions of ROS 2 that compare, combine or choose, against ros2/launch."""

import pytest

from urdfkit.ros.launch.computed import computed, evaluated


@pytest.mark.parametrize(
    ("name", "texts", "result"),
    [
        ("equals", ("gz", "gz"), "true"),
        ("equals", ("gz", "GZ"), "false"),
        ("equals", ("True", "1"), "true"),
        ("equals", ("1.0", "1"), "true"),
        ("equals", ("gz", None), None),
        ("equals", ("gz",), None),
        ("not-equals", ("gz", "classic"), "true"),
        ("not", ("False",), "true"),
        ("not", ("perhaps",), None),
        ("and", ("true", "false"), "false"),
        ("and", (None, "false"), "false"),
        ("and", (None, "true"), None),
        ("or", (None, "on"), "true"),
        ("or", (None, "off"), None),
        ("all", ("true", "yes", "true"), "true"),
        ("any", ("false", "no"), "false"),
        ("if", ("true", "mecanum.yaml", "diff.yaml"), "mecanum.yaml"),
        ("if", ("false", "mecanum.yaml", "diff.yaml"), "diff.yaml"),
        ("if", ("false", "mecanum.yaml"), ""),
        ("if", (None, "mecanum.yaml", "diff.yaml"), None),
        ("if", ("false", None, "diff.yaml"), "diff.yaml"),
        ("eval", ("'mecanum.yaml' if False else 'diff.yaml'",), "diff.yaml"),
        ("eval", (None,), None),
        ("anon", ("talker",), None),
    ],
)
def test_substitutions(name: str, texts: tuple[str | None, ...], result: str | None) -> None:
    assert computed(name, texts) == result


@pytest.mark.parametrize(
    ("expression", "result"),
    [
        ("'ur' + str(5) + 'e'", "ur5e"),
        ("'gz' == 'gz' and not False", "True"),
        ("round(cos(0) + sqrt(4), 1)", "3.0"),
        ("true", None),  # no name of Python
        ("__import__('os').getcwd()", None),
        ("'a' * 10**9", None),
        ("sin", None),
    ],
)
def test_expressions(expression: str, result: str | None) -> None:
    assert evaluated(expression) == result
