"""A model that nobody vouches for can neither run code, read files, nor use up the machine."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path

import pytest

from tests.conftest import ROOT
from tests.expansion import models, stock
from urdfkit.expansion import Xacro, budget, expand
from urdfkit.source import Source
from urdfkit.workspace.resolve import Resolver

SECRET = "the secret of this machine"


@pytest.fixture
def outside(tmp_path: Path) -> Path:
    """A file that does not belong to the workspace of the models."""
    file = tmp_path / "outside" / "secret.yaml"
    file.parent.mkdir()
    file.write_text(SECRET, encoding="utf-8")
    return file


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    folder = tmp_path / "a" / "workspace" / "src" / "robot"
    folder.mkdir(parents=True)
    (folder / "package.xml").write_text("<package><name>robot</name></package>", encoding="utf-8")
    return folder


def run(folder: Path, text: str, *, trust: bool = False, **files: str) -> Xacro:
    """Expand a model whose body, or whole text, is given; ``part="..."`` is ``part.xacro``."""
    for name, content in files.items():
        suffix = ".yaml" if name.startswith("yaml") else ".xacro"
        (folder / f"{name}{suffix}").write_text(content, encoding="utf-8")
    file = folder / "robot.xacro"
    file.write_text(text if text.startswith(("<?", "<!")) else models.document(text), "utf-8")
    return expand(Source.read(file), Resolver({}, {}), trust=trust)


def codes(xacro: Xacro) -> set[str]:
    return {problem.code for problem in xacro.problems}


#: Ways from a value to the interpreter, each of which is refused.
CODE = {
    "a lambda, which xacro does not look into": (
        "${(lambda: [c for c in ().__class__.__base__.__subclasses__()][0])()}"
    ),
    "a comprehension": "${[c for c in ().__class__.__base__.__subclasses__()]}",
    "a class": "${().__class__}",
    "names in strings": "${python.vars(python.type)['__subclasses__'](int)}",
    "the type of a value": "${python.type(1)}",
    "method resolution": "${int.mro()}",
    "the frame of a generator": "${[g.gi_frame.f_back for g in [(x for x in [1])]]}",
    "the code of a generator": "${(x for x in [1]).gi_code}",
    "the globals of a function": "${xacro.load_yaml.__globals__}",
    "the globals of functions in a table": "${[f.__globals__ for f in dict.values(xacro)]}",
    "the module of a function": "${sin.__self__}",
    "the object of a method": "${[].append.__self__}",
    "a format that reads attributes": "${'%s'.format}",
    "a format with a table": "${'a'.format_map(dict(a=1))}",
    "an operator's method": "${(1).__add__(2)}",
    "the tables of xacro": "${xacro.parent}",
    "methods of the tables of xacro": "${python.update(dict(abs=1))}",
    "an assignment": "${(x := 1)}",
    "a formatted string": "${f'a'}",
    "a name with underscores": "${__import__('os')}",
    "a descriptor": "${str.join.__get__}",
    "a codec": "${'a'.encode('idna')}",
    "a separator that ends its set": "${xacro.tokenize('x', 'a]|(x+x+)+y|[b')}",
}


@pytest.mark.parametrize("what", CODE)
def test_no_way_leads_from_a_value_to_the_interpreter(what: str, workspace: Path) -> None:
    xacro = run(workspace, f'<a b="{CODE[what]}"/>')
    assert [problem.code for problem in xacro.problems] == ["XAC009"]
    assert xacro.document is None


EVALUATED = [
    "open(1).read()",
    "exec(1)",
    "eval(1)",
    "compile(1)",
    "globals()",
    "locals()",
    "vars()",
    "getattr(1, 2)",
    "setattr(1, 2, 3)",
    "breakpoint()",
    "input()",
    "print(1)",
    "().__class__",
    "(lambda: 1)()",
    "memoryview(1)",
    "type(1)",
    "int.mro()",
]


@pytest.mark.parametrize("expression", EVALUATED)
def test_eval_has_no_builtins(expression: str, workspace: Path) -> None:
    """Stock xacro gives all of Python's to ``$(eval ...)``, once a property hides the brackets."""
    xacro = run(
        workspace, f'<xacro:property name="p" value="{expression}"/><a b="$(eval ${{p}})"/>'
    )
    assert [problem.code for problem in xacro.problems] == ["XAC009"]


