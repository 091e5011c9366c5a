from __future__ import annotations

import pytest

from tests.xacros import reported, xacro
from urdfkit.lint import engine
from urdfkit.text.source import Source


@pytest.mark.parametrize(
    ("body", "message"),
    [
        (
            '<link name="${().__class__}"/>',
            "refused: attribute '__class__' is not allowed in expressions in ${().__class__}",
        ),
        (
            '<link name="${(lambda: 1)()}"/>',
            "refused: Lambda is not allowed in expressions in ${(lambda: 1)()}",
        ),
        (
            "<link name=\"${__import__('os')}\"/>",
            "refused: name '__import__' is not allowed in expressions in ${__import__('os')}",
        ),
    ],
)
def test_an_expression_that_no_model_needs(body: str, message: str) -> None:
    (found,) = reported("XAC009", body)
    assert found.message == message
    assert found.span.text in body


def test_a_variable_of_the_environment(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SECRET_TOKEN", "hunter2")
    (found,) = reported("XAC009", '<link name="$(env SECRET_TOKEN)"/>')
    assert found.span.text == "$(env SECRET_TOKEN)"
    assert "SECRET_TOKEN" in found.message
    assert "hunter2" not in found.message


def test_variables_of_ros_are_readable(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROBOT_NAME", "r2")
    assert reported("XAC009", '<link name="$(env ROBOT_NAME)"/>') == []


def test_trusted(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("SECRET_TOKEN", "a")
    source = Source("robot.xacro", xacro('<link name="$(env SECRET_TOKEN)"/>').encode())
    assert engine.check(source, select=["XAC"], trust=True).diagnostics == ()


@pytest.mark.parametrize(
    "expression",
    [
        "1 + 2 * 3 ** 2",
        "sin(radians(30))",
        "'a' if 1 &lt; 2 else 'b'",
        "[x * 2 for x in range(3)][1]",
        "dict(a=1)['a']",
        "'left'.replace('l', 'L')",
        "str(1) + 'a'",
        "'%0.2f' % 1.5",
    ],
)
def test_what_models_do(expression: str) -> None:
    assert reported("XAC009", f'<link name="l${{{expression}}}"/>') == []
