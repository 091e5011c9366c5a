"""Builds the playground into the site: Pyodide and the editor from npm, urdfkit from here."""

import importlib.util
import logging
import shutil
import subprocess
import tempfile
import zipfile
from collections.abc import Iterator
from pathlib import Path

from urdfkit.output.report.html import render_view
from urdfkit.output.report.translations import Translator

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
#: Of the report, whose 3D view is that of the page.
TEMPLATES = ROOT / "urdfkit" / "output" / "report" / "templates"
SCRIPTS = ("surfaces.js", "joints.js", "overlays.js", "camera.js", "scene.js")

#: Robots to start from, below ``models``.
EXAMPLES = ("gazebo_pkg", "good/mobile_base", "good/two_link_arm")
#: Of Pyodide; its packages, which it would download, are not used.
PYODIDE = (
    *("pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm", "pyodide-lock.json"),
    "python_stdlib.zip",
)
#: Without a network it fails at once.
_QUIETLY = ("--no-audit", "--no-fund", "--prefer-offline", "--fetch-retries=0")
#: Packages that a check does without.
LEFT_OUT = {
    f"urdfkit/{name}"
    for name in (
        *("cli", "lsp", "pytest_plugin", "render", "scan", "testing", "viewer"),
        *("output/bundle", "output/comparison", "output/conversion", "output/diagrams"),
        *("output/package_templates", "output/report", "output/simulation", "output/covers"),
    )
}

_log = logging.getLogger("mkdocs.playground")


def build(site: Path) -> None:
    """Write the playground into a directory, or say why not: the site is built without it."""
    npm = shutil.which("npm")
    if npm is None:
        _log.info("npm is not installed: the playground stays empty")
        return
    with tempfile.TemporaryDirectory() as scratch:
        work = Path(scratch)
        scripts = (TEMPLATES / name for name in SCRIPTS)
        for source in (*HERE.glob("*.js"), *HERE.glob("*.json"), *scripts):
            shutil.copy(source, work)
        bundle = [
            *(npm, "exec", "--", "esbuild", "playground.js", "worker.js", "--bundle", "--minify"),
            *("--format=esm", "--external:./pyodide/*", f"--outdir={site}"),
        ]
        for command in ([npm, "ci", *_QUIETLY], bundle):
            done = subprocess.run(command, check=False, cwd=work, capture_output=True, text=True)
            if done.returncode:
                _log.info("the playground stays empty: %s", done.stderr.strip())
                return
        (site / "pyodide").mkdir(exist_ok=True)
        for name in PYODIDE:
            shutil.copy(work / "node_modules" / "pyodide" / name, site / "pyodide")
    page = (HERE / "index.html").read_text(encoding="utf-8")
    view = render_view(Translator())
    (site / "index.html").write_text(page.replace("<!-- the 3D view -->", view), encoding="utf-8")
    shutil.copy(TEMPLATES / "scene.css", site)
    _write_zip(site / "python.zip", _python())
    (site / "examples").mkdir(exist_ok=True)
    for example in EXAMPLES:
        directory = ROOT / "models" / example
        files = ((path, path.relative_to(directory.parent)) for path in directory.rglob("*"))
        _write_zip(site / "examples" / f"{directory.name}.zip", files)


def _python() -> Iterator[tuple[Path, Path]]:
    """The modules that a check imports, of which none is compiled: where they are, and become."""
    for module in ("browser.py", "scene.py"):
        yield HERE / module, (HERE / module).relative_to(ROOT)
    for name in ("urdfkit", "xacro", "yaml"):
        spec = importlib.util.find_spec(name)
        assert spec is not None
        assert spec.origin is not None
        directory = Path(spec.origin).parent
        for path in directory.rglob("*"):
            inside = path.relative_to(directory.parent)
            compiled = path.suffix in {".pyc", ".so", ".pyd"}
            if not compiled and not LEFT_OUT & {
                inside.as_posix(),
                *map(Path.as_posix, inside.parents),
            }:
                yield path, inside


def _write_zip(target: Path, files: Iterator[tuple[Path, Path]]) -> None:
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for path, inside in sorted(files):
            if path.is_file():
                archive.write(path, inside)
