"""The 3D engine: three.js from trimesh's package, read when a page is written.

Packages that contain a 3D engine as a script: trimesh's viewer (0.7 MB; three.js with its glTF
loader, and trimesh is installed anyway), viser (0.8 MB; its page uses a protocol of its own),
meshcat (0.9 MB; an old three.js, and it needs IPython, ZeroMQ and Tornado) and k3d (2.6 MB, and
it needs the Jupyter widgets).
"""

from __future__ import annotations

import re
from importlib.metadata import PackageNotFoundError, distribution

from urdfkit.core.installation import needing
from urdfkit.core.record import Record
from urdfkit.errors import UrdfkitError

#: End of the engine in the script of trimesh's page; the code of the page follows.
_END = "THREE.GLTFLoader=GLTFLoader;})();"
_SCRIPT = re.compile(r"<script>(.*?)</script>", re.DOTALL)
_TEMPLATE = "templates/viewer.zip"


class PageEngine(Record):
    """The 3D engine (JavaScript) of a page."""

    script: str  # defines ``THREE`` and ``THREE.GLTFLoader``; with its copyright notice
    package: str  # the source package, with its version
    licence: str  # text of the licence


def load() -> PageEngine:
    """Load the 3D engine.

    Raises:
        UrdfkitError: trimesh is not installed, or its viewer has another format.
    """
    with needing("the 3D view", "report"):
        from trimesh.resources import get_bytes
    match = _SCRIPT.search(_page(get_bytes(_TEMPLATE)))
    script, end, _ = match.group(1).partition(_END) if match else ("", "", "")
    package = distribution("trimesh")
    name = f"trimesh {package.version}"
    if not end:
        raise UrdfkitError(f"the viewer of {name} is not supported: pip install 'trimesh>=4.9'")
    notice = script[: script.find("*/") + 2]
    return PageEngine(script + end, name, f"{notice}\n\n{_licence()}")


def _page(archive: bytes) -> str:
    import io
    import zipfile

    with zipfile.ZipFile(io.BytesIO(archive)) as files:
        return files.read(files.namelist()[0]).decode("utf-8")


def _licence() -> str:
    """Text of the MIT licence of three.js and trimesh, from trimesh's package."""
    try:
        files = distribution("trimesh").files or []
    except PackageNotFoundError:
        return "MIT"
    texts = [file for file in files if "license" in file.name.lower() and ".dist-info" in str(file)]
    return texts[0].read_text(encoding="utf-8") if texts else "MIT"
