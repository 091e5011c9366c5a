"""The tools of ``urdfkit mcp``, each of which runs a command of urdfkit in a separate process.

Thus the limits of the command apply, and a crash affects one answer only. Texts of a client are
never options: paths begin with a dot, codes and names of arguments are words.
"""

import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Callable
from typing import Any

from mcp.server.mcpserver import Image, MCPServer
from mcp.server.mcpserver.exceptions import ToolError
from mcp.server.mcpserver.tools import Tool
from mcp.types import ToolAnnotations

from urdfkit import __version__
from urdfkit.core import disk
from urdfkit.core.words import counted

#: Bytes of an answer: 2,000 tokens of two and a half bytes each.
MAX_BYTES = 5000
#: Seconds after which a command without its own limit is stopped.
MAX_SECONDS = 330
#: Columns of the output.
_WIDTH = "100"
#: ``python -m`` would import from the current directory, which is not trusted.
_PROGRAM = "import sys; sys.path[:] = filter(None, sys.path); from urdfkit.cli import main; main()"
_WORD = re.compile(r"\w[\w-]*")

_INSTRUCTIONS = """\
Checks robot models in URDF and xacro. Call check first; explain describes a rule by its code. trace
shows the source of a value through macros and includes, expand the model without them. fix shows
the safe fixes as a diff. Paths are relative to the workspace. Answers are cut to a page: pass
'start' to read on."""


class Tools:
    """The tools that an MCP client can call.

    Args:
        directory: the only directory whose files are accepted.
        may_write: True if ``fix`` may write.
    """

    def __init__(self, directory: str, *, may_write: bool) -> None:
        self._root = disk.real(directory)
        self._may_write = may_write

    def check(
        self,
        path: str = ".",
        arguments: dict[str, str] | None = None,
        select: list[str] | None = None,
        infos: bool = False,
        start: int = 1,
    ) -> str:
        """Check a robot model, or all robots of a directory: errors and warnings at their lines.

        Args:
            path: of a URDF, xacro or launch file, or a directory.
            arguments: xacro arguments by name.
            select: only these rules: codes such as MSH001, or their beginnings.
            infos: also show infos, and all details of each finding.
            start: first line of the answer.
        """
        words = [*self._robot(path, arguments), *_codes(select), *["--info"] * infos]
        return _page(self._run("check", *words), start)

    def explain(self, code: str, start: int = 1) -> str:
        """Explain a rule: what it reports, why, how to fix it, with sources and examples.

        Args:
            code: such as MSH001, or its name.
        """
        return _page(self._run("explain", _word(code)), start)

    def trace(
        self, path: str, element: str, arguments: dict[str, str] | None = None, start: int = 1
    ) -> str:
        """Show the source of an element or a value of an expanded xacro.

        Args:
            element: such as link/base_link, or link/base_link/inertial/mass@value.
            arguments: xacro arguments by name.
        """
        file, *words = self._robot(path, arguments)
        if element.startswith("-"):
            raise ToolError(f"'{element}' is not an element")
        return _page(self._run("trace", file, element, *words), start)

    def expand(self, path: str, arguments: dict[str, str] | None = None, start: int = 1) -> str:
        """Expand a xacro to URDF, as the xacro command does.

        Args:
            path: of a xacro file.
            arguments: xacro arguments by name.
            start: first line of the answer.
        """
        return _page(self._run("expand", *self._robot(path, arguments), "-q"), start)

    def fix(
        self,
        path: str,
        select: list[str] | None = None,
        unsafe: bool = False,
        write: bool = False,
        start: int = 1,
    ) -> str:
        """Show the fixes of findings as a diff; look at it before you call this with 'write'.

        Args:
            path: of a URDF, xacro or launch file, or a directory.
            select: only these rules; infos are fixed only if their rule is listed here.
            unsafe: also apply fixes that may change the behaviour of the robot.
            write: apply the fixes, if the server was started with --write.
            start: first line of the answer.
        """
        if write and not self._may_write:
            raise ToolError("nothing is written: the server was started without --write")
        words = [*self._robot(path, None), *_codes(select), *["--unsafe-fixes"] * unsafe]
        text = self._run("fix", *words, "--diff")
        if not text:  # show the remaining findings and the reasons
            return _page(self._run("fix", *words, "--check"), start)
        if write:
            for file in re.findall(r"^\+\+\+ (.+?)\t?$", text, re.MULTILINE):
                self._inside(file)  # the repository may be larger than the directory
            text = self._run("fix", *words)
        return _page(text, start)

    def render(
        self,
        path: str,
        arguments: dict[str, str] | None = None,
        view: str = "iso",
        findings: bool = False,
    ) -> Image:
        """Render an image of a robot.

        Args:
            arguments: xacro arguments by name.
            view: iso, front, back, left, right, top or bottom.
            findings: colour links with errors red, with warnings orange.
        """
        words = [*self._robot(path, arguments), "--view", _word(view), "--size", "800x600"]
        with tempfile.TemporaryDirectory() as directory:
            file = os.path.join(directory, "robot.png")
            self._run("render", *words, "-o", file, *["--findings"] * findings)
            with open(file, "rb") as image:
                return Image(data=image.read(), format="png")

    def _robot(self, path: str, arguments: dict[str, str] | None) -> list[str]:
        """The words for a file of the workspace and its arguments.

        Raises:
            ToolError: the file is outside of the workspace, or does not exist.
        """
        file = self._inside(path)
        if not disk.exists(file):
            raise ToolError(f"{path}: file not found")
        pairs = (arguments or {}).items()
        file = os.path.join(os.curdir, os.path.relpath(file, self._root))
        return [file, *(f"{_word(name)}:={value}" for name, value in pairs)]

    def _inside(self, path: str) -> str:
        """The real path of a file of the workspace.

        Raises:
            ToolError: the file is outside of the workspace.
        """
        try:
            encoded = os.fsencode(path)
        except UnicodeEncodeError:  # a lone surrogate
            encoded = b"\0"
        if b"\0" in encoded:
            raise ToolError("not a valid file name")
        file = disk.real(os.path.join(self._root, path))
        if os.path.commonpath((file, self._root)) != self._root:
            raise ToolError(f"{path} is outside of the workspace")
        return file

    def _run(self, *words: str) -> str:
        """Run a command and return what it prints.

        Raises:
            ToolError: the command fails.
        """
        try:
            process = subprocess.run(
                [sys.executable, "-c", _PROGRAM, *words],
                capture_output=True,
                check=False,
                cwd=self._root,
                env={**os.environ, "COLUMNS": _WIDTH, "NO_COLOR": "1"},
                stdin=subprocess.DEVNULL,
                timeout=MAX_SECONDS,
            )
        except subprocess.TimeoutExpired as error:
            raise ToolError(f"not finished after {MAX_SECONDS} s") from error
        except ValueError as error:  # a NUL in an argument
            raise ToolError(str(error)) from error
        if process.returncode not in (0, 1) and not process.stdout:
            raise ToolError(process.stderr[:MAX_BYTES].decode("utf-8", "replace").strip())
        return process.stdout.decode("utf-8", "replace")


