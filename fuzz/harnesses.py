"""What is fuzzed: the seeds of each harness, and the call of the library that takes an input.

A harness raises nothing but what is a defect: what cannot be done is an `UrdfkitError`.
"""

from __future__ import annotations

import io
import json
import os
import re
import tarfile
import tempfile
import zipfile
from collections.abc import Callable
from contextlib import redirect_stderr, redirect_stdout
from functools import lru_cache
from pathlib import Path
from random import Random
from typing import TYPE_CHECKING, Literal, NamedTuple

from fuzz import seeds
from fuzz.seeds import HEAD, ROOT
from urdfkit.errors import UrdfkitError
from urdfkit.lint import config_reader, engine
from urdfkit.lint.ignore_comments import ignores
from urdfkit.lint.options import Options
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.ros.gazebo.samples import ARM, CONTROL, DRIVE, DRIVEN
from urdfkit.ros.launch import read_launch
from urdfkit.scan import models as scanned
from urdfkit.text import located_yaml
from urdfkit.text.editing.formatter import formatted
from urdfkit.text.file_kinds import is_xacro
from urdfkit.text.source import Source
from urdfkit.text.xml_reader import read_xml
from urdfkit.workspace.manifest import manifest_of
from urdfkit.workspace.resolve import Resolver
from urdfkit.xacro import expand

if TYPE_CHECKING:
    from mcp.server.mcpserver import MCPServer


class Harness(NamedTuple):
    """One kind of input.

    Attributes:
        seeds: inputs to begin with.
        run: takes one input; the current directory is a scratch one.
    """

    seeds: Callable[[], list[bytes]]
    run: Callable[[bytes], object]


class CrashedRule(Exception):
    """A rule failed; the check went on without it."""


def _check(path: str, data: bytes | None = None, *, select: tuple[str, ...] = ()) -> None:
    """Check one file; a rule that fails is a defect."""
    source = path if data is None else Source(os.path.abspath(path), data)
    report = engine.check(source, options=Options(select=select, cache=False))
    for crash in report.crashed:
        raise CrashedRule(f"{crash.code}: {crash.error}\n{crash.traceback}")
    for found in report.diagnostics:
        str(found.span)


def _text(data: bytes) -> None:
    source = Source("r.urdf", data)
    _, problems = read_xml(source)
    for problem in problems:
        str(problem.span)
    ignores(source)
    is_xacro(source)
    formatted(source)


def _robot(data: bytes) -> None:
    _check("r.urdf", data)


def _xacro(data: bytes) -> None:
    _check("r.urdf.xacro", data)


def _expression(data: bytes) -> None:
    """A text with expressions as the value of an attribute."""
    text = data.decode("utf-8", "replace").replace("&", "&amp;").replace("<", "&lt;")
    text = "".join(char for char in text if char >= " ").replace('"', "&quot;")
    body = f'{HEAD}<xacro:arg name="a" default="1"/><link name="{text}"/></robot>'
    found = expand(Source("r.xacro", body.encode("utf-8", "replace")), Resolver(environment={}))
    if found.document is not None:
        found.text()
    for problem in found.problems:
        str(problem.span)


def _yaml(data: bytes) -> None:
    source = Source("a.yaml", data)
    located_yaml.load(source)
    located_yaml.syntax_error(source)
    _write("a.yaml", data)
    robot = f"{HEAD}<link name=\"${{xacro.load_yaml('a.yaml')}}\"/></robot>"
    expand(Source(os.path.abspath("y.xacro"), robot.encode()), Resolver(environment={}))


def _launch(data: bytes) -> None:
    name = "r.launch" if data.lstrip()[:1] == b"<" else "r.launch.py"
    launch = read_launch(Source(os.path.abspath(name), data), Resolver(environment={}))
    for problem in launch.problems:
        str(problem.span)


_ARM = b"""<robot name="r"><link name="a"/><link name="b"/><joint name="j" type="revolute">
<parent link="a"/><child link="b"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>"""


def _srdf(data: bytes) -> None:
    _write("srdf/r.srdf", data)
    _check("srdf/r.urdf", _ARM, select=("SRD",))


