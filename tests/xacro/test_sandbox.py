"""A model that nobody vouches for can neither run code nor read files."""

import os
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.xacro import models
from tests.xacro.strangers import SECRET, codes, run
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver
from urdfkit.xacro import expand

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
    "a format whose field looks into its value": "${t0.format(1)}",
    "a format whose field has an item": "${t1.format('a')}",
    "a format of anything but texts and numbers": "${t2.format(sin)}",
    "a format whose width is a field": "${t3.format(1, 10**9)}",
    "a format of great width": "${t4.format(1)}",
    "a format of a type": "${str.format(t2, 1)}",
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
    formats = ("{0.real}", "{0[0]}", "{}", "{:{}}", "{:99999}")
    templates = (
        f'<xacro:property name="t{number}" value="{text}"/>' for number, text in enumerate(formats)
    )
    xacro = run(workspace, f'{"".join(templates)}<a b="{CODE[what]}"/>')
    assert [problem.code for problem in xacro.problems] == ["XAC009"]
    assert xacro.document is None


def test_a_format_of_texts_and_numbers(workspace: Path) -> None:
    """A `}` ends an expression of xacro, so that the fields stand in a property."""
    body = (
        '<xacro:property name="t" value="{0}_{side}_{1:04.1f}_{0!r:>5}"/>'
        "<a b=\"${t.format('arm', 2.25, side='left')}\" c=\"${'plain'.format()}\"/>"
    )
    xacro = run(workspace, body)
    assert xacro.problems == ()
    assert 'b="arm_left_02.2_\'arm\'" c="plain"' in xacro.text()
    (problem,) = run(
        workspace, '<xacro:property name="t" value="{0.real}"/><a b="${t.format(1)}"/>'
    ).problems
    assert problem.code == "XAC009"
    assert "the field '{0.real}' of format() is not allowed" in problem.message


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
    (warning,) = xacro.problems
    assert (warning.code, SECRET in str(warning)) == ("XAC017", False)
    assert "'MY_CI_TOKEN' is set, but not on the allow-list" in warning.message
    trusted = run(workspace, body, trust=True)
    assert f'b="{SECRET}"' in trusted.text()
    assert trusted.problems == ()
    monkeypatch.delenv("MY_CI_TOKEN")
    assert run(workspace, body).problems == ()


FILES: dict[str, Callable[[Path], str]] = {
    "an include": lambda file: f'<xacro:include filename="{file}"/>',
    "a YAML file": lambda file: f"<a b=\"${{xacro.load_yaml('{file}')}}\"/>",
    "a way upwards": lambda file: (
        f"<a b=\"${{xacro.load_yaml('../../../../outside/{file.name}')}}\"/>"
    ),
    "a glob": lambda file: f'<xacro:include filename="{file.parent}/*.yaml"/>',
    "a glob of directories": lambda file: f'<xacro:include filename="{file.parent.parent}/*/s*"/>',
    "a glob from the root": lambda _: '<xacro:include filename="/*/*/*/*/*/*/*/*"/>',
    "the environment": lambda _: "<a b=\"${xacro.load_yaml('/proc/self/environ')}\"/>",
    "a device": lambda _: '<xacro:include filename="/dev/zero"/>',
    "a device as YAML": lambda _: "<a b=\"${xacro.load_yaml('/dev/zero')}\"/>",
}


@pytest.mark.parametrize("what", FILES)
def test_no_file_outside_is_read(what: str, workspace: Path, outside: Path) -> None:
    xacro = run(workspace, FILES[what](outside))
    assert codes(xacro) == {"XAC009"}
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
    (workspace / "directory").symlink_to(outside.parent)
    for path in ("link.yaml", "directory/secret.yaml"):
        xacro = run(workspace, f"<a b=\"${{xacro.load_yaml('{path}')}}\"/>")
        assert codes(xacro) == {"XAC009"}
    assert codes(run(workspace, '<xacro:include filename="directory/*"/>')) == {"XAC009"}


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no named pipes")
def test_a_pipe_is_not_waited_for(workspace: Path) -> None:
    os.mkfifo(workspace / "pipe")
    for body in ('<xacro:include filename="pipe"/>', "<a b=\"${xacro.load_yaml('pipe')}\"/>"):
        (problem,) = run(workspace, body).problems
        assert problem.code == "XAC009"
        assert "pipe is a device or a pipe, not a file" in problem.message


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
    assert codes(run(workspace, body)) >= {"XAC009", "XAC013"}
