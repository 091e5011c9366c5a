"""URIs of files as editors write them, and texts as their files would be."""

from types import SimpleNamespace

import pytest

pytest.importorskip("pygls")

from urdfkit.lsp import text
from urdfkit.lsp.text import to_bytes, to_path, to_uri
from urdfkit.text.source import Source


@pytest.mark.parametrize(
    "path", ["/tmp/a b/é#?%.urdf", "/tmp/\N{ROBOT FACE}.xacro", "/tmp/\udcff.urdf", "/c:/x.urdf"]
)
def test_a_path_comes_back(path: str) -> None:
    assert to_path(to_uri(path)) == path
    assert set(to_uri(path)) <= set(map(chr, range(33, 127)))


@pytest.mark.parametrize("uri", ["untitled:Untitled-1", "git:/a/b.urdf?ref", "vscode-remote://h/x"])
def test_what_is_no_file_stays_what_it_is(uri: str) -> None:
    assert to_path(uri) == uri


@pytest.mark.parametrize(
    ("uri", "path"),
    [
        ("file:///c%3A/Users/a%20b/r.urdf", "c:\\Users\\a b\\r.urdf"),
        ("file:///C:/r.urdf", "C:\\r.urdf"),
        ("file://wsl.localhost/Ubuntu/r.urdf", "\\\\wsl.localhost\\Ubuntu\\r.urdf"),
    ],
)
def test_drives_and_shares_of_windows(uri: str, path: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(text, "os", SimpleNamespace(name="nt", sep="\\"))
    assert to_path(uri) == path


@pytest.mark.parametrize(
    ("declared", "encoding"), [("utf-8", "utf-8"), ("iso-8859-1", "latin-1"), ("UTF-16", "utf-16")]
)
def test_a_text_is_what_its_file_would_be(declared: str, encoding: str) -> None:
    written = f'<?xml version="1.0" encoding="{declared}"?><robot name="é"/>'
    data = to_bytes("r.urdf", written)
    assert data.decode(encoding) == written
    assert Source("r.urdf", data).data == written.encode()


def test_a_text_of_no_known_encoding_is_taken_as_it_is() -> None:
    written = '<?xml version="1.0" encoding="klingon"?><robot/>'
    assert to_bytes("r.urdf", written) == written.encode()
