from pathlib import Path

import pytest

from tests.naming import naming
from tests.reported import fixed, reported
from tests.urdfdom import needs_check_urdf, urdfdom_reads
from urdfkit.lint import engine
from urdfkit.text.source import Source

REST = '<robot name="r"><link name="a"/></robot>'


@pytest.mark.parametrize(
    "declaration",
    [
        '<?xml version="0.0" ?>',
        '<?xml verison="1.0"?>',
        '<?xml version="1.0" standalone="maybe"?>',
        "<?xml?>",
    ],
)
def test_a_declaration_of_another_kind(declaration: str) -> None:
    (found,) = reported("XML007", f"{declaration}\n{REST}")
    assert found.span.text == declaration
    assert found.message == naming("declaration", "1.0")
    assert fixed("XML007", f"{declaration}\n{REST}") == f'<?xml version="1.0"?>\n{REST}'


def test_white_space_before_the_declaration() -> None:
    robot = f'\n  <?xml version="1.0"?>{REST}'
    (found,) = reported("XML007", robot)
    assert (found.span.start, found.span.end) == (0, 3)
    assert found.message == naming("before", "declaration")
    assert fixed("XML007", robot) == robot.lstrip()


def test_a_comment_before_the_declaration() -> None:
    robot = f'<!-- a -->\n<!-- b -->\n<?xml version="1.0"?>\n{REST}'
    (found,) = reported("XML007", robot)
    assert found.span.start == 0
    assert found.message == naming("before", "urdfdom", "4", "ROS 2", "Jazzy", "rejects")
    after = fixed("XML007", robot)
    assert after == f'<?xml version="1.0"?>\n<!-- a -->\n<!-- b -->\n{REST}'
    assert reported("XML007", after) == []


def test_prefixes_without_a_declaration() -> None:
    robot = '<robot name="r">\n<drake:x/><drake:y/><link name="a" gz:b="1"/></robot>'
    found = reported("XML007", robot)
    assert [(one.span.column, one.span.text) for one in found] == [(2, "drake:x"), (36, "gz:b")]
    assert found[1].help == naming("declare", 'xmlns:gz="http://gazebosim.org/schema"')


@pytest.mark.parametrize(
    "robot",
    [
        REST,
        f'<?xml version="1.0"?>{REST}',
        f"<?xml version='1.0' encoding='utf-8' standalone='yes' ?>{REST}",
        f'<?xml version="1.1"?>{REST}',
        f"<!-- a -->{REST}",
        '<robot name="r" xmlns:gz="g"><gz:x gz:y="1" xml:lang="de"/><link name="a"/></robot>',
    ],
)
def test_strict_xml(robot: str) -> None:
    assert reported("XML007", robot) == []


def test_the_robot_is_checked_all_the_same() -> None:
    robot = '<?xml verison="1.0"?><robot name="r"><link name="a"/><link name="a"/></robot>'
    report = engine.check(Source("robot.urdf", robot.encode()))
    assert {"XML007", "NAM001"} <= {one.code for one in report.diagnostics}


@needs_check_urdf
@pytest.mark.parametrize(
    "before", ["\n", '<?xml verison="1.0"?>', '<?xml version="0.0"?>', "\n<?xml?>"]
)
def test_urdfdom_forgives_it(before: str, tmp_path: Path) -> None:
    assert urdfdom_reads(before + REST, tmp_path)


@needs_check_urdf
def test_urdfdom_does_not_forgive_text_before_the_declaration(tmp_path: Path) -> None:
    robot = f'text <?xml version="1.0"?>{REST}'
    assert not urdfdom_reads(robot, tmp_path)
    assert reported("XML001", robot)
