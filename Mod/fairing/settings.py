# SPDX-License-Identifier: LGPL-2.1-or-later
"""The user's defaults, as the preference page stores them."""

from __future__ import annotations

import FreeCAD as App

from .choices import CONTINUITIES, ENERGIES, LAYOUTS, RESULTS, Choices

PATH = "User parameter:BaseApp/Preferences/Mod/Fairing"
_PATCH_COLOR = 0xF5C451FF  # amber, red-green-blue-alpha


def _group():
    return App.ParamGet(PATH)


def new_choices() -> dict:
    """What a new fill asks for before anything is picked, by the names of Choices."""
    group, plain = _group(), Choices()
    return {
        "continuity": _choice(CONTINUITIES, group.GetInt("Continuity", CONTINUITIES.index(plain.continuity))),
        "layout": _choice(LAYOUTS, group.GetInt("Layout", LAYOUTS.index(plain.layout))),
        "energy": _choice(ENERGIES, group.GetInt("Energy", ENERGIES.index(plain.energy))),
        "angle_tolerance": group.GetFloat("AngleTolerance", plain.angle_tolerance),
        "max_poles": group.GetInt("MaxPoles", plain.max_poles),
        "result": _choice(RESULTS, group.GetInt("Result", RESULTS.index(plain.result))),
    }


def shows_preview() -> bool:
    return _group().GetBool("Preview", True)


def shows_labels() -> bool:
    return _group().GetBool("Labels", True)


def patch_color() -> tuple[float, float, float]:
    """Colour of new faces, red, green and blue from 0 to 1."""
    packed = _group().GetUnsigned("PatchColor", _PATCH_COLOR)
    return tuple((packed >> shift & 0xFF) / 255.0 for shift in (24, 16, 8))


def _choice(words, index: int) -> str:
    return words[index] if 0 <= index < len(words) else words[0]
