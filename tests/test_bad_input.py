"""Damaged, hostile and huge files: findings, never a traceback; soon, and in little memory.

The damage is random but the same in every run. What a strict parser or stock xacro refuses must
not pass as a sound robot.
"""

import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from xml.parsers import expat

import pytest
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st

from tests.conftest import CORPUS, MODELS, ROOT
from tests.xacro import stock
from tests.xacros import NAMESPACE, xacro
from urdfkit.errors import UrdfkitError
from urdfkit.lint import engine
from urdfkit.lint.report import Report
from urdfkit.text.diagnostic import Severity
from urdfkit.text.file_kinds import is_xacro
from urdfkit.text.source import Source
from urdfkit.xacro import expansion

resource = pytest.importorskip("resource", reason="memory is limited on Unix only")

OURS = sorted(
    path for path in MODELS.rglob("*") if path.name.endswith((".urdf", ".xacro", ".launch"))
)
SMALL = 12_000  # bytes
#: Every fortieth small file of the corpus: another robot each time.
REAL = sorted(
    path
    for path in CORPUS.rglob("*")
    if path.suffix in (".urdf", ".xacro") and path.stat().st_size < SMALL
)[::40]
FILES = OURS + REAL

PIECES = [
    b"<", b">", b"/", b'"', b"'", b"&", b"=", b"--", b"]]>", b"<!--", b"-->", b"<![CDATA[", b"<?",
    b"<!DOCTYPE r [<!ENTITY a 'b'>]>", b"\0", b"\xff", b"\xf0\x9f\xa4\x96", b"\r", b"\n",
    b"${", b"}", b"$(", b")", b"$(arg x)", b"${x}", b"$(find none)", b"<link>", b"</link>",
    b"<xacro:if>", b"<xacro:include/>", b"<xacro:property name='a' value='${a}'/>",
    b"<xacro:macro name='m'><xacro:m/></xacro:macro><xacro:m/>", b"<mesh filename='%00'/>",
]  # fmt: skip

NUMBERS = [
    b"nan", b"inf", b"-inf", b"1e400", b"-1e400", b"1e-400", b"9" * 400, b"0x10", b"1_000", b"0,5",
    b"", b" ", b"0" * 5000, b"1e308", "\u0663".encode(), b"1 2 3 4 5 6 7", b"--1", b"1e", b".",
]  # fmt: skip

ENCODINGS = ["utf-8-sig", "utf-16", "utf-16-le", "utf-32", "latin-1", "cp1252", "gbk", "cp037"]

bounded = settings(
    derandomize=True,
    suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow],
)


def examine(path: Path, data: bytes) -> Report | None:
    """The report on a file as if it stood at a path; None where the job cannot be done."""
    try:
        report = engine.check(Source(str(path), data))
    except UrdfkitError:
        return None
    assert [f"{crash.code}: {crash.error}\n{crash.traceback}" for crash in report.crashed] == []
    return report


def errors(report: Report) -> list[str]:
    return [one.code for one in report.diagnostics if one.severity is Severity.ERROR]


def is_strict(data: bytes) -> bool:
    """True for what a strict XML parser accepts."""
    try:
        expat.ParserCreate(None, " ").Parse(data, True)
    except (expat.ExpatError, ValueError):  # ValueError: an encoding that Python's expat lacks
        return False
    return True


def is_refused_aloud(path: Path, data: bytes) -> bool:
    """True unless a file that strict readers refuse passes without a word."""
    report = examine(path, data)
    if report is None or errors(report):
        return True
    codes = {one.code for one in report.diagnostics}
    is_part = any(one.code == "XAC001" for one in report.diagnostics)  # an info
    forgiven = is_part or bool(codes & {"XML007", "XAC003"})
    return is_strict(data) or forgiven


files = st.sampled_from(FILES)
places = st.integers(0, SMALL)


