"""Reading COLLADA files: the scene, its nodes, and what they show.

Written here and not left to pycollada, which drops a whole geometry over a bad colour or a
reference to nothing. The unit of length and the upward axis are
recorded and not applied, for every consumer does otherwise with them.
"""

import re
from collections.abc import Iterator
from math import radians

import numpy as np

from urdfkit.core.spatial import rotation_about, unit, vector
from urdfkit.mesh.geometry import Floats, Mesh, MeshPart, NoTriangles
from urdfkit.mesh.io.assemble import (
    MAX_NODES,
    MAX_TRIANGLES,
    LostData,
    assemble,
    counted_kinds,
    mesh_of,
    transformed,
)
from urdfkit.mesh.io.collada_geometry import ColladaTriangles, Geometries
from urdfkit.mesh.io.collada_materials import ColladaMaterial, ColladaMaterials
from urdfkit.mesh.io.collada_tree import ColladaTree, Element, child, children, tag, text
from urdfkit.mesh.io.numbers import floats
from urdfkit.mesh.io.referenced_files import ReferencedFiles

#: Nodes within nodes.
MAX_DEPTH = 200

#: A number as programs in German or French print it.
_DECIMAL_COMMA = re.compile(rb"<float_array[^<>]*>\s*(-?\d+,\d+)\s")

_EXTRAS = {"instance_camera": "camera", "instance_light": "light", "animation": "animation"}
_INSTANCES = ("instance_geometry", "instance_controller")


def read(data: bytes, directory: str, *, recover: bool = False) -> Mesh:
    """What the scene of a COLLADA file shows.

    Args:
        data: the file.
        directory: that it lies in.
        recover: read what is there of XML that is not well formed; geometry that no node shows,
            for the end of the file is missing, is shown as it is.

    Raises:
        NoTriangles: it shows nothing, or is not to be read.
    """
    try:
        return _ColladaReader(ColladaTree(data, recover=recover), directory).mesh(unplaced=recover)
    except NoTriangles:
        comma = _DECIMAL_COMMA.search(data)
        if comma is None:
            raise
        number = comma.group(1).decode()
        raise NoTriangles(f"writes numbers with commas for points, such as '{number}'") from None


