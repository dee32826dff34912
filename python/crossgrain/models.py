# SPDX-License-Identifier: Apache-2.0
"""Models that fields are solved for: surfaces and tet meshes, from files, arrays and objects of other
packages."""

from __future__ import annotations

import os
import time
from functools import cached_property
from typing import Any, List, NamedTuple, Optional, Sequence, Tuple

import numpy as np

from ._arrays import address, indices, integer, numbers, of_shape, tags
from ._library import Handle, array_view, call, library, made, path_bytes, view
from ._options import handle_of, set_changed, unless_none, with_changes
from ._watched import watched
from .errors import InputError
from .options import MapPreparationOptions, ReadOptions, TetMakingOptions, TetTagOptions


class Crease(NamedTuple):
    """A sharp edge of a surface."""

    points: np.ndarray
    """(n, 3)"""
    tangents: np.ndarray
    """Unit vectors, (n, 3)."""
    tag: int
    is_tagged: bool


def _warnings(name: str, handle: Handle) -> List[str]:
    found: List[str] = []
    while True:
        line = getattr(library, name)(handle, len(found))
        if line is None:
            return found
        found.append(line.decode("utf-8", "replace"))


def _read_only(array: np.ndarray) -> np.ndarray:
    array.flags.writeable = False
    return array


class Surface:
    """A surface of triangles that index vertices. It may be open, flipped, non-manifold or a triangle soup.

    ``faces`` and ``solids`` are one number per triangle: the face of the CAD model, or tag, that it belongs
    to, and the solid that it bounds; triangles point out of their solid, and a face between two solids is
    present twice. ``inner_faces`` are triangles inside a solid whose normal frames should follow. ``unit`` is
    that of the coordinates, such as "mm": a label, no number changes.
    """

    path: str = ""
    """File that it was read from."""
    read_seconds: float = 0.0

    def __init__(self, vertices: Any, triangles: Any, *, faces: Any = None, solids: Any = None,
                 corner_normals: Any = None, creases: Sequence[Crease] = (), inner_faces: Any = None,
                 unit: str = ""):
        points = numbers(vertices, "vertices", 3)
        corners = indices(triangles, "triangles", 3)
        self._handle = made("mesh", "mesh_new", address(points), len(points), address(corners), len(corners))
        for name, values in (("faces", faces), ("solids", solids)):
            if values is not None:
                its_numbers = tags(values, name, len(corners))
                call(f"mesh_set_{name}", self._handle, address(its_numbers), len(corners))
        if corner_normals is not None:
            normals = of_shape(corner_normals, "corner_normals", (len(corners), 3, 3))
            call("mesh_set_corner_normals", self._handle, address(normals), len(corners))
        for crease in creases:
            its_points, tangents = numbers(crease[0], "points", 3), numbers(crease[1], "tangents", 3)
            if len(its_points) != len(tangents):
                raise TypeError("a crease has as many tangents as points")
            call("mesh_add_crease", self._handle, address(its_points), address(tangents), len(its_points),
                 integer(crease[2], "tag of a crease", -2**31), int(bool(crease[3])))
        if inner_faces is not None:
            its_faces = indices(inner_faces, "inner_faces", 3)
            call("mesh_add_inner_faces", self._handle, address(its_faces), len(its_faces))
        call("mesh_set_unit", self._handle, unit.encode())

    @classmethod
    def _of(cls, handle: Handle, path: str = "", read_seconds: float = 0.0) -> "Surface":
        surface = cls.__new__(cls)
        surface._handle, surface.path, surface.read_seconds = handle, path, read_seconds
        return surface

    def __repr__(self) -> str:
        return f"<crossgrain.Surface: {len(self.vertices)} vertices, {len(self.triangles)} triangles>"

    def _per_triangle(self, name: str, dtype: Any, *shape: int) -> Optional[np.ndarray]:
        return view(self._handle, getattr(library, f"crossgrain_mesh_{name}")(self._handle), dtype,
                    (len(self.triangles), *shape))

    @cached_property
    def vertices(self) -> np.ndarray:
        """(n, 3)"""
        count = library.crossgrain_mesh_vertex_count(self._handle)
        return array_view(self._handle, library.crossgrain_mesh_vertices(self._handle), np.float64,
                          (count, 3))

    @cached_property
    def triangles(self) -> np.ndarray:
        """Indices of vertices, (m, 3)."""
        count = library.crossgrain_mesh_triangle_count(self._handle)
        return array_view(self._handle, library.crossgrain_mesh_triangles(self._handle), np.uint32,
                          (count, 3))

    @property
    def faces(self) -> Optional[np.ndarray]:
        """Number of the face of the CAD model, or tag, of each triangle; None if there are none."""
        return self._per_triangle("faces", np.int32)

    @property
    def solids(self) -> Optional[np.ndarray]:
        """Number of the solid that each triangle bounds; None if there are none."""
        return self._per_triangle("solids", np.int32)

    @property
    def corner_normals(self) -> Optional[np.ndarray]:
        """Unit normals of the true surface at the corners of each triangle, (m, 3, 3); None if there are
        none."""
        return self._per_triangle("corner_normals", np.float64, 3, 3)

    @property
    def creases(self) -> List[Crease]:
        """Sharp edges that the file knows."""
        found = []
        for i in range(library.crossgrain_mesh_crease_count(self._handle)):
            curve = library.crossgrain_mesh_crease(self._handle, i).contents
            shape = (curve.point_count, 3)
            found.append(Crease(array_view(self._handle, curve.points, np.float64, shape),
                                array_view(self._handle, curve.tangents, np.float64, shape), curve.tag,
                                bool(curve.is_tagged)))
        return found

    @property
    def unit(self) -> str:
        """Unit of the coordinates, such as "mm"; empty if neither the file nor the caller says."""
        return library.crossgrain_mesh_unit(self._handle).decode()

    @property
    def warnings(self) -> List[str]:
        """What reading found."""
        return _warnings("crossgrain_mesh_warning", self._handle)