def test_eval_computes(workspace: Path) -> None:
    body = '<xacro:property name="p" value="max(len([1, 2]), abs(-3)) + sin(0)"/>'
    xacro = run(workspace, body + '<a b="$(eval ${p})"/>')
    assert xacro.document is not None
    assert xacro.document.root.children[0].get("b") == "3.0"


def test_no_property_replaces_a_guard(workspace: Path) -> None:
    """Guards have names that nothing else can have; a table of the model comes after them."""
    weird = "fence call"
    library = models.document('<xacro:property name="x" value="1"/>')
    xacro = run(
        workspace,
        f'<xacro:include filename="part.xacro" ns="{weird}"/>'
        f'<xacro:include filename="part.xacro" ns="n"/>'
        f'<a b="${{dict.update(n, {{\'{weird}\': max}})}}" c="${{str(1)}}"/>'.replace("{{", "{"),
        part=library,
    )
    assert codes(xacro) <= {"XAC001"}  # braces end the expression
    xacro = run(
        workspace, '<xacro:property name="_guard_power" value="${max}"/><a b="${9**9**9}"/>'
    )
    assert codes(xacro) == {"XAC013"}


def test_no_expression_reaches_what_urdfkit_notes(workspace: Path, outside: Path) -> None:
    """The notes hold elements, and through them one came to a reader of files."""
    ways = ["n.places", "n.used", "n.inputs", "n['**block'].tag_at", "n['**block'].ownerDocument"]
    body = "".join(f'<a b="${{{way}}}"/>' for way in ways)
    body += f"<a b=\"${{n['**block'].tag_at.source.read('{outside}').data}}\"/>"
    library = models.document('<xacro:property name="block"><l/></xacro:property>')
    xacro = run(workspace, f'<xacro:include filename="part.xacro" ns="n"/>{body}', part=library)
    assert [problem.code for problem in xacro.problems] == ["XAC001"] * 3 + ["XAC009"] * 3


def test_a_name_space_may_hold_what_urdfkit_calls_its_notes(workspace: Path) -> None:
    names = "places", "used", "inputs", "definers", "root_", "_hidden"
    library = models.document(
        "".join(f'<xacro:property name="{name}" value="{name}!"/>' for name in names)
    )
    values = " ".join(f'{name}="${{n.{name}}}"' for name in names)
    xacro = run(
        workspace, f'<xacro:include filename="part.xacro" ns="n"/><a {values}/>', part=library
    )
    assert xacro.document is not None
    found = xacro.document.root.children[0].attributes
    assert {name: one.value for name, one in found.items()} == {name: f"{name}!" for name in names}


def test_yaml_may_use_any_key(workspace: Path) -> None:
    keys = "format mro encode _x replace gi_frame parent root f_back".split()
    text = "".join(f"{key}: {number}\n" for number, key in enumerate(keys))
    values = " ".join(f'a{number}="${{y.{key}}}"' for number, key in enumerate(keys))
    load = '<xacro:property name="y" value="${xacro.load_yaml(\'yaml.yaml\')}"/>'
    xacro = run(workspace, f"{load}<a {values}/>", yaml=text)
    assert xacro.document is not None
    assert [a.value for a in xacro.document.root.children[0].attributes.values()] == [
        str(number) for number in range(len(keys))
    ]


