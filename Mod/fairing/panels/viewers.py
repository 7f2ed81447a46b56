# SPDX-License-Identifier: LGPL-2.1-or-later
"""The viewer behind a 3D view."""

from __future__ import annotations

_kept = []


def viewer_of(view):
    """FreeCAD 1.1 crashes when it drops the last reference to a viewer handed out to Python: one is kept for good."""
    viewer = view.getViewer()
    if not any(kept is viewer for kept in _kept):
        _kept.append(viewer)
    return viewer


def viewport_of(view):
    return viewer_of(view).getSoRenderManager().getViewportRegion()