class TetMesh:
    """A solid cut into tets, prepared for a field: inverted tets are reoriented, those without volume left
    out.

    ``regions`` is one number per tet. Frames follow feature edges and the normals of feature faces; edges
    that are not ``stated`` to be features may be any curve of the meshed model, and count only where the
    surface is sharp. ``unit`` is that of the coordinates, such as "mm": a label, no number changes.
    """

    path: str = ""
    """File that it was read from."""
    read_seconds: float = 0.0

    def __init__(self, points: Any, cells: Any, *, regions: Any = None, feature_edges: Any = None,
                 edge_tags: Any = None, edges_are_stated: bool = True, feature_faces: Any = None,
                 face_tags: Any = None, unit: str = "", tags_options: Optional[TetTagOptions] = None):
        its_points, tets = numbers(points, "points", 3), indices(cells, "cells", 4)
        its_regions = tags(regions, "regions", len(tets))
        mesh = made("tets", "tets_new", address(its_points), len(its_points), address(tets), len(tets),
                    address(its_regions))
        if feature_edges is not None:
            edges = indices(feature_edges, "feature_edges", 2)
            its_tags = tags(edge_tags, "edge_tags", len(edges))
            call("tets_add_feature_edges", mesh, address(edges), address(its_tags), len(edges),
                 int(edges_are_stated))
        if feature_faces is not None:
            faces = indices(feature_faces, "feature_faces", 3)
            its_tags = tags(face_tags, "face_tags", len(faces))
            call("tets_add_feature_faces", mesh, address(faces), address(its_tags), len(faces))
        call("tets_set_unit", mesh, unit.encode())
        self._prepare(mesh, tags_options)

    def _prepare(self, mesh: Handle, options: Optional[TetTagOptions]) -> None:
        its_options = None if options is None else handle_of(options, TetTagOptions)
        try:
            self._handle = watched(lambda monitor: made("domain", "domain_new", mesh, its_options,
                                                        monitor.handle))
        except InputError as error:
            raise error.with_file(self.path) from None

    @classmethod
    def _of(cls, handle: Handle, path: str = "", read_seconds: float = 0.0) -> "TetMesh":
        mesh = cls.__new__(cls)
        mesh._handle, mesh.path, mesh.read_seconds = handle, path, read_seconds
        return mesh

    def __repr__(self) -> str:
        return f"<crossgrain.TetMesh: {len(self.points)} points, {len(self.cells)} tets>"

    @cached_property
    def points(self) -> np.ndarray:
        """All vertices, (n, 3)."""
        count = library.crossgrain_domain_vertex_count(self._handle)
        return array_view(self._handle, library.crossgrain_domain_vertices(self._handle), np.float64,
                          (count, 3))

    @cached_property
    def cells(self) -> np.ndarray:
        """The tets that have frames, (m, 4): those given, of positive volume."""
        count = library.crossgrain_domain_tet_count(self._handle)
        return array_view(self._handle, library.crossgrain_domain_tets(self._handle), np.uint32, (count, 4))

    @property
    def regions(self) -> Optional[np.ndarray]:
        """Region number of each tet; None if there are none."""
        return view(self._handle, library.crossgrain_domain_regions(self._handle), np.int32,
                    (len(self.cells),))

    def prepared_for_map(self, options: Optional[MapPreparationOptions] = None) -> "TetMesh":
        """These tets, split so that a map that is linear in each can take the surface to integer planes.
        Solve on the result: frames belong to its tets. Points keep their numbers, new ones follow."""
        its_options = None if options is None else handle_of(options, MapPreparationOptions)
        return TetMesh._of(made("domain", "domain_prepared_for_map", self._handle, its_options), self.path,
                           self.read_seconds)

    @property
    def parents(self) -> Optional[np.ndarray]:
        """For each tet the one that it was a part of before `prepared_for_map`, 2**32 - 1 if that is flat;
        None for tets as given."""
        return view(self._handle, library.crossgrain_domain_parents(self._handle), np.uint32,
                    (len(self.cells),))

    @cached_property
    def _faces(self) -> Tuple[np.ndarray, np.ndarray]:
        count = library.crossgrain_domain_face_count(self._handle)
        vertices, its_tags = np.empty((count, 3), np.uint32), np.empty(count, np.int32)
        library.crossgrain_domain_faces(self._handle, address(vertices), address(its_tags))
        return _read_only(vertices), _read_only(its_tags)

    @cached_property
    def _edges(self) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
        count = library.crossgrain_domain_edge_count(self._handle)
        vertices, its_tags = np.empty((count, 2), np.uint32), np.empty(count, np.int32)
        stated = np.empty(count, np.uint8)
        library.crossgrain_domain_edges(self._handle, address(vertices), address(its_tags), address(stated))
        return _read_only(vertices), _read_only(its_tags), _read_only(stated.astype(bool))

    @property
    def feature_faces(self) -> np.ndarray:
        """Tagged triangles, indices of points, (k, 3)."""
        return self._faces[0]

    @property
    def face_tags(self) -> np.ndarray:
        """Number of the face of the model, or tag, of each of the feature faces."""
        return self._faces[1]

    @property
    def feature_edges(self) -> np.ndarray:
        """Tagged edges, indices of points, (k, 2)."""
        return self._edges[0]

    @property
    def edge_tags(self) -> np.ndarray:
        """Number of the edge of the model, or tag, of each of the feature edges."""
        return self._edges[1]

    @property
    def edges_are_stated(self) -> np.ndarray:
        """Whether each of the feature edges is stated to be one; others may be any curve of the meshed
        model."""
        return self._edges[2]

    def write(self, path: Any) -> None:
        """Writes the mesh with its regions and tags: .mesh for Medit, .msh for Gmsh. The file appears
        complete or not at all."""
        encoded = path_bytes(path)
        watched(lambda monitor: call("domain_write", self._handle, encoded, monitor.handle))

    @property
    def typical_edge_length(self) -> float:
        """Edge of a regular tet with the mean volume of the tets."""
        return library.crossgrain_domain_typical_edge_length(self._handle)

    @property
    def boundary(self) -> Surface:
        """The boundary as a surface that points outward."""
        return Surface._of(made("mesh", "domain_boundary", self._handle))

    @property
    def warnings(self) -> List[str]:
        """What was repaired or is unusual."""
        return _warnings("crossgrain_domain_warning", self._handle)


