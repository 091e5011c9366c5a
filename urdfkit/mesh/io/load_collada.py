"""Reading of COLLADA files: the scene, its nodes and their geometry.

pycollada is not used, because it drops a whole geometry over a bad colour or an unresolved
reference. The unit of length and the up axis are recorded but not applied, because programs handle
them differently.
"""

import re
from collections.abc import Iterator
from itertools import chain
from math import radians

import numpy as np

from urdfkit.core.spatial import rotation_about, unit, vector
from urdfkit.mesh.geometry import Floats, Mesh, MeshPart, NoTriangles
from urdfkit.mesh.io.assemble import (
    MAX_NODES,
    MAX_TRIANGLES,
    LostData,
    assemble,
    at_most,
    counted_kinds,
    limited,
    mesh_of,
    transformed,
)
from urdfkit.mesh.io.collada_geometry import ColladaTriangles, Geometries
from urdfkit.mesh.io.collada_materials import ColladaMaterial, ColladaMaterials
from urdfkit.mesh.io.collada_tree import ColladaTree, Element, child, children, tag, text
from urdfkit.mesh.io.numbers import floats
from urdfkit.mesh.io.referenced_files import ReferencedFiles

#: Levels of nested nodes.
MAX_DEPTH = 200

#: A number in the format of German or French locales.
_DECIMAL_COMMA = re.compile(rb"<float_array[^<>]*>\s*(-?\d+,\d+)\s")

_EXTRAS = {"instance_camera": "camera", "instance_light": "light", "animation": "animation"}
_INSTANCES = ("instance_geometry", "instance_controller")