class TestDamage:
    @bounded
    @given(files, st.lists(st.tuples(places, st.integers(1, 255)), min_size=1, max_size=4))
    def test_flipped_bytes(self, path: Path, flips: list[tuple[int, int]]) -> None:
        data = bytearray(path.read_bytes())
        for at, mask in flips:
            data[at % len(data)] ^= mask
        assert is_refused_aloud(path, bytes(data))

    @bounded
    @given(files, places)
    def test_cut_off(self, path: Path, at: int) -> None:
        data = path.read_bytes()
        assert is_refused_aloud(path, data[: at % len(data)])

    @bounded
    @given(files, st.lists(st.tuples(places, st.sampled_from(PIECES)), min_size=1, max_size=3))
    def test_pieces_put_in(self, path: Path, pieces: list[tuple[int, bytes]]) -> None:
        data = path.read_bytes()
        for place, piece in pieces:
            at = place % (len(data) + 1)
            data = data[:at] + piece + data[at:]
        assert is_refused_aloud(path, data)

    @bounded
    @given(files, st.data())
    def test_tags_deleted_doubled_or_swapped(self, path: Path, draw: st.DataObject) -> None:
        parts = re.split(rb"(<[^<>]*>)", path.read_bytes())
        for _ in range(draw.draw(st.integers(1, 4))):
            one, other = (draw.draw(st.integers(0, len(parts) - 1)) for _ in range(2))
            match draw.draw(st.sampled_from(["delete", "double", "swap"])):
                case "delete":
                    parts[one] = b""
                case "double":
                    parts[one] *= 2
                case _:
                    parts[one], parts[other] = parts[other], parts[one]
        assert is_refused_aloud(path, b"".join(parts))

    @bounded
    @given(files, st.data())
    def test_values_replaced_or_swapped(self, path: Path, draw: st.DataObject) -> None:
        parts = re.split(rb'("[^"<>]*")', path.read_bytes())
        values = range(1, len(parts), 2)
        assume(len(values) > 1)
        for _ in range(draw.draw(st.integers(1, 6))):
            one, other = (draw.draw(st.sampled_from(values)) for _ in range(2))
            if draw.draw(st.booleans()):
                parts[one] = b'"' + draw.draw(st.sampled_from(NUMBERS)) + b'"'
            else:
                parts[one], parts[other] = parts[other], parts[one]
        assert is_refused_aloud(path, b"".join(parts))

    @bounded
    @given(files, st.sampled_from(ENCODINGS))
    def test_other_encodings(self, path: Path, encoding: str) -> None:
        text = path.read_bytes().decode()
        assert is_refused_aloud(path, text.encode(encoding, "replace"))

    @bounded
    @given(files, st.binary(max_size=300))
    def test_anything(self, path: Path, data: bytes) -> None:
        assert is_refused_aloud(path, data)


@bounded
@given(st.sampled_from([path for path in OURS if path.suffix == ".xacro"]), st.data())
def test_what_stock_xacro_refuses_is_an_error(
    tmp_path_factory: pytest.TempPathFactory, path: Path, draw: st.DataObject
) -> None:
    parts = re.split(rb'("[^"<>]*"|<[^<>"]*>|[${}()]+)', path.read_bytes())
    for _ in range(draw.draw(st.integers(1, 3))):
        at = draw.draw(st.integers(0, len(parts) - 1))
        parts[at] = draw.draw(st.sampled_from([b"", b"x", b"${y}", parts[at] * 2, b"<xacro:z/>"]))
    package = path.parents[1]
    damaged = path.with_name(f"damaged_{path.name}")
    copy = tmp_path_factory.mktemp("damaged") / damaged.name
    copy.write_bytes(b"".join(parts))
    expected = stock.expand(copy, packages={package.name: str(package)})
    report = examine(damaged, b"".join(parts))
    assert report is not None
    if expected.error is not None:
        assert errors(report)


