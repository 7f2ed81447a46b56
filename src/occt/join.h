// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <TopoDS_Shape.hxx>
#include <vector>

#include "core/base/result.h"
#include "core/boundary/boundary_loop.h"
#include "occt/result_mode.h"
#include "occt/shape_index.h"

namespace fairing::occt {

/// One filled loop: its new faces, the loop they belong to and the largest distance between the two
/// (mm).
struct JoinPart {
  TopoDS_Shape faces;
  boundary::BoundaryLoop loop;
  double gap = 0.0;
};

/// Puts the new faces together as asked: as they are, as a shell a part, or into the base. There
/// `replaced` faces (FreeCAD's numbers) are left out first, edges are sewn where they are within
/// twice the measured gap (never less than the edges' own tolerances), and a closed result becomes
/// a solid of positive volume. Sewing keeps one of two edges and raises its tolerance to the
/// distance found, so tolerances of the result are true. Fails with SewingOpen where an edge beside
/// a face stays free, or ResultInvalid.
[[nodiscard]] Result<TopoDS_Shape> joinResult(const ShapeIndex& base,
                                              const std::vector<int>& replaced,
                                              const std::vector<JoinPart>& parts,
                                              ResultMode mode);

}  // namespace fairing::occt
