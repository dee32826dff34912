# SPDX-License-Identifier: Apache-2.0
"""Solves for a field from arrays and looks at it: cells, frames, answer, a picture and files for ParaView.

    python3 first_field.py [FOLDER]
"""

import sys
import tempfile
from pathlib import Path

import crossgrain as cg
import numpy as np
from solids import cylinder

folder = Path(sys.argv[1] if len(sys.argv) > 1 else tempfile.mkdtemp())

field = cg.solve(*cylinder(), resolution=48)
print(f"{len(field)} cells, from {field.sizes.min():.3g} to {field.sizes.max():.3g} across")

# One axis of each frame is along the axis of the cylinder.
upright = np.abs(field.frames[:, :, 2]).max(axis=1)
print(f"an axis is within {np.degrees(np.arccos(upright.min().clip(max=1))):.2f} degrees of z everywhere")

# On the surface another one is along the normal.
print(f"frames are {field.report['alignment_deg']['mean']:.2f} degrees off the surface in the mean")
print(f"hexahedra: {field.check()}")

field.write(folder / "cylinder.frames")  # field.vtu and others for ParaView, report.html for a browser
field.render(folder / "cylinder.png", cut="z")
print(f"wrote {folder}/cylinder.frames and {folder}/cylinder.png")
