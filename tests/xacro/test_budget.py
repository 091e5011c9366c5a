"""No value of a model is so large, so deep or so slow that it uses up the machine."""

from itertools import pairwise
from pathlib import Path

import pytest

from tests.xacro import stock
from tests.xacro.strangers import codes, run
from urdfkit.core import expansion_limits as limits


def properties(first: str, following: str, count: int = 60) -> str:
    """Properties p0, p1, ... of which each is made from the one before; and a use of the last."""
    text = f'<xacro:property name="p0" value="{first}"/>'
    for number in range(1, count):
        value = following.replace("@", f"p{number - 1}")
        text += f'<xacro:property name="p{number}" value="{value}"/>'
    return text + f'<a b="${{p{count - 1}}}"/>'


#: Small texts whose values would be immense.
LARGE = {
    "a power": "${9**9**7}",
    "a shift": "${1 &lt;&lt; 10**9}",
    "a string": "${'a'*3*10**9}",
    "bytes": "${b'a'*10**10}",
    "a list": "${[0]*10**10}",
    "lists in lists": "${[[[[0]*1000]*1000]*1000]*1000}",
    "a range": "${list(python.range(10**12))}",
    "a range of more than a machine word": "${python.range(10**30)}",
    "a sum of a range": "${python.sum(python.range(10**12))}",
    "a sum of lists": "${python.sum([[0]*1000 for x in python.range(10**4)], [])}",
    "a wide field": "${'%999999999d' % 1}",
    "a wide field with a key": "${'%((a))99999999d' % dict([('(a)', 1)])}",
    "a width as an argument": "${'%*d' % (10**9, 1)}",
    "a precision": "${'%.999999999f' % 1}",
    "padding": "${'a'.zfill(10**10)}",
    "padding by the method of the class": "${[str.ljust][0]('a', 10**10)}",
    "padding as a key": "${python.sorted([10**10], key='a'.zfill)}",
    "padding in map": "${list(map('a'.rjust, [10**10]))}",
    "joining": "${('x'*10**5).join(['a']*10**5)}",
    "joining from a generator": "${('x'*10**5).join(str(i) for i in python.range(10**5))}",
    "replacing": "${('a'*10**5).replace('a', 'b'*10**5)}",
    "a factorial": "${factorial(10**6)}",
    "combinations": "${math.comb(10**6, 5*10**5)}",
    "permutations": "${math.perm(10**6)}",
    "a product": "${math.prod([2**19000]*1000)}",
    "a common multiple": "${math.lcm(*python.range(1, 99999))}",
    "rounding": "${round(1, -10**9)}",
    "a number in a string": "${int('f'*10**5, 16)}",
    "a search from behind": "${('a'*500000).rfind('b'+'a'*200000)}",
    "equal hashes": "${len(python.set([i*(2**61-1) for i in python.range(10**5)]))}",
    "equal hashes of keys": "${len(dict.fromkeys([i*(2**61-1) for i in python.range(10**5)]))}",
    "a list that grows by itself": "${[l.extend(l) for l in [[1]] for i in python.range(99)]}",
    "a comprehension": "${[x for x in python.range(10**7)]}",
    "a long expression": "${1" + "+1" * 3000 + "}",
}


@pytest.mark.parametrize("what", LARGE)
def test_no_value_is_immense(what: str, workspace: Path) -> None:
    (problem,) = run(workspace, f'<a b="{LARGE[what]}"/>').problems
    assert problem.code == "XAC013"
    assert problem.span.text == LARGE[what] or "&lt;" in LARGE[what]


@pytest.mark.parametrize("text", ["-" * 3000 + "1", "1" + "+1" * 1900, "a" + "[0]" * 1300])
def test_an_expression_may_be_deep(text: str, workspace: Path) -> None:
    """How deep is for each Python to say."""
    xacro = run(workspace, f'<a b="${{{text}}}"/>')
    assert xacro.document is not None or codes(xacro) <= {"XAC013", "XAC001"}


