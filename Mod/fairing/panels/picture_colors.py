# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colours of curvature pictures, as arrays of red, green and blue from 0 to 255."""

from __future__ import annotations

import dataclasses
from typing import Optional

import numpy as np

STEPS = 256  # of a scale
DARK, LIGHT, SOFT = 50.0, 255.0, 0.015  # of stripes, and how far their borders reach, in stripes
UNKNOWN = (128, 128, 128)  # where there is no curvature

# From below to above: where the quantity is 0 a signed scale is pale, the other one calm.
SIGNED = ((0.10, 0.22, 0.72), (0.16, 0.52, 0.92), (0.55, 0.83, 0.97), (0.98, 0.98, 0.94), (1.00, 0.82, 0.38),
          (0.95, 0.42, 0.15), (0.72, 0.06, 0.12))
UNSIGNED = ((0.90, 0.95, 0.97), (0.62, 0.85, 0.70), (0.98, 0.90, 0.38), (0.95, 0.52, 0.15), (0.72, 0.05, 0.12))


def scale(is_signed: bool) -> np.ndarray:
    """STEPS x 3, the colours from the lower end of a range to the upper one."""
    stops = np.array(SIGNED if is_signed else UNSIGNED)
    places = np.linspace(0.0, len(stops) - 1.0, STEPS)
    channels = [np.interp(places, np.arange(len(stops)), stops[:, k]) for k in range(3)]
    return np.rint(255.0 * np.stack(channels, axis=1)).astype(np.uint8)


def zebra_image() -> np.ndarray:
    """2 x STEPS x 3: one stripe, a dark half and a light one with soft borders, to be repeated."""
    along = np.abs((np.arange(STEPS) + 0.5) / STEPS - 0.5)  # from the middle of the dark half
    grey = np.interp(along, (0.25 - SOFT, 0.25 + SOFT), (DARK, LIGHT))
    line = np.repeat(np.rint(grey).astype(np.uint8)[:, None], 3, axis=1)
    return np.stack([line, line])


def stripes_at(points: np.ndarray, normals: np.ndarray, camera: "Camera", stripes: int) -> np.ndarray:
    """n x 2: where each vertex looks up the stripe that it mirrors.

    So many light lines stand at even angles round the part, parallel to the screen's horizontal. A line of sight v is
    thrown back to r = v - 2 (v.n) n; r's angle about the horizontal says which line it meets. The sign of n plays no
    part: sheets are seen from both sides.
    """
    if camera.eye is None:
        sight = -camera.back[None]
    else:
        sight = points - camera.eye
        sight = sight / np.linalg.norm(sight, axis=1, keepdims=True)
    mirrored = sight - 2.0 * np.sum(sight * normals, axis=1, keepdims=True) * normals
    around = np.arctan2(mirrored @ camera.up, mirrored @ camera.back)
    along = stripes * around / (2.0 * np.pi)
    return np.stack([along, np.full(len(along), 0.5)], axis=1).astype(np.float32)


@dataclasses.dataclass(frozen=True)
class Camera:
    """Unit vectors up the screen and out of it; where a perspective camera stands, None for a parallel one."""

    up: np.ndarray
    back: np.ndarray
    eye: Optional[np.ndarray]


def places_in(values: np.ndarray, low: float, high: float) -> np.ndarray:
    """n x 2: where values lie in the picture of a scale, between 0 and 1 along it; the second row is for those that are
    not finite."""
    known = np.isfinite(values)
    width = max(high - low, np.finfo(np.float32).tiny)
    along = np.clip((np.where(known, values, low) - low) / width, 0.0, 1.0)
    along = (0.5 + along * (STEPS - 1)) / STEPS  # at the middles of texels
    return np.stack([along, np.where(known, 0.25, 0.75)], axis=1).astype(np.float32)


def scale_image(is_signed: bool) -> np.ndarray:
    """2 x STEPS x 3: the scale, and above it the colour of what is unknown."""
    return np.stack([scale(is_signed), np.tile(np.uint8(UNKNOWN), (STEPS, 1))])