def _controllers(data: bytes) -> None:
    """A parameter file of the two wheels of a robot."""
    _write("control/c.yaml", data)
    robot = whole_robot(ARM + CONTROL + DRIVEN)
    robot = re.sub(
        r"<parameters>[^<]*<", f"<parameters>{os.path.abspath('control/c.yaml')}<", robot
    )
    _check("control/r.urdf", robot.encode(), select=("RCT",))


_BRINGUP = b"""from ament_index_python.packages import get_package_share_directory
from launch.actions import ExecuteProcess
from launch_ros.actions import Node
from nav2_common.launch import RewrittenYaml

share = get_package_share_directory("cart")
parameters = share + "/p.yaml"
gazebo = ExecuteProcess(cmd=["gz", "sim", "-r", share + "/w.sdf"])
spawn = Node(package="ros_gz_sim", executable="create", arguments=["-world", "hall", "-z", "0.1"])
ekf = Node(package="robot_localization", executable="ekf_node", parameters=[parameters])
costmap = Node(
    package="nav2_controller", executable="controller_server",
    parameters=[RewrittenYaml(source_file=parameters, root_key="", param_rewrites={})],
)
"""


def _bringup(name: str) -> Callable[[bytes], None]:
    """A file that a launch file gives to what it starts."""

    def run(data: bytes) -> None:
        _write("bringup/package.xml", b"<package><name>cart</name></package>")
        _write(f"bringup/{name}", data)
        _check("bringup/launch/r.launch.py", _BRINGUP, select=("LAU", "WLD"))

    return run


def _worlds() -> list[bytes]:
    include = b"<include><uri>model://a</uri></include>"
    floor = b"""<model name="floor"><static>true</static><link name="l"><collision name="c">
    <geometry><plane><normal>0 0 1</normal></plane></geometry></collision></link></model>"""
    whole = b"""<sdf version="1.9"><world name="hall"><physics type="ode"><max_step_size>0.001
    </max_step_size></physics>%s%s</world></sdf>"""
    return [whole % (include, floor), *seeds.files(".sdf")]


def _package(data: bytes) -> None:
    _write("package/package.xml", data)
    robot = os.path.abspath("package/r.urdf")
    manifest = manifest_of(Resolver(environment={}), robot)
    if manifest is not None:
        _ = manifest.dependencies, manifest.dependency_tag, manifest.ros
    mesh = b'<mesh filename="package://other/a.stl"/>'
    visual = b'<link name="a"><visual><geometry>%s</geometry></visual></link>' % mesh
    _check("package/r.urdf", b'<robot name="r">%s</robot>' % visual, select=("PKG",))


def _archives() -> list[bytes]:
    """A robot as an archive of each kind."""
    made = []
    for method in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED, zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA):
        with zipfile.ZipFile(file := io.BytesIO(), "w", method) as packed:
            for name in ("a/r.urdf", "a/r.xacro", "../r.urdf"):
                packed.writestr(name, _ARM)
        made.append(file.getvalue())
    modes: tuple[Literal["w", "w:gz", "w:bz2", "w:xz"], ...] = ("w", "w:gz", "w:bz2", "w:xz")
    for mode in modes:
        with tarfile.open(fileobj=(file := io.BytesIO()), mode=mode) as tar:
            for name in ("a/r.urdf", "long" * 60 + "/r.urdf.xacro", "../r.urdf"):
                member = tarfile.TarInfo(name)
                member.size = len(_ARM)
                tar.addfile(member, io.BytesIO(_ARM))
        made.append(file.getvalue())
    return made


def _archive(data: bytes) -> None:
    """The models of an archive, extracted."""
    name = "a.zip" if data[:1] == b"P" else "a.tar"
    _write(name, data)
    with scanned.Extraction() as extraction:
        for model in scanned.models([name]):
            assert (
                Path(extraction.on_disk(model).path).resolve().is_relative_to(tempfile.gettempdir())
            )


def _configuration(data: bytes) -> None:
    _write("urdfkit.toml", data)
    try:
        config_reader.load(os.path.abspath("urdfkit.toml"), trusted=False)
    finally:
        os.remove("urdfkit.toml")


def _mesh(name: str) -> Callable[[bytes], None]:
    def run(data: bytes) -> None:
        from urdfkit.mesh.io.load import UnloadableMesh, load_bytes, salvage
        from urdfkit.mesh.measuring import measure

        _write(name, data)
        try:
            salvage(name)
        except UnloadableMesh:
            pass
        measure(load_bytes(data, os.path.abspath(name)))

    return run


