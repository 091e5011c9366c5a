"""Other values of the arguments of a launch file."""

import pytest

from urdfkit.ros.launch.alternatives import alternatives
from urdfkit.text.source import Source

DECLARED = "DeclareLaunchArgument('place', default_value='depot'{})"


@pytest.mark.parametrize(
    ("text", "values"),
    [
        (DECLARED.format(", choices=['depot', 'yard', 'dock']"), ["yard", "dock"]),
        (DECLARED.format(", choices=['true', 'depot']"), []),
        (DECLARED.format(", choices=places"), []),
        (DECLARED.format("") + "\nLaunchConfigurationEquals('place', 'yard')", ["yard"]),
        (DECLARED.format("") + "\nLaunchConfigurationEquals('place', 'depot')", []),
        (DECLARED.format("") + "\nLaunchConfigurationEquals('other', 'yard')", []),
        (
            DECLARED.format("")
            + "\nEqualsSubstitution(LaunchConfiguration('place'), 'yard')"
            + "\nPythonExpression([\"'\", LaunchConfiguration('place'), \"' == 'dock'\"])",
            ["yard", "dock"],
        ),
        ("DeclareLaunchArgument('place', choices=['depot', 'yard'])", []),  # it must be passed
        ("DeclareLaunchArgument(", []),
    ],
)
def test_python(text: str, values: list[str]) -> None:
    found = alternatives(Source("a.launch.py", text.encode()))
    assert found == [("place", value) for value in values]


ARGUMENT = '<launch><arg name="place" default="depot">{}</arg>{}</launch>'


@pytest.mark.parametrize(
    ("text", "values"),
    [
        (ARGUMENT.format('<choice value="depot"/><choice value="yard"/>', ""), ["yard"]),
        (ARGUMENT.format("", "<group if=\"$(eval \"'$(var place)' == 'yard'\")\"/>"), []),
        (
            ARGUMENT.format("", "<group if=\"$(eval &quot;'$(var place)' == 'yard'&quot;)\"/>"),
            ["yard"],
        ),
        (ARGUMENT.format("", ""), []),
        ("<launch>", []),
    ],
)
def test_xml(text: str, values: list[str]) -> None:
    found = alternatives(Source("a.launch.xml", text.encode()))
    assert found == [("place", value) for value in values]


def test_yaml() -> None:
    text = """launch:
- arg: {name: place, default: depot}
- group:
    if: $(eval "'$(var place)' == 'yard'")
    children: []
"""
    assert alternatives(Source("a.launch.yaml", text.encode())) == [("place", "yard")]


def test_only_some_are_tried() -> None:
    text = DECLARED.format(f", choices={[f'place{number}' for number in range(9)]}")
    assert len(alternatives(Source("a.launch.py", text.encode()))) == 4
