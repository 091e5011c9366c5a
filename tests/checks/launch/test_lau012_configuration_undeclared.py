"""LAU012: see the rule."""

from pathlib import Path

import pytest

from tests.launched import launch, reported

USE = "LaunchConfiguration('model')\n"


def test_in_python(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, "LAU012", "a.launch.py", USE)
    assert found.message == "no argument 'model' is declared"
    assert found.span.text == "LaunchConfiguration('model')"


def test_in_xml(tmp_path: Path) -> None:
    text = '<let name="x" value="1"/><log message="$(var model)"/>'
    (found,) = reported(tmp_path, "LAU012", "a.launch", text)
    assert (found.message, found.span.line) == ("no argument 'model' is declared", 2)


@pytest.mark.parametrize(
    "head",
    [
        "DeclareLaunchArgument('model')\n",
        "SetLaunchConfiguration('model', 'x')\n",
        "from arm_bringup.helpers import declare\n",
        "for n in names: DeclareLaunchArgument(n)\n",
        "IncludeLaunchDescription(somewhere())\n",
        "DeclareLaunchArgument('modell')\n",  # which LAU006 tells
    ],
)
def test_what_may_be_declared_is_calm(tmp_path: Path, head: str) -> None:
    assert reported(tmp_path, "LAU012", "a.launch.py", head + USE) == []


def test_launch_files_that_come_with_ros_declare_nothing(tmp_path: Path) -> None:
    head = "IncludeLaunchDescription([FindPackageShare('{}'), '/launch/x.launch.py'])\n"
    assert len(reported(tmp_path, "LAU012", "a.launch.py", head.format("ros_gz_sim") + USE)) == 1
    assert reported(tmp_path, "LAU012", "a.launch.py", head.format("some_arm") + USE) == []


def test_a_file_that_others_include_may_get_it_there(tmp_path: Path) -> None:
    outer = {"launch/b.launch": launch('<include file="$(dirname)/a.launch.py"/>')}
    assert reported(tmp_path, "LAU012", "a.launch.py", USE, outer) == []


def test_a_file_whose_name_is_put_together_elsewhere_may_get_it_there(tmp_path: Path) -> None:
    includes = "IncludeLaunchDescription([folder, '/launch/gz_', name, '{}'])\n"
    for end, count in ((".launch.py", 0), ("_arm.launch.py", 0), ("_base.launch.py", 1)):
        outer = {"launch/b.launch.py": includes.format(end)}
        assert len(reported(tmp_path, "LAU012", "gz_arm.launch.py", USE, outer)) == count


def test_a_configuration_that_nobody_reads_is_calm(tmp_path: Path) -> None:
    assert reported(tmp_path, "LAU012", "a.launch.py", "model = " + USE) == []
    assert (
        len(reported(tmp_path, "LAU012", "a.launch.py", "model = " + USE + "print(model)\n")) == 1
    )