def server(directory: str, *, may_write: bool) -> MCPServer:
    """The server with its tools."""
    tools = Tools(directory, may_write=may_write)
    reading: tuple[Callable[..., Any], ...] = (
        *(tools.check, tools.explain, tools.trace, tools.expand, tools.render),
    )
    fix = _tool(tools.fix, is_read_only=not may_write)
    return MCPServer(
        "urdfkit",
        instructions=_INSTRUCTIONS,
        version=__version__,
        log_level="WARNING",
        tools=[*(_tool(read, is_read_only=True) for read in reading), fix],
    )


def _tool(function: Callable[..., Any], *, is_read_only: bool) -> Tool:
    """A tool that rejects unknown arguments, which the SDK would ignore."""
    tool = Tool.from_function(function, annotations=ToolAnnotations(read_only_hint=is_read_only))
    arguments = tool.fn_metadata.arg_model
    arguments.model_config["extra"] = "forbid"
    arguments.model_rebuild(force=True)
    tool.parameters = arguments.model_json_schema(by_alias=True)
    return tool


def _word(text: str) -> str:
    """A code or a name, which cannot be an option.

    Raises:
        ToolError: the text is not a word.
    """
    if not _WORD.fullmatch(text):
        raise ToolError(f"'{text}' is not a name: only letters, digits, '_' and '-'")
    return text


def _codes(select: list[str] | None) -> list[str]:
    return ["--select", ",".join(map(_word, select))] if select else []


def _page(text: str, start: int) -> str:
    """The part of a text that fits in an answer, and how to get the rest."""
    lines = text.splitlines()
    if not 1 <= start <= max(len(lines), 1):
        raise ToolError(f"there is no line {start}, only {counted(len(lines), 'line')}")
    shown: list[str] = []
    remaining = MAX_BYTES
    for line in lines[start - 1 :]:
        data = line.encode("utf-8", "replace")
        remaining -= len(data) + 1
        if remaining < 0 and shown:
            break
        cut = data[:MAX_BYTES].decode("utf-8", "ignore")
        shown.append(line if remaining >= 0 else f"{cut} ... (the line is longer)")
    end = start - 1 + len(shown)
    if end < len(lines):
        shown.append(f"[lines {start} to {end} of {len(lines)}; start={end + 1} shows more]")
    return "\n".join(shown)