BOMB = "<!DOCTYPE robot [<!ENTITY a 'aaaaaaaaaa'>{}]>".format(
    "".join(
        f"<!ENTITY {b} '{f'&{a};' * 10}'>" for a, b in zip("abcdefghi", "bcdefghij", strict=True)
    )
)
DOUBLING = "".join(
    f'<xacro:macro name="m{n + 1}"><xacro:m{n}/><xacro:m{n}/></xacro:macro>' for n in range(60)
)
CIRCLE = (
    '<xacro:property name="a" value="${b}"/><xacro:property name="b" value="${a}"/>'
    '<link name="${a}"/>'
)
LONG = "${" + "+".join("1" for _ in range(9000)) + "}"


class TestHostile:
    @pytest.mark.parametrize(
        ("body", "code"),
        [
            ('<xacro:macro name="m"><xacro:m/></xacro:macro><xacro:m/>', "XAC013"),
            ('<xacro:macro name="m0"><a/></xacro:macro>' + DOUBLING + "<xacro:m60/>", "XAC013"),
            ('<xacro:property name="a" value="${a}"/><link name="${a}"/>', "XAC001"),
            (CIRCLE, "XAC001"),
            ('<link name="${9**9**9}"/>', "XAC013"),
            ('<link name="${1&lt;&lt;10**9}"/>', "XAC013"),
            ("<link name=\"${'%999999999d' % 1}\"/>", "XAC013"),
            ("<link name=\"${'a'.ljust(10**10)}\"/>", "XAC013"),
            ('<link name="${[[]]*10**9}"/>', "XAC013"),
            ('<link name="${sum([x for y in range(9999) for x in range(9999)])}"/>', None),
            (f'<link name="{LONG}"/>', None),
            (f'<link name="{"${" * 5000}{"}" * 5000}"/>', None),
            (f'<link name="${{{"(" * 500}1{")" * 500}}}"/>', None),
            (f'<link name="${{{"-" * 9000}1}}"/>', None),
            ("<a>" * 3000 + "</a>" * 3000, None),
            ('<xacro:include filename="robot.xacro"/>', None),
            ('<xacro:include filename="/dev/zero"/>', "XAC009"),
            ('<xacro:include filename="a&#0;b"/>', "XML001"),
            ("<link name=\"${xacro.load_yaml('/proc/self/environ')}\"/>", "XAC009"),
            ("<link name=\"${''.__class__.__mro__[1].__subclasses__()}\"/>", "XAC009"),
            ('<xacro:element xacro:name="${1}"/>', None),
            ('<xacro:attribute name="${none}" value="a"/><link name="a"/>', "XAC001"),
            ('<xacro:macro name="" params="*"/><xacro:/>', None),
            ('<xacro:call macro="${none}"/>', "XAC001"),
        ],
    )
    def test_xacro(
        self,
        body: str,
        code: str | None,
        monkeypatch: pytest.MonkeyPatch,
        tmp_path: Path,
    ) -> None:
        monkeypatch.setattr(expansion, "MAX_CALLS", 2000)
        path = tmp_path / "robot.xacro"
        path.write_text(xacro(body), encoding="utf-8")
        report = examine(path, path.read_bytes())
        assert report is not None
        assert errors(report)
        if code is not None:
            assert code in errors(report)

    @pytest.mark.parametrize("name", ["robot.urdf", "robot.xacro"])
    @pytest.mark.parametrize("use", ['<link name="&j;"/>', "<link name='a'/>&j;", ""])
    def test_an_entity_bomb(self, name: str, use: str) -> None:
        report = examine(Path(name), f'{BOMB}<robot name="r" {NAMESPACE}>{use}</robot>'.encode())
        assert report is not None
        assert errors(report)

    def test_includes_in_a_circle(self, tmp_path: Path) -> None:
        for one, other in (("a", "b"), ("b", "c"), ("c", "a")):
            text = xacro(f'<xacro:include filename="{other}.xacro"/>' * 2)
            (tmp_path / f"{one}.xacro").write_text(text, encoding="utf-8")
        report = examine(tmp_path / "a.xacro", (tmp_path / "a.xacro").read_bytes())
        assert report is not None
        assert errors(report) == ["XAC013"]

    def test_yaml_that_multiplies(self, tmp_path: Path) -> None:
        levels = "".join(f"a{n}: &a{n} [{', '.join([f'*a{n - 1}'] * 9)}]\n" for n in range(1, 12))
        (tmp_path / "bomb.yaml").write_text("a0: &a0 [x, x]\n" + levels, encoding="utf-8")
        body = "<link name=\"${xacro.load_yaml('bomb.yaml')['a11']}\"/>"
        report = examine(tmp_path / "robot.xacro", xacro(body).encode())
        assert report is not None
        assert "XAC013" in errors(report)


