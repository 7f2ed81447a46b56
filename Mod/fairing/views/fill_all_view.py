# SPDX-License-Identifier: LGPL-2.1-or-later
"""View provider of an object that fills all holes."""

from __future__ import annotations

from .fill_view import FillView


class FillAllView(FillView):
    ICON = "Fairing_FillAllHoles.svg"

    @staticmethod
    def bases_of(obj):
        return [obj.Base] if obj.Base else []

    @staticmethod
    def open_panel(obj):
        from ..panels.fill_all_panel import FillAllPanel

        return FillAllPanel.show(obj=obj)
