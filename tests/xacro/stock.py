"""The stock xacro package as the yardstick, and the packages of the corpus as both see them."""

import contextlib
import io
import json
import shutil
import sys
import warnings
from collections.abc import Iterator, Mapping
from pathlib import Path
from types import ModuleType
from typing import NamedTuple
from xml.parsers.expat import ExpatError

from tests.conftest import CORPUS

with warnings.catch_warnings():
    warnings.simplefilter("ignore")  # of Python 3.10, about names in xacro
    import xacro

#: What expansions read; the rest of the corpus (meshes, textures) need not be installed.
SUFFIXES = (".xacro", ".urdf", ".xml", ".gazebo", ".trans", ".yaml", ".yml", ".srdf")


class Outcome(NamedTuple):
    """What an expansion gave.

    Attributes:
        text: the document; None if there was an error.
        error: in the words of the ``xacro`` command; None without one.
        warnings: in order.
    """

    text: str | None
    error: str | None
    warnings: tuple[str, ...]


def expand(
    path: Path, arguments: Mapping[str, str] | None = None, packages: Mapping[str, str] = {}
) -> Outcome:
    """Expand a file with the stock package."""
    reported = io.StringIO()
    text = error = None
    with _installed(packages), contextlib.redirect_stderr(reported):
        try:
            document = xacro.process_file(str(path), mappings=dict(arguments or {}))
            text = document.toprettyxml(indent="  ")
        except ExpatError as broken:
            error = f"XML parsing error: {broken}"
        except Exception as other:
            error = str(other) or repr(other)
    lines = reported.getvalue().splitlines()
    warnings = tuple(
        line.removeprefix("warning: ") for line in lines if line.startswith("warning: ")
    )
    return Outcome(text, error, warnings)


@contextlib.contextmanager
def _installed(packages: Mapping[str, str]) -> Iterator[None]:
    """A stand-in for ROS's index of packages, which is not to be had without ROS."""

    def get_package_share_directory(name: str) -> str:
        if name not in packages:
            raise LookupError(name)
        return packages[name]

    index = ModuleType("ament_index_python")
    inner = ModuleType("ament_index_python.packages")
    vars(inner)["get_package_share_directory"] = get_package_share_directory
    modules = {index.__name__: index, inner.__name__: inner}
    before = {name: sys.modules.get(name) for name in modules}
    sys.modules.update(modules)
    try:
        yield
    finally:
        for name, module in before.items():
            if module is None:
                del sys.modules[name]
            else:
                sys.modules[name] = module


def install(prefix: Path) -> dict[str, str]:
    """Install the packages of the corpus as their build files would.

    Returns:
        The directories of the packages by name.
    """
    layout = json.loads((CORPUS / "INSTALL_LAYOUT.json").read_text(encoding="utf-8"))
    packages: dict[str, str] = {}
    for repository in json.loads((CORPUS / "MANIFEST.json").read_text(encoding="utf-8"))["repos"]:
        for name, directory in repository["packages"].items():
            if name in packages:
                continue
            source = CORPUS / repository["dir"] / directory
            target = prefix / "share" / name
            packages[name] = str(target)
            target.mkdir(parents=True, exist_ok=True)  # of some nothing is installed
            rows = layout.get(str(source.relative_to(CORPUS)), {}).get("install_directory")
            if rows is None:
                _copy(source, target)
                continue
            for inner, destination in rows:
                into = prefix / destination.replace("${PROJECT_NAME}", name)
                into = into if inner.endswith("/") else into / Path(inner).name
                _copy(source / inner, into)
    return packages


def _copy(source: Path, target: Path) -> None:
    for file in source.rglob("*"):
        if file.suffix in SUFFIXES and file.is_file():
            copy = target / file.relative_to(source)
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(file, copy)
