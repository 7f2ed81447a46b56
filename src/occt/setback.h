// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <map>
#include <vector>

#include "core/analysis/continuity_report.h"
#include "core/base/result.h"
#include "core/boundary/boundary_loop.h"
#include "occt/read_chains.h"
#include "occt/shape_index.h"

namespace fairing::occt {

/// The user's numbers of edges and faces by those of a shape made from his; what is not there keeps
/// its number.
struct UserNumbers {
  std::map<int, int> edges, faces;
};

/// A shape whose faces end where a blend with setback is to start, and what its edges and faces
/// stand for.
struct TrimmedBase {
  ShapeIndex index;
  BlendPicks picks;   ///< the same wishes in its numbers, without setback and pairs
  UserNumbers users;  ///< an edge that was set back gives its number to the curve it went to
  std::vector<analysis::Note> notes;  ///< of drawn curves, in the user's numbers
};

/// Trims the faces beside the picked chains, `pair`, back by `picks.setback` or to
/// `picks.setbackCurve`: they are split along the curves at that distance (offset_curve.h) or along
/// the drawn ones (drawn_setback.h), and what lies between these and the chains is left out; drawn
/// edges without a face are, too. Fails with SetbackNegative, SetbackTwice, SetbackWithoutFace,
/// SetbackTooLarge, SetbackCurveBeside, the codes of layOntoFaces(), and EdgeNotInLoop for a wish
/// about an edge that is cut off.
[[nodiscard]] Result<TrimmedBase> trimBack(const ShapeIndex& index,
                                           const BlendPicks& picks,
                                           const boundary::ChainPair& pair);

/// For reports and failures that speak of the user's own edges and faces.
[[nodiscard]] boundary::BoundaryLoop inNumbersOf(boundary::BoundaryLoop sides,
                                                 const UserNumbers& users);
[[nodiscard]] Error inNumbersOf(Error error, const UserNumbers& users);
[[nodiscard]] analysis::Note inNumbersOf(analysis::Note note, const UserNumbers& users);

}  // namespace fairing::occt
