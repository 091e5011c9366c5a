"""A plug-in for pytest: xacro's own tests put their questions to a command.

Loaded with ``-p xacro_harness`` where xacro's ``test_xacro.py`` runs; SUBJECT in the environment
is the command, such as ``xacro``, as a shell takes it.
"""

import os
import re
import shlex
import subprocess
import sys
import tempfile
from typing import Any
from xml.dom import minidom
from xml.parsers.expat import ExpatError

SUBJECT = shlex.split(os.environ["SUBJECT"])
#: The message ends where the places begin.
_ERROR = re.compile(
    r"^error: (.*?)(?=\n(?:when |in file|\S+:\d+:\d+: )|\Z)", re.MULTILINE | re.DOTALL
)


def pytest_collection_modifyitems(items: list[Any]) -> None:
    """Exchange what the tests run."""
    module = items[0].module
    module.XACRO_EXECUTABLE = _script()
    module.TestXacroBase.quick_xacro = _quick_xacro
    module.xacro.init_stacks(None)  # which some tests take for granted


def _script() -> str:
    """The subject as one program, which the tests of xacro's command line start."""
    handle, path = tempfile.mkstemp(prefix="subject", dir=os.getcwd())
    os.write(handle, f'#!/bin/sh\nexec {shlex.join(SUBJECT)} "$@"\n'.encode())
    os.close(handle)
    os.chmod(path, 0o755)
    return path


def _quick_xacro(_: Any, xml: Any, cli: list[str] | None = None, **options: Any) -> Any:
    """What xacro makes of a text, as its output, exit code and standard error."""
    import xacro

    text = xml if isinstance(xml, str) else xml.read()
    arguments = list(cli or [])
    if "verbosity" in options:
        arguments.append(f"--verbosity={options['verbosity']}")
    handle, path = tempfile.mkstemp(prefix="model", suffix=".xacro", dir=os.getcwd())
    os.write(handle, text.encode())
    os.close(handle)
    try:
        name = os.path.basename(path)  # relative, so that included paths are as of a string
        done = subprocess.run(
            [*SUBJECT, name, *arguments], capture_output=True, text=True, check=False
        )
    finally:
        os.remove(path)
    sys.stderr.write(done.stderr)
    if done.returncode == 0:
        return _without_banner(minidom.parseString(done.stdout.encode()))
    assert done.returncode == 2, done.stderr
    message = _ERROR.search(done.stderr)
    assert message is not None, done.stderr
    is_broken = message.group(1).startswith("XML parsing error: ")
    raise (ExpatError if is_broken else xacro.XacroException)(message.group(1))


def _without_banner(document: Any) -> Any:
    for comment in list(document.childNodes)[:4]:
        document.removeChild(comment)
    return document
