# SPDX-License-Identifier: LGPL-2.1-or-later
"""View provider of a blend."""

from __future__ import annotations

from .fill_view import FillView


class BlendView(FillView):
    ICON = "Fairing_BlendFaces.svg"

    @staticmethod
    def bases_of(obj):
        """The objects that are joined; none where the links are lost."""
        return list(dict.fromkeys(link[0] for link in obj.FromEdges + obj.ToEdges))

    @staticmethod
    def open_panel(obj):
        from ..panels.blend_panel import BlendPanel

        return BlendPanel.show(obj=obj)
