"""Small files that would be immense end in a report, within bounds of memory and time."""

import json
import subprocess
import sys
from collections.abc import Callable, Mapping
from pathlib import Path

import pytest

from tests.conftest import ROOT
from tests.xacro import models
from tests.xacro.strangers import run
from tests.xacros import NAMESPACE


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
LAUGHING = f'<robot {NAMESPACE} name="&a9;"><xacro:a/></robot>'


#: Expat expands nested entities, and reads nested groups, by recursion.
DEEP_ENTITIES = '<!ENTITY a0 "">' + "".join(
    f'<!ENTITY a{n} "&a{n - 1};">' for n in range(1, 60_000)
)
DEEP_DTD = {
    "deep entities": f'<!DOCTYPE r [{DEEP_ENTITIES}]><robot {NAMESPACE} name="&a59999;"/>',
    "deep groups": f"<!DOCTYPE r [<!ELEMENT r {'(' * 200_000}]><robot {NAMESPACE}/>",
}


def entity(value: str) -> str:
    """The beginning of a file with the entity ``&a;``."""
    return f"<!DOCTYPE r [<!ENTITY a {value}>]><robot {NAMESPACE}><xacro:a/>"


#: Small files that would fill the memory or keep the processor busy; with the code that says so.
BOMBS = {
    **{what: (text, "XAC013") for what, text in DEEP_DTD.items()},
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
    "millions of comments": ("<!---->" * 3_000_000, "XAC013"),
    "millions of processing instructions": ("<?a?>" * 3_000_000, "XAC013"),
    "many properties": ('<xacro:property name="a" value="1"/>' * 30_000 + "<xacro:b/>", "XAC001"),
    "many errors": ("".join(f'<a b="${{x{n}}}"/>' for n in range(20_000)), "XAC001"),
    "many failing tags": ("".join(f"<xacro:x{n}/>" for n in range(2_000)), "XAC001"),
    "one error in many calls": (
        '<xacro:macro name="m"><a b="${x}"/></xacro:macro>' + "<xacro:m/>" * 20_000,
        "XAC001",
    ),
    "brackets that nothing closes": (f"<x><![CDATA[{'${' * 300_000}]]></x><xacro:a/>", "XAC001"),
    "packages that are not found": (f'<a b="{"$(find a)" * 100_000}"/>', "XAC011"),
    "an include of itself": ('<xacro:include filename="robot.xacro"/>', "XAC013"),
    "an include of itself twice": ('<xacro:include filename="robot.xacro"/>' * 2, "XAC013"),
    "thousands of includes": (
        '<xacro:include filename="part.xacro"/>' * 3_000 + "<xacro:a/>",
        "XAC001",
    ),
    "entities of entities": (
        f'<!DOCTYPE r [<!ENTITY a0 "lol">{LAUGHS}]>{LAUGHING}',
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

MANY_TIMES = "for i in python.range(10**6)"
COLLIDING = "[i*(2**61-1) for i in python.range(9999)]"
ZEROS = "[0.0]*900000"
#: Expressions whose value, or whose way to it, is immense. Most end without one.
EXPRESSIONS = {
    "punycode": "('a'*500000+'-').encode('punycode')",
    "a codec by the method of the class": "str.encode('é'*900000, 'idna')",
    "texts of large integers": "str([2**1000]*900000)",
    "a format of large integers": "'%s' % ([2**1000]*900000,)",
    "large integers": f"[2**1000+i {MANY_TIMES}]",
    "an integer in the text": "9" * 3000,
    "a product": "2**1000*2**1000",
    "tuples with equal hashes": "python.set([(0,)*98+(i*(2**61-1),) for i in python.range(9999)])",
    "a set that grows": f"[s.add(i*(2**61-1)) for s in [python.set()] {MANY_TIMES}]",
    "a set that is updated": f"[s.update({COLLIDING}) for s in [python.set()]]",
    "a table that is updated": f"[s.update(dict.fromkeys({COLLIDING})) for s in [dict()]]",
    "comparing": f"[l == m for l in [{ZEROS}] for m in [[0]*900000] {MANY_TIMES}]",
    "comparing without a call": "[0.0]*9 == " + " == ".join(["[0]*900000"] * 300),
    "searching": f"[1 in l for l in [{ZEROS}] {MANY_TIMES}]",
    "searching nested values": f"[[2] in l for l in [[[1]]*400000] {MANY_TIMES}]",
    "counting": f"[l.count(1) for l in [{ZEROS}] {MANY_TIMES}]",
    "sorting": f"[l.sort() for l in [[0.0, 1]*400000] {MANY_TIMES}]",
    "inserting": f"[l.insert(0, 1) for l in [{ZEROS}] {MANY_TIMES}]",
    "largest": f"[max(l) for l in [{ZEROS}] {MANY_TIMES}]",
    "exact sums": f"[math.fsum(l) for l in [[1e308, -1e308]*400000] {MANY_TIMES}]",
    "hashing": f"[python.hash(t) for t in [(0,)*900000] {MANY_TIMES}]",
    "lists": f"[l[::-1] for l in [[0.0]*9000] {MANY_TIMES}]",
    "empty sets": f"[[python.set()] {MANY_TIMES}]",
    "splitting": f"[s.split('a') for s in ['a'*900000] {MANY_TIMES}]",
    "changing letters": f"[s.title() for s in ['a '*400000] {MANY_TIMES}]",
    "searching texts": f"[s.rfind('ba') for s in ['a'*900000] {MANY_TIMES}]",
    "arguments with stars": f"[max(*l, *l, *l, *l) for l in [{ZEROS}] {MANY_TIMES}]",
}

ROBOT = '<robot name="r"><link name="a"/></robot>'
CONTROL = (
    '<robot name="r"><link name="a"/><gazebo><plugin name="gazebo_ros2_control" '
    'filename="libgazebo_ros2_control.so"><parameters>$(find robot)/b.yaml</parameters></plugin>'
    "</gazebo></robot>"
)
LOAD = models.document("<link name=\"a${len(str(xacro.load_yaml('b.yaml')))}\"/>")
LAUGHING = "a0: &a0 [x, x]\n" + "".join(
    f"a{n}: &a{n} [{', '.join([f'*a{n - 1}'] * 9)}]\n" for n in range(1, 12)
)


def doubling(text: str, count: int, last: str) -> dict[str, str]:
    """Files 0, 1, ... of which each names the next one twice."""
    return {f"{n}.x": text.format(f"{n + 1}.x") for n in range(count)} | {f"{count}.x": last}


def launches(body: str) -> dict[str, str]:
    return {"b.launch": f"<launch>{body}</launch>"}


def numbered(count: int) -> str:
    """So many attributes."""
    return " ".join(f'a{n}=""' for n in range(count))


#: Files, of which the first is checked, and the beginning of a code that tells what is wrong with
#: it; empty where nothing is. Texts of megabytes are made where they are needed.
FILES: dict[str, tuple[Mapping[str, str | Callable[[], str]], str]] = {
    **{what: ({"r.urdf": text}, "XAC013") for what, text in DEEP_DTD.items()},
    "aliases": ({"b.xacro": LOAD, "b.yaml": LAUGHING}, "XAC013"),
    "a number to the base of 60": (
        {"b.xacro": LOAD, "b.yaml": "a: 1" + ":1" * 400_000},
        "XAC013",
    ),
    "a hexadecimal number": ({"b.xacro": LOAD, "b.yaml": "a: 0x" + "f" * 900_000}, "XAC013"),
    "keys with equal hashes": (
        {"b.xacro": LOAD, "b.yaml": "".join(f"{i * (2**61 - 1)}: 1\n" for i in range(9000))},
        "XAC013",
    ),
    "many short values": ({"b.xacro": LOAD, "b.yaml": "[" + "1," * 500_000 + "]"}, "XAC013"),
    "deep parameters": ({"b.urdf": CONTROL, "b.yaml": "[" * 900_000}, ""),
    "aliases of parameters": ({"b.urdf": CONTROL, "b.yaml": LAUGHING}, ""),
    "includes that multiply": (
        {"b.xacro": models.document('<xacro:include filename="0.x"/>')}
        | doubling(
            models.document('<xacro:include filename="{0}"/><xacro:include filename="{0}"/>'),
            40,
            models.document("<a/>"),
        ),
        "XAC013",
    ),
    "a launch file of itself": (launches('<include file="b.launch"/>' * 2), ""),
    "launch files that multiply": (
        {"b.launch": '<launch><include file="$(dirname)/0.x"/></launch>'}
        | doubling(
            '<launch><include file="$(dirname)/{0}"/><include file="$(dirname)/{0}"/></launch>',
            40,
            "<launch/>",
        ),
        "",
    ),
    "a deep launch file": (launches("<group>" * 100_000 + "</group>" * 100_000), ""),
    "an expression of a launch file": (launches("<arg name='a' value='$(eval 9**9**9)'/>"), ""),
    "a deep program": ({"b.launch.py": "x = " + "(" * 50_000}, ""),
    "a long program": ({"b.launch.py": "x = " + "-" * 900_000 + "1"}, ""),
    "deep groups": (
        {
            "r.urdf": ROBOT,
            "r.srdf": '<robot name="r">'
            + "".join(
                f'<group name="g{n}"><group name="g{n + 1}"/><group name="g{n + 1}"/></group>'
                for n in range(60)
            )
            + "</robot>",
        },
        "",
    ),
    "a deep SRDF": (
        {"r.urdf": ROBOT, "r.srdf": '<robot name="r">' + "<group>" * 100_000},
        "",
    ),
    "a hostile SRDF": (
        {
            "r.urdf": ROBOT,
            "r.srdf.xacro": models.document("<a b='${[[0]*900000 for i in python.range(9999)]}'/>"),
        },
        "",
    ),
    "a deep robot": (
        {"r.urdf": f'<robot name="r">{"<a>" * 100_000}{"</a>" * 100_000}</robot>'},
        "",
    ),
    "attributes": (
        {"r.urdf": lambda: f'<robot name="r"><link {numbered(1_000_000)}/></robot>'},
        "XAC013",
    ),
    "a long text": (
        {"r.urdf": lambda: f'<robot name="r">{"a " * 10_000_000}<link name="a"/></robot>'},
        "",
    ),
    "elements": ({"r.urdf": lambda: f'<robot name="r">{"<a/>" * 2_000_000}</robot>'}, "XAC013"),
    "a launch file in Python": (
        {"b.launch.py": lambda: "x = 1\n" * 300_000},
        "LAU001",
    ),
    "a manifest": (
        {"r.urdf": ROBOT, "package.xml": "<package>" + "<depend>a</depend>" * 50_000},
        "",
    ),
}

#: Limits of the process. The slowest file takes 5 seconds on a usual machine; without a bound each
#: would take minutes, so that a slow machine must not fail here.
CPU_SECONDS = 25
MEMORY = 640 * 2**20


def limit() -> None:
    import resource

    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (CPU_SECONDS, CPU_SECONDS + 1))


#: Expands in a thread, where no signal interrupts anything.
IN_THREAD = """
import sys, threading
from urdfkit.cli import main
codes = []
thread = threading.Thread(target=lambda: codes.append(main(sys.argv[1:])))
thread.start()
thread.join()
sys.exit(codes[0])
"""


def checked(file: Path, *program: str) -> dict[str, set[int]]:
    """The codes of what is reported about a file within the limits, with the lines."""
    words = ["check", "--no-cache", "--format", "json", str(file)]
    done = subprocess.run(
        [sys.executable, *(program or ("-m", "urdfkit")), *words],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
        preexec_fn=limit,
    )
    assert done.returncode in (0, 1), done.stderr
    assert done.stderr == ""
    report = json.loads(done.stdout)
    assert report["crashed"] == []
    found: dict[str, set[int]] = {}
    for one in report["diagnostics"]:
        found.setdefault(one["code"], set()).add(one["line"])
    return found


on_unix = pytest.mark.skipif(sys.platform == "win32", reason="there are no limits of a process")


def placed_bomb(what: str, workspace: Path) -> tuple[Path, str]:
    """A file that holds a bomb, and the code that is reported."""
    text, code = BOMBS[what]
    (workspace / "part.xacro").write_text(models.document("<l/>"), encoding="utf-8")
    file = workspace / "robot.xacro"
    file.write_text(text if text.startswith(("<!D", "<?")) else models.document(text))
    return file, code


@on_unix
@pytest.mark.parametrize("what", BOMBS)
def test_a_bomb_ends_in_a_report(what: str, workspace: Path) -> None:
    file, code = placed_bomb(what, workspace)
    assert code in checked(file)


@on_unix
@pytest.mark.parametrize("what", BOMBS)
def test_a_bomb_ends_in_a_report_without_the_system(what: str, workspace: Path) -> None:
    """By the bounds of the sandbox alone, as on Windows."""
    file, code = placed_bomb(what, workspace)
    assert code in checked(file, "-c", IN_THREAD)


@on_unix
@pytest.mark.parametrize("what", EXPRESSIONS)
def test_an_expression_ends_without_the_system(what: str, workspace: Path) -> None:
    expression = EXPRESSIONS[what].replace("&", "&amp;").replace("<", "&lt;")
    file = workspace / "robot.xacro"
    file.write_text(models.document(f'<link name="b${{len(str({expression}))}}"/>'))
    assert checked(file, "-c", IN_THREAD).keys() & {"XAC009", "XAC013"}


@on_unix
@pytest.mark.parametrize("what", EXPRESSIONS)
def test_an_expression_ends_in_one_finding_at_its_place(what: str, workspace: Path) -> None:
    expression = EXPRESSIONS[what].replace("&", "&amp;").replace("<", "&lt;")
    file = workspace / "robot.xacro"
    text = f'\n<link name="a"/>\n<link name="b${{len(str({expression}))}}"/>\n'
    file.write_text(models.document(text), encoding="utf-8")
    line = file.read_text(encoding="utf-8").split('<link name="b')[0].count("\n") + 1
    found = checked(file)
    (code,) = found.keys() & {"XAC009", "XAC013"}
    assert found[code] == {line}


@on_unix
@pytest.mark.parametrize("what", FILES)
def test_files_end_in_a_report(what: str, workspace: Path) -> None:
    files, code = FILES[what]
    for name, text in files.items():
        (workspace / name).write_text(text if isinstance(text, str) else text(), encoding="utf-8")
    found = checked(workspace / next(iter(files)))
    assert not code or code in found


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
