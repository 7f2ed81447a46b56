// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <array>
#include <vector>

#include "core/base/result.h"

namespace fairing::occt {

/// What lies behind one end of a border edge.
enum class EdgeEnd {
  Joined,  ///< another edge of the chain in the same face goes on there
  Open,    ///< the offset ends at the border of the face, and goes straight on to it if need be
};

/// An edge in the border of a face, and where its offset within the face is to lie.
struct OffsetRequest {
  TopoDS_Face face;
  TopoDS_Edge use;        ///< as the face has it, so that the face lies to the left
  double distance = 0.0;  ///< mm, above 0
  std::array<EdgeEnd, 2> ends{EdgeEnd::Open, EdgeEnd::Open};  ///< along the edge's own curve
};

/// The curve on a face at a distance from one of its border edges, measured on the face along the
/// geodesics that leave the edge perpendicularly: an iso-curve of the surface where that is what
/// it is, else a B-spline within 2e-8 mm. What is over the
/// face's border is longer than needed; an end inside the face goes on straight in the parameters.
/// Fails with SetbackTooLarge (value = how far the face lets the edge go back, its edge unset)
/// where the face ends before.
[[nodiscard]] Result<std::vector<TopoDS_Edge>> offsetOnFace(const OffsetRequest& request);

}  // namespace fairing::occt
