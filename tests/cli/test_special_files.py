"""What is no regular file, or an endless one, is one error line: commands x what is named."""

import json
import os
import resource
import signal
import socket
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from tests.shipped import GRIPPER
from urdfkit.cli import main

if not hasattr(os, "mkfifo"):
    pytest.skip("needs named pipes", allow_module_level=True)


def _device(path: Path) -> None:
    path.symlink_to("/dev/zero")


def _loop(path: Path) -> None:
    path.symlink_to(path)


def _sparse(path: Path) -> None:
    with path.open("wb") as file:
        file.truncate(2 << 30)


def _locked(path: Path) -> None:
    if os.geteuid() == 0:
        pytest.skip("root may read every file")
    path.touch(mode=0)


def _socket(path: Path) -> None:
    before = os.getcwd()
    os.chdir(path.parent)  # the address of a socket is short
    try:
        with socket.socket(socket.AF_UNIX) as one:
            one.bind(path.name)
    finally:
        os.chdir(before)


KINDS: dict[str, Callable[[Path], None]] = {
    "pipe": os.mkfifo,
    "device": _device,
    "socket": _socket,
    "directory": Path.mkdir,
    "loop": _loop,
    "no permission": _locked,
    "2 GB": _sparse,
}

#: Command lines for a file, by its suffix; ``{}`` is the file.
COMMANDS = {
    ".urdf": [
        "check {}",
        "fix {}",
        "format {}",
        "expand {}",
        "trace {} base_link",
        "info {}",
        "tree {}",
        "kinematics {}",
        "mass {}",
        "statics {}",
        "collisions {}",
        "gazebo {}",
        "importers {}",
        "bundle {} -o made",
        "convert {} --to mjcf -o made",
        "simulate {}",
        "inertia {}",
        "migrate {} --to gz-harmonic",
        "render {} -o made.png",
        f"diff {{}} {GRIPPER}",
        f"diff {GRIPPER} {{}}",
        "report {} -o made.html",
        "view {} --no-open",
        "doctor {}",
        "mesh collision {}",
        "mesh spheres {}",
        "mesh capsules {}",
        "mesh generate --model {}",
    ],
    ".urdf.xacro": ["check {}", "expand {}"],
    ".launch": ["check {}"],
    ".launch.py": ["check {}"],
    ".toml": [f"check {GRIPPER} --config {{}}"],
    ".json": [f"check {GRIPPER} --baseline {{}}"],
    ".yaml": [f"kinematics {GRIPPER} --pose {{}}"],
    ".srdf": [f"collisions {GRIPPER} --compare {{}}", f"collisions {GRIPPER} -o {{}}"],
    ".tar": ["scan {} -o out"],
    ".txt": ["scan {} -o out"],
    ".stl": [
        "mesh info {}",
        "mesh convert {} -o made.obj",
        "mesh repair {} -o made.stl",
        "mesh simplify {} --triangles 9 -o made.stl",
        "mesh hull {} -o made.stl",
        "mesh decompose {} -o made.stl",
    ],
}
#: The same, where it is written to.
OUTPUTS = {
    ".json": f"check {GRIPPER} --format json:{{}}",
    ".html": f"report {GRIPPER} --quick -o {{}}",
    ".png": f"render {GRIPPER} --size 32x32 -o {{}}",
    ".urdf": f"expand {GRIPPER} -o {{}}",
}
LINES = [(suffix, line) for suffix, lines in COMMANDS.items() for line in lines]


def _give_up(*_: object) -> None:
    raise TimeoutError


@pytest.fixture(autouse=True)
def limits() -> Iterator[None]:
    """A minute, and 512 MB more than now."""
    pages = int(Path("/proc/self/statm").read_text().split()[0])
    before = resource.getrlimit(resource.RLIMIT_AS)
    most = pages * resource.getpagesize() + 512 * 2**20
    resource.setrlimit(resource.RLIMIT_AS, (most, before[1]))
    handler = signal.signal(signal.SIGALRM, _give_up)
    signal.alarm(60)
    yield
    signal.alarm(0)
    signal.signal(signal.SIGALRM, handler)
    resource.setrlimit(resource.RLIMIT_AS, before)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize(("suffix", "line"), LINES, ids=[line.split(" /")[0] for _, line in LINES])
def test_a_special_file_is_one_error_line(
    suffix: str,
    line: str,
    kind: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    if suffix == ".tar" and kind == "2 GB":
        pytest.skip("takes long: padding of a compressed archive is zeros, too")
    monkeypatch.chdir(tmp_path)
    path = tmp_path / f"it{suffix}"
    KINDS[kind](path)
    code = main(line.format(path).split())
    out, err = capsys.readouterr()
    if (
        kind == "directory"
        and line.split(maxsplit=1)[0] in ("check", "fix", "scan")
        and "--" not in line
    ):
        assert code in (0, 2)  # which take directories
        return
    assert code == 2, out
    assert err.startswith("error: ")
    assert path.name in err
    assert err.count("\n") == 1


@pytest.mark.parametrize("kind", ["pipe", "socket", "directory", "loop"])
@pytest.mark.parametrize("suffix", OUTPUTS)
def test_writing_to_a_pipe_does_not_block(
    suffix: str, kind: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / f"it{suffix}"
    KINDS[kind](path)
    assert main(OUTPUTS[suffix].format(path).split()) == 2
    err = capsys.readouterr().err
    assert path.name in err
    assert err.count("\n") == 1
    assert os.listdir(tmp_path) == [path.name]


ROBOT = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{}<link name="a">
<visual><geometry><mesh filename="{}"/></geometry></visual></link></robot>"""


@pytest.mark.parametrize("kind", KINDS)
def test_a_special_file_in_a_robot_is_a_finding(
    kind: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "LICENSE").touch()
    for name in ("a.stl", "b.xacro", "c.yaml", "d.srdf", "e.launch"):
        KINDS[kind](tmp_path / name)
    (tmp_path / "mesh.urdf").write_text(ROBOT.format("", "a.stl"))
    (tmp_path / "include.urdf.xacro").write_text(
        ROBOT.format('<xacro:include filename="b.xacro"/>', "none.stl")
    )
    (tmp_path / "yaml.urdf.xacro").write_text(
        ROBOT.format("<xacro:property name='p' value=\"${xacro.load_yaml('c.yaml')}\"/>", "${p}")
    )
    assert main(["check", str(tmp_path), "--format", "json"]) == 1
    report = json.loads(capsys.readouterr().out)
    files = {os.path.basename(one["path"]) for one in report["diagnostics"]}
    assert {"mesh.urdf", "include.urdf.xacro", "yaml.urdf.xacro"} <= files


@pytest.mark.parametrize("name", ["a.urdf", "a.stl"])
def test_a_file_that_shrinks_while_it_is_read(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "a.urdf").write_text(ROBOT.format("", "a.stl"))
    (tmp_path / "a.stl").write_bytes(bytes(80) + b"\x01\0\0\0" + bytes(50))
    real = os.fstat

    def shrinking(descriptor: int) -> os.stat_result:
        state = real(descriptor)
        if os.path.basename(os.readlink(f"/proc/self/fd/{descriptor}")) == name:
            os.truncate(tmp_path / name, 30)
        return state

    monkeypatch.setattr(os, "fstat", shrinking)
    assert main(["check", str(tmp_path / "a.urdf")]) == 1
    assert main(["format", str(tmp_path / "a.urdf")]) in (0, 2)
