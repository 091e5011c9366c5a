"""The arguments of functions that a Python launch file calls once."""

import ast

import pytest

from urdfkit.ros.launch.bound_parameters import bound_parameters


@pytest.mark.parametrize(
    ("program", "bound"),
    [
        ("def f(a, b=2): pass\nf(1)", {"a": "1", "b": "2"}),
        ("def f(a, b=2): pass\nf(b=3, a=1)", {"a": "1", "b": "3"}),
        (
            "def f(context, a, b): pass\nOpaqueFunction(function=f, args=[x, y])",
            {"a": "x", "b": "y"},
        ),
        ("def f(context, a): pass\nOpaqueFunction(function=f, kwargs={'a': x})", {"a": "x"}),
        ("def f(context, *rest): pass\nOpaqueFunction(function=f, args=[x])", {"rest": "(x,)"}),
        ("def f(a, *rest): pass\nf(1, 2, 3)", {"a": "1", "rest": "(2, 3)"}),
        ("def f(*rest): pass\nf(*values)", {}),
        ("def f(*rest, a, b=2): pass\nf(a=1)", {"a": "1", "b": "2", "rest": "()"}),
        ("def f(a, b): pass\nf(*values)", {}),
        ("def f(a): pass\nf(1)\nf(2)", None),  # called twice
        ("def f(a): pass\nf(1)\ncallbacks = [f]", None),
        ("def f(a): pass\ndef f(a, b): pass\nf(1)", None),
        ("def f(a): pass", None),
    ],
)
def test_parameters(program: str, bound: dict[str, str] | None) -> None:
    found = [
        {name: ast.unparse(value) for name, value in binding.passed.items()}
        for binding in bound_parameters(ast.parse(program)).values()
    ]
    assert found == ([] if bound is None else [bound])
