"""Parts of expressions with ``or`` and ``if`` that a Python launch file has as values."""

import ast
from pathlib import Path

import pytest

from tests.ros.launch.python_files import included, read
from urdfkit.ros.launch.chosen_values import chosen

NAMES = {"none": "None", "empty": "{}", "pair": "{'a': '1'}"}


@pytest.mark.parametrize(
    ("expression", "part"),
    [
        ("none or {}", "{}"),
        ("empty or pair", "pair"),
        ("pair or {}", "pair"),
        ("none or empty or pair", "pair"),
        ("other or {}", "other or {}"),
        ("pair and none", "pair and none"),
        ("pair if pair else {}", "pair"),
        ("pair if none else {}", "{}"),
        ("pair if not pair else {}", "{}"),
        ("{} if none is None else pair", "{}"),
        ("pair if pair is not None else {}", "pair"),
        ("pair if other is None else {}", "pair if other is None else {}"),
        ("pair if pair == none else {}", "pair if pair == none else {}"),
    ],
)
def test_parts(expression: str, part: str) -> None:
    def known(node: ast.expr | None) -> ast.expr | None:
        if isinstance(node, ast.Name):
            return ast.parse(NAMES[node.id], mode="eval").body if node.id in NAMES else None
        return node

    assert ast.unparse(chosen(ast.parse(expression, mode="eval").body, known)) == part


@pytest.mark.parametrize(
    "given", ["(arguments or {}).items()", "({} if arguments is None else arguments).items()"]
)
def test_a_function_includes_files_with_and_without_arguments(package: Path, given: str) -> None:
    for name in ("one.launch.py", "two.launch.py"):
        included(package, name, f"Node(package='p', executable='{name[:3]}')")
    body = f"""
def part(name, arguments=None):
    path = os.path.join(get_package_share_directory('arm'), 'launch', name)
    return IncludeLaunchDescription(path, launch_arguments={given})
return LaunchDescription([part('one.launch.py'), part('two.launch.py', {{'x': '1'}})])
"""
    launch = read(package, body)
    assert [program.executable for program in launch.programs] == ["one", "two"]
    assert launch.unread == ()
    assert [sorted(file.arguments or {}) for file in launch.includes] == [[], ["x"]]


def test_long_chains_end(package: Path) -> None:
    lines = [f"a{n} = a{n - 1} or a{n - 1}" for n in range(1, 200)]
    body = "\n".join(["a0 = {}", *lines, "IncludeLaunchDescription(a199, a199)"])
    assert read(package, body).programs == ()
