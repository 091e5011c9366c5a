"""What a check loads: the start of the program is most of the time that a small robot costs."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.conftest import ARM, GRIPPER, MISSION, ROOT

#: Of Python's own library, what costs several milliseconds each.
SLOW = {"asyncio", "dataclasses", "inspect", "multiprocessing", "subprocess", "typing", "urllib"}


def loaded(*words: str, cache: Path | None = None) -> set[str]:
    """What a command line has loaded when it is done, beyond what Python starts with."""
    program = (
        "import sys; before = set(sys.modules)\n"
        "from urdfkit.cli import main\n"
        "code = main(sys.argv[1:])\n"
        "assert code in (0, 1), code\n"
        "print(*sorted(set(sys.modules) - before), file=sys.stderr)"
    )
    done = subprocess.run(
        [sys.executable, "-c", program, *words],
        check=False,
        cwd=ROOT,
        capture_output=True,
        text=True,
        timeout=60,
        env={**os.environ, "URDFKIT_CACHE_DIR": str(cache or "")},
    )
    assert done.returncode == 0, done.stderr
    return set(done.stderr.split())


def external(modules: set[str]) -> set[str]:
    """The packages among them that belong neither to Python nor to urdfkit."""
    packages = {module.partition(".")[0] for module in modules}
    return packages - sys.stdlib_module_names - {"urdfkit"}


def slow(modules: set[str]) -> set[str]:
    """The SLOW ones among them; a package for all its modules."""
    return {module.partition(".")[0] for module in modules} & SLOW


def test_a_plain_robot_needs_nothing_but_python() -> None:
    modules = loaded("check", str(GRIPPER))
    assert external(modules) == set()
    assert slow(modules) == set()
    assert not [name for name in modules if name.startswith("urdfkit.xacro")]


@pytest.mark.parametrize("robot", [GRIPPER, ARM, MISSION], ids=lambda path: path.stem)
def test_launch_files_and_yaml_wait_for_a_rule_that_needs_them(robot: Path) -> None:
    modules = loaded("check", str(robot), "--ignore", "COL")
    launch = {name for name in modules if name.startswith("urdfkit.ros.launch.")}
    # The launch file next to the mission's model loads no YAML, and the model has no arguments.
    assert launch == ({"urdfkit.ros.launch.robot_arguments"} if robot == MISSION else set())
    assert "urdfkit.text.located_yaml" not in modules


def test_findings_and_statistics_load_no_more(tmp_path: Path) -> None:
    bad = tmp_path / "bad.urdf"
    joint = '<joint name="j" type="fixed"><parent link="a"/><child link="a"/></joint>'
    bad.write_text(f'<robot name="r"><link name="a"/>{joint}</robot>', encoding="utf-8")
    for words in ([], ["--statistics"], ["--select", "TRE", "--color", "always"]):
        modules = loaded("check", str(bad), *words)
        assert external(modules) == set()
        assert slow(modules) == set()


def test_meshes_that_were_measured_before_need_nothing_but_python(tmp_path: Path) -> None:
    for library in ("numpy", "lxml", "manifold3d"):
        pytest.importorskip(library)
    assert "numpy" in loaded("check", str(ARM), cache=tmp_path)
    modules = loaded("check", str(ARM), cache=tmp_path)
    assert external(modules) == set()
    assert slow(modules) == set()


def test_a_xacro_loads_a_private_copy_of_xacro_and_nothing_else_foreign() -> None:
    modules = loaded("check", str(MISSION), "--ignore", "COL")  # which have something to say
    assert external(modules) == {"_urdfkit_xacro"}
    assert slow(modules) == set()


@pytest.mark.parametrize("data", [b"", b"<robot", b"<robot><a></b></robot>", b"\xff"])
def test_broken_xml_needs_nothing_but_python(data: bytes, tmp_path: Path) -> None:
    broken = tmp_path / "broken.urdf"
    broken.write_bytes(data)
    assert external(loaded("check", str(broken))) == set()


@pytest.mark.parametrize("words", [["--version"], ["rules"], ["explain", "XML001"]])
def test_other_commands_load_click_and_nothing_heavy(words: list[str]) -> None:
    assert external(loaded(*words)) == {"click"}


def test_only_the_families_that_apply_are_loaded(tmp_path: Path) -> None:
    file = tmp_path / "robot.urdf"
    file.write_text('<robot name="r"><link name="a"/></robot>', encoding="utf-8")
    names = [m.split(".") for m in loaded("check", str(file)) if m.startswith("urdfkit.checks.")]
    families = {name[2] for name in names if len(name) > 3}
    assert families == {"geometry", "inertia", "joints", "names", "tree", "xml"}
