"""The materials of the parts."""

from __future__ import annotations

from urdfkit.mesh.geometry import MeshMaterial

BLACK = MeshMaterial("black_plastic", (0.06, 0.06, 0.07, 1.0))
DARK = MeshMaterial("dark_metal", (0.16, 0.17, 0.18, 1.0))
GREY = MeshMaterial("grey_metal", (0.45, 0.46, 0.48, 1.0))
ALUMINIUM = MeshMaterial("aluminium", (0.78, 0.79, 0.81, 1.0))
WINDOW = MeshMaterial("optical_window", (0.16, 0.04, 0.05, 1.0))
GLASS = MeshMaterial("lens_glass", (0.08, 0.12, 0.22, 1.0))
RUBBER = MeshMaterial("rubber", (0.10, 0.10, 0.10, 1.0))
ORANGE = MeshMaterial("orange_paint", (0.93, 0.42, 0.06, 1.0))
GREEN = MeshMaterial("green_light", (0.20, 0.75, 0.30, 1.0))
