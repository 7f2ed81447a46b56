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


def set_indices(field, indices) -> None:
    """Copies whole numbers into a field of indices."""
    numbers = np.ascontiguousarray(indices, np.int32)
    field.setNum(len(numbers))
    if not len(numbers):
        return
    ctypes.memmove(int(field.startEditing()), numbers.ctypes.data, numbers.nbytes)
    field.finishEditing()
