"""PKG007: see the rule."""

from pathlib import Path

import pytest

from tests.launched import MANIFEST, reported
from tests.naming import naming
from tests.workspaces import add_files, add_package
from urdfkit import Diagnostic, check

ROBOT = """<robot name="r"><link name="base">
<visual><geometry><mesh filename="package://arm/a.stl"/></geometry></visual>
</link></robot>"""


def built(directory: Path, build: str, more: dict[str, str] | None = None) -> list[Diagnostic]:
    files = {"CMakeLists.txt": build, **(more or {})}
    return reported(directory / "arm", "PKG007", "a.launch", "", files)


@pytest.mark.parametrize(
    "build", ["# project(arm)\nproject(amr VERSION 1.0)\n", 'PROJECT (\n  "amr")\n']
)
def test_another_name(tmp_path: Path, build: str) -> None:
    (found,) = built(tmp_path, build)
    assert found.message == naming("amr", "CMakeLists.txt", "arm", "package.xml")
    assert found.span.source.path == str(tmp_path / "arm" / "CMakeLists.txt")
    assert found.span.text == "amr"


@pytest.mark.parametrize(
    "build", ["project(arm)", "project(${NAME})", "", "# no project here", "myproject(amr)"]
)
def test_the_same_name_or_none_that_is_written_out(tmp_path: Path, build: str) -> None:
    assert built(tmp_path, build) == []


@pytest.mark.parametrize(("mesh", "count"), [("package://arm/a.stl", 1), ("a.stl", 0)])
def test_a_robot_that_refers_to_its_package(tmp_path: Path, mesh: str, count: int) -> None:
    files = {"package.xml": MANIFEST, "CMakeLists.txt": "project(amr)", "r.urdf": ROBOT}
    add_files(tmp_path, files | {"r.urdf": ROBOT.replace("package://arm/a.stl", mesh)})
    assert len(check(tmp_path / "r.urdf", select=["PKG007"]).diagnostics) == count


@pytest.mark.parametrize(
    ("last", "count"),
    [
        ("ament_package()", 0),
        ("ament_auto_package()", 0),
        ("# ament_package()", 1),
        ("", 1),
        ("include(cmake/package.cmake)", 0),
    ],
)
def test_ament_package_is_called(tmp_path: Path, last: str, count: int) -> None:
    text = f"project(arm)\nfind_package(ament_cmake REQUIRED)\n{last}\n"
    assert len(built(tmp_path, text)) == count


@pytest.mark.parametrize(
    ("first", "count"),
    [("", 1), ("# find_package(ament_cmake)", 1), ("include(a.cmake)", 0), ("find_package(a)", 0)],
)
def test_ament_package_is_known(tmp_path: Path, first: str, count: int) -> None:
    found = built(tmp_path, f"project(arm)\n{first}\nament_package()\n")
    found = [one for one in found if "is unknown" in one.message]
    assert len(found) == count


REGISTERED = "RCLCPP_COMPONENTS_REGISTER_NODE({})\n"


@pytest.mark.parametrize(
    ("named", "source", "meant"),
    [
        ("arm::WatchDog", REGISTERED.format("arm::Watchdog"), ["arm::Watchdog"]),
        ("arm::Watchdog", REGISTERED.format("Watchdog"), ["Watchdog"]),
        ("arm::Watchdog", REGISTERED.format("arm::dog::Watchdog"), ["arm::dog::Watchdog"]),
        ("arm::Watchdog", REGISTERED.format("arm::Watchdog"), []),
        ("arm::Watchdog", "// " + REGISTERED.format("arm::WatchDog"), []),
        ("arm::Watchdog", "#define A(X) " + REGISTERED.format("arm::X") + "A(Watchdog)", []),
        ("${PROJECT_NAME}::WatchDog", REGISTERED.format("arm::Watchdog"), []),
        ("arm::Reader", REGISTERED.format("arm::Watchdog"), []),  # of a generated source
    ],
)
def test_components(tmp_path: Path, named: str, source: str, meant: list[str]) -> None:
    """From basler/pylon-ros-camera#190."""
    calls = f'rclcpp_components_register_node(dog PLUGIN "{named}" EXECUTABLE dog)\n'
    build = f"find_package(a)\n{calls}ament_package()\n"
    found = built(tmp_path, build, {"src/dog.cpp": source})
    assert [(one.span.text, one.message.split("'")[3]) for one in found] == [
        (named, name) for name in meant
    ]


FINDS = "project(arm)\nfind_package(ament_cmake REQUIRED)\n{}\nament_package()\n"


@pytest.mark.parametrize(
    ("command", "depend", "count"),
    [
        ("find_package(arm_msgs REQUIRED)", "", 1),
        ("find_package(arm_msgs REQUIRED)", "<depend>arm_msgs</depend>", 0),
        ("find_package(arm_msgs REQUIRED)", "<depend>tools</depend>", 0),  # which depends on it
        ("find_package(arm_msgs QUIET)", "", 0),
        ("# find_package(arm_msgs REQUIRED)", "", 0),
        ("find_package(other REQUIRED)", "", 0),
    ],
)
def test_a_package_that_is_found_and_not_declared(
    tmp_path: Path, command: str, depend: str, count: int
) -> None:
    add_package(tmp_path / "arm_msgs", "arm_msgs")
    tools = "<package><name>tools</name><depend>arm_msgs</depend></package>"
    manifest = MANIFEST.replace("</package>", f"{depend}</package>")
    add_files(tmp_path, {".git/HEAD": "", "tools/package.xml": tools})
    found = built(tmp_path, FINDS.format(command), {"package.xml": manifest})
    assert ["does not declare" in one.message for one in found] == [True] * count


HOOKS = """find_package(ament_cmake REQUIRED)
install(DIRECTORY models DESTINATION share/${PROJECT_NAME})
{}
ament_environment_hooks("${CMAKE_CURRENT_SOURCE_DIR}/hooks/arm.dsv.in")
ament_package()
"""


@pytest.mark.parametrize(
    ("value", "more", "count"),
    [
        ("share/@PROJECT_NAME@/models", "", 0),
        ("share/@PROJECT_NAME@/model", "", 1),
        ("share/arm/model", "", 1),
        ("share/@PROJECT_NAME@/made", "install(DIRECTORY models/ DESTINATION share/arm/made)", 0),
        ("share/@PROJECT_NAME@", "", 0),
        ("share/other/model", "", 0),
        ("lib", "", 0),
    ],
)
def test_a_hook_adds_a_directory(tmp_path: Path, value: str, more: str, count: int) -> None:
    hook = f"prepend-non-duplicate;GZ_SIM_RESOURCE_PATH;{value}\n"
    build = "project(arm)\n" + HOOKS.replace("{}", more)
    found = built(tmp_path, build, {"hooks/arm.dsv.in": hook, "models/a/model.config": ""})
    assert [one.span.text for one in found] == [value] * count
