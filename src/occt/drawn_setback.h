// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <TopoDS_Edge.hxx>
#include <map>
#include <vector>

#include "core/analysis/continuity_report.h"
#include "core/base/result.h"
#include "core/boundary/side_chain.h"
#include "occt/shape_index.h"

namespace fairing::occt {

/// A drawn curve laid onto the faces beside one side of a blend.
struct LaidCurve {
  std::map<int, std::vector<TopoDS_Edge>> onFace;  ///< by face number, from border to border
  std::vector<analysis::Note> notes;               ///< how far it was off, where it was extended
};

/// Lays the curve that edges of the shape make, in any order and run through in any direction, onto
/// the faces beside chain 0 or 1 of a pair, along their normals. It may stand off them by 5 % of
/// the pair's diagonal, and end inside a face where straight on the border is within 5 % of its own
/// length. Fails with EdgeOutOfRange, EdgePickedTwice, EdgeDegenerate, EdgeInfinite,
/// SetbackCurveBroken, SetbackCurveUnlike, SetbackCurveOff and SetbackCurveShort.
[[nodiscard]] Result<LaidCurve> layOntoFaces(const ShapeIndex& index,
                                             const std::vector<int>& drawn,
                                             const boundary::ChainPair& pair,
                                             std::size_t chain);

}  // namespace fairing::occt
