# SPDX-License-Identifier: LGPL-2.1-or-later
"""Texts in the user's language: translate(context, text) where shown, NOOP(context, text) where FreeCAD translates."""

from __future__ import annotations

import FreeCAD as App

translate = App.Qt.translate


def NOOP(context: str, text: str) -> str:
    return text