MANY = 100_000
LINKED = 30_000  # thirty times the depth of Python's recursion
LINKS = "".join(f'<link name="l{n}"/>' for n in range(LINKED))
JOINTS = "".join(
    f'<joint name="j{n}" type="fixed"><parent link="l{n}"/><child link="l{n + 1}"/></joint>'
    for n in range(LINKED - 1)
)
BACK = f'<joint name="back" type="fixed"><parent link="l{LINKED - 1}"/><child link="l0"/></joint>'


def robot(body: str, namespace: str = "") -> str:
    return f'<robot name="r"{namespace}>{body}</robot>'


def attributes() -> str:
    given = " ".join(f'a{n}="{n}"' for n in range(MANY))
    return robot(f'<link name="a" {given}/>')


HUGE: dict[str, tuple[Callable[[], str], set[str]]] = {
    "a chain of 30 000 links": (lambda: robot(LINKS + JOINTS), set()),
    "a loop of 30 000 links": (lambda: robot(LINKS + JOINTS + BACK), {"TRE003"}),
    "30 000 roots": (lambda: robot(LINKS), {"TRE002"}),
    "100 000 attributes": (attributes, set()),
    "100 000 levels": (lambda: robot("<a>" * MANY + "</a>" * MANY), {"TRE001"}),
    "100 000 levels of xacro": (
        lambda: robot("<a>" * MANY + "</a>" * MANY, f" {NAMESPACE} a='${{1}}'"),
        {"XAC013"},
    ),
    "100 000 tags that are not closed": (lambda: robot("<a>" * MANY), {"XML001"}),
    "a comment of 30 MB": (lambda: robot(f"<!--{'x' * 30_000_000}--><link name='a'/>"), set()),
    "a text of 30 MB": (
        lambda: robot(f"<gazebo>{'x ' * 15_000_000}</gazebo><link name='a'/>"),
        set(),
    ),
    "elements of 30 MB": (lambda: robot("<link/>" * 4_300_000), {"XAC013"}),
    "tags of 30 MB that are not closed": (lambda: "<a>" * 10_000_000, {"XAC013"}),
    "more than 64 MB": (lambda: " " * (65 * 2**20), {"refused"}),
}


def limit_memory() -> None:
    resource.setrlimit(resource.RLIMIT_AS, (2 * 2**30, 2 * 2**30))


@pytest.mark.parametrize("name", HUGE)
def test_huge_files_on_the_command_line(name: str, tmp_path: Path) -> None:
    make, codes = HUGE[name]
    file = tmp_path / "robot.urdf"
    file.write_text(make(), encoding="utf-8")
    result = subprocess.run(
        [sys.executable, "-m", "urdfkit", "check", "--format", "statistics", str(file)],
        capture_output=True,
        text=True,
        check=False,
        cwd=ROOT,
        timeout=120,
        preexec_fn=limit_memory,
    )
    assert "Traceback" not in result.stderr
    if codes == {"refused"}:
        assert result.returncode == 2
        assert "larger than 64 MiB" in result.stderr
        return
    assert result.returncode in (0, 1)
    found = dict(re.findall(r"^ *\d+ +(\S+) +(error|warning|info)", result.stdout, re.MULTILINE))
    assert {code for code, severity in found.items() if severity == "error"} == codes


def test_every_file_is_of_another_kind() -> None:
    assert {is_xacro(Source.read(path)) for path in FILES} == {True, False}
    assert len(OURS) >= 6