def read(data: bytes, directory: str, *, recover: bool = False) -> Mesh:
    """The scene of a COLLADA file.

    Args:
        data: the file.
        directory: the directory of the file.
        recover: read as much as possible of XML that is not well formed; if the scene is missing,
            all geometry is read without transforms.

    Raises:
        NoTriangles: the scene is empty, or the file cannot be read.
    """
    try:
        return _ColladaReader(ColladaTree(data, recover=recover), directory).mesh(unplaced=recover)
    except NoTriangles:
        comma = _DECIMAL_COMMA.search(data)
        if comma is None:
            raise
        number = comma.group(1).decode()
        raise NoTriangles(f"has numbers with a decimal comma, such as '{number}'") from None


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
        placed = (self._node_parts(*node) for node in at_most(MAX_NODES, "nodes", self._nodes()))
        parts = list(limited(chain.from_iterable(placed)))
        if unplaced and not self._placed:
            parts += self._unplaced()
        asset = child(self._tree.root, "asset")
        return mesh_of(parts, self._losses, self._files)._replace(
            unit=_unit(child(asset, "unit")),
            up_axis=text(child(asset, "up_axis")).upper(),
            extras=self._extras(),
        )

    def _nodes(self) -> Iterator[tuple[Element, Floats]]:
        """The nodes of the scene and their transforms, in the order of the file."""
        stack: list[tuple[Element, Floats, tuple[Element, ...]]] = [
            (node, np.eye(4), (node,)) for node in reversed(self._roots())
        ]
        while stack:
            node, parent_matrix, path = stack.pop()
            matrix = parent_matrix @ self._matrix(node)
            yield node, matrix
            below = list(children(node, "node"))
            for instance in children(node, "instance_node"):
                target = self._tree.named(instance.get("url"), "node")
                if target is None:
                    self._losses.add("node* missing from the file")
                else:
                    below.append(target)
            for child_node in reversed(below):
                if child_node in path or len(path) > MAX_DEPTH:
                    self._losses.add("reference* of a node to itself")
                else:
                    stack.append((child_node, matrix, (*path, child_node)))

    def _roots(self) -> list[Element]:
        instance = child(self._tree.root, "scene", "instance_visual_scene")
        scene = self._tree.named(
            instance.get("url") if instance is not None else "", "visual_scene"
        )
        if scene is None:  # an unresolved reference, or the end of the file is missing
            scene = child(self._tree.root, "library_visual_scenes", "visual_scene")
        return list(children(scene, "node"))

    def _matrix(self, node: Element) -> Floats:
        matrix = np.eye(4)
        for step in children(node, "matrix", "translate", "rotate", "scale", "lookat", "skew"):
            move = _step_matrix(tag(step), floats(text(step)))
            if move is None:
                self._losses.add(f"<{tag(step)}>* that cannot be read")
            else:
                matrix = matrix @ move
        return matrix

    def _node_parts(self, node: Element, matrix: Floats) -> Iterator[MeshPart | None]:
        for instance in children(node, *_INSTANCES):
            geometry, bound = self._geometry(instance)
            if geometry is None:
                self._losses.add("unresolved geometry reference*")
                continue
            self._placed = True
            for part in self._parts(geometry, self._bound_materials(instance)):
                yield transformed(part, matrix @ bound, self._losses)

    def _unplaced(self) -> Iterator[MeshPart]:
        """All geometry of a file without a scene, without transforms."""
        for library in children(self._tree.root, "library_geometries"):
            for geometry in children(library, "geometry"):
                self._losses.add("geometry* without a place in the scene")
                for part in self._parts(geometry, {}):
                    if np.isfinite(part.vertices).all():
                        yield part

    def _geometry(self, instance: Element) -> tuple[Element | None, Floats]:
        """The geometry of an instance, and its transform: of a skin, the bind shape matrix."""
        if tag(instance) == "instance_geometry":
            return self._tree.named(instance.get("url"), "geometry"), np.eye(4)
        controller = self._tree.named(instance.get("url"), "controller")
        skin = child(controller, "skin")
        if skin is None:
            skin = child(controller, "morph")
        if skin is None:
            return None, np.eye(4)
        bound = _step_matrix("matrix", floats(text(child(skin, "bind_shape_matrix"))))
        geometry = self._tree.named(skin.get("source"), "geometry")
        return geometry, np.eye(4) if bound is None else bound

    def _bound_materials(self, instance: Element) -> dict[str, tuple[ColladaMaterial, Element]]:
        """The materials of an instance by symbol."""
        bindings = child(instance, "bind_material", "technique_common")
        materials: dict[str, tuple[ColladaMaterial, Element]] = {}
        for binding in children(bindings, "instance_material"):
            material = self._materials.material(binding.get("target", ""))
            if material is None:
                self._losses.add("material* missing from the file")
            else:
                materials.setdefault(binding.get("symbol", ""), (material, binding))
        return materials

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
            raise NoTriangles(f"has more than {MAX_TRIANGLES} triangles")
        material, binding = materials.get(surface.symbol, (None, None))
        if material is None and surface.symbol:  # unbound: assimp uses the material of that name
            material = self._materials.material(f"#{surface.symbol}")
        uv = None
        if surface.uvs:
            name = ""
            if material and binding is not None:
                name = _set_of(binding, material.coordinates)
            uv = surface.uvs.get(name, next(iter(surface.uvs.values())))
        return assemble(
            surface.position,
            self._losses,
            material.material if material else None,
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
    """The set of texture coordinates that an instance binds to a semantic."""
    for bound in children(binding, "bind_vertex_input"):
        if bound.get("semantic") == coordinates:
            return str(bound.get("input_set", "0"))
    return ""


def _unit(element: Element | None) -> float:
    numbers = floats(element.get("meter", "1") if element is not None else "1")
    usable = len(numbers) == 1 and np.isfinite(numbers[0]) and numbers[0] > 0
    return float(numbers[0]) if usable else 1.0


def _step_matrix(kind: str, numbers: Floats) -> Floats | None:
    """The (4, 4) matrix of a transform element; None if numbers are missing or not finite."""
    matrix = np.eye(4)
    if not np.isfinite(numbers).all():
        return None
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
