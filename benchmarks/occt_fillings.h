// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <vector>

namespace fairing::benchmarks {

/// One side of a hole as OpenCASCADE's fillings want it.
struct OcctSide {
  TopoDS_Edge edge;
  TopoDS_Face face;
};

/// BRepOffsetAPI_MakeFilling with its default parameters, tangent (G1) to every face. Null on
/// failure.
[[nodiscard]] TopoDS_Shape makeFilling(const std::vector<OcctSide>& sides);

/// Three sides or four: what GeomFill_ConstrainedFilling takes.
[[nodiscard]] bool suitsConstrainedFilling(const std::vector<OcctSide>& sides);

/// GeomFill_ConstrainedFilling, degree at most 8, 15 segments, tangent to every face; sides in
/// order. Null on failure.
[[nodiscard]] TopoDS_Shape constrainedFilling(const std::vector<OcctSide>& sides);

}  // namespace fairing::benchmarks
