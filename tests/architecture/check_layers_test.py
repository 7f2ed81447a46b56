# SPDX-License-Identifier: LGPL-2.1-or-later
"""The checker itself: a good small tree passes, and each kind of breach is named."""

import check_layers
import pytest

SPDX = "// SPDX-License-Identifier: LGPL-2.1-or-later\n"
PYTHON = "# SPDX-License-Identifier: LGPL-2.1-or-later\n"


def breaches(tmp_path, files):
    for name, text in files.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    return list(check_layers.check_tree(tmp_path))


def header(*includes):
    return SPDX + "#pragma once\n" + "".join(f"#include {include}\n" for include in includes)


def test_a_tree_that_keeps_the_rules_has_no_breach(tmp_path):
    assert breaches(tmp_path, {
        "src/core/energy/thin_plate.h": header("<Eigen/Core>", "<vector>", '"core/spline/knot_vector.h"'),
        "src/core/constraint/side.h": header('"core/solver/quadratic_program.h"'),
        "src/core/fill/fill_hole.h": header('"core/energy/thin_plate.h"', '"core/analysis/report.h"'),
        "src/occt/make_faces.cpp": SPDX + '#include <gp_Pnt.hxx>\n#include "core/fill/fill_hole.h"\n',
        "src/python/module.cpp": SPDX + "#include <pybind11/pybind11.h>\n",
        "Mod/fairing/panels/fill.py": PYTHON + "from PySide import QtGui\n",
        "Mod/fairing/features/fill.py": PYTHON + "def show():\n    import FreeCADGui\n",
    }) == []


@pytest.mark.parametrize("name, include, words", [
    ("core/energy/x.h", '"core/layout/quad.h"', "core/energy must not know core/layout"),
    ("core/base/x.h", '"core/spline/knot_vector.h"', "core/base must not know core/spline"),
    ("core/solver/x.h", '"core/spline/knot_vector.h"', "core/solver must not know core/spline"),
    ("core/assembly/x.h", '"core/solver/solve.h"', "core/assembly must not know core/solver"),
    ("core/fill/x.h", '"core/blend/blend_faces.h"', "core/fill must not know core/blend"),
    ("core/fill/x.h", '"occt/make_faces.h"', "core/fill must not know occt"),
    ("core/fill/x.h", "<gp_Pnt.hxx>", "must not know <gp_Pnt.hxx>"),
    ("text/x.h", '"occt/make_faces.h"', "text must not know occt"),
    ("occt/x.h", "<pybind11/pybind11.h>", "must not know <pybind11/pybind11.h>"),
    ("cli/x.h", '"python/module.h"', "cli must not know python"),
    ("core/energy/x.h", '"thin_plate.h"', "is not a path from src/"),
])
def test_an_include_against_the_arrows_is_named(tmp_path, name, include, words):
    found = breaches(tmp_path, {f"src/{name}": header(include)})
    assert len(found) == 1 and words in found[0]


@pytest.mark.parametrize("name, text, words", [
    ("src/core/helpers/x.h", header(), "not a folder"),
    ("src/core/x.h", header(), "no layer"),
    ("utils/x.txt", "", "not a folder"),
    ("src/core/base/x.h", "#pragma once\n", "no SPDX line"),
    ("src/core/base/x.h", SPDX, "no #pragma once"),
    ("src/core/base/x.h", header() + "// \u03bb\n", "not ASCII"),
    ("src/core/base/x.cpp", SPDX + "\n" * 500, "the limit is 500"),
    ("tests/unit/x.cpp", SPDX + "\n" * 700, "the limit is 700"),
    ("src/core/base/x.h", header() + "// see docs/none.md\n", "speaks of docs/none.md"),
    ("docs/x.md", "see /" + "home/me/fairing\n", "a path of one machine"),
    ("Mod/fairing/features/x.py", PYTHON + "import FreeCADGui\n", "imports FreeCADGui"),
    ("Mod/fairing/features/x.py", PYTHON + "try:\n    from PySide import QtGui\nexcept ImportError:\n    pass\n",
     "imports PySide"),
])
def test_each_other_breach_is_named(tmp_path, name, text, words):
    assert any(words in breach for breach in breaches(tmp_path, {name: text}))


def test_the_line_limits_are_reached_before_they_are_broken(tmp_path):
    assert breaches(tmp_path, {"src/core/base/x.cpp": SPDX + "\n" * 499}) == []
