"""Format and defects of a mesh file, before it is loaded."""

from __future__ import annotations

from enum import Enum

from urdfkit.core.record import Record

BINARY_STL = "binary STL"
ASCII_STL = "ASCII STL"
COLLADA = "COLLADA"
OBJ = "OBJ"
PLY = "PLY"
GLB = "GLB"
GLTF = "glTF"
VTK = "VTK"

#: Larger files are recognised by their beginning, and not validated.
MAX_BYTES = 128 * 1024 * 1024

#: Formats that can be loaded.
READ = (BINARY_STL, ASCII_STL, COLLADA, OBJ, PLY, GLB, GLTF)

#: Formats by suffix, by which programs choose their reader.
BY_SUFFIX = {
    ".stl": (BINARY_STL, ASCII_STL),
    ".stlb": (BINARY_STL,),
    ".stla": (ASCII_STL,),
    ".dae": (COLLADA,),
    ".obj": (OBJ,),
    ".ply": (PLY,),
    ".glb": (GLB,),
    ".gltf": (GLTF,),
}


class DefectKind(Enum):
    """Kinds of defects of mesh files."""

    EMPTY = "empty"
    NOT_A_MESH = "not a mesh"
    TRUNCATED = "truncated"
    UNREADABLE = "unreadable"


class Defect(Record):
    """The reason why a mesh file cannot be used."""

    kind: DefectKind
    reason: str  # a predicate whose subject is the file: ``contains no triangles``


class MeshFacts(Record):
    """Properties of the bytes of a mesh file."""

    format: str  # by content, such as ``binary STL``; empty if unknown
    size: int  # in bytes
    defect: Defect | None = None  # why the file cannot be used, or None
    non_finite: str = ""  # the first non-finite coordinate, in words; empty if there is none
    unit: float = 1.0  # metres per unit of length, in COLLADA; 1 if not defined
    #: ``X_UP``, ``Y_UP`` or ``Z_UP``, in COLLADA; empty if not defined.
    up_axis: str = ""
    starts_with_solid: bool = False  # True for a binary STL that begins as an ASCII STL


def has_other_unit(facts: MeshFacts) -> bool:
    """True if a file declares another unit than metres."""
    return abs(facts.unit - 1) > 1e-6


def has_other_up_axis(facts: MeshFacts) -> bool:
    """True for a COLLADA file that declares x or y as up."""
    return facts.up_axis not in ("", "Z_UP")


def is_gltf(facts: MeshFacts) -> bool:
    """True for a valid glTF file."""
    return not facts.defect and facts.format in (GLB, GLTF)


def empty(reason: str) -> Defect:
    return Defect(DefectKind.EMPTY, reason)


def not_a_mesh(reason: str) -> Defect:
    return Defect(DefectKind.NOT_A_MESH, reason)


def truncated(reason: str) -> Defect:
    return Defect(DefectKind.TRUNCATED, reason)


def unreadable(reason: str) -> Defect:
    return Defect(DefectKind.UNREADABLE, reason)