GROWING = {
    "strings": ("xxxxxxxxxx", "${@}${@}"),
    "strings by an operator": ("xxxxxxxxxx", "${@ + @}"),
    "lists": ("${[1]}", "${[@, @]}"),
    "lists by stars": ("${[1]}", "${[*@, *@]}"),
    "lists by slices": ("${[1]}", "${@[:] + @[:]}"),
    "tuples that are hashed": ("${(1,)}", "${(@, @)}"),
    "tables": ("${dict(a=1)}", "${dict(a=@, b=@)}"),
    "escapes of escapes": ("\\", "${python.repr(@)}"),
    "comprehensions": ("${[1]}", "${[x for y in (@, @) for x in y]}"),
    "copies": ("${[1]}", "${python.sum([@, @], [])}"),
}


@pytest.mark.parametrize("what", GROWING)
def test_no_value_grows_from_property_to_property(what: str, workspace: Path) -> None:
    (problem,) = run(workspace, properties(*GROWING[what])).problems
    assert problem.code == "XAC013"


#: Values in values, as deep as a comprehension goes; each once ended Python itself.
DEEP = {
    "lists": "l.append([l.pop()])",
    "tuples": "l.append((l.pop(),))",
    "tables": "l.append(dict(a=l.pop()))",
    "slices": "l.append(python.slice(l.pop()))",
    "iterators": "l.append(python.zip(l.pop()))",
    "numbered": "l.append(python.enumerate(l.pop()))",
    "generators": "l.append((x for x in l.pop()))",
    "mapped": "l.append(map(str, l.pop()))",
    "in a list": "l.append([python.zip(l.pop())])",
}


@pytest.mark.parametrize("what", DEEP)
def test_no_value_is_deep(what: str, workspace: Path) -> None:
    body = '<xacro:property name="l" value="${[[1]]}"/>'
    body += f'<a b="${{[{DEEP[what]} for i in python.range(99999)]}}"/>'
    body += '<a b="${python.hash(l.pop())}"/><a b="${list(l.pop())}"/>'
    assert codes(run(workspace, body)) <= {"XAC001", "XAC009", "XAC013"}


@pytest.mark.parametrize(
    "value", ["(p@,)", "python.zip(p@)", "(x for x in p@)", "python.slice(p@)"]
)
def test_no_value_is_deep_by_properties(value: str, workspace: Path) -> None:
    body = '<xacro:property name="p0" value="${(1,)}"/>'
    for number in range(1, 20_000):
        text = value.replace("@", str(number - 1))
        body += f'<xacro:property name="p{number}" value="${{{text}}}" lazy_eval="false"/>'
    body += '<a b="${python.hash(p19999)}"/><a b="${list(p19999)}"/>'
    assert codes(run(workspace, body)) <= {"XAC001", "XAC013"}


def test_iterators_are_lists(workspace: Path) -> None:
    body = (
        '<xacro:property name="p" value="${map(float, [1, 2])}"/>'
        '<a b="${list(p)}" c="${list(p)}" d="${max(x for x in p)}" e="${list(python.zip(p, p))}"/>'
    )
    text = run(workspace, body).text()
    assert 'b="[1.0, 2.0]" c="[1.0, 2.0]" d="2.0" e="[(1.0, 1.0), (2.0, 2.0)]"' in text


def test_a_value_that_contains_itself(workspace: Path) -> None:
    body = '<xacro:property name="l" value="${[1]}"/><a b="${l.append(l)}" c="${l}"/>'
    assert codes(run(workspace, f'{body}<a b="${{[l, l]}}"/>')) == {"XAC013"}