def read_surface(path: Any, options: Optional[ReadOptions] = None) -> Surface:
    """Reads a surface (STL, OBJ, PLY, OFF, 3MF) or a CAD file (STEP, IGES, BREP, FCStd), also packed by gzip.

    Raises InputError naming the file, the place in it and the remedy.
    """
    return _read_surface(path, None if options is None else handle_of(options, ReadOptions))


def _read_surface(path: Any, options: Optional[Handle]) -> Surface:
    start = time.perf_counter()
    encoded = path_bytes(path)
    handle = watched(lambda monitor: made("mesh", "mesh_read", encoded, options, monitor.handle))
    return Surface._of(handle, os.fsdecode(encoded), time.perf_counter() - start)


def read_tets(path: Any, *, max_memory_bytes: int = 0, unit: str = "",
              tags_options: Optional[TetTagOptions] = None) -> TetMesh:
    """Reads a tet mesh (Medit, Gmsh, VTK), also packed by gzip, and prepares it for a field. ``unit`` is
    that of its coordinates, which no format names. Raises InputError like `read_surface`."""
    start = time.perf_counter()
    encoded, most = path_bytes(path), integer(max_memory_bytes, "max_memory_bytes", 0, 2**63 - 1)
    mesh = watched(lambda monitor: made("tets", "tets_read", encoded, most, monitor.handle))
    call("tets_set_unit", mesh, unit.encode())
    tets = TetMesh.__new__(TetMesh)
    tets.path = os.fsdecode(encoded)
    tets._prepare(mesh, tags_options)
    tets.read_seconds = time.perf_counter() - start
    return tets


