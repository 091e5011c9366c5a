"""Format and validity of mesh files by their bytes, without a mesh library.

Libraries load many broken meshes as empty, without an error. Suffixes are not reliable either: web
pages are saved as meshes, and 118 of 121 STL files that begin with ``solid``, the keyword of ASCII
STL, are binary.
"""

import os
import re
from importlib import import_module
from stat import S_ISREG

from urdfkit.core import disk
from urdfkit.mesh.io import binary_stl, facts
from urdfkit.mesh.io.facts import MAX_BYTES, Defect, MeshFacts, empty, not_a_mesh, unreadable
from urdfkit.text.source import why_unreadable

#: Upper bound of the size of a robot mesh.
_MAX_SIZE = 1024**3
_HEAD = 4096
_LONG_HEAD = 64 * 1024

_VALIDATORS = {
    facts.BINARY_STL: ("binary_stl", "validate"),
    facts.ASCII_STL: ("ascii_stl", "validate"),
    facts.COLLADA: ("collada", "validate"),
    facts.OBJ: ("obj", "validate"),
    facts.PLY: ("ply", "validate"),
    facts.GLB: ("gltf", "validate_glb"),
    facts.GLTF: ("gltf", "validate_json"),
}

_TEXT = bytes([9, 10, 12, 13, *range(32, 127), *range(128, 256)])
_UTF_16 = (b"\xff\xfe", b"\xfe\xff")
_LFS = b"version https://git-lfs.github.com/spec/"
_XML_ROOT = rb"<(?:[\w.-]+:)?([A-Za-z_][\w.-]*)"
#: Declarations and comments; unterminated ones extend to the end of the text.
_NOT_ROOT = rb"(?s)<\?.*?(?:\?>|\Z)|<!--.*?(?:-->|\Z)|<![^>]*(?:>|\Z)"
_HTML_TAGS = frozenset("html head body script meta title div table".split())
#: A line of OBJ data, or a reference to materials.
_OBJ = (
    rb"(?:\A|\n)[ \t]*"
    rb"(?:vn?[ \t]+[-+.\deE]+[ \t]+[-+.\d]|f[ \t]+\d+[ \t/]|mtllib[ \t]|usemtl[ \t])"
)

#: Formats with a signature; most are not supported by URDF parsers.
_MAGIC = (
    (b"glTF", facts.GLB),
    (b"ISO-10303-21", "STEP"),
    (b"Kaydara FBX Binary", "FBX"),
    (b"; FBX", "FBX"),
    (b"BLENDER", "Blender"),
    (b"#VRML", "VRML"),
    (b"#Inventor", "Open Inventor"),
    (b"#X3D", "X3D"),
    (b"#usda", "USD"),
    (b"# vtk DataFile", facts.VTK),
    (b"PXR-USDC", "USD"),
    (b"\x00\x10[MeshSerializer", "Ogre mesh"),
    (b"OFF\n", "OFF"),
    (b"OFF\r", "OFF"),
)
_XML_FORMATS = {"COLLADA": facts.COLLADA, "X3D": "X3D", "amf": "AMF"}
#: Signatures of files that are not meshes.
_FOREIGN = (
    (b"\x89PNG", "a PNG image"),
    (b"\xff\xd8\xff", "a JPEG image"),
    (b"GIF8", "a GIF image"),
    (b"%PDF-", "a PDF document"),
    (b"\x1f\x8b", "a gzip archive"),
    (b"PK\x03\x04", "a zip archive"),
    (b"7z\xbc\xaf", "a 7z archive"),
    (b"Rar!", "a RAR archive"),
    (b"\x7fELF", "a program"),
    (b"MZ\x90", "a program"),
    (b"\xd0\xcf\x11\xe0", "a document of an office or CAD program"),
)


def sniff_file(path: str) -> MeshFacts:
    """Validate a mesh file. Never raises: an unreadable file has a defect, too."""
    try:
        state = disk.state(path)
        if not S_ISREG(state.st_mode):  # reading a device or a pipe might never end
            return MeshFacts("", 0, unreadable("is not a regular file"))
        data = disk.read(path, state.st_size if state.st_size <= MAX_BYTES else _HEAD)
    except OSError as error:
        return MeshFacts("", 0, unreadable(why_unreadable(path, error)))
    except ValueError:
        return MeshFacts("", 0, unreadable("cannot be read: its name contains a NUL"))
    if state.st_size > MAX_BYTES:
        return MeshFacts(recognise(data, state.st_size), state.st_size)
    return sniff(data, os.path.splitext(path)[1])


