# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the 3D view and the panel show of a surface while it is being made."""

import re

import gui


def drawn_points(panels):
    """Of the surface of the panel opened last."""
    return panels[-1]._display._preview._surface._points.point.getValues()


def handle_arrow(panels, number=0):
    """Foot and tip of a handle's arrow."""
    display = panels[-1]._display
    arrow = display.guide_handles._arrows[number]
    return arrow.point, arrow.tip(display._mouse)


def guides():
    """The rows of what guides."""
    shown = gui.widget("guideList")
    return [shown.item(row).text() for row in range(shown.count())]


def angles_to_guide():
    """Rms and largest, as the panel tells them."""
    found = re.match(r"Follows within ([\d.]+)\S rms, ([\d.]+)\S at most", gui.widget("followLabel").text())
    assert found, gui.widget("followLabel").text()
    return float(found[1]), float(found[2])
