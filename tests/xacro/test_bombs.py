"""Small files that would be immense end in a report, within bounds of memory and time."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

from tests.conftest import ROOT
from tests.xacro import models
from tests.xacro.strangers import run


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