def make_tets(model: Any, triangles: Any = None, *, size: Optional[float] = None,
              edges: Optional[float] = None, maker: Optional[str] = None,
              options: Optional[TetMakingOptions] = None,
              tags_options: Optional[TetTagOptions] = None) -> TetMesh:
    """Cuts the solids of a CAD file or of a surface into tets, by gmsh or Netgen, and prepares them
    for a field.

    The model is a file (STEP, IGES, BREP, FCStd; STL, OBJ, PLY, OFF, 3MF), two arrays (vertices (n, 3) and
    triangles (m, 3)), a mesh of meshio or trimesh, or a `Surface`. Faces and edges of the model are tagged:
    of CAD files by their numbers, of surfaces between creases.

    size:
        largest edge of the tets, in model units
    edges:
        number of edges along the longest side instead, 20 by default
    maker:
        'gmsh' or 'netgen'; by default the first that is installed and succeeds
    options:
        all other options; those above replace its members

    Raises InputError naming the places of holes, and what to install if no program is there. Ctrl-C ends the
    program that makes the tets.
    """
    start = time.perf_counter()
    chosen = with_changes(options, TetMakingOptions, unless_none(size=size, edges=edges, maker=maker))
    handle = handle_of(chosen, TetMakingOptions)
    tets = TetMesh.__new__(TetMesh)
    if triangles is None and is_path(model):
        encoded = path_bytes(model)
        tets.path = os.fsdecode(encoded)
        mesh = watched(lambda monitor: made("tets", "tets_make", encoded, handle, monitor.handle))
    else:
        surface = surface_of(model, triangles, lambda: None)
        mesh = watched(lambda monitor: made("tets", "tets_make_inside", surface._handle, handle,
                                            monitor.handle))
    tets._prepare(mesh, tags_options)
    tets.read_seconds = time.perf_counter() - start
    return tets


# -- Objects of other packages -----------------------------------------------------------------------------

# Data of cells that number regions or tag features, best first, as in files of VTK.
_TAG_NAMES = ("gmsh:physical", "medit:ref", "CellEntityIds", "region", "RegionId", "tag", "material",
              "MaterialIds", "gmsh:geometrical")
_CORNERS = {"tetra": 4, "triangle": 3, "quad": 4, "line": 2}
_IGNORED = ("vertex", "empty")


def is_meshio(model: Any) -> bool:
    """Whether an object is a mesh of meshio, or looks like one."""
    if not (hasattr(model, "points") and hasattr(model, "cells") and hasattr(model, "cell_data")):
        return False
    return isinstance(model.cells, (list, tuple)) and all(
        hasattr(block, "type") and hasattr(block, "data") for block in model.cells)


def _shape_of(block: Any) -> str:
    """The shape of the cells of a block: cells of higher order, such as "tetra10", count as straight ones."""
    return block.type.rstrip("0123456789")


