# SPDX-License-Identifier: Apache-2.0
"""Crossgrain computes octahedral frame fields inside solids: three orthogonal directions at every point that
vary smoothly and follow the surface.

    >>> import crossgrain as cg
    >>> field = cg.solve("part.step", resolution=128)
    >>> field.frames, field.centers, field.sizes      # (n, 3, 3), (n, 3), (n,)
    >>> field.sample(points)                          # (m, 3, 3)
    >>> print(field.check())
    >>> field.write("part.frames")

`solve` and `solve_onto` make fields, `read` reads them. See `Field` and `TetField` for what to do with them.
`hex` meshes a model with hexahedra, which are a `HexMesh`:

    >>> mesh = cg.hex("part.step", size=2)
    >>> mesh.points, mesh.cells, mesh.quality         # (n, 3), (m, 8), (m,)

`fit` puts hexahedra of another mesher onto a model.
"""

from ._library import library as _library_of_c
from ._watched import Progress
from .constraints import Constraints, read_constraints
from .errors import Error, InputError, InternalError, Interrupted, LimitError, OutputError, UsageError
from .field import CONSTRAINT_CLASSES, Field, Samples
from .hex_fitting import fit
from .hex_meshing import hex  # pylint: disable=redefined-builtin
from .matchings import Matchings
from .models import Crease, Surface, TetMesh, make_tets, read_surface, read_tets
from .options import (HexFitOptions, HexMeshingOptions, HexOptions, MapPreparationOptions, OutputOptions,
                      PictureOptions, ReadOptions, RepairOptions, SolveOptions, StreamlineOptions,
                      TetMakingOptions, TetTagOptions)
from .singularities import Answer, Arc, Node, Reason, SingularityGraph, read_singularities
from .solving import carry_onto, is_clipped, read, solve, solve_onto
from .spectra import Spectrum, coefficients, spectrum
from .streamlines import Streamline, Streamlines, read_streamlines
from .tet_field import HexMesh, TetField

__version__ = _library_of_c.crossgrain_version().decode()

__all__ = [
    "Answer", "Arc", "CONSTRAINT_CLASSES", "Constraints", "Crease", "Error", "Field", "HexMesh",
    "HexFitOptions", "HexMeshingOptions", "HexOptions", "InputError", "InternalError", "Interrupted",
    "LimitError", "MapPreparationOptions", "Matchings", "Node", "OutputError", "OutputOptions",
    "PictureOptions", "Progress", "ReadOptions", "Reason", "RepairOptions", "Samples", "SingularityGraph",
    "SolveOptions", "Spectrum", "Streamline", "StreamlineOptions", "Streamlines", "Surface", "TetField",
    "TetMakingOptions", "TetMesh", "TetTagOptions", "UsageError", "carry_onto", "coefficients", "fit",
    "hex", "is_clipped", "make_tets", "read", "read_constraints", "read_singularities",
    "read_streamlines", "read_surface", "read_tets", "solve", "solve_onto", "spectrum",
]
