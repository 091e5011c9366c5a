from pathlib import Path

import pytest

from tests.naming import naming
from tests.workspaces import add_package
from tests.xacros import reported, told_of, write, xacro
from urdfkit.lint import engine
from urdfkit.text.source import Source


@pytest.mark.parametrize(
    ("body", "message"),
    [
        (
            '<link name="${().__class__}"/>',
            naming("rejected", "__class__", "${().__class__}"),
        ),
        (
            '<link name="${(lambda: 1)()}"/>',
            naming("rejected", "${(lambda: 1)()}"),
        ),
        (
            "<link name=\"${__import__('os')}\"/>",
            naming("rejected", "__import__", "${__import__('os')}"),
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


@pytest.mark.parametrize(
    "body",
    [
        '<xacro:include filename="/etc/hostname"/>',
        "<link name=\"${xacro.load_yaml('/etc/hostname')}\"/>",
    ],
)
def test_a_file_of_the_machine(body: str) -> None:
    (found,) = reported("XAC009", body)
    assert "outside the workspace" in found.message
    assert "/etc/hostname" in found.span.text


def test_a_device() -> None:
    (found,) = reported("XAC009", '<xacro:include filename="/dev/zero"/>')
    assert found.message == naming("/dev/zero", "pipe")


def test_a_link_that_leads_outside(tmp_path: Path) -> None:
    directory = add_package(tmp_path / "ws" / "arm", "arm")
    (directory / "inner.xacro").symlink_to("/etc/hostname")
    write(directory, robot='<xacro:include filename="inner.xacro"/><link name="a"/>')
    (found,) = told_of("XAC009", directory / "robot.xacro")
    assert found.span.text == "inner.xacro"


def test_a_file_that_does_not_exist_is_missing_wherever_it_is() -> None:
    assert reported("XAC009", '<xacro:include filename="/home/bob/ws/arm.xacro"/>') == []
    (found,) = reported("XAC001", '<xacro:include filename="/home/bob/ws/arm.xacro"/>')
    assert found.message == "file not found: /home/bob/ws/arm.xacro"


def test_a_trusted_model_includes_any_file(tmp_path: Path) -> None:
    outside = tmp_path / "outside.xacro"
    write(tmp_path, outside='<link name="a"/>')
    directory = add_package(tmp_path / "a" / "b" / "c" / "d" / "arm", "arm")
    write(directory, robot=f'<xacro:include filename="{outside}"/>')
    assert len(told_of("XAC009", directory / "robot.xacro")) == 1
    assert engine.check(directory / "robot.xacro", select=["XAC"], trust=True).diagnostics == ()


def test_a_neighbour_of_the_package(tmp_path: Path) -> None:
    directory = add_package(tmp_path / "ws" / "arm", "arm")
    write(add_package(tmp_path / "ws" / "common", "common"), part='<link name="a"/>')
    write(directory, robot='<xacro:include filename="../common/part.xacro"/>')
    assert told_of("XAC009", directory / "robot.xacro") == []
