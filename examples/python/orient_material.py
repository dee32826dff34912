# SPDX-License-Identifier: Apache-2.0
"""Gives every element of a finite element mesh a material orientation: samples a field at the centres of its tets.

The field comes from the surface and knows nothing of the mesh, which may be any, also of other elements. Frames are equivalent under
24 ways to name their axes; a material that is not cubic needs a choice. Here the stiff direction is the axis nearest to z.
"""

import crossgrain as cg
import numpy as np
from solids import cylinder, cylinder_of_tets

field = cg.solve(*cylinder(), resolution=48)

points, tets = cylinder_of_tets()
centres = points[tets].mean(axis=1)
frames = field.sample(centres)  # (number of tets, 3, 3), axes as rows

# The stiff axis first, upwards; the others follow, right-handed.
stiff = np.abs(frames[:, :, 2]).argmax(axis=1)
order = (stiff[:, None] + np.arange(3)) % 3
oriented = np.take_along_axis(frames, order[:, :, None], axis=1)
oriented[:, :2] *= np.where(oriented[:, 0, 2] < 0, -1, 1)[:, None, None]
np.testing.assert_allclose(np.linalg.det(oriented), 1)

print(f"{len(tets)} elements; the stiff axis is within {np.degrees(np.arccos(oriented[:, 0, 2].min())):.2f} degrees of z")
print("element 0:", np.array2string(oriented[0], precision=3, suppress_small=True).replace("\n", ""))
