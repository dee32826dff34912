# SPDX-License-Identifier: Apache-2.0
"""Prepares a field on tets for a program that makes hexahedra of it: frames and matchings, as arrays and as files.

    python3 field_for_hexahedra.py [FOLDER]

Such programs (CubeCover and others, docs/formats.md) want a frame in each tet, and across each face the naming of axes that brings the two
frames nearest.
"""

import sys
import tempfile

import crossgrain as cg
import numpy as np
from solids import cylinder_of_tets

folder = sys.argv[1] if len(sys.argv) > 1 else tempfile.mkdtemp()

field = cg.solve_onto(*cylinder_of_tets())
matchings = field.matchings
print(f"{len(field)} tets, {len(matchings)} faces between them, {(~matchings.are_identities).sum()} with other names of axes")

# In the names of the first tet, the frame of the second is near: no axis is more than 45 degrees off, but near singular arcs.
first, second = matchings.tets.T
cosines = np.einsum("fka,fka->fk", field.frames[first], matchings.matrices @ field.frames[second])
print(f"frames of neighbours turn by at most {np.degrees(np.arccos(cosines.min())):.1f} degrees along an axis")

print(f"arcs: {[arc.valence for arc in field.singularities.arcs]}; {field.check()}")
field.write(folder, formats=["fra", "perm"], foreign_files="keep")  # onto.fra and onto.perm for CubeCover
print(f"wrote {folder}")
