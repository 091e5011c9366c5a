import pytest

from tests.naming import naming
from tests.reported import reported

ROBOT = '<robot name="r"><!-- größe --><link name="a"/></robot>'


def declared(encoding: str) -> bytes:
    return f'<?xml version="1.0" encoding="{encoding}"?>{ROBOT}'.encode(encoding)


def test_a_byte_that_is_not_utf_8() -> None:
    (found,) = reported("XML002", ROBOT.encode("latin-1"))
    assert (found.span.line, found.span.column) == (1, 24)
    assert found.message == naming("byte", "utf-8")


def test_a_byte_that_is_not_what_is_declared() -> None:
    data = declared("utf-8").replace("ö".encode(), b"\xf6")
    (found,) = reported("XML002", data)
    assert found.span.start == data.index(b"\xf6")
    assert found.message == naming("byte", "utf-8")


def test_an_encoding_that_does_not_exist() -> None:
    (found,) = reported("XML002", b'<?xml version="1.0" encoding="klingon"?><robot name="r"/>')
    assert found.span.text == "klingon"
    assert found.message == naming("encoding", "klingon")


@pytest.mark.parametrize("encoding", ["UTF-16", "utf-16le", "UTF-32"])
def test_one_byte_for_a_character(encoding: str) -> None:
    """A declaration of an editor that saves in UTF-8."""
    data = f'<?xml version="1.0" encoding="{encoding}"?>\n<robot name="r"><link name="a"/></robot>'
    (found,) = reported("XML", data.encode())
    assert found.code == "XML002"
    assert found.span.text == encoding
    assert found.message == naming(encoding.lower())
    assert found.fix
    assert [edit.text for edit in found.fix.edits] == ["UTF-8"]
    (found,) = reported("XML002", data.replace('"a"', '"größe"').encode())
    assert found.fix is None


@pytest.mark.parametrize("encoding", ["utf-16", "utf-32", "utf-16-le", "utf-16-be"])
def test_utf_16_which_urdfdom_refuses(encoding: str) -> None:
    (found,) = reported("XML002", ROBOT.encode(encoding))
    assert (found.span.start, found.span.end) == (0, 0)
    assert found.message == naming(encoding, "urdfdom", "UTF-8")


def test_a_chinese_encoding() -> None:
    data = '<?xml version="1.0" encoding="gbk"?><robot name="r"><!-- 机器人 --></robot>'.encode(
        "gbk"
    )
    (found,) = reported("XML002", data)
    assert found.message == naming("urdfdom", "UTF-8")


@pytest.mark.parametrize("encoding", ["latin-1", "iso-8859-1", "cp1252"])
def test_one_byte_per_character_is_readable_as_urdf_but_not_as_xacro(encoding: str) -> None:
    assert reported("XML002", declared(encoding)) == []
    (found,) = reported("XML002", declared(encoding), "robot.xacro")
    assert found.message == naming(encoding, "UTF-8")


@pytest.mark.parametrize("name", ["robot.urdf", "robot.xacro"])
@pytest.mark.parametrize(
    "data",
    [
        ROBOT.encode(),
        ROBOT.encode("utf-8-sig"),
        declared("utf-8"),
        declared("UTF-8"),
        b'<?xml version="1.0" encoding="latin-1"?><robot name="r"><link name="a"/></robot>',
        b'<?xml version="1.0" encoding="us-ascii"?><robot name="r"><link name="a"/></robot>',
    ],
)
def test_what_everybody_reads(data: bytes, name: str) -> None:
    assert reported("XML002", data, name) == []


@pytest.mark.parametrize("name", ["robot.urdf", "robot.xacro"])
@pytest.mark.parametrize("data", [bytes(range(256)) * 4, b"\x1f\x8b\x08\x08\xff\xfe, a gzip"])
def test_what_is_no_text_has_no_encoding(data: bytes, name: str) -> None:
    assert reported("XML002", data, name) == []
    (found,) = reported("XML001", data, name)
    assert found.message.startswith("not a")
