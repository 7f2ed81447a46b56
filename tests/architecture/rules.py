# SPDX-License-Identifier: LGPL-2.1-or-later
"""The architecture as data: docs/ARCHITECTURE.md section 2, for check_layers.py to hold the sources against."""

STANDARD = r"[a-z_0-9]+"
EIGEN = r"Eigen/.+"
EXPECTED = r"tl/expected\.hpp"
OCCT = r"[A-Za-z][A-Za-z0-9_]*\.(hxx|lxx)"

# The type the stages hand to the solver; they know nothing else of it.
PROGRAM = "core/solver/quadratic_program.h"

# folder under src/ -> folders (or single headers) it may include, besides its own
STAGES = {
    "core/base": [],
    "core/spline": ["core/base"],
    "core/boundary": ["core/base", "core/spline"],
    "core/layout": ["core/base", "core/spline", "core/boundary"],
    "core/constraint": ["core/base", "core/spline", "core/boundary", "core/layout", PROGRAM],
    "core/energy": ["core/base", "core/spline"],
    "core/shape_energy": ["core/base", "core/spline"],
    "core/solver": ["core/base"],
    "core/assembly": ["core/base", "core/spline", "core/boundary", "core/layout", "core/constraint",
                      "core/energy", "core/shape_energy", PROGRAM],
    "core/analysis": ["core/base", "core/spline", "core/boundary", "core/energy", "core/shape_energy"],
    "core/height_field": ["core/base", "core/spline", "core/boundary", "core/constraint", "core/energy"],
    "core/span": ["core/base", "core/spline", "core/boundary", "core/layout", "core/constraint", "core/energy",
                  "core/shape_energy", "core/solver", "core/assembly", "core/analysis", "core/height_field/trim.h"],
    "core/uniform_patch": ["core/base", "core/spline", "core/solver"],
    "core/fill": ["core/*"],
    "core/blend": ["core/*"],
    "core/edit": ["core/*"],
    "core/curve_network": ["core/*"],
    "core/flow": ["core/*"],
    "occt": ["core/*"],
    "text": ["core/*"],
    "python": ["core/*", "occt", "text"],
    "cli": ["core/*", "occt", "text"],
}

# the pipelines use the stages, not each other
PIPELINES = ["core/fill", "core/blend", "core/edit", "core/curve_network", "core/flow"]

# first folder under src/ -> foreign headers it may include in angle brackets
FOREIGN = {
    "core": [STANDARD, EIGEN, EXPECTED],
    "occt": [STANDARD, EIGEN, EXPECTED, OCCT],
    "text": [STANDARD, EIGEN, EXPECTED, r"nlohmann/.+", r"fmt/.+"],
    "python": [STANDARD, EIGEN, EXPECTED, OCCT, r"nlohmann/.+", r"fmt/.+", r"pybind11/.+"],
    "cli": [STANDARD, EIGEN, EXPECTED, OCCT, r"nlohmann/.+", r"fmt/.+", r"CLI/.+"],
}

FOLDERS = {
    ".": [".ci", "Mod", "benchmarks", "cmake", "docs", "examples", "resources", "scripts", "src", "tests"],
    "src": ["cli", "core", "occt", "python", "text"],
    "src/core": [stage.split("/")[1] for stage in STAGES if stage.startswith("core/")],
    "Mod": ["fairing"],
    "Mod/fairing": ["commands", "features", "panels", "views"],
    "tests": ["architecture", "convergence", "data", "freecad", "golden", "occt", "property", "python",
              "regression", "support", "unit"],
}

# modules that need the GUI, and where in Mod/fairing they may be imported at the top of a file
GUI_MODULES = ["FreeCADGui", "PartGui", "PySide", "PySide2", "PySide6", "pivy"]
GUI_PLACES = ["Mod/fairing/commands/", "Mod/fairing/panels/", "Mod/fairing/views/", "Mod/fairing/selection.py"]

LINE_LIMITS = {"tests/": 700, "": 500}