def sniff(data: bytes, suffix: str) -> MeshFacts:
    """Validate the bytes of a mesh file.

    Args:
        suffix: of the file name, such as ``.stl``; the intended format of broken content.
    """
    format = recognise(data, len(data))
    defect: Defect | None = None
    not_finite = ""
    if not format:
        defect = _foreign(data)
        format = "" if defect else _suggested(data, suffix.lower())
    if format in _VALIDATORS:
        module, function = _VALIDATORS[format]
        defect, not_finite = getattr(import_module(f"urdfkit.mesh.io.{module}"), function)(data)
    elif not format and defect is None:
        defect = _unknown(data)
    unit, up_axis = 1.0, ""
    if format == facts.COLLADA and defect is None:
        from urdfkit.mesh.io.collada import conventions

        unit, up_axis = conventions(data)
    is_solid = format == facts.BINARY_STL and data[:5].lower() == b"solid"
    return MeshFacts(format, len(data), defect, not_finite, unit, up_axis, is_solid)


def recognise(data: bytes, size: int) -> str:
    """The format of a mesh file by its beginning and size; empty if unknown."""
    head = data[:_HEAD]
    if binary_stl.is_stl(head, size):  # first, because its header may contain any text
        return facts.BINARY_STL
    for magic, format in _MAGIC:
        if head.startswith(magic):
            return format
    if head.startswith(b"MM") and size == int.from_bytes(head[2:6], "little"):
        return "3DS"
    if head.startswith(b"PK\x03\x04"):
        return "3MF" if b"3D/3dmodel.model" in data else "USD" if b".usd" in data else ""
    if head[72:73] == b"S" and head[73:80].strip(b" 0") == b"1":
        return "IGES"
    if head.lstrip().startswith((b"ply\n", b"ply\r", b"ply ")):
        return facts.PLY
    text = head.lstrip(b"\xef\xbb\xbf \t\r\n")
    if text.startswith((b"<", *_UTF_16)):
        return _XML_FORMATS.get(_xml_root(data), "")
    return _text_format(text, data) if _is_text(head) else ""


def _text_format(text: bytes, data: bytes) -> str:
    if text[:5].lower() == b"solid":
        return facts.ASCII_STL
    if text.startswith(b"{"):
        return facts.GLTF
    return facts.OBJ if re.search(_OBJ, data[:_LONG_HEAD]) else ""


def _xml_root(data: bytes) -> str:
    """The tag of the root element of XML, without its prefix; empty if there is none."""
    for length in (_HEAD, _LONG_HEAD):  # few files begin with a long comment
        text = data[:length]
        if text.startswith(_UTF_16):
            text = text.replace(b"\0", b"")
        match = re.search(_XML_ROOT, re.sub(_NOT_ROOT, b" ", text))
        if match:
            return match.group(1).decode("ascii")
    return ""


def _is_text(data: bytes) -> bool:
    return not data.translate(None, _TEXT)


def _suggested(data: bytes, suffix: str) -> str:
    """The intended format of broken content, if the suffix and the bytes agree."""
    if suffix in (".stl", ".stlb") and not _is_text(data[:_HEAD]):
        # In a file that is not STL, the triangle count is an arbitrary number.
        header = data[:80].rstrip(b"\0")
        is_stl = _is_text(header) or binary_stl.whole_size(data) <= _MAX_SIZE
        return facts.BINARY_STL if is_stl else ""
    if suffix == ".obj" and data.lstrip().startswith(b"#"):
        return facts.OBJ
    if suffix == ".dae" and data.startswith(b"<") and not _xml_root(data):
        return facts.COLLADA
    return ""


def _foreign(data: bytes) -> Defect | None:
    """The defect of a file that is recognised as something other than a mesh."""
    if not data.strip():
        return empty("is empty" if not data else "contains only white space")
    if data.startswith(b"<<<<<<<"):
        return unreadable("contains the markers of a merge conflict")
    if data.startswith(_LFS):
        size = re.search(rb"\nsize (\d{1,18})\b", data[:_HEAD])
        length = f" of {size.group(1).decode()} bytes" if size else ""
        return not_a_mesh(f"is a Git LFS pointer: the mesh{length} itself has not been fetched")
    for magic, thing in _FOREIGN:
        if data.startswith(magic):
            return not_a_mesh(f"is {thing}")
    root = _xml_root(data) if data.lstrip(b"\xef\xbb\xbf \t\r\n").startswith(b"<") else ""
    if root.lower() in _HTML_TAGS:
        title = re.search(rb"(?i)<title[^>]*>([^<]{1,200})", data[:_LONG_HEAD])
        words = title.group(1).decode("utf-8", "replace").split() if title else []
        return not_a_mesh(f"is a web page{_quoted(' '.join(words))}")
    if root:
        return not_a_mesh(f"is XML with the root element <{root[:60]}>")
    return None


def _unknown(data: bytes) -> Defect:
    if _is_text(data[:_HEAD]):
        words = data[:200].decode("utf-8", "replace").split()
        return not_a_mesh(f"is text, not in a mesh format{_quoted(' '.join(words))}")
    return unreadable(f"is not in a known mesh format (begins with {data[:8].hex(' ')})")


def _quoted(text: str) -> str:
    """The beginning of a text, for a message."""
    return f": '{text[:40]}{'...' if len(text) > 40 else ''}'" if text else ""