#: Commands that serve until they are ended, start other programs, or write beside their files.
_NEVER = frozenset("lsp view scan init clean".split())
#: Nor what dies where an allocation fails, as all of these processes bound their memory: USD.
_UNSAFE = re.compile(r"\.\.|/|~|\$|^usd$|=usd$")
#: A path of the documentation, and what stands for it by suffix.
_FILE_NAME = re.compile(r"[\w./$-]+\.(urdf|xacro|stl|dae|obj|launch)\b")
_SCRATCH = {"xacro": "r.xacro", "stl": "a.stl", "dae": "a.stl", "obj": "a.stl"}


def _command_lines() -> list[bytes]:
    """The command lines of the documentation, with files of the scratch directory."""
    text = "\n".join(path.read_text(encoding="utf-8") for path in (ROOT / "docs").rglob("*.md"))
    lines = re.findall(r"(?m)^\s*(?:\$ )?urdfkit ([\w -]+.*)$", text)
    named = [_FILE_NAME.sub(lambda found: _SCRATCH.get(found[1], "r.urdf"), one) for one in lines]
    return [one.encode() for one in dict.fromkeys(named) if one.split()[0] not in _NEVER]


def _arguments(data: bytes) -> None:
    """A command line; it may name nothing outside of the scratch directory."""
    from urdfkit.mesh import samples

    words = data.decode("utf-8", "replace").replace("\0", "").split()
    if not words or words[0] in _NEVER or any(map(_UNSAFE.search, words)):
        return
    _write("r.urdf", _ARM)
    _write("r.xacro", _ARM)
    _write("a.stl", samples.stl(samples.box((0, 0, 0), (0.1, 0.1, 0.3))))
    _run(words)


def _run(words: list[str]) -> None:
    """Run a command line; an error of urdfkit itself is a defect."""
    from urdfkit.cli import main

    with redirect_stdout(io.TextIOWrapper(io.BytesIO())), redirect_stderr(io.StringIO()) as err:
        code = main(words)
    if code not in (0, 1, 2):
        raise AssertionError(f"exit code {code}: {err.getvalue()}")


#: What tools for agents pass to commands.
_OPTIONS_OF_TOOLS = frozenset(
    "--info --select -q --unsafe-fixes --diff --view --size -o --findings".split()
)
#: What is done with a damaged robot.
_COMMANDS = """\
check --add-ignore
fix --unsafe-fixes --force
format
migrate --to gz-harmonic
expand
trace link/a
info
tree
kinematics
mass
inertia
statics --samples 3
collisions --samples 5 --jobs 1
importers
gazebo
diff other.urdf
bundle -o bundle --force
convert --to urdf -o urdf --force
convert --to mjcf -o mjcf --force
simulate
render -o r.png --size 60x40
report --quick -o r.html""".splitlines()


def _command(data: bytes) -> None:
    """A command, with a robot."""
    command, *options = Random(data).choice(_COMMANDS).split()
    _write("command/r.urdf", data)
    _write("command/other.urdf", _ARM)
    before = os.getcwd()
    os.chdir("command")
    try:
        _run([command, *["other.urdf"] * (command == "diff"), "r.urdf", *options])
    finally:
        os.chdir(before)


def _tool_calls() -> list[bytes]:
    calls: tuple[tuple[str, dict[str, object]], ...] = (
        ("check", {"path": "r.urdf", "arguments": {"a": "1"}, "select": ["MSH"], "infos": True}),
        ("check", {"path": ".", "start": 2}),
        ("explain", {"code": "MSH001"}),
        ("trace", {"path": "r.urdf", "element": "link/a"}),
        ("expand", {"path": "./r.urdf"}),
        ("fix", {"path": "r.urdf", "unsafe": True, "write": True}),
        ("render", {"path": "r.urdf", "view": "iso", "findings": False}),
    )
    return [json.dumps([name, words]).encode() for name, words in calls]


