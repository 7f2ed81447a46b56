# SPDX-License-Identifier: LGPL-2.1-or-later
"""FreeCAD's property editor modes, as bits of addProperty's attributes."""

READ_ONLY, HIDDEN = 1, 4
