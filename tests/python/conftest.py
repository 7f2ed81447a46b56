# SPDX-License-Identifier: LGPL-2.1-or-later
"""Lets plain Python use FreeCAD's shapes, and the assembled add-on (PYTHONPATH)."""

import pathlib
import sys

sys.path[:0] = ["/usr/lib/freecad-python3/lib", "/usr/lib/freecad/Mod/Part"]
sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "examples" / "four_sided_hole"))

import FreeCAD  # noqa: E402, F401  (before Part)
import make_example  # noqa: E402
import pytest  # noqa: E402


@pytest.fixture(scope="session")
def sheet():
    """The example's sheet with its four-sided hole."""
    return make_example.sheet_with_hole()


@pytest.fixture(scope="session")
def edges(sheet):
    """Numbers of the edges round the hole."""
    return [int(name[4:]) for name in make_example.hole_edges(sheet)]


@pytest.fixture
def shape(sheet):
    """The same as the native module's Shape."""
    from fairing import exchange

    return exchange.native_shape(sheet)
