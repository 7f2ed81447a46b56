# SPDX-License-Identifier: LGPL-2.1-or-later
"""Many vectors into a node of the scene graph at once."""

from __future__ import annotations

import ctypes

import numpy as np


def set_vectors(field, vectors) -> None:
    """Copies n x 3 numbers into a field of vectors or colours: by pivy's own setValues it takes a hundred times as
    long."""
    numbers = np.ascontiguousarray(vectors, np.float32)
    field.setNum(len(numbers))
    if not len(numbers):
        return
    start = field.startEditing()
    ctypes.memmove(int(start.this), numbers.ctypes.data, numbers.nbytes)
    field.finishEditing()


def set_faces(field, corners) -> None:
    """Copies faces, n x their number of corners, into a field of indices."""
    numbers = np.full((len(corners), np.shape(corners)[1] + 1), -1, np.int32)
    numbers[:, :-1] = corners
    field.setNum(numbers.size)
    if not numbers.size:
        return
    ctypes.memmove(int(field.startEditing()), numbers.ctypes.data, numbers.nbytes)
    field.finishEditing()