def _tool(data: bytes) -> None:
    """A call of the tools for agents, without the command that it leads to."""
    import asyncio

    from mcp.server.mcpserver.exceptions import ToolError
    from pydantic import ValidationError

    _write("tools/r.urdf", _ARM)
    try:
        name, words = json.loads(data)
        asyncio.run(_tool_server().call_tool(str(name), dict(words)))
    except (ValueError, TypeError, RecursionError):
        pass  # not a call
    except ToolError as error:
        cause = error.__cause__
        if cause and not isinstance(cause, (ToolError, ValidationError, FileNotFoundError)):
            raise cause from None  # FileNotFoundError: of the image that nothing renders


@lru_cache
def _tool_server() -> MCPServer:
    from urdfkit.cli import mcp_tools

    def run(_: object, *words: str) -> str:
        """The words of a command; of what a client sends, none is an option."""
        options = {one for one in words if one.startswith("-")}
        if not options <= _OPTIONS_OF_TOOLS:
            raise AssertionError(f"options: {words}")
        return "\n".join(words)

    mcp_tools.Tools._run = run  # type: ignore[method-assign,assignment]
    return mcp_tools.server("tools", may_write=True)


def _lsp(data: bytes) -> None:
    """An edited text, and questions at some places of it."""
    from lsprotocol import types as lsp

    from urdfkit.lsp import actions, completion, hover, inlay_hints, navigation, outline
    from urdfkit.lsp.text import PositionEncoding
    from urdfkit.lsp.workspace import Workspace

    random = Random(data)
    path = os.path.abspath("lsp.urdf.xacro")
    workspace = Workspace()
    workspace.set_text(path, data)
    workspace.check(path, thorough=False, is_cancelled=lambda: False)
    robot = workspace.robot(path)
    markup = robot.markup(path)
    outline.outline(robot, markup)
    outline.symbols([robot], "a")
    list(navigation.links(robot, markup))
    list(inlay_hints.inlay_hints(robot, markup, 0, len(data)))
    for _ in range(5):
        place = lsp.Position(random.randint(0, 60), random.randint(0, 80))
        offset = PositionEncoding("utf-16").offset(markup.source, place)
        completion.complete(robot, markup, offset)
        hover.hover(robot, markup, offset, workspace.diagnostics(path))
        navigation.definitions(robot, markup, offset)
        navigation.references(robot, markup, offset, definitions=True)
        try:
            navigation.rename(robot, markup, offset, "other")
        except UrdfkitError:
            pass
    for found in workspace.diagnostics(path)[:3]:
        list(actions.actions(markup, found))


def _write(name: str, data: bytes) -> None:
    os.makedirs(os.path.dirname(name) or ".", exist_ok=True)
    with open(name, "wb") as file:
        file.write(data)


HARNESSES: dict[str, Harness] = {
    "text": Harness(lambda: [*seeds.robots(), *seeds.xacros()], _text),
    "robot": Harness(seeds.robots, _robot),
    "xacro": Harness(seeds.xacros, _xacro),
    "expression": Harness(seeds.expressions, _expression),
    "yaml": Harness(lambda: seeds.files(".yaml"), _yaml),
    "launch": Harness(seeds.launches, _launch),
    "srdf": Harness(seeds.srdfs, _srdf),
    "controllers": Harness(lambda: [DRIVE, *seeds.files(".yaml")], _controllers),
    "package": Harness(seeds.manifests, _package),
    "configuration": Harness(seeds.configurations, _configuration),
    "stl": Harness(seeds.meshes(".stl"), _mesh("a.stl")),
    "collada": Harness(seeds.meshes(".dae"), _mesh("a.dae")),
    "obj": Harness(seeds.meshes(".obj"), _mesh("a.obj")),
    "ply": Harness(seeds.meshes(".ply"), _mesh("a.ply")),
    "gltf": Harness(seeds.meshes(".glb", ".gltf"), _mesh("a.glb")),
    "bringup": Harness(lambda: seeds.files(".yaml"), _bringup("p.yaml")),
    "world": Harness(_worlds, _bringup("w.sdf")),
    "archive": Harness(_archives, _archive),
    "command": Harness(seeds.robots, _command),
    "tool": Harness(_tool_calls, _tool),
    "arguments": Harness(_command_lines, _arguments),
    "lsp": Harness(lambda: [*seeds.robots(), *seeds.xacros()], _lsp),
}
