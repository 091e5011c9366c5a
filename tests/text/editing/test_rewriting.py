"""New texts for files: as diffs that ``patch`` applies, and written."""

import shutil
import subprocess
import tempfile
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from urdfkit.errors import UnwritableFile
from urdfkit.text.diagnostic import Edit
from urdfkit.text.editing.diff import diff
from urdfkit.text.editing.rewriting import Rewrite, rewrites, write
from urdfkit.text.source import Source, Span

CHANGES = {
    "plain": (b"<a>\n<b/>\n</a>\n", b"<a>\n<c/>\n</a>\n"),
    "no line end": (b"<a>\n<b/>\n</a>", b"<a>\n<c/>\n</a>\n"),
    "Windows": (b"<a>\r\n<b/>\r\n</a>\r\n", b"<a>\r\n<c/>\r\n</a>\r\n"),
    "other separators": (
        "<a>\n<!-- 1\u20282\x853\r4 -->\n<b/></a>\n".encode(),
        "<a>\n  <!-- 1\u20282\x853\r4 -->\n<c/></a>\n".encode(),
    ),
}


@pytest.mark.skipif(shutil.which("patch") is None, reason="it needs patch")
@pytest.mark.parametrize(
    ("name", "path"), [*((name, "a.urdf") for name in CHANGES), ("plain", "my arm [1].urdf")]
)
def test_patch_takes_the_diff(name: str, path: str, tmp_path: Path):
    before, after = CHANGES[name]
    file = tmp_path / path
    file.write_bytes(before)
    diff = Rewrite(path, before, after).diff()
    subprocess.run(
        ["patch", "-p0", "--binary", "-s"], input=diff.encode(), cwd=tmp_path, check=True
    )
    assert file.read_bytes() == after


def test_a_diff_is_text_whatever_the_encoding_of_the_file():
    before, after = ('<a b="\xe9"/>\n'.encode("utf-16"), '<a b="\xe8"/>\n'.encode("utf-16"))
    assert '-<a b="\xe9"/>\n+<a b="\xe8"/>\n' in Rewrite("a.urdf", before, after).diff()


def test_what_has_changed_meanwhile_stops_all(tmp_path: Path):
    files = [tmp_path / "a.urdf", tmp_path / "b.urdf"]
    for file in files:
        file.write_bytes(b"<a/>")
    rewrites = [Rewrite(str(file), b"<a/>", b"<b/>") for file in files]
    files[1].write_bytes(b"<c/>")
    with pytest.raises(UnwritableFile, match="the file changed meanwhile"):
        write(rewrites)
    assert [file.read_bytes() for file in files] == [b"<a/>", b"<c/>"]


def test_what_has_changed_since_it_was_read_is_not_rewritten(tmp_path: Path):
    (tmp_path / "a.urdf").write_bytes(b"<a/>")
    source = Source.read(tmp_path / "a.urdf")
    assert rewrites([Edit(Span(source, 1, 2), "b")])[0].after == b"<b/>"
    (tmp_path / "a.urdf").write_bytes(b"<c/>")
    with pytest.raises(UnwritableFile, match="the file changed meanwhile"):
        rewrites([Edit(Span(source, 1, 2), "b")])


def test_a_file_with_a_byte_that_is_no_text_is_not_rewritten(tmp_path: Path):
    """Its source has a question mark in place of the byte."""
    (tmp_path / "a.urdf").write_bytes(b"<a><!-- \xf6 --></a>")
    source = Source.read(tmp_path / "a.urdf")
    with pytest.raises(UnwritableFile, match="not valid text"):
        rewrites([Edit(Span(source, 1, 2), "b")])


@pytest.mark.skipif(shutil.which("patch") is None, reason="it needs patch")
@given(*[st.lists(st.sampled_from("abc"), max_size=12)] * 2)
def test_a_diff_is_the_smallest_and_patch_takes_it(old: list[str], new: list[str]) -> None:
    before, after = ("".join(f"{line}\n" for line in lines) for lines in (old, new))
    lines = diff("x", before.encode(), after.encode()).splitlines()
    changed = [line for line in lines[2:] if line[0] in "-+"]
    assert len(changed) == len(old) + len(new) - 2 * _longest(old, new)
    with tempfile.TemporaryDirectory() as directory:
        file = Path(directory, "x")
        file.write_text(before)
        patch = ["patch", "-s", "-p0"]
        text = diff("x", before.encode(), after.encode())
        subprocess.run(patch, input=text, text=True, cwd=directory, check=True)
        assert (file.read_text() if file.exists() else "") == after


def _longest(old: list[str], new: list[str]) -> int:
    """The length of the longest common subsequence, by its definition."""
    best = [[0] * (len(new) + 1) for _ in range(len(old) + 1)]
    for i, one in enumerate(old):
        for j, other in enumerate(new):
            longest = max(best[i][j + 1], best[i + 1][j])
            best[i + 1][j + 1] = best[i][j] + 1 if one == other else longest
    return best[-1][-1]


def test_lines_that_are_frequent_count_as_others_do() -> None:
    """Of 116 changed lines 580 were shown."""
    block = ["<link>", "<inertial>", "<mass/>", "</inertial>", "</link>", ""]
    old = block * 300
    new = [line for n, line in enumerate(old) if n % 31]
    shown = diff("x", *("\n".join([*lines, ""]).encode() for lines in (old, new))).splitlines()
    assert sum(line[0] in "-+" for line in shown[2:]) == len(old) - len(new)


def test_texts_that_have_nothing_in_common() -> None:
    old, new = (b"".join(b"%s%d\n" % (name, n) for n in range(3000)) for name in (b"a", b"b"))
    assert len(diff("x", old, new).splitlines()) == 6003
