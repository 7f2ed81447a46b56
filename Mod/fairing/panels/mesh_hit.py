# SPDX-License-Identifier: LGPL-2.1-or-later
"""Where a line of sight meets a mesh."""

from __future__ import annotations

from typing import Optional

import numpy as np


def nearest_triangle(mesh, start, direction) -> Optional[tuple[float, int, float, float]]:
    """Where a ray first meets a mesh, (points, normals, triangles) as the native module gives it: t, the triangle's
    number, and the shares a and b of its second and third corner; None where it does not.

    start + t direction = (1 - a - b) p0 + a p1 + b p2 for all triangles at once, by Cramer's rule.
    """
    points, _, triangles = mesh
    start, direction = np.asarray(start, float), np.asarray(direction, float)
    corners = np.asarray(points, float)[triangles]
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    across = np.cross(direction, second)
    volume = np.einsum("ij,ij->i", first, across)
    with np.errstate(divide="ignore", invalid="ignore"):  # triangles seen edge on
        from_corner = start - corners[:, 0]
        a = np.einsum("ij,ij->i", from_corner, across) / volume
        turned = np.cross(from_corner, first)
        b = turned @ direction / volume
        t = np.einsum("ij,ij->i", turned, second) / volume
        met = np.flatnonzero((a >= 0.0) & (b >= 0.0) & (a + b <= 1.0) & (t > 0.0))
    if not len(met):
        return None
    at = met[np.argmin(t[met])]
    return float(t[at]), int(at), float(a[at]), float(b[at])


def first_hit(mesh, start, direction) -> Optional[tuple[np.ndarray, np.ndarray]]:
    """Point and unit normal there."""
    hit = nearest_triangle(mesh, start, direction)
    if hit is None:
        return None
    t, triangle, a, b = hit
    _, normals, triangles = mesh
    normal = np.array([1.0 - a - b, a, b]) @ np.asarray(normals, float)[triangles[triangle]]
    return np.asarray(start, float) + t * np.asarray(direction, float), normal / np.linalg.norm(normal)
