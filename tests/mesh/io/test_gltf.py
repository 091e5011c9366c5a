import struct

import pytest

from tests.mesh import made
from urdfkit.mesh.io.facts import Defect, DefectKind
from urdfkit.mesh.io.sniff import sniff

GLB = made.glb()


@pytest.mark.parametrize(
    ("data", "kind", "reason"),
    [
        (b"glTF", DefectKind.TRUNCATED, "ends after 4 bytes, inside its header"),
        (GLB[:-1], DefectKind.TRUNCATED, f"declares {len(GLB)} bytes and has {len(GLB) - 1}"),
        (
            GLB[:4] + struct.pack("<I", 1) + GLB[8:],
            DefectKind.UNREADABLE,
            "is GLB version 1; parsers support version 2",
        ),
        (GLB[:16] + b"BIN\0" + GLB[20:], DefectKind.UNREADABLE, "does not begin with a JSON chunk"),
        (
            GLB[:12] + struct.pack("<I", 9999) + GLB[16:],
            DefectKind.TRUNCATED,
            f"declares 9999 bytes of JSON and has {len(GLB) - 20}",
        ),
        (made.glb(b"{}"), DefectKind.NOT_A_MESH, "is JSON, but not glTF"),
        (
            made.glb(made.gltf(asset={"version": "1.0"})),
            DefectKind.UNREADABLE,
            "is glTF version 1.0; parsers support version 2",
        ),
        (made.glb(made.gltf(meshes=[])), DefectKind.EMPTY, "contains no triangles"),
    ],
)
def test_broken_containers(data: bytes, kind: DefectKind, reason: str) -> None:
    assert sniff(data, ".glb").defect == Defect(kind, reason)


@pytest.mark.parametrize(
    ("data", "kind", "reason"),
    [
        (made.gltf(meshes=[]), DefectKind.EMPTY, "contains no triangles"),
        (made.gltf(meshes=None), DefectKind.EMPTY, "contains no triangles"),
        (made.gltf(meshes=[{}, 1]), DefectKind.EMPTY, "contains no triangles"),
        (b'{"asset"', DefectKind.TRUNCATED, "ends inside its JSON"),
        (b'{"asset": "2.', DefectKind.TRUNCATED, "ends inside a text of its JSON"),
        (b'{"asset": {}\n,}', DefectKind.UNREADABLE, "is not JSON: "),
        (b'{"asset": ' + b"[" * 100_000, DefectKind.UNREADABLE, "is not JSON"),
        (b'{"asset": "\xff"}', DefectKind.UNREADABLE, "is not JSON"),
    ],
)
def test_broken_json(data: bytes, kind: DefectKind, reason: str) -> None:
    defect = sniff(data, ".gltf").defect
    assert defect is not None
    assert defect.kind is kind
    assert defect.reason.startswith(reason)
