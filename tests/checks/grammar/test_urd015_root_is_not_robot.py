from tests.naming import naming
from tests.reported import fixed, messages, reported
from urdfkit.lint import engine
from urdfkit.text.source import Source


def test_another_format_is_one_error_and_no_more() -> None:
    text = b'<sdf version="1.6"><model name="m"><link name="l"><pose>0</pose></link></model></sdf>'
    report = engine.check(Source("model.sdf", text))
    assert [(found.code, found.message) for found in report.diagnostics] == [
        ("URD015", naming("<sdf>", "<robot>"))
    ]
    assert report.diagnostics[0].fix is None
    assert report.diagnostics[0].help.startswith("gz sdf --check")


def test_a_world_is_checked_with_what_starts_it() -> None:
    text = b'<sdf version="1.9"><world name="w"/></sdf>'
    (found,) = engine.check(Source("hall.world", text)).diagnostics
    assert found.code == "URD015"
    assert "world" in found.help
    assert "urdfkit check PACKAGE" in found.help


def test_a_misspelt_robot_gets_its_name_back() -> None:
    robot = '<robt name="r">\n  <link name="a"/>\n</robt>\n'
    assert messages("URD015", robot) == [naming("<robt>", "<robot>")]
    assert fixed("URD015", robot) == robot.replace("robt", "robot")


def test_a_file_of_macros_may_have_any_root() -> None:
    library = '<macros {}><xacro:macro name="m" params=""/></macros>'
    namespace = 'xmlns:xacro="http://www.ros.org/wiki/xacro"'
    assert reported("URD015", library.format(namespace), "macros.xacro") == []