@pytest.mark.parametrize(
    "text",
    [
        "a: &a [x, x, x, x, x, x, x, x]\n"
        + "".join(f"{b}: &{b} [{', '.join([f'*{a}'] * 8)}]\n" for a, b in pairwise("abcdefghi")),
        "a: &a {x: 1}\n"
        + "".join(
            f"{b}: &{b} {{<<: [{', '.join([f'*{a}'] * 8)}]}}\n" for a, b in pairwise("abcdefghi")
        ),
        'a: &a "' + "x" * 400_000 + '"\nb: [*a, *a, *a, *a]\n',
        "&a [*a]\n",
        "[" * 300_000,
        "- " * 300_000 + "1",
        "? " * 300_000 + "1",
        "".join(" " * level + "a:\n" for level in range(1200)),
        "{" + ", ".join(f"{i * (2**61 - 1)}: 1" for i in range(20_000)) + "}",
        "a: !degrees 9**9**9\n",
        "x" * 1_100_000,
    ],
    ids=["aliases", "merges", "texts", "itself", "[", "-", "?", "block", "hashes", "unit", "size"],
)
def test_no_yaml_is_immense(text: str, workspace: Path) -> None:
    """Deep ones end Python itself: libyaml builds them by recursion in C."""
    body = "<a b=\"${len(str(xacro.load_yaml('yaml.yaml')))}\"/>"
    (problem,) = run(workspace, body, yaml=text).problems
    assert problem.code == "XAC013", problem.message


def test_yaml_runs_no_code(workspace: Path) -> None:
    body = "<a b=\"${xacro.load_yaml('yaml.yaml')}\"/>"
    (problem,) = run(workspace, body, yaml='!!python/object/apply:os.system ["id"]').problems
    assert problem.code == "XAC001"
    assert "could not determine a constructor" in problem.message
    (problem,) = run(workspace, body, yaml="a: !degrees ().__class__").problems
    assert problem.code == "XAC009"


MACRO_PARAMETERS = {
    "a quote in a default": "a:=" + "x" * 60 + "'",
    "quotes in a default": "a:=" + "'" * 61,
    "many": "a " * 100_000,
    "an open bracket": "a:=" + "${" * 100_000,
}


@pytest.mark.parametrize("what", MACRO_PARAMETERS)
def test_parameters_are_read_in_bounded_time(what: str, workspace: Path) -> None:
    body = f'<xacro:macro name="m" params="{MACRO_PARAMETERS[what]}"/>'
    (problem,) = run(workspace, body).problems
    assert problem.code == "XAC013"


def test_parameters_with_quotes(workspace: Path) -> None:
    """The bound touches none that is meant."""
    body = (
        "<xacro:macro name='m' params='a:=\"a long default, in quotes, of many words\" b:=${1 + 2} "
        'c:=$(optenv NONE "with words") d="x" *e **f\'>'
        '<l a="${a}" b="${b}" d="${d}"/></xacro:macro>'
        "<xacro:m><x/><y/></xacro:m>"
    )
    xacro = run(workspace, body)
    assert xacro.text() == stock.expand(workspace / "robot.xacro").text


@pytest.mark.parametrize("name", ["(" * 500_000, "1+" * 50_000 + "1", "a" + ".b" * 50_000])
def test_names_are_read_in_bounded_space(name: str, workspace: Path) -> None:
    (problem,) = run(workspace, f'<xacro:property name="{name}" value="1"/>').problems
    assert problem.code == "XAC001"


def test_directories_that_lead_in_circles(workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(limits, "_allowed", limits.Limits(seconds=0.5))
    for number in range(10):
        (workspace / f"link{number}").symlink_to(".")
    (problem,) = run(workspace, f'<xacro:include filename="{"*/" * 30}none"/>').problems
    assert problem.code == "XAC013"
    assert problem.message == "rejected: the expansion takes longer than 0.5 s"


def test_time_is_that_of_all_attempts_together(
    workspace: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(limits, "_allowed", limits.Limits(seconds=0.5))
    slow = '<a b="${len([1 for x in python.range(9999) for y in python.range(99999)])}"/>'
    failing = "".join(f"<xacro:none{number}/>" for number in range(40))
    xacro = run(workspace, failing + slow)
    assert codes(xacro) == {"XAC001", "XAC013"}
