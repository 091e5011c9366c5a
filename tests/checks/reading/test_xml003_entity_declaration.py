import pytest

from tests.naming import naming
from tests.reported import reported
from urdfkit.lint import engine
from urdfkit.text.source import Source

BOMB = (
    "<!DOCTYPE robot [<!ENTITY a0 'ha'>"
    + "".join(f"<!ENTITY a{n} '{f'&a{n - 1};' * 10}'>" for n in range(1, 12))
    + "]>\n"
)


def test_each_declaration_is_reported() -> None:
    robot = (
        '<!DOCTYPE robot [\n  <!ENTITY base "b">\n  <!ENTITY arm SYSTEM "/etc/passwd">\n]>\n'
        '<robot name="r"><link name="&base;"/></robot>'
    )
    found = reported("XML003", robot)
    assert [(one.span.line, one.span.column, one.message) for one in found] == [
        (2, 3, naming("entity", "base")),
        (3, 3, naming("entity", "arm")),
    ]


@pytest.mark.parametrize("name", ["robot.urdf", "robot.xacro"])
@pytest.mark.parametrize("use", ['<link name="&a11;"/>', '<link name="a"/>&a11;', ""])
def test_a_bomb_does_not_go_off(use: str, name: str) -> None:
    report = engine.check(Source(name, f'{BOMB}<robot name="r">{use}</robot>'.encode()))
    codes = {one.code for one in report.diagnostics}
    assert report.crashed == ()
    assert "XML003" in codes or "XML001" in codes
    assert report.exit_code() == 1


def test_a_document_type_without_entities_is_none() -> None:
    assert reported("XML003", '<!DOCTYPE robot>\n<robot name="r"><link name="a"/></robot>') == []