def test_variables_of_the_environment(workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MY_CI_TOKEN", SECRET)
    monkeypatch.setenv("ROS_DISTRO", "jazzy")
    xacro = run(workspace, '<a b="$(env MY_CI_TOKEN)"/>')
    assert codes(xacro) == {"XAC009"}
    assert SECRET not in str(xacro.problems)
    body = '<a b="$(optenv MY_CI_TOKEN none)" c="$(env ROS_DISTRO)" d="$(optenv ROS_DISTRO)"/>'
    xacro = run(workspace, body)
    assert '<a b="none" c="jazzy" d="jazzy"/>' in xacro.text()
    assert f'b="{SECRET}"' in run(workspace, body, trust=True).text()


FILES: dict[str, Callable[[Path], str]] = {
    "an include": lambda file: f'<xacro:include filename="{file}"/>',
    "a YAML file": lambda file: f"<a b=\"${{xacro.load_yaml('{file}')}}\"/>",
    "a way upwards": lambda file: (
        f"<a b=\"${{xacro.load_yaml('../../../../outside/{file.name}')}}\"/>"
    ),
    "a glob": lambda file: f'<xacro:include filename="{file.parent}/*.yaml"/>',
    "a glob of folders": lambda file: f'<xacro:include filename="{file.parent.parent}/*/s*"/>',
    "a glob from the root": lambda _: '<xacro:include filename="/*/*/*/*/*/*/*/*"/>',
    "the environment": lambda _: "<a b=\"${xacro.load_yaml('/proc/self/environ')}\"/>",
    "a device": lambda _: '<xacro:include filename="/dev/zero"/>',
    "a device as YAML": lambda _: "<a b=\"${xacro.load_yaml('/dev/zero')}\"/>",
}


@pytest.mark.parametrize("what", FILES)
def test_no_file_outside_is_read(what: str, workspace: Path, outside: Path) -> None:
    xacro = run(workspace, FILES[what](outside))
    assert codes(xacro) == {"XAC012"}
    assert SECRET not in str(xacro.problems)


@pytest.mark.parametrize("name", ["/etc", "../../../../../../../../../../etc", "..", "."])
def test_no_package_is_named_by_a_path(name: str, workspace: Path, tmp_path: Path) -> None:
    (tmp_path / "ros" / "share").mkdir(parents=True)
    body = f"<a b=\"${{xacro.load_yaml('$(find {name})/hostname')}}\"/>"
    file = workspace / "robot.xacro"
    file.write_text(models.document(body), encoding="utf-8")
    for variable in ("AMENT_PREFIX_PATH", "ROS_PACKAGE_PATH"):
        xacro = expand(Source.read(file), Resolver({}, {variable: str(tmp_path / "ros")}))
        assert codes(xacro) == {"XAC011"}


def test_no_link_leads_outside(workspace: Path, outside: Path) -> None:
    (workspace / "link.yaml").symlink_to(outside)
    (workspace / "folder").symlink_to(outside.parent)
    for path in ("link.yaml", "folder/secret.yaml"):
        xacro = run(workspace, f"<a b=\"${{xacro.load_yaml('{path}')}}\"/>")
        assert codes(xacro) == {"XAC012"}
    assert codes(run(workspace, '<xacro:include filename="folder/*"/>')) == {"XAC012"}


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no named pipes")
def test_a_pipe_is_not_waited_for(workspace: Path) -> None:
    os.mkfifo(workspace / "pipe")
    for body in ('<xacro:include filename="pipe"/>', "<a b=\"${xacro.load_yaml('pipe')}\"/>"):
        (problem,) = run(workspace, body).problems
        assert problem.code == "XAC012"
        assert problem.message.endswith("pipe is no file but a device or a pipe")


def test_trust_lifts_the_fence(workspace: Path, outside: Path) -> None:
    """All of what stock xacro lets a model do."""
    body = (
        f"<a b=\"${{xacro.load_yaml('{outside}')}}\""
        f" c=\"${{python.vars(python.type)['__subclasses__'](int)[0] == True.real or 1}}\""
        " d=\"${(lambda x: x*2)(3)}\" e=\"${len('a'*10**7)}\" f=\"${'%s' % ''.format()}\"/>"
        '<xacro:property name="p" value="open(1).fileno() if 0 else len(str(vars()))"/>'
        '<b c="$(eval ${p})"/>'
    )
    xacro = run(workspace, body, trust=True)
    assert xacro.first_error is None
    assert f'b="{SECRET}"' in xacro.text()
    assert 'd="6" e="10000000"' in xacro.text()
    assert codes(run(workspace, body)) >= {"XAC009", "XAC012", "XAC013"}


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
    assert problem.code == "XAC013"


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


def test_folders_that_lead_in_circles(workspace: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(budget, "MAX_SECONDS", 0.5)
    for number in range(10):
        (workspace / f"link{number}").symlink_to(".")
    (problem,) = run(workspace, f'<xacro:include filename="{"*/" * 30}none"/>').problems
    assert problem.code == "XAC013"
    assert problem.message == "refused: the expansion takes longer than 0.5 s"


def test_time_is_that_of_all_attempts_together(
    workspace: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(budget, "MAX_SECONDS", 0.5)
    slow = '<a b="${len([1 for x in python.range(9999) for y in python.range(99999)])}"/>'
    failing = "".join(f"<xacro:none{number}/>" for number in range(40))
    xacro = run(workspace, failing + slow)
    assert codes(xacro) == {"XAC001", "XAC013"}


def nested_macros(depth: int, width: int) -> str:
    """A macro that calls another so many times, which calls another, and so on."""
    text = '<xacro:macro name="m0"><l/></xacro:macro>'
    for level in range(1, depth):
        calls = f"<xacro:m{level - 1}/>" * width
        text += f'<xacro:macro name="m{level}">{calls}</xacro:macro>'
    return text + f"<xacro:m{depth - 1}/>"


def growing_blocks() -> str:
    twice = '<x><xacro:insert_block name="b"/><xacro:insert_block name="b"/></x>'
    text = '<xacro:macro name="m0" params="*b"><xacro:insert_block name="b"/></xacro:macro>'
    for level in range(1, 60):
        call = f"<xacro:m{level - 1}>{twice}</xacro:m{level - 1}>"
        text += f'<xacro:macro name="m{level}" params="*b">{call}</xacro:macro>'
    return text + "<xacro:m59><y/></xacro:m59>"


LAUGHS = "".join(f'<!ENTITY a{n} "{f"&a{n - 1};" * 10}">' for n in range(1, 10))
HEAD = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'


def entity(value: str) -> str:
    """The beginning of a file with the entity ``&a;``."""
    return f"<!DOCTYPE r [<!ENTITY a {value}>]><robot {HEAD}><xacro:a/>"


#: Small files that would fill the memory or keep the processor busy; with the code that says so.
BOMBS = {
    "a macro that calls itself": (
        '<xacro:macro name="m"><xacro:m/></xacro:macro><xacro:m/>',
        "XAC013",
    ),
    "a macro that renames itself": (
        '<xacro:macro name="m"><xacro:element xacro:name="xacro:m"/></xacro:macro><xacro:m/>',
        "XAC013",
    ),
    "macros that call each other": (nested_macros(9, 10), "XAC013"),
    "blocks": (growing_blocks(), "XAC013"),
    "long texts": (
        f'<xacro:macro name="m"><a>{"x" * 100_000}</a></xacro:macro>' + "<xacro:m/>" * 20_000,
        "XAC013",
    ),
    "long attributes": (
        '<xacro:property name="p" value="${\'a\'*900000}"/>' + '<a b="${p}"/>' * 20_000,
        "XAC013",
    ),
    "long properties": (
        "".join(
            f'<xacro:property name="p{n}" value="${{\'a\'*900000}}" lazy_eval="false"/>'
            for n in range(10_000)
        ),
        "XAC013",
    ),
    "many expressions in one text": (
        '<xacro:property name="p" value="${\'a\'*900000}"/><a b="' + "${p}" * 50_000 + '"/>',
        "XAC013",
    ),
    "parameters that grow": (
        (
            '<xacro:macro name="m" params="n s"><xacro:if value="${n}">'
            '<xacro:m n="${n-1}" s="${s}${s}"/></xacro:if></xacro:macro><xacro:m n="99" s="xx"/>'
        ),
        "XAC013",
    ),
    "arguments that grow": (
        '<xacro:arg name="a0" default="xxxxxxxxxx"/>'
        + "".join(
            f'<xacro:arg name="a{n}" default="$(arg a{n - 1})$(arg a{n - 1})"/>'
            for n in range(1, 60)
        ),
        "XAC013",
    ),
    "messages": (
        "<a b=\"${[xacro.message('a'*900000, i) for i in python.range(1000)]}\"/>",
        "XAC013",
    ),
    "nested comprehensions": (
        '<a b="${[1 for a in python.range(9999) for b in python.range(9999) for c in [1]]}"/>',
        "XAC013",
    ),
    "deep XML": ("<a>" * 100_000 + "</a>" * 100_000, "XAC013"),
    "many elements": ("<a/>" * 400_000, "XAC013"),
    "many comments": ("<!-- a -->" * 300_000 + "<xacro:property name='1' value='1'/>", "XAC001"),
    "many properties": ('<xacro:property name="a" value="1"/>' * 30_000 + "<xacro:b/>", "XAC001"),
    "many errors": ("".join(f'<a b="${{x{n}}}"/>' for n in range(20_000)), "XAC001"),
    "many failing tags": ("".join(f"<xacro:x{n}/>" for n in range(2_000)), "XAC001"),
    "one error in many calls": (
        '<xacro:macro name="m"><a b="${x}"/></xacro:macro>' + "<xacro:m/>" * 20_000,
        "XAC001",
    ),
    "brackets that nothing closes": (f"<x><![CDATA[{'${' * 300_000}]]></x><xacro:a/>", "XAC001"),
    "an include of itself": ('<xacro:include filename="robot.xacro"/>', "XAC013"),
    "an include of itself twice": ('<xacro:include filename="robot.xacro"/>' * 2, "XAC013"),
    "thousands of includes": (
        '<xacro:include filename="part.xacro"/>' * 3_000 + "<xacro:a/>",
        "XAC001",
    ),
    "entities of entities": (
        f'<!DOCTYPE r [<!ENTITY a0 "lol">{LAUGHS}]><robot {HEAD} name="&a9;"><xacro:a/></robot>',
        "XML001",
    ),
    "a long entity often": (
        entity('"' + "x" * 50_000 + '"') + "&a;" * 50_000 + "</robot>",
        "XML001",
    ),
    "an entity from a file": (
        entity('SYSTEM "file:///etc/hostname"') + "&a;</robot>",
        "XML003",
    ),
    "a codec of Python": (
        '<?xml version="1.0" encoding="punycode"?><robot>'
        + ("a" * 10**6 + "-" + "b" * 10**6)
        + "</robot>",
        "XML002",
    ),
}

MEMORY = 1 << 30
SECONDS = 60


def limit_memory() -> None:
    import resource

    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


@pytest.mark.skipif(sys.platform == "win32", reason="there are no limits of a process")
@pytest.mark.parametrize("what", BOMBS)
def test_a_bomb_ends_in_a_report(what: str, workspace: Path) -> None:
    """Within a gigabyte and a minute, of which most need a tenth."""
    text, code = BOMBS[what]
    (workspace / "part.xacro").write_text(models.document("<l/>"), encoding="utf-8")
    file = workspace / "robot.xacro"
    file.write_text(text if text.startswith(("<!D", "<?")) else models.document(text))
    done = subprocess.run(
        [sys.executable, "-m", "urdfkit", "check", "--format", "json", str(file)],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
        timeout=SECONDS,
        preexec_fn=limit_memory,
    )
    assert done.stderr == ""
    assert done.returncode == 1
    report = json.loads(done.stdout)
    assert report["crashed"] == []
    assert code in {diagnostic["code"] for diagnostic in report["diagnostics"]}


def test_a_large_file_is_not_read(workspace: Path) -> None:
    with (workspace / "part.xacro").open("wb") as file:
        file.truncate(100 * 2**20)
    (problem,) = run(workspace, '<xacro:include filename="part.xacro"/>').problems
    assert problem.code == "XAC013"
    (problem,) = run(workspace, "<a b=\"${xacro.load_yaml('part.xacro')}\"/>").problems
    assert problem.code == "XAC013"


def test_half_characters_do_no_harm(workspace: Path) -> None:
    xacro = run(workspace, "<a b=\"${'\\ud800'}\"/><a b=\"${'\\x00'}\"/>")
    assert xacro.first_error is None
    file = workspace / "robot.xacro"
    for command in (["check"], ["expand"], ["expand", "--map", "-"]):
        done = subprocess.run(
            [sys.executable, "-m", "urdfkit", *command, str(file)],
            cwd=ROOT,
            capture_output=True,
            check=False,
        )
        assert done.returncode in (0, 1)
        assert done.stderr == b""
