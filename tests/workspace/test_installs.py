from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from urdfkit.workspace import installs
from urdfkit.workspace.installs import Installed, read_rules, source_paths


def rules(directory: Path, text: str, package: str = "arm") -> list[Installed]:
    (directory / "CMakeLists.txt").write_text(text, encoding="utf-8")
    return read_rules(str(directory), package)


def paths(directory: Path, text: str, relative: str) -> list[str]:
    rules(directory, text)
    return source_paths(read_rules(str(directory), "arm"), "arm", relative)


INSTALL = "install(DIRECTORY {} DESTINATION {})".format
LOOPS = """\
foreach(a x y)
  foreach(b ${a}/1 ${a}/2)
    install(DIRECTORY ${b}/ DESTINATION share/arm/${b})
  endforeach()
endforeach()
"""
COMMENTS = """\
# an (open comment
#[[ install(DIRECTORY no DESTINATION share/arm) ]]
install(DIRECTORY t/urdf # why
        DESTINATION share/arm)
"""
IN_LOOP = INSTALL("x/${d}", "share/arm")


@pytest.mark.parametrize(
    ("text", "relative", "source"),
    [
        (INSTALL("d/urdf", "share/arm"), "urdf/a.xacro", "d/urdf/a.xacro"),
        (INSTALL("d/urdf/", "share/arm/urdf"), "urdf/a.xacro", "d/urdf/a.xacro"),
        (INSTALL("d/", "share/arm"), "urdf/a.xacro", "d/urdf/a.xacro"),
        (INSTALL("launch d/urdf", "share/${PROJECT_NAME}/"), "urdf/a.xacro", "d/urdf/a.xacro"),
        (INSTALL("d/m", "${CATKIN_PACKAGE_SHARE_DESTINATION}"), "m/b.stl", "d/m/b.stl"),
        (INSTALL("m/", "share/arm/meshes PATTERN .svn EXCLUDE"), "meshes/b.stl", "m/b.stl"),
        (INSTALL('"${CMAKE_CURRENT_SOURCE_DIR}/m"', '"share/arm"'), "m/b.stl", "m/b.stl"),
        (INSTALL("m", "${CMAKE_INSTALL_DATADIR}/${PROJECT_NAME}"), "m/b.stl", "m/b.stl"),
        ("INSTALL(\n FILES x/a b\n DESTINATION share/arm/c)", "c/a", "x/a"),
        ("set(D share/arm)\nset(X a;b/urdf)\n" + INSTALL("${X}", "${D}"), "urdf/a", "b/urdf/a"),
        (f"foreach(d u m)\n{IN_LOOP}\nendforeach(d)", "m/b", "x/m/b"),
        (f"foreach(d IN ITEMS u m)\n{IN_LOOP}\nendforeach()", "m/b", "x/m/b"),
        (f"set(L u m)\nforeach(d IN LISTS L)\n{IN_LOOP}\nendforeach()", "m/b", "x/m/b"),
        (LOOPS, "y/2/b.stl", "y/2/b.stl"),
        (f"if(BUILD_TESTING)\n{INSTALL('t/urdf', 'share/arm')}\nendif()", "urdf/a", "t/urdf/a"),
        (COMMENTS, "urdf/a", "t/urdf/a"),
        ("ament_auto_package(INSTALL_TO_SHARE launch d/urdf/)", "urdf/a", "d/urdf/a"),
        ("cogen_dcf(arm)", "config/arm/bus.yml", "config/arm/bus.yml"),  # ros2_canopen
    ],
)
def test_where_an_installed_file_lies(
    tmp_path: Path, text: str, relative: str, source: str
) -> None:
    assert paths(tmp_path, text, relative) == [source]


@pytest.mark.parametrize(
    "text",
    [
        "",
        "install(TARGETS arm DESTINATION lib)",
        "install(DIRECTORY include/ DESTINATION include/arm)",
        "install(DIRECTORY urdf DESTINATION share/other)",
        "install(DIRECTORY urdf DESTINATION ${UNKNOWN}/arm)",
        "install(DIRECTORY ${UNKNOWN} DESTINATION share/arm)",
        "install(DIRECTORY /abs/urdf DESTINATION share/arm)",
        "install(DIRECTORY urdf)",
        "install(DIRECTORY urdf DESTINATION)",
        "install(DIRECTORY urdfs DESTINATION share/arm)",
        "install(",
        "install(DIRECTORY urdf DESTINATION share/arm",
        "ament_auto_package()",
        "endforeach()",
        "foreach()",
    ],
)
def test_rules_that_do_not_say_where_it_lies(tmp_path: Path, text: str) -> None:
    assert paths(tmp_path, text, "urdf/a.xacro") == []


def test_no_cmake_file(tmp_path: Path) -> None:
    assert read_rules(str(tmp_path), "arm") == []


def test_loops_are_bounded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(installs, "MAX_COMMANDS", 1000)
    items = " ".join(map(str, range(100)))
    loop = f"foreach(x {items})\n" * 6
    text = f"{loop}install(DIRECTORY ${{x}} DESTINATION share/arm)\n{'endforeach()' * 6}"
    assert len(rules(tmp_path, text)) <= 1000


@given(st.text('installforeachd(DIRECTORY DESTINATION set)$"#\\[]{};/\n x', max_size=200))
def test_any_text_is_read(text: str) -> None:
    reader = installs._CMakeReader(installs.known_variables("arm"))
    for command in installs._commands(text):
        reader.read(command)
