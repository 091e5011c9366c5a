"""Loops of a Python launch file that create actions."""

import ast
from pathlib import Path

import pytest

from tests.ros.launch.python_files import read
from urdfkit.ros.launch.unrolled_loops import without_loops

NODE = "Node(package='p', executable='e', name={})"


def unparsed(program: str) -> str:
    return ast.unparse(without_loops(ast.parse(program)))


@pytest.mark.parametrize(
    ("loop", "names"),
    [
        ("for n in ['a', 'b']: found.append({})", "ab"),
        ("for n, m in [('a', 1), ('b', 2)]: found.append({})", "ab"),
        ("for i, n in enumerate(('a', 'b')): found.append({})", "ab"),
        ("for n, m in {{'a': 1, 'b': 2}}.items(): found.append({})", "ab"),
        ("NAMES = ['a', 'b']\nfor n in NAMES: found.append({})", "ab"),
        ("found = [{} for n in ('a', 'b')]", "ab"),
        ("for n in ['a']:\n    for m in ['b', 'c']: found.append({})", "aa"),
        ("for n in []: found.append({})", ""),
    ],
)
def test_a_loop_is_its_rounds(loop: str, names: str) -> None:
    text = unparsed(loop.format(NODE.format("n")))
    assert "for" not in text
    assert [one for one in "abc" for _ in range(text.count(f"name='{one}'"))] == list(names)


@pytest.mark.parametrize(
    "loop",
    [
        "for n in names: found.append({})",
        "for i, n in enumerate(names): found.append({})",
        "for n in ['a', *others]: found.append({})",
        "for n in range(count): found.append({})",
        "for n in range(0, 4, 2): found.append({})",
        "for n in range(1000000000): found.append({})",
        "for n in range(): found.append({})",
        "NAMES = ['a']\nNAMES.append(b)\nfor n in NAMES: found.append({})",
        "NAMES = ['a']\nNAMES = ['b']\nfor n in NAMES: found.append({})",
        "for n, m in [('a',), ('b', 1)]: found.append({})",
        "for n in ['a']: found.append({})\nelse: pass",
        "found = [{} for n in ('a', 'b') if n]",
        "for n in [" + "'a', " * 21 + "]: found.append({})",
    ],
)
def test_other_loops_stay(loop: str) -> None:
    program = loop.format(NODE.format("n"))
    assert unparsed(program) == ast.unparse(ast.parse(program))


@pytest.mark.parametrize(
    ("loop", "names"),
    [
        ("for n in range(2): found.append({})", ["0", "1"]),
        ("for n in range(1, 3): found.append({})", ["1", "2"]),
        ("ROBOTS = 2\nfor n in range(ROBOTS): found.append({})", ["0", "1"]),
        ("for n in range(2, 1): found.append({})", []),
    ],
)
def test_a_loop_over_numbers(loop: str, names: list[str]) -> None:
    text = unparsed(loop.format("Node(package='p', executable='e', name=f'r{n}')"))
    assert "for" not in text
    assert [one for one in "0123" if f"f'r{{{one}}}'" in text] == names


def test_a_loop_without_actions_stays() -> None:
    tree = ast.parse("for n in ['a', 'b']: print(n)")
    assert without_loops(tree) is tree


def test_what_a_round_computes(package: Path) -> None:
    """Names that only the loop uses are of each round; those around it are shared."""
    body = """
found = []
for name in ['left', 'right']:
    topic = f'/{name}/joy'
    found += [Node(package='p', executable='e', name=name, arguments=[topic])]
return LaunchDescription(found)
"""
    programs = read(package, body).programs
    assert [(one.name, one.words[0].text) for one in programs] == [
        ("left", "/left/joy"),
        ("right", "/right/joy"),
    ]
    assert [one.words[0].span.line for one in programs] == [programs[0].words[0].span.line] * 2


def test_many_copies_are_not_made() -> None:
    items = ", ".join(f"'{number}'" for number in range(20))
    loops = f"for a in [{items}]:\n for b in [{items}]:\n  for c in [{items}]: f({NODE})"
    text = unparsed(loops)
    assert "for" in text
    assert len(text) < 200_000
