# SPDX-License-Identifier: LGPL-2.1-or-later
"""The colours of curvature pictures, as arrays of red, green and blue from 0 to 255."""

from __future__ import annotations

import functools

import numpy as np

STEPS = 256  # of a scale
ZEBRA_SIZE, OVERSAMPLED = 512, 3  # texels along a side, and how many times finer their stripes are looked up
DARK, LIGHT = 35.0, 255.0
UNKNOWN = (128, 128, 128)  # where there is no curvature

# From below to above: where the quantity is 0 a signed scale is pale, the other one calm.
SIGNED = ((0.03, 0.15, 0.55), (0.10, 0.45, 0.85), (0.50, 0.80, 0.95), (0.97, 0.97, 0.92), (0.99, 0.80, 0.35),
          (0.92, 0.38, 0.12), (0.58, 0.02, 0.10))
UNSIGNED = ((0.90, 0.95, 0.97), (0.62, 0.85, 0.70), (0.98, 0.90, 0.38), (0.95, 0.52, 0.15), (0.72, 0.05, 0.12))


def scale(is_signed: bool) -> np.ndarray:
    """STEPS x 3, the colours from the lower end of a range to the upper one."""
    stops = np.array(SIGNED if is_signed else UNSIGNED)
    places = np.linspace(0.0, len(stops) - 1.0, STEPS)
    channels = [np.interp(places, np.arange(len(stops)), stops[:, k]) for k in range(3)]
    return np.rint(255.0 * np.stack(channels, axis=1)).astype(np.uint8)


def zebra(stripes: int) -> np.ndarray:
    """ZEBRA_SIZE x ZEBRA_SIZE: what a mirror shows of so many light lines round the part, all parallel to the screen's
    horizontal, by its normal n seen from the camera: texel (s, t) stands for n.x = 2 s - 1, n.y = 2 t - 1.

    The line of sight (0, 0, -1) is thrown back to r = 2 n.z n - (0, 0, 1); r's angle about the horizontal says which of the
    lines it meets. Where two texels lie either side of a stripe's border, they share it.
    """
    is_light = (np.floor(stripes / np.pi * _around()) % 2.0).astype(np.float32)
    shares = is_light.reshape(ZEBRA_SIZE, OVERSAMPLED, ZEBRA_SIZE, OVERSAMPLED).mean(axis=(1, 3))
    grey = np.rint(DARK + (LIGHT - DARK) * shares).astype(np.uint8)
    return np.repeat(grey[:, :, None], 3, axis=2)


@functools.lru_cache(maxsize=1)
def _around() -> np.ndarray:
    """The angle of r about the horizontal, radians, for every place that zebra() looks up."""
    count = ZEBRA_SIZE * OVERSAMPLED
    axis = ((np.arange(count) + 0.5) / count * 2.0 - 1.0).astype(np.float32)
    x, y = np.meshgrid(axis, axis)
    z = np.sqrt(np.maximum(0.0, 1.0 - x * x - y * y))
    return np.arctan2(2.0 * z * y, 2.0 * z * z - 1.0)


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