class _Blocks:
    """The cells of one shape in a mesh of meshio, of any order, with their tags."""

    def __init__(self, mesh: Any, shape: str):
        chosen = [i for i, block in enumerate(mesh.cells) if _shape_of(block) == shape]
        corners = _CORNERS[shape]
        cells = [np.asarray(mesh.cells[i].data)[:, :corners] for i in chosen]
        self.cells = np.concatenate(cells) if chosen else np.zeros((0, corners), int)
        self.tags = None
        name = next((name for name in _TAG_NAMES if name in mesh.cell_data), None)
        if name and chosen:
            if len(mesh.cell_data[name]) != len(mesh.cells):
                raise InputError(f"the cell data {name} are of {len(mesh.cell_data[name])} blocks, and the "
                                 f"mesh has {len(mesh.cells)}")
            values = [np.asarray(mesh.cell_data[name][i]) for i in chosen]
            # As in files, numbers that are no integers tag nothing.
            if all(part.dtype.kind in "iu" and part.ndim == 1 for part in values):
                self.tags = np.concatenate(values)


def _refuse_other_cells(mesh: Any) -> None:
    for block in mesh.cells:
        if _shape_of(block) not in (*_CORNERS, *_IGNORED):
            raise InputError(f"the mesh has cells of type {block.type}; give triangles and quads, or cut "
                             "solids into tets")


def has_tets(mesh: Any) -> bool:
    """Whether a mesh of meshio has tets."""
    return any(_shape_of(block) == "tetra" for block in mesh.cells)


def _tets_of_meshio(mesh: Any) -> TetMesh:
    _refuse_other_cells(mesh)
    tets, faces, edges = _Blocks(mesh, "tetra"), _Blocks(mesh, "triangle"), _Blocks(mesh, "line")
    # As of files: Gmsh and Medit list every curve of the model.
    stated = not any(name.startswith(("gmsh:", "medit:")) for name in mesh.cell_data)
    return TetMesh(mesh.points, tets.cells, regions=tets.tags, feature_edges=edges.cells,
                   edge_tags=edges.tags, edges_are_stated=stated, feature_faces=faces.cells,
                   face_tags=faces.tags)


def _surface_of_meshio(mesh: Any) -> Surface:
    _refuse_other_cells(mesh)
    quads = _Blocks(mesh, "quad").cells
    return Surface(mesh.points, np.concatenate([_Blocks(mesh, "triangle").cells, quads[:, [0, 1, 2]],
                                                quads[:, [0, 2, 3]]]))


def _no_model(wanted: str, model: Any) -> TypeError:
    is_vtk = hasattr(model, "GetClassName")
    hint = "; pyvista.to_meshio makes a mesh of meshio of it" if is_vtk else ""
    return TypeError(f"{wanted}, not {type(model).__name__}{hint}")


def surface_of(model: Any, triangles: Any, read: "Any") -> Surface:
    """The surface that a caller means: a path, arrays, a mesh of meshio or trimesh, or a Surface. `read()`
    gives the options of reading."""
    if triangles is not None:
        return Surface(model, triangles)
    if isinstance(model, Surface):
        return model
    if is_path(model):
        return _read_surface(model, read())
    if is_meshio(model):
        return _surface_of_meshio(model)
    if hasattr(model, "vertices") and hasattr(model, "faces"):
        return Surface(model.vertices, model.faces)
    raise _no_model("a model is a path, two arrays (vertices and triangles), a mesh of meshio or a Surface",
                    model)


def tets_of(model: Any, cells: Any, max_memory_bytes: int = 0) -> TetMesh:
    """The tets that a caller means: a path, arrays, a mesh of meshio or a TetMesh."""
    if cells is not None:
        return TetMesh(model, cells)
    if isinstance(model, TetMesh):
        return model
    if is_path(model):
        return read_tets(model, max_memory_bytes=max_memory_bytes)
    if is_meshio(model):
        if not has_tets(model):
            raise InputError("the mesh has no tets")
        return _tets_of_meshio(model)
    raise _no_model("tets are a path, two arrays (points and cells), a mesh of meshio or a TetMesh", model)


def is_path(model: Any) -> bool:
    """Whether a model is a file."""
    return isinstance(model, (str, bytes, os.PathLike))


def is_of_tets(model: Any) -> bool:
    """Whether a model without triangles of its own is one of tets."""
    if is_path(model):
        return bool(library.crossgrain_is_tet_file(path_bytes(model)))
    return isinstance(model, TetMesh) or (is_meshio(model) and has_tets(model))


def reading_for(options: Handle, read: Optional[ReadOptions]) -> Handle:
    """Options for reading a surface for a solve, with those of `read` that are not defaults."""
    handle = made("options", "options_for_reading", options)
    if read is not None:
        set_changed(handle, read, ReadOptions)
    return handle
