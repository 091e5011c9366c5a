import ast

import pytest

from urdfkit.ros.launch.branches import decided_calls


@pytest.mark.parametrize(
    ("text", "decided"),
    [
        ("Node()", []),
        ("if sim():\n    Node()\nelse:\n    Other()", ["Node", "Other"]),
        ("x = Node() if sim() else None", ["Node"]),
        ("match mode():\n    case 'sim':\n        Node()", ["Node"]),
        ("def f():\n    if sim():\n        return Node()\n    Other()", ["Node", "Other"]),
        ("if sim():\n    raise Error()\nNode()", ["Error"]),
        ("node = Node()\nif sim():\n    nodes.append(node)", ["Node", "append"]),
        ("node = Node()\nif sim():\n    nodes.append(node)\nstart(node)", ["append"]),
        ("for one in robots():\n    Node()", []),
    ],
)
def test_conditional_calls(text: str, decided: list[str]) -> None:
    found = [ast.unparse(call.func).rpartition(".")[2] for call in decided_calls(ast.parse(text))]
    assert sorted(found) == sorted(decided)
