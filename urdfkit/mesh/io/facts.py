"""What is known of a mesh file before it is loaded."""

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

#: Larger files are recognised by their beginning, and not validated further.
MAX_BYTES = 128 * 1024 * 1024

#: The formats whose triangles are read.
READ = (BINARY_STL, ASCII_STL, COLLADA, OBJ, PLY, GLB, GLTF)

#: The formats that a suffix promises; consumers choose their reader by the suffix.
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
    """What is wrong with a mesh file."""

    EMPTY = "empty"
    NOT_A_MESH = "not a mesh"
    TRUNCATED = "truncated"
    UNREADABLE = "unreadable"


class Defect(Record):
    """Why a mesh file cannot be used."""

    kind: DefectKind  # in one word
    reason: str  # a predicate whose subject is the file: ``holds no triangles``


class MeshFacts(Record):
    """What the bytes of a mesh file say."""

    format: str  # by content, such as ``binary STL``; empty if it is none that is known
    size: int  # in bytes
    defect: Defect | None = None  # why it cannot be used, or None
    non_finite: str = ""  # which coordinate is not finite, in words; empty if all are
    unit: float = 1.0  # metres per unit of length, as COLLADA says; 1 where nothing is said
    #: ``X_UP``, ``Y_UP`` or ``Z_UP``, as COLLADA says; empty where nothing is said.
    up_axis: str = ""
    starts_with_solid: bool = False  # True for a binary STL that begins as ASCII ones do


def has_other_unit(facts: MeshFacts) -> bool:
    """True if a file says that it is not in metres."""
    return abs(facts.unit - 1) > 1e-6


def has_other_up_axis(facts: MeshFacts) -> bool:
    """True for a COLLADA file that says that x or y is up."""
    return facts.up_axis not in ("", "Z_UP")


def is_gltf(facts: MeshFacts) -> bool:
    """True for a glTF file that can be read."""
    return not facts.defect and facts.format in (GLB, GLTF)


def empty(reason: str) -> Defect:
    return Defect(DefectKind.EMPTY, reason)


def not_a_mesh(reason: str) -> Defect:
    return Defect(DefectKind.NOT_A_MESH, reason)


def truncated(reason: str) -> Defect:
    return Defect(DefectKind.TRUNCATED, reason)


def unreadable(reason: str) -> Defect:
    return Defect(DefectKind.UNREADABLE, reason)