class _ColladaReader:
    def __init__(self, tree: ColladaTree, directory: str) -> None:
        self._tree = tree
        self._losses = LostData()
        self._geometries = Geometries(tree, self._losses)
        self._files = ReferencedFiles(directory)
        self._materials = ColladaMaterials(tree, self._files, self._losses)
        self._triangles = 0
        self._placed = False

    def mesh(self, *, unplaced: bool = False) -> Mesh:
        parts = [part for node, matrix in self._nodes() for part in self._shown(node, matrix)]
        if unplaced and not self._placed:
            parts += self._unplaced()
        asset = child(self._tree.root, "asset")
        return mesh_of(parts, self._losses, self._files)._replace(
            unit=_unit(child(asset, "unit")),
            up_axis=text(child(asset, "up_axis")).upper(),
            extras=self._extras(),
        )

    def _nodes(self) -> Iterator[tuple[Element, Floats]]:
        """The nodes of the scene and where each stands, in the order of the file."""
        stack: list[tuple[Element, Floats, tuple[Element, ...]]] = [
            (node, np.eye(4), (node,)) for node in reversed(self._roots())
        ]
        shown = 0
        while stack:
            node, above, path = stack.pop()
            shown += 1
            if shown > MAX_NODES:
                raise NoTriangles(f"shows more than {MAX_NODES} nodes")
            matrix = above @ self._matrix(node)
            yield node, matrix
            below = list(children(node, "node"))
            for instance in children(node, "instance_node"):
                target = self._tree.named(instance.get("url"), "node")
                if target is None:
                    self._losses.add("node* missing from the file")
                else:
                    below.append(target)
            for one in reversed(below):
                if one in path or len(path) > MAX_DEPTH:
                    self._losses.add("reference* of a node to itself")
                else:
                    stack.append((one, matrix, (*path, one)))

    def _roots(self) -> list[Element]:
        instance = child(self._tree.root, "scene", "instance_visual_scene")
        scene = self._tree.named(
            instance.get("url") if instance is not None else "", "visual_scene"
        )
        if scene is None:  # a reference to nothing, or the end of the file is missing
            scene = child(self._tree.root, "library_visual_scenes", "visual_scene")
        return list(children(scene, "node"))

    def _matrix(self, node: Element) -> Floats:
        matrix = np.eye(4)
        for step in children(node, "matrix", "translate", "rotate", "scale", "lookat", "skew"):
            numbers = floats(text(step))
            move = _moves(tag(step), numbers) if np.isfinite(numbers).all() else None
            if move is None:
                self._losses.add(f"<{tag(step)}>* that cannot be read")
            else:
                matrix = matrix @ move
        return matrix

    def _shown(self, node: Element, matrix: Floats) -> Iterator[MeshPart]:
        for instance in children(node, *_INSTANCES):
            geometry, bound = self._geometry(instance)
            if geometry is None:
                self._losses.add("geometry reference* to nothing")
                continue
            self._placed = True
            for part in self._parts(geometry, self._bound(instance)):
                moved = transformed(part, matrix @ bound)
                if np.isfinite(moved.vertices).all():
                    yield moved
                else:
                    self._losses.add("surface* that a node moves to infinity")

    def _unplaced(self) -> Iterator[MeshPart]:
        """Every geometry of a file that has lost its scene, where its vertices are."""
        for library in children(self._tree.root, "library_geometries"):
            for geometry in children(library, "geometry"):
                self._losses.add("geometry* whose place in the scene is not in the file")
                for part in self._parts(geometry, {}):
                    if np.isfinite(part.vertices).all():
                        yield part

    def _geometry(self, instance: Element) -> tuple[Element | None, Floats]:
        """The geometry of an instance; a skin is shown as it was bound to its bones."""
        if tag(instance) == "instance_geometry":
            return self._tree.named(instance.get("url"), "geometry"), np.eye(4)
        controller = self._tree.named(instance.get("url"), "controller")
        skin = child(controller, "skin")
        if skin is None:
            skin = child(controller, "morph")
        if skin is None:
            return None, np.eye(4)
        numbers = floats(text(child(skin, "bind_shape_matrix")))
        bound = _moves("matrix", numbers) if np.isfinite(numbers).all() else None
        geometry = self._tree.named(skin.get("source"), "geometry")
        return geometry, np.eye(4) if bound is None else bound

    def _bound(self, instance: Element) -> dict[str, tuple[ColladaMaterial, Element]]:
        """The materials of an instance by the symbols that its surfaces use."""
        bindings = child(instance, "bind_material", "technique_common")
        found: dict[str, tuple[ColladaMaterial, Element]] = {}
        for binding in children(bindings, "instance_material"):
            material = self._materials.material(binding.get("target", ""))
            if material is None:
                self._losses.add("material* missing from the file")
            else:
                found.setdefault(binding.get("symbol", ""), (material, binding))
        return found

    def _parts(
        self, geometry: Element, materials: dict[str, tuple[ColladaMaterial, Element]]
    ) -> Iterator[MeshPart]:
        for surface in self._geometries.surfaces(geometry):
            part = self._part(surface, materials)
            if part is not None:
                yield part

    def _part(
        self, surface: ColladaTriangles, materials: dict[str, tuple[ColladaMaterial, Element]]
    ) -> MeshPart | None:
        self._triangles += len(surface.position.rows)
        if self._triangles > MAX_TRIANGLES:
            raise NoTriangles(f"shows more than {MAX_TRIANGLES} triangles")
        textured, binding = materials.get(surface.symbol, (None, None))
        if textured is None and surface.symbol:  # unbound: assimp takes the material of that name
            textured = self._materials.material(f"#{surface.symbol}")
        uv = None
        if surface.uvs:
            wanted = ""
            if textured and binding is not None:
                wanted = _set_of(binding, textured.coordinates)
            uv = surface.uvs.get(wanted, next(iter(surface.uvs.values())))
        return assemble(
            surface.position,
            self._losses,
            textured.material if textured else None,
            normals=surface.normals,
            uv=uv,
            colors=surface.colors,
        )

    def _extras(self) -> tuple[str, ...]:
        kinds = {"line set": self._geometries.lines}
        for name, kind in _EXTRAS.items():
            kinds[kind] = sum(1 for _ in self._tree.root.iter(f"{{*}}{name}"))
        kinds["skin"] = sum(1 for _ in self._tree.root.iter("{*}instance_controller"))
        return counted_kinds(kinds)


def _set_of(binding: Element, coordinates: str) -> str:
    """The set of texture coordinates that an instance binds to a name."""
    for bound in children(binding, "bind_vertex_input"):
        if bound.get("semantic") == coordinates:
            return str(bound.get("input_set", "0"))
    return ""


def _unit(element: Element | None) -> float:
    numbers = floats(element.get("meter", "1") if element is not None else "1")
    usable = len(numbers) == 1 and np.isfinite(numbers[0]) and numbers[0] > 0
    return float(numbers[0]) if usable else 1.0


def _moves(kind: str, numbers: Floats) -> Floats | None:
    """The (4, 4) matrix of a step of a node; None if its numbers are too few."""
    matrix = np.eye(4)
    if kind == "matrix" and len(numbers) >= 16:
        return numbers[:16].reshape(4, 4)
    if kind == "translate" and len(numbers) >= 3:
        matrix[:3, 3] = numbers[:3]
    elif kind == "scale" and len(numbers) >= 3:
        matrix[[0, 1, 2], [0, 1, 2]] = numbers[:3]
    elif kind == "rotate" and len(numbers) >= 4:
        if any(numbers[:3]):
            axis = unit(vector(numbers[:3]))
            matrix[:3, :3] = rotation_about(axis, radians(numbers[3]))
    else:
        return None
    return matrix
